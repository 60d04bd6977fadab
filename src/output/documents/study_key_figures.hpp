#pragma once
/// The few figures of a study, on top of its page.

#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::output {

/// The figures behind study_answer(): probabilities, the factors that matter, least peaks of cushion curves,
/// or ranges. At most max_key_figures; none without rows.
std::vector<ValueRow> study_key_figures(const study::StudyAnswers& answers, const UnitSystem& units);

}  // namespace dashpad::output
