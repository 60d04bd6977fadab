#pragma once
/// A panel as SVG: axes, marks, series, and the names at the ends of lines.

#include <string>
#include <vector>

#include "output/plot/series_svg.hpp"

namespace dashpad::output {

/// What a panel needs to be placed. Lengths are in px.
struct PanelFrame {
  const Panel* panel;
  const PanelDrawing* drawing;
  PanelScale scale;  ///< its width is set when all panels are known
  std::vector<Tick> x_ticks, y_ticks;
  std::vector<std::string> title, y_title;  ///< lines

  PanelFrame(const Panel& panel_to_draw, const PanelDrawing& drawing_of_panel);

  /// Room that the numbers on the y axis take.
  [[nodiscard]] double left_margin() const;
  /// From its upper edge to the axes, and from there to its lower edge.
  [[nodiscard]] double above_axes() const;
  [[nodiscard]] double below_axes() const;
};

/// The upper left corner of the axes is at that place; texts begin at `edge`.
std::string panel_svg(const PanelFrame& frame, double left, double top, double edge);

}  // namespace dashpad::output
