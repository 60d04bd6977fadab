#pragma once
/// The answer of a study in a sentence.

#include <string>

#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/study/questions.hpp"

namespace dashpad::output {

/// Of the first question that the study answers: how probable it is that a limit is exceeded, or how many
/// combinations keep it; which factor matters most; where a response is least; how its draws spread. Empty
/// for a study without rows.
std::string study_answer(const study::StudyAnswers& answers, const UnitSystem& units);

}  // namespace dashpad::output
