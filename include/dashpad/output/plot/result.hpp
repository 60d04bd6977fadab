#pragma once
/// A still of one impact.

#include <optional>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Acceleration over time with the window of HIC15 and the 3 ms clip, and force over motion and penetration;
/// the flags of the result in the small print.
Plot result_plot(const ImpactCase& impact, const Solution& solution,
                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units);

}  // namespace dashpad::output
