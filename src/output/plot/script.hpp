#pragma once
/// A plot in gnuplot's language.

#include <string>

#include "dashpad/output/plot/plot.hpp"

namespace dashpad::output {

/// Draws the picture to standard output. The plot has been checked. Throws std::invalid_argument if nothing
/// in it can be drawn.
std::string plot_script(const Plot& plot, PictureFormat format);

}  // namespace dashpad::output
