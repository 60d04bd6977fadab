#include "output/plot/check.hpp"

#include <stdexcept>

#include <fmt/format.h>

#include "output/plot/rows.hpp"
#include "output/svg/text.hpp"

namespace dashpad::output {

namespace {

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
    throw std::invalid_argument(fmt::format("the axis \"{}\" ends at {}, not above its beginning at {}", name,
                                            *axis.high, *axis.low));
}

}  // namespace

void check(const Panel& panel) {
  check(panel.x);
  check(panel.y);
  for (const Series& series : panel.series) check(series);
}

}  // namespace dashpad::output
