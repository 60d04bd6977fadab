#pragma once
/// Lines within the rectangle of a panel. Places and lengths are in px, from its upper left corner.

#include <vector>

#include "output/svg/svg.hpp"

namespace dashpad::output {

using PlaceLine = std::vector<Place>;

struct PlotSize {
  double width = 0;
  double height = 0;
};

/// The parts of a line inside.
std::vector<PlaceLine> line_inside(const PlaceLine& line, const PlotSize& size);
/// The part of an area inside; empty if there is none.
PlaceLine area_inside(PlaceLine outline, const PlotSize& size);
bool is_inside(const Place& place, const PlotSize& size);

double length_of(const PlaceLine& line);
/// After that length from the begin of a line that has a place; its end if it is shorter.
Place place_on(const PlaceLine& line, double length);

/// Leaves out places that are no farther than a twentieth of a px from the line between two that stay. The
/// first, the last and those where the line turns back stay.
PlaceLine simplified(const PlaceLine& line);

}  // namespace dashpad::output
