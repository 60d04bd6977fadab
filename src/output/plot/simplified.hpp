#pragma once
/// Lines with as few places as their shape needs.

#include "output/plot/clip.hpp"

namespace dashpad::output {

/// Leaves out places that are no farther than a twentieth of a px from the line between two that stay. The
/// first, the last and those where the line turns back stay.
PlaceLine simplified(const PlaceLine& line);

}  // namespace dashpad::output
