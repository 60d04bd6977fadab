#include "output/plot/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

#include "output/svg/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t longest_label = 90;

/// Those of the values that the axis can show.
std::vector<double> shown(const std::vector<double>& values, const Axis& axis) {
  std::vector<double> result;
  for (const double value : values) {
    if (is_drawable(value, axis) && value >= axis.low.value_or(value) && value <= axis.high.value_or(value))
      result.push_back(value);
  }
  return result;
}

SeriesDrawing drawing_of(const Series& series, const Panel& panel) {
  SeriesDrawing drawing{.label = series.label,
                        .end_label = series.end_label,
                        .of = series.of,
                        .label_place = series.label_place,
                        .is_cased = series.is_cased,
                        .has_arrow = series.has_arrow,
                        .looks = {},
                        .runs = {},
                        .places = {}};
  if (series.style == SeriesStyle::vertical_line)
    drawing.places = shown(series.x, panel.x);
  else if (series.style == SeriesStyle::horizontal_line)
    drawing.places = shown(series.y, panel.y);
  else
    drawing.runs = drawable_runs(series, panel.x, panel.y);
  return drawing;
}

/// Those points of a line that have a gap on either side, which no line can show.
PlotRun lone_points(const SeriesDrawing& drawing) {
  PlotRun points;
  if (drawing.looks.style == SeriesStyle::points || is_ground(drawing.looks.style)) return points;
  for (const PlotRun& run : drawing.runs) {
    if (run.size() == 1) points.push_back(run.front());
  }
  return points;
}

/// Where an axis ends for certain.
Span with_limits(Span span, const Axis& axis) {
  return {.low = axis.low.value_or(span.low), .high = axis.high.value_or(span.high)};
}

/// Calls `use` for each row of the panel.
template <typename Use>
void for_rows(const PanelDrawing& drawing, const Use& use) {
  for (const SeriesDrawing& series : drawing.series)
    for (const PlotRun& run : series.runs)
      for (const PlotRow& row : run) use(row);
}

/// A line across at the very top would have no room for its name.
void leave_room_above_lines(PanelDrawing& drawing, const Axis& y) {
  constexpr double height_of_name = 0.06;  // of the axis
  if (y.logarithmic || y.high) return;
  const double room = height_of_name * (drawing.y.high - y.low.value_or(drawing.y.low));
  if (!std::isfinite(room) || room <= 0) return;
  for (const SeriesDrawing& series : drawing.series)
    if (series.looks.style == SeriesStyle::horizontal_line && !series.label.empty())
      for (const double place : series.places) drawing.y.include(place + room);
}

/// What the axes have to include: along y, what the x axis shows.
void find_spans(PanelDrawing& drawing, const Panel& panel) {
  Span shown_y, all_y;
  for_rows(drawing, [&](const PlotRow& row) {
    drawing.x.include(row.x);
    const bool is_shown = row.x >= panel.x.low.value_or(row.x) && row.x <= panel.x.high.value_or(row.x);
    for (const double value : {row.y, row.y2}) {
      all_y.include(value);
      if (is_shown) shown_y.include(value);
    }
  });
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
      result.series.push_back({.label = series.label,
                               .end_label = {},
                               .of = {},
                               .looks = looks_of_dot(drawing.looks),
                               .runs = {std::move(dots)},
                               .places = {}});
    result.series.push_back(std::move(drawing));
  }
  std::stable_partition(result.series.begin(), result.series.end(),
                        [](const SeriesDrawing& series) { return is_ground(series.looks.style); });
  find_spans(result, panel);
  thin(result, panel);
  return result;
}

}  // namespace

LegendEntry entry_of(const SeriesDrawing& series) {
  return {.label = shortened(series.label, longest_label), .looks = series.looks};
}

PlotDrawing drawing_of(const Plot& plot) {
  PlotDrawing result;
  Turns turns{plot};
  for (const Panel& panel : plot.panels) result.panels.push_back(drawing_of(panel, turns));
  if (std::ranges::none_of(result.panels, &PanelDrawing::has_data))
    throw std::invalid_argument("the plot has no data: no series has a point that its axes can show");
  return result;
}

}  // namespace dashpad::output
