#pragma once
/// The parts of an assessment that text and page share.

#include <string>
#include <vector>

#include "dashpad/output/assessment.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// "Passes: 3 ms clip has 3.66 g to spare", by the criterion next to its limit or farthest beyond it.
std::string assessment_answer(const AssessmentReport& report, const UnitSystem& units);

/// Whether it passes by less than a foam is known to that is used beyond its tests.
bool passes_narrowly(const injury::Assessment& assessment);

/// A criterion a row: value, estimated error, limit, margin, verdict.
Table criteria_table(const AssessmentReport& report, const UnitSystem& units);

/// What of the case was replaced and kept, and where the standard's figures come from, a sentence each.
std::vector<std::string> assessment_basis(const AssessmentReport& report, const UnitSystem& units);

}  // namespace dashpad::output
