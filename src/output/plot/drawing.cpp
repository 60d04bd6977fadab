#include "output/plot/drawing.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "output/svg/svg.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t longest_label = 90;

/// Hands out the turns that nobody has been given, in the order in which it is asked.
class Turns {
 public:
  explicit Turns(const Plot& plot) {
    for (const Panel& panel : plot.panels)
      for (const Series& series : panel.series)
        if (series.palette_index) given_.insert(*series.palette_index);
  }

  std::size_t turn_of(const Series& series) {
    if (series.palette_index) return *series.palette_index;
    if (is_marker(series.style)) return 0;
    if (series.label.empty()) return next();
    const auto known = of_label_.find(series.label);
    return known != of_label_.end() ? known->second : of_label_[series.label] = next();
  }

 private:
  std::size_t next() {
    std::size_t palette_index = 0;
    while (!given_.insert(palette_index).second) ++palette_index;
    return palette_index;
  }

  std::set<std::size_t> given_;
  std::map<std::string, std::size_t> of_label_;
};

SeriesColour colour_of(const Series& series, std::size_t palette_index) {
  if (series.shade) return {.shade = colour_of_shade(*series.shade)};
  if (is_marker(series.style) && !series.palette_index) return {.class_name = "dp-grey"};
  return {.class_name = fmt::format("dp-turn-{}", palette_index % colours_by_turn)};
}

/// The values that the axis can show.
std::vector<double> shown(const std::vector<double>& values, const Axis& axis) {
  std::vector<double> result;
  for (const double value : values) {
    if (is_drawable(value, axis) && is_within_limits(value, axis)) result.push_back(value);
  }
  return result;
}

SeriesDrawing drawing_of(const Series& series, const Panel& panel) {
  SeriesDrawing drawing{.label = series.label,
                        .end_label = series.end_label,
                        .of = series.of,
                        .label_place = series.label_place,
                        .is_cased = series.is_cased,
                        .has_arrow = series.has_arrow};
  if (series.style == SeriesStyle::vertical_line)
    drawing.places = shown(series.x, panel.x);
  else if (series.style == SeriesStyle::horizontal_line)
    drawing.places = shown(series.y, panel.y);
  else
    drawing.runs = drawable_runs(series, panel.x, panel.y);
  return drawing;
}

/// Points of a line with a gap on either side, which no line can show.
PlotRun lone_points(const SeriesDrawing& drawing) {
  PlotRun points;
  if (drawing.looks.style == SeriesStyle::points || is_ground(drawing.looks.style)) return points;
  for (const PlotRun& run : drawing.runs) {
    if (run.size() == 1) points.push_back(run.front());
  }
  return points;
}

/// The span with the given ends of the axis.
Span with_limits(Span span, const Axis& axis) {
  return {.low = axis.low.value_or(span.low), .high = axis.high.value_or(span.high)};
}

/// A line across at the very top would have no room for its name.
void leave_room_above_lines(PanelDrawing& drawing, const Axis& y) {
  constexpr double height_of_name = 0.06;  // as a share of the axis
  if (y.logarithmic || y.high) return;
  const double room = height_of_name * (drawing.y.high - y.low.value_or(drawing.y.low));
  if (!std::isfinite(room) || room <= 0) return;
  for (const SeriesDrawing& series : drawing.series)
    if (series.looks.style == SeriesStyle::horizontal_line && !series.label.empty())
      for (const double place : series.places) drawing.y.include(place + room);
}

/// Finds what the axes have to include; along y only what the x axis shows counts.
void find_spans(PanelDrawing& drawing, const Panel& panel) {
  Span shown_y, all_y;
  const auto include = [&](const PlotRow& row) {
    drawing.x.include(row.x);
    for (const double value : {row.y, row.y2}) {
      all_y.include(value);
      if (is_within_limits(row.x, panel.x)) shown_y.include(value);
    }
  };
  for (const SeriesDrawing& series : drawing.series)
    for (const PlotRun& run : series.runs) std::ranges::for_each(run, include);
  drawing.y = shown_y.is_empty() ? all_y : shown_y;
  for (const SeriesDrawing& series : drawing.series) {
    Span& lines = series.looks.style == SeriesStyle::vertical_line ? drawing.x : drawing.y;
    for (const double place : series.places) lines.include(place);
  }
  leave_room_above_lines(drawing, panel.y);
}

