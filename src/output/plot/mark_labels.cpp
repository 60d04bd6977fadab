#include "output/plot/mark_labels.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

#include <fmt/format.h>

#include "output/plot/line_places.hpp"
#include "output/plot/text_sizes.hpp"
#include "output/svg/svg.hpp"
#include "output/svg/text_fit.hpp"

namespace dashpad::output {

namespace {

constexpr double mark_line = 16;  // px
/// From a line to the base of a text above it, below it, and to a text beside it, px.
constexpr double to_text_above = 4, to_text_below = 13, to_text_beside = 6;
/// More are easier to read in a legend.
constexpr std::size_t most_named_lines_across = 4;

struct Box {
  double left = 0, top = 0, right = 0, bottom = 0;
};

Box box_of(const MarkLabel& label) {
  constexpr double ascent = 11, descent = 3;
  const double width = text_room(label.text, label_text);
  const double before = label.anchor == TextAnchor::start ? 0 : label.anchor == TextAnchor::end ? 1 : 0.5;
  const double left = label.at.x - before * width;
  return {left, label.at.y - ascent, left + width, label.at.y + descent};
}

/// What a text must not lie on.
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
  for (PlotPlace& at : line) at = {at.x - box.left, at.y - box.top};
  return !line_inside(line, {box.right - box.left, box.bottom - box.top}).empty();
}

bool is_free(const Box& box, const Obstacles& obstacles) {
  constexpr double edge = 2, size_of_point = 4, beside_line = 3;
  if (box.left < edge || box.right > obstacles.size.width - edge || box.top < 0 ||
      box.bottom > obstacles.size.height)
    return false;
  const auto is_near = [&](const PlotPlace& at) {
    return at.x > box.left - size_of_point && at.x < box.right + size_of_point &&
           at.y > box.top - size_of_point && at.y < box.bottom + size_of_point;
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
        for (const PlotRow& row : run) obstacles.points.push_back({scale.across(row.x), scale.down(row.y)});
  }
  for (const EndLabel& label : ends)
    if (!ends_early(label, size))
      obstacles.lines.push_back({label.line_end, {size.width + beside_axes, label.height}});
  return obstacles;
}

/// Places beside a line across, the best first.
std::vector<MarkLabel> beside_horizontal(const MarkLabel& label, double y, const PlotSize& size) {
  std::vector<MarkLabel> all;
  const double way = size.width - 2 * to_text_above - text_room(label.text, label_text);
  for (const double part : {0.0, 0.25, 0.5, 0.75, 1.0})
    for (const double base : {y - to_text_above, y + to_text_below})
      all.push_back(
          {label.series, label.text, {size.width - to_text_above - part * way, base}, TextAnchor::end});
  return all;
}

std::vector<MarkLabel> beside_vertical(const MarkLabel& label, double x) {
  constexpr int rows = 8;
  std::vector<MarkLabel> all;
  // Where a curve runs along the line, on the other side of it.
  for (const double away : {to_text_beside, 3 * to_text_beside})
    for (int row = 0; row < rows; ++row) {
      const double base = to_text_below + mark_line * row;
      all.push_back({label.series, label.text, {x + away, base}, TextAnchor::start});
      all.push_back({label.series, label.text, {x - away, base}, TextAnchor::end});
    }
  return all;
}

std::vector<MarkLabel> beside_middle(const MarkLabel& label, const std::vector<PlaceLine>& parts) {
  std::vector<MarkLabel> all;
  if (parts.empty()) return all;
  const PlaceLine& line = *std::ranges::max_element(parts, {}, length_of);
  const auto add = [&](double x, double y, TextAnchor anchor) {
    all.push_back({label.series, label.text, {x, y}, anchor});
  };
  for (const double part : {0.5, 0.4, 0.6, 0.3, 0.7, 0.2, 0.8}) {
    const PlotPlace at = place_on(line, part * length_of(line));
    add(at.x, at.y - to_text_above, TextAnchor::middle);
    add(at.x, at.y + to_text_below, TextAnchor::middle);
    add(at.x + to_text_beside, at.y + to_text_above, TextAnchor::start);
    add(at.x - to_text_beside, at.y + to_text_above, TextAnchor::end);
  }
  // A bracket that is narrower than its name.
  const auto [highest, lowest] = std::ranges::minmax(line, {}, &PlotPlace::y);
  const double middle = (line.front().x + line.back().x) / 2;
  add(middle, highest.y - to_text_above, TextAnchor::middle);
  add(middle, lowest.y + to_text_below, TextAnchor::middle);
  return all;
}

std::vector<MarkLabel> beside_end(const MarkLabel& label, const PlotPlace& end) {
  std::vector<MarkLabel> all;
  for (const double base : {to_text_above, -to_text_above, to_text_below}) {
    all.push_back({label.series, label.text, {end.x + to_text_beside, end.y + base}, TextAnchor::start});
    all.push_back({label.series, label.text, {end.x - to_text_beside, end.y + base}, TextAnchor::end});
  }
  for (const double base : {-to_text_above, to_text_below})
    all.push_back({label.series, label.text, {end.x, end.y + base}, TextAnchor::middle});
  return all;
}

bool is_named_line_across(const SeriesDrawing& series) {
  return is_marker(series.looks.style) && series.places.size() == 1 && !series.label.empty();
}

bool is_named_point(const SeriesDrawing& series) {
  return series.looks.style == SeriesStyle::points && series.label_place == LabelPlace::middle &&
         !series.label.empty() && series.runs.size() == 1 && series.runs.front().size() == 1;
}

/// Where the name of a series could stand.
std::vector<MarkLabel> places_for(const SeriesDrawing& series, const PanelScale& scale) {
  const MarkLabel label{.series = &series, .text = entry_of(series).label};
  if (is_named_line_across(series))
    return series.looks.style == SeriesStyle::vertical_line
               ? beside_vertical(label, scale.across(series.places.front()))
               : beside_horizontal(label, scale.down(series.places.front()), scale.size);
  if (is_line(series.looks.style) && series.label_place == LabelPlace::middle && !series.label.empty())
    return beside_middle(label, parts_inside(series, scale));
  if (is_named_point(series)) {
    const PlotRow& at = series.runs.front().front();
    return beside_end(label, {scale.across(at.x), scale.down(at.y)});
  }
  return {};
}

}  // namespace

