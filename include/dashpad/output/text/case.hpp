#pragma once
/// A case as people read it.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// What strikes what, in two lines, below the title if there is one.
std::string case_text(const ImpactCase& impact, const UnitSystem& units);

/// Every value of the case as it is computed with: `key = value unit` in SI and full precision, a line each.
std::string case_in_si(const ImpactCase& impact, const Options& options);

}  // namespace dashpad::output
