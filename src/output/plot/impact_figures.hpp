#pragma once
/// All that is plotted of one impact, a figure each.

#include <optional>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Force, deceleration, distances and energy over time, and force over penetration and displacement.
std::vector<CaptionedPlot> impact_figures(const ImpactCase& impact, const Solution& solution,
                                          const std::optional<injury::InjuryFigures>& injury,
                                          const UnitSystem& units);

/// Stress and strain over the radius of the contact, a curve for each moment; none without snapshots.
std::vector<CaptionedPlot> contact_figures(const std::vector<ContactSnapshot>& snapshots,
                                           const UnitSystem& units);

/// A line across a panel over time where the pad bottoms out on a rigid support, if it does.
void mark_bottoming(Panel& panel, const Solution& solution, const UnitSystem& units);

/// Ends the axis of a force, or of what is in proportion to it, above what a pad that bottomed out on a rigid
/// support had before the last hundredth of its penetration: at the end it has no finite limit, and would
/// hide all the rest. `column` is what is plotted, an entry for each of the history.
void end_before_bottoming(Axis& axis, const Solution& solution, const std::vector<double>& column);

}  // namespace dashpad::output
