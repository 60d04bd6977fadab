#pragma once
/// Whether the values of the factors make cases that can be solved, as far as that can be known before work
/// starts.

#include <vector>

#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// Rules of the case that levels or the ends of distributions break, under keys such as
/// "factors.impactor.speed". All combinations of levels are tried, up to 100,000; with more, each level with
/// the first of the others. The sampled factors stand at their medians, and at each end of their range (6
/// deviations out for a normal that is not cut off) one at a time. For a study whose factors are sound in
/// themselves.
std::vector<Violation> case_violations(const Study& study);

}  // namespace dashpad::study
