#pragma once
/// Names of lines at the right of a panel, each beside the end of its line.

#include <string>
#include <vector>

#include "output/plot/series_svg.hpp"

namespace dashpad::output {

/// From the axes to the text, px.
inline constexpr double beside_axes = 18;

/// Places are in px from the upper left corner of the axes.
struct EndLabel {
  const SeriesDrawing* series;
  std::vector<std::string> lines;  ///< of text
  PlotPlace line_end = {};         ///< of a line that goes forth and back, where it turns
  double height = 0;               ///< of the middle of the text
};

/// The names that are to stand there, not placed yet: those that series ask for, and the labels of lines if
/// these are few enough and short enough to be read beside a plot of that width.
std::vector<EndLabel> end_labels_of(const PanelDrawing& panel, double plot_width);

/// Sets all places.
void place(std::vector<EndLabel>& labels, const PanelScale& scale);

/// Sets the heights so that no text lies on another and each is as near to the end of its line as that allows
/// (least squares); on the way down the order of the ends stays. `height`: of the axes.
void make_room(std::vector<EndLabel>& labels, double height);

/// What lines and texts take, in px.
double width_beside_axes(const std::vector<EndLabel>& labels);

std::string end_labels_svg(const std::vector<EndLabel>& labels, const PanelScale& scale);

}  // namespace dashpad::output
