#pragma once
/// What of a line or an area lies within the rectangle of a panel. Places are in px from its upper left
/// corner.

#include <vector>

namespace dashpad::output {

struct PlotPlace {
  double x = 0;
  double y = 0;
};
using PlaceLine = std::vector<PlotPlace>;

struct PlotSize {
  double width = 0;
  double height = 0;
};

/// The parts of a line inside.
std::vector<PlaceLine> line_inside(const PlaceLine& line, const PlotSize& size);

/// The part of an area inside; empty if there is none.
PlaceLine area_inside(PlaceLine outline, const PlotSize& size);

bool is_inside(const PlotPlace& place, const PlotSize& size);

}  // namespace dashpad::output
