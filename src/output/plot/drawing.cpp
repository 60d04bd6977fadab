#include "output/plot/drawing.hpp"

#include <algorithm>
#include <stdexcept>
#include <utility>

#include "output/plot/text.hpp"

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
  SeriesDrawing drawing{.style = series.style, .looks = {}, .runs = {}, .places = {}};
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
  if (drawing.style == SeriesStyle::points || is_ground(drawing.style)) return points;
  for (const PlotRun& run : drawing.runs) {
    if (run.size() == 1) points.push_back(run.front());
  }
  return points;
}

/// Where an axis ends for certain.
Span with_limits(Span span, const Axis& axis) {
  return {.low = axis.low.value_or(span.low), .high = axis.high.value_or(span.high)};
}

void thin(PanelDrawing& drawing, const Panel& panel) {
  Span x, y;
  for (const SeriesDrawing& series : drawing.series) {
    for (const PlotRun& run : series.runs) {
      for (const PlotRow& row : run) {
        x.include(row.x);
        y.include(row.y);
      }
    }
  }
  x = with_limits(x, panel.x);
  y = with_limits(y, panel.y);
  for (SeriesDrawing& series : drawing.series) {
    if (series.style == SeriesStyle::area) continue;
    for (PlotRun& run : series.runs) {
      run = series.style == SeriesStyle::points ? thinned_points(run, panel.x, x, panel.y, y)
                                                : thinned_line(run, panel.x, x);
    }
  }
}

PanelDrawing drawing_of(const Panel& panel, Turns& turns, Legend& legend) {
  PanelDrawing result;
  for (const Series& series : panel.series) {
    SeriesDrawing drawing = drawing_of(series, panel);
    if (drawing.runs.empty() && drawing.places.empty()) continue;
    const std::size_t turn = turns.turn_of(series);
    drawing.looks = looks(series, turn);
    legend.add({shortened(series.label, longest_label), drawing.looks});
    if (!drawing.runs.empty()) {
      result.has_data = true;
      if (!series.end_label.empty())
        result.end_labels.push_back(
            end_label_of(series, colour_of(series, turn), drawing.runs.back().back(), panel.y));
    }
    Span& lines =
        series.style == SeriesStyle::vertical_line ? result.vertical_lines : result.horizontal_lines;
    for (const double place : drawing.places) lines.include(place);
    if (PlotRun dots = lone_points(drawing); !dots.empty())
      result.series.push_back({.style = SeriesStyle::points,
                               .looks = looks_of_dot(turn),
                               .runs = {std::move(dots)},
                               .places = {}});
    result.series.push_back(std::move(drawing));
  }
  std::stable_partition(result.series.begin(), result.series.end(),
                        [](const SeriesDrawing& series) { return is_ground(series.style); });
  thin(result, panel);
  make_room(result.end_labels);
  return result;
}

}  // namespace

PlotDrawing drawing_of(const Plot& plot) {
  PlotDrawing result;
  Turns turns{plot};
  for (const Panel& panel : plot.panels) result.panels.push_back(drawing_of(panel, turns, result.legend));
  if (std::ranges::none_of(result.panels, &PanelDrawing::has_data))
    throw std::invalid_argument("the plot has no data: no series has a point that its axes can show");
  return result;
}

}  // namespace dashpad::output
