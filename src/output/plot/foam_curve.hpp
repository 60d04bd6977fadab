#pragma once
/// How much of its foam one impact uses: the foam's own curve, for what a result rests on.

#include <optional>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Stress over strain in a first loading at the slowest tested rate, under the pad's condition: solid and
/// shaded up to the largest strain of the impact, dashed beyond, with a line where the tests ended. Of a pad
/// of layers, the one that is compressed most. Beside it the curve at the
/// highest rate of the impact, where the foam knows rates.
///
/// The title says how far the foam is used. None where nothing was run, and for a pad whose law breaks a
/// rule.
std::optional<Plot> foam_curve_plot(const Pad& pad, const Summary& summary, const UnitSystem& units);

/// A line across where the foam's tests end; nothing where that is not known, or at full compression.
std::optional<Series> line_of_range(const Material& material);

}  // namespace dashpad::output
