#include "output/plot/study_figures.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>
#include <random>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/plot/drawing.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Levels of all factors with levels, and the response there.
struct Cell {
  std::vector<double> levels;
  double value = 0;
  double low = 0, high = 0;  ///< range that holds 90 % of the draws
};

std::vector<Cell> cells_of(const study::StudyAnswers& answers, std::size_t response) {
  std::vector<Cell> cells;
  const std::vector<std::size_t> factors = level_factors(answers.study);
  if (answers.groups.front().group.drawn) {
    for (const study::StudyAnswers::OfGroup& group : answers.groups) {
      const auto at = [&](double probability) {
        const auto found = study::quantile(group.distributions[response], probability);
        return found ? found->value : std::numeric_limits<double>::quiet_NaN();
      };
      cells.push_back({group.group.levels, at(0.5), at(0.05), at(0.95)});
    }
    return cells;
  }
  const study::Group& all = answers.groups.front().group;
  const std::vector<double> values =
      study::values_of(answers.study, answers.records, all, answers.responses[response]);
  for (std::size_t i = 0; i < all.places.size(); ++i) {
    const std::size_t place = all.places[i];
    Cell cell{.levels = {}, .value = values[i]};
    for (const std::size_t factor : factors) cell.levels.push_back(answers.records.factors[factor][place]);
    cells.push_back(std::move(cell));
  }
  return cells;
}

const std::vector<double>& levels_of(const study::Factor& factor) { return *factor.given_values(); }

std::vector<double> sorted(std::vector<double> values) {
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  return values;
}

std::size_t place_in(const std::vector<double>& levels, double value) {
  return static_cast<std::size_t>(std::ranges::lower_bound(levels, value) - levels.begin());
}

}  // namespace

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
  std::size_t palette_index = triangle;
  while (palette_index % colours_by_turn != colour % colours_by_turn) palette_index += shapes_by_turn;
  return {
      .label = "bottomed out: no finite force", .style = SeriesStyle::points, .palette_index = palette_index};
}

double above_all(const std::vector<Series>& series) {
  constexpr double part_above = 0.06;
  Span all;
  for (const Series& each : series)
    for (const auto* column : {&each.y, &each.y2})
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

CaptionedPlot study_figure(const study::StudyAnswers& answers, std::string title, std::vector<Panel> panels,
                           std::string note) {
  return {.plot = {.title = std::move(title),
                   .panels = std::move(panels),
                   .source = fmt::format("dashpad {}; {} rows; {}", version(), answers.records.rows.size(),
                                         one_line(answers.study.title))},
          .note = std::move(note)};
}

std::optional<GridPlane> grid_plane(const study::StudyAnswers& answers, std::size_t response,
                                    const UnitSystem& units) {
  const std::vector<std::size_t> factors = level_factors(answers.study);
  // Rows of a table need not make a grid.
  if (study::table_rows(answers.study) > 1 && factors.size() > 1) return std::nullopt;
  // Places in `factors`: numbers before materials, many levels before few.
  std::vector<std::size_t> order(factors.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  const auto factor_at = [&](std::size_t i) -> const study::Factor& {
    return answers.study.factors[factors[i]];
  };
  std::ranges::stable_sort(order, [&](std::size_t a, std::size_t b) {
    const bool a_number = !factor_at(a).unit.empty(), b_number = !factor_at(b).unit.empty();
    return a_number != b_number ? a_number : levels_of(factor_at(a)).size() > levels_of(factor_at(b)).size();
  });
  if (order.empty() || factor_at(order[0]).unit.empty() || levels_of(factor_at(order[0])).size() < 2)
    return std::nullopt;

  GridPlane plane;
  plane.across = factors[order[0]];
  plane.is_median = answers.groups.front().group.drawn;
  plane.across_levels = sorted(levels_of(factor_at(order[0])));
  plane.line_levels = {0};
  if (order.size() > 1) {
    plane.lines = factors[order[1]];
    plane.line_levels = sorted(levels_of(factor_at(order[1])));
  }
  std::vector<double> middle(factors.size());
  for (std::size_t i = 2; i < order.size(); ++i) {
    const std::vector<double> levels = sorted(levels_of(factor_at(order[i])));
    middle[order[i]] = levels[levels.size() / 2];
    plane.at += (plane.at.empty() ? "" : ", ") +
                output::factor_at(answers.study, factors[order[i]], middle[order[i]], units);
  }
  plane.values.assign(
      plane.line_levels.size(),
      std::vector<double>(plane.across_levels.size(), std::numeric_limits<double>::quiet_NaN()));
  if (plane.is_median) plane.low = plane.high = plane.values;
  for (const Cell& cell : cells_of(answers, response)) {
    bool here = true;
    for (std::size_t i = 2; i < order.size(); ++i) here = here && cell.levels[order[i]] == middle[order[i]];
    if (!here) continue;
    const std::size_t line = plane.lines ? place_in(plane.line_levels, cell.levels[order[1]]) : 0;
    const std::size_t place = place_in(plane.across_levels, cell.levels[order[0]]);
    plane.values[line][place] = cell.value;
    if (!plane.is_median) continue;
    plane.low[line][place] = cell.low;
    plane.high[line][place] = cell.high;
  }
  return plane;
}

}  // namespace dashpad::output
