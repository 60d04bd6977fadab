#pragma once
/// Arrows on lines, in the direction in which they are gone through.

#include <string>

#include "output/plot/series_svg.hpp"

namespace dashpad::output {

/// One on the last third of each line that wants one; empty without such.
std::string arrows_svg(const PanelDrawing& panel, const PanelScale& scale);

}  // namespace dashpad::output
