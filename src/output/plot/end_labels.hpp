#pragma once
/// Names of lines at the right of a panel, each beside the end of its line.

#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/looks.hpp"
#include "output/plot/rows.hpp"

namespace dashpad::output {

// All px. From the axes to the text, and the text's size.
inline constexpr double beside_axes = 18, end_label_text = 11.5;
/// Of the axes of every panel.
inline constexpr double panel_height = 320;

/// Heights are shares of the axis: 0 at its low end, 1 at its high one.
struct EndLabel {
  std::string text;
  SeriesColour colour;
  double line_end = 0;     ///< x
  double line_height = 0;  ///< of the line where it ends
  double height = 0;       ///< of the text
};

/// For a line that ends there; the axis has both its limits.
EndLabel end_label_of(const Series& series, const SeriesColour& colour, const PlotRow& end, const Axis& y);

/// Sets the heights so that no text lies on another and each is as near to the end of its line as that allows
/// (least squares); on the way from low to high the order of the lines stays.
void make_room(std::vector<EndLabel>& labels);

/// What lines and texts take, in px.
double width_beside_axes(const std::vector<EndLabel>& labels);

}  // namespace dashpad::output
