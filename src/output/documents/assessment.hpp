#pragma once
/// The parts of an assessment that a test plan and a measured pulse show, too.

#include <string>
#include <vector>

#include "dashpad/output/assessment.hpp"
#include "output/documents/basis.hpp"

namespace dashpad::output {

/// A figure that is shown beside every verdict.
struct KeyFigure {
  const char* key;
  injury::Figure injury::KeyFigures::*figure;
};
inline constexpr KeyFigure figures_of_assessment[]{
    {"peak_acceleration", &injury::KeyFigures::peak_acceleration},
    {"peak_strain", &injury::KeyFigures::peak_strain},
    {"hic15", &injury::KeyFigures::hic15},
    {"hic36", &injury::KeyFigures::hic36},
    {"contact_end", &injury::KeyFigures::contact_end},
    {"rebound_speed", &injury::KeyFigures::rebound_speed},
    {"restitution", &injury::KeyFigures::restitution}};

/// Each source of what is in force of a standard, with what comes from it.
std::vector<Basis> sources_in_full(const injury::Standard& standard);

Tone tone_of(injury::Verdict verdict);

/// The criterion nearest to its limit, or farthest beyond it. Null if none has a margin.
const injury::CriterionResult* closest(const std::vector<injury::CriterionResult>& results);

/// The absolute margin of a criterion, which must have one: "3.66 g".
std::string margin_words(const injury::CriterionResult& result, const UnitSystem& units, int digits);

/// Value, limit and verdict; the error only where that may decide, or is asked for.
ValueRow criterion_row(const injury::CriterionResult& result, const UnitSystem& units, Detail detail);
std::vector<ValueRow> criterion_rows(const std::vector<injury::CriterionResult>& results,
                                     const UnitSystem& units, Detail detail);

/// A line across at each limit that is an acceleration, g.
std::vector<Series> acceleration_limits(const std::vector<injury::CriterionResult>& results,
                                        const UnitSystem& units);

/// The deceleration with the limits that are accelerations.
Plot deciding_curve(const AssessmentReport& report, const UnitSystem& units);

}  // namespace dashpad::output
