#pragma once
/// The panels of one impact, for stills and pages.

#include <optional>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Deceleration, the window of HIC15 and the 3 ms clip.
Panel deceleration_panel(const History& history, const std::optional<injury::InjuryFigures>& injury,
                         const UnitSystem& units);

/// Force over displacement and penetration.
Panel loop_panel(const History& history, const UnitSystem& units);

}  // namespace dashpad::output
