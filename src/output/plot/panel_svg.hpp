#pragma once
/// Panels as SVG: axes, marks, series and names. Places are in px from the upper left corner of the axes.

#include <cstddef>
#include <string>
#include <vector>

#include "output/plot/series_svg.hpp"

namespace dashpad::output {

/// The distance from the axes to the labels at their right, px.
inline constexpr double beside_axes = 18;

/// A name at the right of a panel, beside the end of its line.
struct EndLabel {
  const SeriesDrawing* series;
  std::vector<std::string> lines;  ///< lines of text
  Place line_end = {};             ///< end of the line, or where it turns if it comes back
  double height = 0;               ///< y of the middle of the text
};

/// The labels at the right of a panel, not placed yet: those of series, and few and short ones of lines.
std::vector<EndLabel> end_labels_of(const PanelDrawing& panel, double plot_width);

/// Sets all places.
void place(std::vector<EndLabel>& labels, const PanelScale& scale);

/// Sets the heights so that no texts overlap and each is as near to the end of its line as possible (least
/// squares). The order of the ends is kept. `height` is that of the axes.
void make_room(std::vector<EndLabel>& labels, double height);

/// The width of the labels and their leaders, px.
double width_beside_axes(const std::vector<EndLabel>& labels);

std::string end_labels_svg(const std::vector<EndLabel>& labels, const PanelScale& scale);

enum class TextAnchor { start, middle, end };

struct TextPlace {
  Place at;  ///< place of the base line
  TextAnchor anchor = TextAnchor::start;
};

/// A name beside a line across, a bracket, a contour, a single point or a line that ends early.
struct MarkLabel {
  const SeriesDrawing* series;
  TextPlace place;
};

/// The names that have a place within the axes where they cover neither each other nor a line or point.
/// `ends` must be placed, since their leaders are lines too. Names of lines that end far from the right of
/// the axes are moved from there to beside the end of the line if they have room.
std::vector<MarkLabel> mark_labels_of(const PanelDrawing& panel, std::vector<EndLabel>& ends,
                                      const PanelScale& scale);

std::string mark_labels_svg(const std::vector<MarkLabel>& labels);

/// The margin around a plot, px.
inline constexpr double plot_edge = 16;

/// The data from which a panel is laid out. Lengths are in px.
struct PanelFrame {
  const Panel* panel;
  const PanelDrawing* drawing;
  std::size_t x_labels;  ///< number of labels that have room
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

  /// The entries that are not named in the panel, for the legend.
  [[nodiscard]] std::vector<LegendEntry> not_named() const;

  /// Room that the numbers on the y axis take.
  [[nodiscard]] double left_margin() const;
  /// The heights from the upper edge to the axes, and from the axes to the lower edge.
  [[nodiscard]] double above_axes() const;
  [[nodiscard]] double below_axes() const;
};

/// The upper left corner of the axes is at that place; texts begin at `edge`.
std::string panel_svg(const PanelFrame& frame, double left, double top, double edge);

}  // namespace dashpad::output
