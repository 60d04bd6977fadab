#pragma once
/// A case as a case file that repeats it.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::output {

/// TOML in SI that read_case() reads as the same numbers. It holds the law itself, so that no card is needed;
/// where the material comes from is a comment.
std::string case_toml(const ImpactCase& impact, const Options& options);

}  // namespace dashpad::output
