#pragma once
/// A panel as SVG: axes, marks, series and their names.

#include <cstddef>
#include <string>
#include <vector>

#include "output/plot/labels.hpp"

namespace dashpad::output {

/// Around a plot, px.
inline constexpr double plot_edge = 16;

/// What a panel needs to be placed. Lengths are in px.
struct PanelFrame {
  const Panel* panel;
  const PanelDrawing* drawing;
  std::size_t x_labels;  ///< that have room
  PanelScale scale;      ///< its width is set when all panels are known
  std::vector<Tick> x_ticks, y_ticks;
  std::vector<std::string> title, y_title;  ///< lines
  std::vector<EndLabel> ends;
  // These, and places of names, when the width of the axes is known.
  std::vector<std::string> x_title;
  std::vector<MarkLabel> marks;

  PanelFrame(const Panel& panel_to_draw, const PanelDrawing& drawing_of_panel, double plot_width);

  /// Sets where the axes begin and how wide they are, and places the names.
  void place_across(double left, double width);

  /// What is not named in the panel: it has to be in the legend.
  [[nodiscard]] std::vector<LegendEntry> not_named() const;

  /// Room that the numbers on the y axis take.
  [[nodiscard]] double left_margin() const;
  /// From its upper edge to the axes, and from there to its lower edge.
  [[nodiscard]] double above_axes() const;
  [[nodiscard]] double below_axes() const;
};

/// The upper left corner of the axes is at that place; texts begin at `edge`.
std::string panel_svg(const PanelFrame& frame, double left, double top, double edge);

}  // namespace dashpad::output
