#pragma once
/// The parts of an assessment that text and page share.

#include <string>
#include <vector>

#include "dashpad/output/assessment.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// "Passes: 3 ms clip has 3.66 g to spare", by the criterion next to its limit or farthest beyond it.
std::string assessment_answer(const AssessmentReport& report, const UnitSystem& units);

/// What makes a pass doubtful that its interval does not show, in words to be put behind it as they are: a
/// pad that is struck through. Empty where nothing does.
std::string doubt_about_pass(const AssessmentReport& report);

/// A criterion a row: value, estimated error, limit, margin, verdict.
Table criteria_table(const AssessmentReport& report, const UnitSystem& units);

/// What of the case was replaced and kept, and where the standard's figures come from, a sentence each.
std::vector<std::string> assessment_basis(const AssessmentReport& report, const UnitSystem& units);

}  // namespace dashpad::output
