#pragma once
/// The few figures of a study, on top of its page.

#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::output {

/// Of what study_answer() speaks: a probability, the factors that matter, least peaks of cushion curves, or a
/// range. At most most_key_figures; none without rows.
std::vector<ValueRow> study_key_figures(const study::StudyAnswers& answers, const UnitSystem& units);

}  // namespace dashpad::output
