// What several figures of a study have in common: axes, limits, rows that struck through.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <random>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/plot/drawing.hpp"
#include "output/plot/study_figures.hpp"
#include "output/text/factor_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

Axis axis_of_factor(const study::Factor& factor, const UnitSystem& units) {
  const std::string unit = shown_as(factor.unit, units).unit;
  return {.label = factor_title(factor.key) + (unit.empty() ? "" : fmt::format(" ({})", unit))};
}

std::vector<Series> limit_lines(const study::StudyAnswers& answers, const std::string& response,
                                SeriesStyle style, const UnitSystem& units) {
  std::vector<Series> lines;
  for (const study::StudyLimit& limit : answers.limits) {
    if (limit.response != response) continue;
    const std::string unit = si_unit_of(response);
    lines.push_back({.label = "limit " + brief_quantity(limit.value, unit, units), .style = style});
    (style == SeriesStyle::vertical_line ? lines.back().x : lines.back().y)
        .push_back(shown_as(unit, units).scale * limit.value);
  }
  return lines;
}

Series struck_through_marks(std::size_t colour) {
  constexpr std::size_t triangle = 2;
  static_assert(std::gcd(colours_by_turn, shapes_by_turn) == 1, "then every pair has a turn");
  std::size_t turn = triangle;
  while (turn % colours_by_turn != colour % colours_by_turn) turn += shapes_by_turn;
  return {.label = "bottomed out: no finite force", .style = SeriesStyle::points, .turn = turn};
}

double above_all(const std::vector<Series>& series) {
  constexpr double part_above = 0.06;
  Span all;
  for (const Series& of : series)
    for (const auto* column : {&of.y, &of.y2})
      for (const double value : *column)
        if (std::isfinite(value)) all.include(value);
  return all.is_empty() ? 0 : all.high + part_above * (all.high > all.low ? all.high - all.low : all.high);
}

std::vector<std::size_t> rows_drawn(std::size_t count, std::size_t most) {
  std::vector<std::size_t> all(count), drawn;
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::ranges::sample(all, std::back_inserter(drawn), static_cast<std::ptrdiff_t>(most), std::mt19937_64{});
  return drawn;
}

std::string study_source(const study::StudyAnswers& answers) {
  return fmt::format("dashpad {}; {} rows; {}", version(), answers.records.rows.size(),
                     one_line(answers.study.title));
}

}  // namespace dashpad::output
