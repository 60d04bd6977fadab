#include "output/plot/axis_ticks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <span>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

#include "output/svg/svg.hpp"

namespace dashpad::output {

namespace {

/// Differences of larger numbers need not be numbers.
constexpr double largest_drawn = 1e300;

// Cells of the axes, which are about 800 by 330 pixels large.
constexpr int columns_of_lines = 1600, columns_of_points = 530, rows_of_points = 220;
constexpr std::size_t few_points = 20'000;

double on_scale(double value, const Axis& axis) { return axis.logarithmic ? std::log10(value) : value; }
double from_scale(double place, const Axis& axis) { return axis.logarithmic ? std::pow(10, place) : place; }

/// Divides an axis into `count` cells. Cell -1 is everything before it, cell `count` everything behind it.
class AxisCells {
 public:
  AxisCells(const Axis& axis, const Span& span, int count)
      : axis_(axis),
        count_(count),
        begin_(on_scale(span.low, axis)),
        scale_(count / (on_scale(span.high, axis) - begin_)) {
    // An empty span has only one cell.
    if (!std::isfinite(scale_)) scale_ = 0;
  }
  [[nodiscard]] int cell(double value) const {
    return static_cast<int>(
        std::clamp(std::floor((on_scale(value, axis_) - begin_) * scale_), -1.0, 1.0 * count_));
  }

 private:
  const Axis& axis_;
  int count_;
  double begin_, scale_;
};

bool is_beyond(const Span& span, const Axis& axis) {
  return span.high < axis.low.value_or(span.high) || span.low > axis.high.value_or(span.low);
}

bool is_beyond(const PlotRun& run, const Axis& x_axis, const Axis& y_axis) {
  Span x, y;
  for (const PlotRow& row : run) {
    x.include(row.x);
    y.include(row.y);
    y.include(row.y2);
  }
  return is_beyond(x, x_axis) || is_beyond(y, y_axis);
}

/// Adds points at the ends of the x axis, since the ends of the y axis depend on the points shown.
PlotRun with_crossings(const PlotRun& run, const Axis& x, const Axis& y) {
  PlotRun result;
  for (const PlotRow& row : run) {
    if (!result.empty()) {
      const PlotRow before = result.back();
      std::vector<double> ends;
      for (const auto& end : {x.low, x.high}) {
        if (end && (before.x < *end) != (row.x < *end)) ends.push_back(*end);
      }
      if (row.x < before.x) std::ranges::reverse(ends);
      for (const double end : ends) {
        const double begin = on_scale(before.x, x);
        const double part = (on_scale(end, x) - begin) / (on_scale(row.x, x) - begin);
        const auto between = [&](double a, double b) {
          return from_scale(std::lerp(on_scale(a, y), on_scale(b, y), part), y);
        };
        result.push_back({.x = end, .y = between(before.y, row.y), .y2 = between(before.y2, row.y2)});
      }
    }
    result.push_back(row);
  }
  return result;
}

/// Adds to `kept` the rows of run[begin, end) that leave a trace of their own.
void keep_extremes(const PlotRun& run, std::size_t begin, std::size_t end, PlotRun& kept) {
  std::array<std::size_t, 6> places{begin, begin, begin, begin, begin, end - 1};
  for (std::size_t row = begin; row < end; ++row) {
    if (run[row].y < run[places[1]].y) places[1] = row;
    if (run[row].y > run[places[2]].y) places[2] = row;
    if (run[row].y2 < run[places[3]].y2) places[3] = row;
    if (run[row].y2 > run[places[4]].y2) places[4] = row;
  }
  std::ranges::sort(places);
  for (const std::size_t place : std::span(places.begin(), std::unique(places.begin(), places.end())))
    kept.push_back(run[place]);
}

void check(const Series& series) {
  if (series.style == SeriesStyle::vertical_line || series.style == SeriesStyle::horizontal_line) return;
  const bool has_second = series.style == SeriesStyle::band;
  if (series.x.size() != series.y.size() || (has_second && series.y2.size() != series.y.size()))
    throw std::invalid_argument(
        fmt::format("the columns of the series \"{}\" differ in length", readable(series.label)));
}

void check(const Axis& axis) {
  const auto name = readable(axis.label);
  for (const auto& limit : {axis.low, axis.high}) {
    if (limit && !is_drawable(*limit, axis))
      throw std::invalid_argument(fmt::format("the axis \"{}\" cannot end at {}", name, *limit));
  }
  if (axis.low && axis.high && !(*axis.low < *axis.high))
    throw std::invalid_argument(fmt::format("the axis \"{}\" ends at {}, which is not above its start at {}",
                                            name, *axis.high, *axis.low));
}

}  // namespace

void Span::include(double value) {
  low = std::min(low, value);
  high = std::max(high, value);
}

bool is_drawable(double value, const Axis& axis) {
  return std::abs(value) <= largest_drawn && (!axis.logarithmic || value > 0);
}

bool is_within_limits(double value, const Axis& axis) {
  return value >= axis.low.value_or(value) && value <= axis.high.value_or(value);
}

void check(const Panel& panel) {
  check(panel.x);
  check(panel.y);
  for (const Series& series : panel.series) check(series);
}

std::vector<PlotRun> drawable_runs(const Series& series, const Axis& x, const Axis& y) {
  const std::vector<double>& y2 = series.style == SeriesStyle::band ? series.y2 : series.y;
  std::vector<PlotRun> runs(1);
  for (std::size_t row = 0; row < series.x.size(); ++row) {
    if (is_drawable(series.x[row], x) && is_drawable(series.y[row], y) && is_drawable(y2[row], y))
      runs.back().push_back({.x = series.x[row], .y = series.y[row], .y2 = y2[row]});
    else if (!runs.back().empty())
      runs.emplace_back();
  }
  std::erase_if(runs, [&](const PlotRun& run) { return run.empty() || is_beyond(run, x, y); });
  if (series.style != SeriesStyle::points && series.style != SeriesStyle::area) {
    for (PlotRun& run : runs) run = with_crossings(run, x, y);
  }
  return runs;
}

PlotRun thinned_line(const PlotRun& run, const Axis& x, const Span& span) {
  const AxisCells columns{x, span, columns_of_lines};
  PlotRun kept;
  for (std::size_t first = 0, end = 0; first < run.size(); first = end) {
    const int column = columns.cell(run[first].x);
    while (end < run.size() && columns.cell(run[end].x) == column) ++end;
    keep_extremes(run, first, end, kept);
  }
  return kept;
}

PlotRun thinned_points(const PlotRun& run, const Axis& x, const Span& x_span, const Axis& y,
                       const Span& y_span) {
  if (run.size() <= few_points) return run;
  const AxisCells columns{x, x_span, columns_of_points}, rows{y, y_span, rows_of_points};
  std::set<std::pair<int, int>> taken;
  PlotRun kept;
  for (const PlotRow& row : run) {
    if (taken.emplace(columns.cell(row.x), rows.cell(row.y)).second) kept.push_back(row);
  }
  return kept;
}

}  // namespace dashpad::output
