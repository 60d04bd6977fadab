#pragma once
/// The cases that a study makes, against the rules of cases.

#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// The rules that cases of the study break, under keys such as "factors.impactor.speed", at most 20: at all
/// combinations of levels, up to 100,000, or else at each level with the first of the others, and at the ends
/// of each distribution with the others at their medians. The factors must be sound.
std::vector<Violation> violations_of_cases(const Study& study);

}  // namespace dashpad::study
