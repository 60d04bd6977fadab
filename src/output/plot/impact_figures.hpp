#pragma once
/// The figures of one impact for pages, and those that stills and other pages share.

#include <cstddef>
#include <optional>
#include <string>
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

/// Deceleration, the window of HIC15 and the 3 ms clip; the title says what they are.
Panel deceleration_panel(const Solution& solution, const std::optional<injury::InjuryFigures>& injury,
                         const UnitSystem& units);

/// "peaks at 76.3 g and holds 71.2 g for 3 ms".
std::string peak_words(const injury::InjuryFigures& figures);

/// The window of a head injury criterion as a bracket just above the time axis: shading would hide the curve.
/// `value` is the criterion as it is shown; `peak`, with its sign, that of the curve, g; `row` counts
/// brackets from the axis upwards.
Series hic_bracket(const char* key, const injury::Hic& hic, const std::string& value, double peak,
                   std::size_t palette_index, const UnitSystem& units, int row = 0);

/// Adds a line across at the level of the 3 ms clip, g, with its shown value; none for level 0, without clip.
void add_clip(Panel& panel, double level, const std::string& value);

/// Limits the axis of a force, or of a quantity proportional to it, if the pad bottomed out on a rigid
/// support: the force has no finite limit there. The axis ends above the values before the last hundredth of
/// the penetration. `column` has the plotted values, one for each entry of the history.
void end_before_bottoming(Axis& axis, const Solution& solution, const std::vector<double>& column);
/// The same of a panel over time, which begins at nothing, with a line across where the pad bottoms out.
void show_bottoming(Panel& panel, const Solution& solution, const std::vector<double>& column,
                    const UnitSystem& units);

/// The energies of an impact over time, J, an entry for each of the history. Works are trapezoidal sums of
/// force over distance; the total includes the work of the weight.
struct ImpactEnergies {
  std::vector<double> kinetic, support, pad, total;
  double largest_deviation = 0;  ///< largest relative deviation of the total from its first value
};
ImpactEnergies impact_energies(const ImpactCase& impact, const History& history);

}  // namespace dashpad::output
