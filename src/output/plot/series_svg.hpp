#pragma once
/// Series as SVG, and lines within a panel. Places and lengths are in px from its upper left corner.

#include <string>
#include <vector>

#include "output/plot/axis_ticks.hpp"
#include "output/plot/drawing.hpp"
#include "output/svg/svg.hpp"

namespace dashpad::output {

using PlaceLine = std::vector<Place>;

struct PlotSize {
  double width = 0;
  double height = 0;
};

/// The parts of a line inside.
std::vector<PlaceLine> line_inside(const PlaceLine& line, const PlotSize& size);
/// The part of an area inside; empty if there is none.
PlaceLine area_inside(PlaceLine outline, const PlotSize& size);
bool is_inside(const Place& place, const PlotSize& size);

double length_of(const PlaceLine& line);
/// The place at that length along a line with at least one place; the end of a shorter line.
Place place_on(const PlaceLine& line, double length);

/// Removes places within a twentieth of a px of the line between two that stay, but no turning points.
PlaceLine simplified(const PlaceLine& line);

/// The scale of a panel: its coordinates are px from the upper left corner of its rectangle.
struct PanelScale {
  AxisRange x, y;
  PlotSize size;

  [[nodiscard]] double across(double value) const;
  [[nodiscard]] double down(double value) const;
  [[nodiscard]] Place place(double x_value, double y_value) const { return {across(x_value), down(y_value)}; }
};

/// The group of a series with its label and style as data for scripts. Each point begins with its place
/// ("M"); a line passes through its points in their order.
std::string series_svg(const SeriesDrawing& series, const PanelScale& scale);

/// The parts of its runs that lie within the axes, in px.
std::vector<PlaceLine> parts_inside(const SeriesDrawing& series, const PanelScale& scale);

/// Arrows in the direction of the lines that ask for them, on their last third; empty without such lines.
std::string arrows_svg(const PanelDrawing& panel, const PanelScale& scale);

/// A piece of such a series for the legend.
std::string sample_svg(const Looks& looks, double left, double middle, double width);

/// Attributes of a group in that colour, with further classes: ` class="dp-series dp-turn-0"`.
std::string colour_attributes(const SeriesColour& colour, const std::string& classes);

}  // namespace dashpad::output
