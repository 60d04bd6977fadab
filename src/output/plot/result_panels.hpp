#pragma once
/// The panel of one impact that stills and pages share.

#include <optional>
#include <string>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// "peaks at 76.3 g and holds 71.2 g for 3 ms".
std::string peak_words(const injury::InjuryFigures& figures);

/// Deceleration, the window of HIC15 and the 3 ms clip; the title says what they are.
Panel deceleration_panel(const Solution& solution, const std::optional<injury::InjuryFigures>& injury,
                         const UnitSystem& units);

}  // namespace dashpad::output
