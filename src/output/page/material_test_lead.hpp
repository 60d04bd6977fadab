#pragma once
/// What a material test says to whoever chooses a foam.

#include <string>
#include <vector>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/page/figures_page.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Of the run at the highest rate, which is the nearest to an impact: what was asked for (a stress limit, a
/// hold), else where the foam is used best.
Lead material_test_lead(const laboratory::MaterialTestReport& report, const UnitSystem& units);

/// Foam with its source, tested range and reservations, and what was done to it.
std::vector<std::string> material_test_basis(const laboratory::MaterialTestReport& report,
                                             const UnitSystem& units);

}  // namespace dashpad::output
