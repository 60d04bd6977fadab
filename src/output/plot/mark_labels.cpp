#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "output/plot/panel_svg.hpp"
#include "output/plot/svg_plot.hpp"

namespace dashpad::output {

namespace {

constexpr double mark_line = 16;  // px
/// Distances from a line to the base line of a text above it and below it, and to a text beside it, px.
constexpr double to_text_above = 4, to_text_below = 13, to_text_beside = 6;
/// The largest number of names on lines across; more are easier to read in a legend.
constexpr std::size_t max_named_lines_across = 4;

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
};

double width_of_name(const SeriesDrawing& series) { return text_room(entry_of(series).label, label_text); }

Box box_at(const TextPlace& place, double width) {
  constexpr double ascent = 11, descent = 3;
  const double before = place.anchor == TextAnchor::start ? 0 : place.anchor == TextAnchor::end ? 1 : 0.5;
  const double left = place.at.x - before * width;
  return {left, place.at.y - ascent, left + width, place.at.y + descent};
}

/// Everything that a text must not cover.
struct Obstacles {
  PlotSize size;
  std::vector<PlaceLine> lines;
  PlaceLine points;
  std::vector<Box> texts;
};

bool overlap(const Box& a, const Box& b) {
  return a.left < b.right && b.left < a.right && a.top < b.bottom && b.top < a.bottom;
}

/// The line as it is seen from the corner of the box.
bool crosses(PlaceLine line, const Box& box) {
  for (Place& at : line) at = {at.x - box.left, at.y - box.top};
  return !line_inside(line, {box.right - box.left, box.bottom - box.top}).empty();
}

bool is_free(const Box& box, const Obstacles& obstacles) {
  constexpr double edge = 2, size_of_point = 4, beside_line = 3;
  if (box.left < edge || box.right > obstacles.size.width - edge || box.top < 0 ||
      box.bottom > obstacles.size.height)
    return false;
  const auto is_near = [&](const Place& at) {
    return overlap({at.x - size_of_point, at.y - size_of_point, at.x + size_of_point, at.y + size_of_point},
                   box);
  };
  return std::ranges::none_of(obstacles.texts, [&](const Box& text) { return overlap(text, box); }) &&
         std::ranges::none_of(obstacles.points, is_near) &&
         std::ranges::none_of(obstacles.lines, [&](const PlaceLine& line) {
           return crosses(line, {box.left - beside_line, box.top, box.right + beside_line, box.bottom});
         });
}

/// A leader from there to the right of the axes would cross half of the panel.
bool ends_early(const EndLabel& label, const PlotSize& size) {
  return label.line_end.x < 0.8 * size.width && label.series->end_label.empty();
}

Obstacles obstacles_of(const PanelDrawing& panel, const std::vector<EndLabel>& ends,
                       const PanelScale& scale) {
  const PlotSize& size = scale.size;
  Obstacles obstacles{.size = size, .lines = {}, .points = {}, .texts = {}};
  for (const SeriesDrawing& series : panel.series) {
    const SeriesStyle style = series.looks.style;
    for (const double place : series.places) {
      const double x = scale.across(place), y = scale.down(place);
      obstacles.lines.push_back(style == SeriesStyle::vertical_line ? PlaceLine{{x, 0}, {x, size.height}}
                                                                    : PlaceLine{{0, y}, {size.width, y}});
    }
    if (is_line(style))
      for (PlaceLine& part : parts_inside(series, scale)) obstacles.lines.push_back(std::move(part));
    if (style == SeriesStyle::points)
      for (const PlotRun& run : series.runs)
        for (const PlotRow& row : run) obstacles.points.push_back(scale.place(row.x, row.y));
  }
  for (const EndLabel& label : ends)
    if (!ends_early(label, size))
      obstacles.lines.push_back({label.line_end, {size.width + beside_axes, label.height}});
  return obstacles;
}

/// Places beside a line across, the best first.
std::vector<TextPlace> beside_horizontal(double y, double width, const PlotSize& size) {
  std::vector<TextPlace> all;
  const double way = size.width - 2 * to_text_above - width;
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
    for (const double base : {y - to_text_above, y + to_text_below})
      all.push_back({{size.width - to_text_above - part * way, base}, TextAnchor::end});
  return all;
}

std::vector<TextPlace> beside_vertical(double x) {
  constexpr int rows = 8;
  std::vector<TextPlace> all;
  // The second distance avoids a curve that runs along the line.
  for (const double away : {to_text_beside, 3 * to_text_beside})
    for (int row = 0; row < rows; ++row) {
      const double base = to_text_below + mark_line * row;
      all.push_back({{x + away, base}, TextAnchor::start});
      all.push_back({{x - away, base}, TextAnchor::end});
    }
  return all;
}

std::vector<TextPlace> beside_middle(const std::vector<PlaceLine>& parts) {
  std::vector<TextPlace> all;
  if (parts.empty()) return all;
  const PlaceLine& line = *std::ranges::max_element(parts, {}, length_of);
  for (const double part : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
    const auto [x, y] = place_on(line, part * length_of(line));
    all.push_back({{x, y - to_text_above}, TextAnchor::middle});
    all.push_back({{x, y + to_text_below}, TextAnchor::middle});
    all.push_back({{x + to_text_beside, y + to_text_above}, TextAnchor::start});
    all.push_back({{x - to_text_beside, y + to_text_above}, TextAnchor::end});
  }
  // A bracket that is narrower than its name.
  const auto [highest, lowest] = std::ranges::minmax(line, {}, &Place::y);
  const double middle = (line.front().x + line.back().x) / 2;
  all.push_back({{middle, highest.y - to_text_above}, TextAnchor::middle});
  all.push_back({{middle, lowest.y + to_text_below}, TextAnchor::middle});
  return all;
}

std::vector<TextPlace> beside_end(const Place& end) {
  std::vector<TextPlace> all;
  for (const double base : {to_text_above, -to_text_above, to_text_below}) {
    all.push_back({{end.x + to_text_beside, end.y + base}, TextAnchor::start});
    all.push_back({{end.x - to_text_beside, end.y + base}, TextAnchor::end});
  }
  for (const double base : {-to_text_above, to_text_below})
    all.push_back({{end.x, end.y + base}, TextAnchor::middle});
  return all;
}

bool is_named_line_across(const SeriesDrawing& series) {
  return is_marker(series.looks.style) && series.places.size() == 1 && !series.label.empty();
}

bool is_named_point(const SeriesDrawing& series) {
  return series.looks.style == SeriesStyle::points && series.label_place == LabelPlace::middle &&
         !series.label.empty() && series.runs.size() == 1 && series.runs.front().size() == 1;
}

/// The possible places for the name of a series, the best first.
std::vector<TextPlace> places_for(const SeriesDrawing& series, const PanelScale& scale) {
  if (is_named_line_across(series))
    return series.looks.style == SeriesStyle::vertical_line
               ? beside_vertical(scale.across(series.places.front()))
               : beside_horizontal(scale.down(series.places.front()), width_of_name(series), scale.size);
  if (is_line(series.looks.style) && series.label_place == LabelPlace::middle && !series.label.empty())
    return beside_middle(parts_inside(series, scale));
  if (!is_named_point(series)) return {};
  const PlotRow& at = series.runs.front().front();
  return beside_end(scale.place(at.x, at.y));
}

}  // namespace

