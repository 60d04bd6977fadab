#include "output/plot/series_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include <fmt/format.h>

namespace dashpad::output {

namespace {

/// The largest coordinate that is written: renderers count thousandths of a px in 32 bits.
constexpr double far_away = 1e7;  // px

std::string pair(const Place& place) { return px(place.x) + " " + px(place.y); }

/// "M1 2 3 4": what follows the first pair are lines. Places that are the same when written are one.
std::string path_of(const PlaceLine& line) {
  std::string path, before;
  for (const Place& place : line) {
    std::string next = pair(place);
    if (next == before) continue;
    path += (path.empty() ? "M" : " ") + next;
    before = std::move(next);
  }
  return path;
}

/// The shape of a point: a path relative to its place, and a class. With round ends, a line of zero length is
/// a disc; cairo leaves out some with square ends.
struct PointShape {
  const char* around;
  const char* class_name;
};
constexpr std::array<PointShape, shapes_by_turn> point_shapes{
    {{"h0", "dp-disc"},
     {"m-2.6-2.6h5.2v5.2h-5.2z", "dp-shape"},  // square
     {"m-3.5 2.5h7l-3.5-6z", "dp-shape"},      // triangle
     {"m0-4 4 4-4 4-4-4z", "dp-shape"},        // diamond
     {"m-3.5-2.5h7l-3.5 6z", "dp-shape"},      // triangle on its tip
     {"m-2.6 0a2.6 2.6 0 1 0 5.2 0 2.6 2.6 0 1 0-5.2 0", "dp-ring"}}};

std::string class_of(const Looks& looks) {
  switch (looks.style) {
    case SeriesStyle::band: return "dp-band";
    case SeriesStyle::area: return "dp-area";
    case SeriesStyle::points: return looks.is_dot ? "dp-dot" : point_shapes[looks.pattern].class_name;
    case SeriesStyle::vertical_line:
    case SeriesStyle::horizontal_line: return "dp-line dp-across";
    default: return looks.pattern == 0 ? "dp-line" : fmt::format("dp-line dp-dash-{}", looks.pattern);
  }
}

/// A path with these looks; nothing if it has no places.
std::string path_with(const Looks& looks, const std::string& path) {
  if (path.empty()) return {};
  const std::string width = looks.width > 0 ? fmt::format(" stroke-width=\"{}\"", px(looks.width)) : "";
  return fmt::format("<path class=\"{}\"{} d=\"{}\"/>", class_of(looks), width, path);
}

PlaceLine places_of(const PlotRun& run, const PanelScale& scale) {
  PlaceLine places;
  places.reserve(run.size());
  for (const PlotRow& row : run) places.push_back(scale.place(row.x, row.y));
  return places;
}

std::string area_path(const PlaceLine& outline, const PanelScale& scale) {
  const std::string path = path_of(area_inside(outline, scale.size));
  return path.empty() ? path : path + "z";
}

/// The outline of a band: forth along y, back along y2.
std::string band_path(const PlotRun& run, const PanelScale& scale) {
  PlaceLine outline = places_of(run, scale);
  for (const PlotRow& row : PlotRun(run.rbegin(), run.rend())) outline.push_back(scale.place(row.x, row.y2));
  return area_path(simplified(outline), scale);
}

std::string points_path(const PlotRun& run, const Looks& looks, const PanelScale& scale) {
  std::string path;
  for (const Place& place : places_of(run, scale))
    if (is_inside(place, scale.size))
      path += fmt::format("M{}{}", pair(place), point_shapes[looks.pattern].around);
  return path;
}

std::string line_path(const PlotRun& run, const PanelScale& scale) {
  std::string path;
  for (const PlaceLine& part : line_inside(places_of(run, scale), scale.size))
    path += path_of(simplified(part));
  return path;
}

std::string run_path(const PlotRun& run, const Looks& looks, const PanelScale& scale) {
  switch (looks.style) {
    case SeriesStyle::band: return band_path(run, scale);
    case SeriesStyle::area: return area_path(places_of(run, scale), scale);
    case SeriesStyle::points: return points_path(run, looks, scale);
    default: return run.size() > 1 ? line_path(run, scale) : std::string{};
  }
}

/// A line across the whole panel.
std::string marker_path(double place, SeriesStyle style, const PanelScale& scale) {
  if (style == SeriesStyle::vertical_line)
    return fmt::format("M{} 0V{}", px(scale.across(place)), px(scale.size.height));
  return fmt::format("M0 {}H{}", px(scale.down(place)), px(scale.size.width));
}

/// A line that marks something, as a bracket does, is no curve.
const char* word_of(const SeriesDrawing& series) {
  switch (series.looks.style) {
    case SeriesStyle::points: return series.looks.is_dot ? "dots" : "points";
    case SeriesStyle::band: return "band";
    case SeriesStyle::area: return "area";
    case SeriesStyle::vertical_line: return "vertical";
    case SeriesStyle::horizontal_line: return "horizontal";
    default: return series.label_place == LabelPlace::middle ? "mark" : "line";
  }
}

/// The path of an arrow; empty for lines shorter than two arrows.
std::string arrow_path(const std::vector<PlaceLine>& parts) {
  constexpr double half_length = 5.5, half_width = 4;  // px
  // The place of the arrow as a share of the line; a loop is on its way back there.
  constexpr double share_before = 0.7;
  if (parts.empty()) return {};
  const PlaceLine& line = *std::ranges::max_element(parts, {}, length_of);
  const double middle = share_before * length_of(line);
  if (length_of(line) < 4 * half_length) return {};
  const Place tail = place_on(line, middle - half_length), tip = place_on(line, middle + half_length);
  const double x = tip.x - tail.x, y = tip.y - tail.y, length = std::hypot(x, y);
  if (!(length > half_length)) return {};  // round a corner
  const double across = half_width / length;
  return fmt::format("M{} {}L{} {}L{} {}z", px(tip.x), px(tip.y), px(tail.x - across * y),
                     px(tail.y + across * x), px(tail.x + across * y), px(tail.y - across * x));
}

}  // namespace

double PanelScale::across(double value) const {
  return std::clamp(size.width * x.share(value), -far_away, far_away);
}

double PanelScale::down(double value) const {
  return std::clamp(size.height * (1 - y.share(value)), -far_away, far_away);
}

std::string colour_attributes(const SeriesColour& colour, const std::string& classes) {
  if (colour.shade.empty()) return fmt::format(" class=\"{} {}\"", classes, colour.class_name);
  return fmt::format(" class=\"{}\" color=\"{}\"", classes, colour.shade);
}

std::vector<PlaceLine> parts_inside(const SeriesDrawing& series, const PanelScale& scale) {
  std::vector<PlaceLine> parts;
  for (const PlotRun& run : series.runs)
    for (PlaceLine& part : line_inside(places_of(run, scale), scale.size)) parts.push_back(std::move(part));
  return parts;
}

std::string series_svg(const SeriesDrawing& series, const PanelScale& scale) {
  constexpr double edges = 3;  // px
  const std::string label = xml_text(entry_of(series).label);
  std::string path, casing;
  for (const PlotRun& run : series.runs) path += run_path(run, series.looks, scale);
  for (const double place : series.places) path += marker_path(place, series.looks.style, scale);
  if (series.is_cased)
    casing = fmt::format(
        "<g class=\"dp-series dp-casing\" data-label=\"{}\" data-style=\"line\"><path class=\"dp-line\" "
        "stroke-width=\"{}\" d=\"{}\"/></g>\n",
        label, px(series.looks.width + edges), path);
  const std::string of = series.of.empty() ? "" : fmt::format(" data-of=\"{}\"", xml_text(series.of));
  return casing + fmt::format("<g{} data-label=\"{}\"{} data-style=\"{}\">{}</g>\n",
                              colour_attributes(series.looks.colour, "dp-series"), label, of, word_of(series),
                              path_with(series.looks, path));
}

std::string arrows_svg(const PanelDrawing& panel, const PanelScale& scale) {
  std::string arrows;
  for (const SeriesDrawing& series : panel.series) {
    if (!series.has_arrow) continue;
    const std::string path = arrow_path(parts_inside(series, scale));
    if (path.empty()) continue;
    arrows += fmt::format("<g{} data-of=\"{}\"><path class=\"dp-shape\" d=\"{}\"/></g>\n",
                          colour_attributes(series.looks.colour, "dp-arrow"),
                          xml_text(series.label.empty() ? series.of : series.label), path);
  }
  return arrows.empty() ? arrows : "<g class=\"dp-marks\">\n" + arrows + "</g>\n";
}

std::string sample_svg(const Looks& looks, double left, double middle, double width) {
  std::string path;
  if (is_ground(looks.style))
    path = fmt::format("M{} {}h{}v10h-{}z", px(left), px(middle - 5), px(width), px(width));
  else if (looks.style == SeriesStyle::points)
    path = fmt::format("M{}{}", pair({left + width / 2, middle}), point_shapes[looks.pattern].around);
  else
    path = fmt::format("M{} {}h{}", px(left), px(middle), px(width));
  return fmt::format("<g{}>{}</g>", colour_attributes(looks.colour, "dp-sample"), path_with(looks, path));
}

}  // namespace dashpad::output
