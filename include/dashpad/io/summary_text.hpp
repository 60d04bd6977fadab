#pragma once
/// The result of one impact as an engineer reads it at a glance.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/io/unit_system.hpp"

namespace dashpad {

/// Text of some twenty lines: what struck what; how it ended; warnings in capitals (EXTRAPOLATED, BOTTOMED,
/// TIME LIMIT, TOLERANCE NOT MET); then a table of figures to five digits with their estimated errors, those
/// that a designer asks for first on top; last the numbers behind the numbers. Speeds of rebound are
/// positive. "±" is relative to the figure in its line; for the energy absorbed, to the impact energy.
std::string summary_text(const ImpactCase& impact, const Summary& summary, const UnitSystem& units);

}  // namespace dashpad
