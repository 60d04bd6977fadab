// Rows of sampled factors as points, coloured by a response.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "output/plot/study_figures.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_coloured_dots = 1000;

/// Rows of a group: two factors and the response, as shown. Those that struck through stand apart.
struct Rows {
  std::vector<double> x, y, value;
  Series struck = struck_through_marks();
};

/// Pearson's correlation over the rows of a group that have a value; 0 where nothing varies.
double correlation(const std::vector<std::size_t>& places, const std::vector<double>& a,
                   const std::vector<double>& b) {
  double n = 0, mean_a = 0, mean_b = 0, aa = 0, bb = 0, ab = 0;
  for (const std::size_t place : places) {
    if (!std::isfinite(b[place])) continue;
    ++n;
    const double from_a = a[place] - mean_a, from_b = b[place] - mean_b;
    mean_a += from_a / n;
    mean_b += from_b / n;
    aa += from_a * (a[place] - mean_a);
    bb += from_b * (b[place] - mean_b);
    ab += from_a * (b[place] - mean_b);
  }
  return aa > 0 && bb > 0 ? ab / std::sqrt(aa * bb) : 0;
}

/// The two sampled factors that the response follows most; fewer where there are fewer.
std::vector<std::size_t> leading_factors(const study::StudyAnswers& answers,
                                         const std::vector<double>& response) {
  const std::vector<std::size_t>& places = answers.groups.front().group.places;
  std::vector<std::pair<double, std::size_t>> order;
  for (const std::size_t factor : sampled_factors(answers.study))
    order.emplace_back(-std::abs(correlation(places, answers.records.factors[factor], response)), factor);
  std::ranges::stable_sort(order, {}, &std::pair<double, std::size_t>::first);
  std::vector<std::size_t> leading;
  for (std::size_t i = 0; i < std::min<std::size_t>(2, order.size()); ++i) leading.push_back(order[i].second);
  return leading;
}

/// Levels over the middle 98 % of the values, so that a few far away do not leave one colour for all others.
std::vector<double> levels_of(std::vector<double> values) {
  if (values.empty()) return {};
  std::ranges::sort(values);
  const std::size_t cut = values.size() / 100;
  return round_levels(values[cut], values[values.size() - 1 - cut]);
}

std::vector<Series> classes(const Rows& rows, const std::vector<double>& levels, const std::string& unit) {
  std::vector<Series> list;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    list.push_back(class_of_levels(levels, i, unit));
    list.back().style = SeriesStyle::points;
  }
  for (std::size_t row = 0; row < rows.value.size(); ++row) {
    const auto above = std::ranges::upper_bound(levels, rows.value[row]) - levels.begin();
    const auto place = std::clamp<std::ptrdiff_t>(above - 1, 0, std::ssize(list) - 1);
    Series& series = list[static_cast<std::size_t>(place)];
    series.add(rows.x[row], rows.y[row]);
  }
  std::erase_if(list, [](const Series& series) { return series.x.empty(); });
  return list;
}

Rows rows_of(const study::StudyAnswers& answers, const std::vector<std::size_t>& factors, std::size_t number,
             double scale, const UnitSystem& units) {
  const std::vector<std::size_t>& places = answers.groups.front().group.places;
  const double x = shown_as(answers.study.factors[factors[0]].unit, units).scale,
               y = shown_as(answers.study.factors[factors[1]].unit, units).scale;
  const std::vector<double> values =
      study::values_of(answers.study, answers.records, answers.groups.front().group, number);
  Rows rows;
  for (const std::size_t i : rows_drawn(places.size(), max_coloured_dots)) {
    if (std::isnan(values[i])) continue;
    const bool has_value = std::isfinite(values[i]);
    (has_value ? rows.x : rows.struck.x).push_back(x * answers.records.factors[factors[0]][places[i]]);
    (has_value ? rows.y : rows.struck.y).push_back(y * answers.records.factors[factors[1]][places[i]]);
    if (has_value) rows.value.push_back(scale * values[i]);
  }
  return rows;
}

}  // namespace

std::vector<CaptionedPlot> coloured_scatter_figures(const study::StudyAnswers& answers,
                                                    const UnitSystem& units) {
  std::vector<CaptionedPlot> figures;
  for (const std::size_t response : answers.responses) {
    const std::vector<double>& values = answers.records.responses[response];
    const std::vector<std::size_t> leading = leading_factors(answers, values);
    if (leading.size() < 2) return {};
    const std::string& name = answers.study.responses[response];
    const ScaledUnit shown = shown_as(si_unit_of(name), units);
    const Rows rows = rows_of(answers, leading, response, shown.scale, units);
    const std::vector<double> levels = levels_of(rows.value);
    if (levels.size() < 3) continue;
    const study::Factor &across = answers.study.factors[leading[0]], &up = answers.study.factors[leading[1]];
    std::vector<Series> points = classes(rows, levels, shown.unit);
    if (!rows.struck.x.empty()) points.push_back(rows.struck);
    figures.push_back(study_figure(
        answers,
        fmt::format("{} against {} and {}", title_of(name), factor_words(across.key), factor_words(up.key)),
        {{title_of(name), axis_of_factor(across, units), axis_of_factor(up, units), std::move(points)}},
        fmt::format(
            "Each point is one row, plotted against the two sampled factors that most affect the response. "
            "The first and last classes include all values beyond them. At most {} rows{} are drawn.",
            max_coloured_dots,
            answers.groups.size() > 1
                ? " (" + words_of_levels(answers, answers.groups.front().group, units) + ")"
                : "")));
  }
  return figures;
}

}  // namespace dashpad::output
