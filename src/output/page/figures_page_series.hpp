#pragma once
/// The panels of a plot for the page of figures.

#include <nlohmann/json.hpp>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// A list of panels: title, axes, and those series that have something to show, each with its turn as in the
/// stills, or null if it is grey. A null in x, y or y2 is a gap.
nlohmann::ordered_json panels_json(const Plot& plot);

}  // namespace dashpad::output
