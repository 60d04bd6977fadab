#pragma once
/// Colours between others.

#include <array>
#include <span>
#include <string>

namespace dashpad::output {

/// Red, green and blue, from 0 to 255.
using Colour = std::array<double, 3>;

/// "#rrggbb" on a scale with these colours at equal distances, two or more; `share`: from 0, at the first, to
/// 1.
std::string colour_on_scale(std::span<const Colour> stops, double share);

}  // namespace dashpad::output