std::vector<MarkLabel> mark_labels_of(const PanelDrawing& panel, std::vector<EndLabel>& ends,
                                      const PanelScale& scale) {
  std::vector<MarkLabel> labels;
  const auto across = static_cast<std::size_t>(std::ranges::count_if(panel.series, is_named_line_across));
  Obstacles obstacles = obstacles_of(panel, ends, scale);
  const auto take_first_free = [&](const std::vector<MarkLabel>& places) {
    const auto found = std::ranges::find_if(
        places, [&](const MarkLabel& label) { return is_free(box_of(label), obstacles); });
    if (found == places.end()) return false;
    obstacles.texts.push_back(box_of(*found));
    labels.push_back(*found);
    return true;
  };
  for (const SeriesDrawing& series : panel.series)
    if (!is_named_line_across(series) || across <= most_named_lines_across)
      take_first_free(places_for(series, scale));
  std::erase_if(ends, [&](const EndLabel& end) {
    const MarkLabel label{.series = end.series, .text = entry_of(*end.series).label};
    return ends_early(end, scale.size) && take_first_free(beside_end(label, end.line_end));
  });
  return labels;
}

std::string mark_labels_svg(const std::vector<MarkLabel>& labels) {
  constexpr std::array<const char*, 3> anchors{"", " dp-centred", " dp-to-end"};
  if (labels.empty()) return {};
  std::string svg = "<g class=\"dp-marks\">\n";
  for (const MarkLabel& label : labels)
    svg += fmt::format(
        "<g{} data-label=\"{}\"><text class=\"dp-mark-label{}\" x=\"{}\" y=\"{}\">{}</text></g>\n",
        colour_attributes(label.series->looks.colour, "dp-mark"), xml_text(entry_of(*label.series).label),
        anchors[static_cast<std::size_t>(label.anchor)], px(label.at.x), px(label.at.y),
        xml_text(label.text));
  return svg + "</g>\n";
}

}  // namespace dashpad::output
