#pragma once
/// The colours of strains, and their legend.

#include <string>

#include "output/drawing/elements.hpp"
#include "output/drawing/moment.hpp"

namespace dashpad::output {

/// Of equal steps from 0 to 1.
inline constexpr int shades_of_strain = 20;
/// The class of a shade, from 0 up: "dd-s0".
std::string shade_class(int shade);
/// The rules of those classes, on light paper or dark: little strain is near the colour of the paper.
std::string shade_rules(bool dark);

/// The scale from 0 to 1 with its upper left corner there, `width` px wide: up to which strain the foams were
/// tested, and the strains on the axis at greatest penetration.
std::string strain_legend(const DrawnMoments& moments, Place corner, double width);
/// px, of the legend.
inline constexpr double strain_legend_height = 80;

}  // namespace dashpad::output
