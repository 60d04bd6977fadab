#pragma once
/// The parts of an assessment that a test plan and a measured pulse show, too.

#include <vector>

#include "dashpad/output/assessment.hpp"

namespace dashpad::output {

Tone tone_of(injury::Verdict verdict);

/// That which is next to its limit, or farthest beyond it; null without a margin.
const injury::CriterionResult* closest(const std::vector<injury::CriterionResult>& results);

/// Value, limit and verdict; the error only where that may decide, or is asked for.
ValueRow criterion_row(const injury::CriterionResult& result, const UnitSystem& units, Detail detail);

/// A line across at each limit that is an acceleration, g.
std::vector<Series> acceleration_limits(const std::vector<injury::CriterionResult>& results,
                                        const UnitSystem& units);

/// The deceleration with the limits that are accelerations.
Plot deciding_curve(const AssessmentReport& report, const UnitSystem& units);

}  // namespace dashpad::output