void thin(PanelDrawing& drawing, const Panel& panel) {
  const Span x = with_limits(drawing.x, panel.x), y = with_limits(drawing.y, panel.y);
  for (SeriesDrawing& series : drawing.series) {
    if (series.looks.style == SeriesStyle::area) continue;
    for (PlotRun& run : series.runs) {
      run = series.looks.style == SeriesStyle::points ? thinned_points(run, panel.x, x, panel.y, y)
                                                      : thinned_line(run, panel.x, x);
    }
  }
}

PanelDrawing drawing_of(const Panel& panel, Turns& turns) {
  PanelDrawing result;
  for (const Series& series : panel.series) {
    SeriesDrawing drawing = drawing_of(series, panel);
    if (drawing.runs.empty() && drawing.places.empty()) continue;
    drawing.looks = looks_of(series, turns.turn_of(series));
    add_to(result.named, entry_of(drawing));
    if (!drawing.runs.empty()) result.has_data = true;
    if (PlotRun dots = lone_points(drawing); !dots.empty())
      result.series.push_back(
          {.label = series.label,
           .looks = {.style = SeriesStyle::points, .colour = drawing.looks.colour, .is_dot = true},
           .runs = {std::move(dots)}});
    result.series.push_back(std::move(drawing));
  }
  std::stable_partition(result.series.begin(), result.series.end(),
                        [](const SeriesDrawing& series) { return is_ground(series.looks.style); });
  find_spans(result, panel);
  thin(result, panel);
  return result;
}

}  // namespace

bool is_marker(SeriesStyle style) {
  return style == SeriesStyle::vertical_line || style == SeriesStyle::horizontal_line;
}

bool is_line(SeriesStyle style) {
  return style == SeriesStyle::line || style == SeriesStyle::solid_line || style == SeriesStyle::dashed_line;
}

bool is_ground(SeriesStyle style) { return style == SeriesStyle::band || style == SeriesStyle::area; }

std::string colour_of_shade(double shade) {
  constexpr std::array<Colour, 9> scale{{{68, 1, 84},
                                         {71, 44, 122},
                                         {59, 81, 139},
                                         {44, 113, 142},
                                         {33, 144, 141},
                                         {39, 173, 129},
                                         {92, 200, 99},
                                         {170, 220, 50},
                                         {253, 231, 37}}};
  return colour_on_scale(scale, shade);
}

Looks looks_of(const Series& series, std::size_t palette_index) {
  Looks looks{.style = series.style, .colour = colour_of(series, palette_index)};
  switch (series.style) {
    case SeriesStyle::line:
      // Lines that lie on each other stay visible: the later ones are narrower, and only the first is solid.
      looks.width = std::max(1.5, 2.2 - 0.15 * static_cast<double>(palette_index));
      looks.pattern = palette_index % dashes_by_turn;
      break;
    case SeriesStyle::solid_line: looks.width = 2; break;
    case SeriesStyle::dashed_line:
      looks.width = 2;
      looks.pattern = 1;
      break;
    case SeriesStyle::points: looks.pattern = palette_index % shapes_by_turn; break;
    case SeriesStyle::vertical_line:
    case SeriesStyle::horizontal_line: looks.width = 1.4; break;
    case SeriesStyle::band:
    case SeriesStyle::area: break;
  }
  return looks;
}

void add_to(std::vector<LegendEntry>& entries, const LegendEntry& entry) {
  if (entry.label.empty() || std::ranges::find(entries, entry) != entries.end()) return;
  entries.push_back(entry);
}

LegendEntry entry_of(const SeriesDrawing& series) {
  return {.label = shortened(series.label, longest_label), .looks = series.looks};
}

std::vector<PanelDrawing> drawings_of(const Plot& plot) {
  std::vector<PanelDrawing> drawings;
  Turns turns{plot};
  for (const Panel& panel : plot.panels) drawings.push_back(drawing_of(panel, turns));
  if (std::ranges::none_of(drawings, &PanelDrawing::has_data))
    throw std::invalid_argument("the plot has no data: no series has a point that can be shown on its axes");
  return drawings;
}

}  // namespace dashpad::output
