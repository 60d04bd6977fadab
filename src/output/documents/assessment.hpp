#pragma once
/// The parts of an assessment that a test plan and a measured pulse show, too.

#include <string>
#include <vector>

#include "dashpad/output/assessment.hpp"

namespace dashpad::output {

/// What is said beside every verdict, by the keys of the table of results, the most telling first.
struct KeyFigure {
  const char* key;
  injury::Figure injury::KeyFigures::*figure;
};
inline constexpr KeyFigure figures_of_assessment[]{
    {"peak_acceleration", &injury::KeyFigures::peak_acceleration},
    {"peak_strain", &injury::KeyFigures::peak_strain},
    {"hic15", &injury::KeyFigures::hic15},
    {"contact_end", &injury::KeyFigures::contact_end},
    {"rebound_speed", &injury::KeyFigures::rebound_speed},
    {"hic36", &injury::KeyFigures::hic36},
    {"restitution", &injury::KeyFigures::restitution}};

Tone tone_of(injury::Verdict verdict);

/// That which is next to its limit, or farthest beyond it; null without a margin.
const injury::CriterionResult* closest(const std::vector<injury::CriterionResult>& results);

/// How far a criterion is from its limit: "3.66 g". It has a margin.
std::string margin_words(const injury::CriterionResult& result, const UnitSystem& units, int digits);

/// Value, limit and verdict; the error only where that may decide, or is asked for.
ValueRow criterion_row(const injury::CriterionResult& result, const UnitSystem& units, Detail detail);

/// A line across at each limit that is an acceleration, g.
std::vector<Series> acceleration_limits(const std::vector<injury::CriterionResult>& results,
                                        const UnitSystem& units);

/// The deceleration with the limits that are accelerations.
Plot deciding_curve(const AssessmentReport& report, const UnitSystem& units);

}  // namespace dashpad::output
