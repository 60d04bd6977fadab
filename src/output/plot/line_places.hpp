#pragma once
/// Lengths along lines, in px.

#include "output/plot/clip.hpp"

namespace dashpad::output {

double length_of(const PlaceLine& line);

/// After that length from the begin of a line that has a place; its end if it is shorter.
PlotPlace place_on(const PlaceLine& line, double length);

}  // namespace dashpad::output