std::vector<MarkLabel> mark_labels_of(const PanelDrawing& panel, std::vector<EndLabel>& ends,
                                      const PanelScale& scale) {
  std::vector<MarkLabel> labels;
  const auto across = static_cast<std::size_t>(std::ranges::count_if(panel.series, is_named_line_across));
  Obstacles obstacles = obstacles_of(panel, ends, scale);
  const auto take_first_free = [&](const SeriesDrawing& series, const std::vector<TextPlace>& places) {
    const double width = width_of_name(series);
    for (const TextPlace& place : places) {
      const Box box = box_at(place, width);
      if (!is_free(box, obstacles)) continue;
      obstacles.texts.push_back(box);
      labels.push_back({&series, place});
      return true;
    }
    return false;
  };
  for (const SeriesDrawing& series : panel.series)
    if (!is_named_line_across(series) || across <= max_named_lines_across)
      take_first_free(series, places_for(series, scale));
  std::erase_if(ends, [&](const EndLabel& end) {
    return ends_early(end, scale.size) && take_first_free(*end.series, beside_end(end.line_end));
  });
  return labels;
}

std::string mark_labels_svg(const std::vector<MarkLabel>& labels) {
  constexpr std::array<const char*, 3> anchors{"", " dp-centred", " dp-to-end"};
  if (labels.empty()) return {};
  std::string svg = "<g class=\"dp-marks\">\n";
  for (const auto& [series, place] : labels) {
    const std::string name = xml_text(entry_of(*series).label);
    svg += fmt::format(
        "<g{} data-label=\"{}\"><text class=\"dp-mark-label{}\" x=\"{}\" y=\"{}\">{}</text></g>\n",
        colour_attributes(series->looks.colour, "dp-mark"), name,
        anchors[static_cast<std::size_t>(place.anchor)], px(place.at.x), px(place.at.y), name);
  }
  return svg + "</g>\n";
}

}  // namespace dashpad::output
