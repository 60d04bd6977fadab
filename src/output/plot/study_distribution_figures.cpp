// Distribution functions, scatter and indices of a study.

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "output/plot/study_figures.hpp"
#include "output/text/capitals.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_steps = 400;        ///< points of a distribution function
constexpr std::size_t max_plain_dots = 1000;  ///< dots of a scatter plot

/// The share of rows at or below each value; rows without a finite value count as above all.
Series distribution_function(std::vector<double> values, double scale) {
  const auto all = static_cast<double>(values.size());
  std::erase_if(values, [](double value) { return !std::isfinite(value); });
  std::ranges::sort(values);
  Series series{.style = SeriesStyle::solid_line};
  const std::size_t count = values.size();
  const std::size_t points = std::min(count, max_steps);
  for (std::size_t i = 0; i < points; ++i) {
    const std::size_t place = points < 2 ? 0 : i * (count - 1) / (points - 1);
    series.add(scale * values[place], 100 * static_cast<double>(place + 1) / all);
  }
  return series;
}

/// A line where a distribution ends because the rest struck through; nothing where none did.
std::optional<Series> struck_through_line(const std::vector<double>& values) {
  const auto all = static_cast<double>(values.size());
  const auto finite =
      static_cast<double>(std::ranges::count_if(values, [](double value) { return std::isfinite(value); }));
  const auto struck =
      static_cast<double>(std::ranges::count_if(values, [](double value) { return std::isinf(value); }));
  if (struck == 0) return std::nullopt;
  return Series{.label = fmt::format("{:.3g} % bottomed out", 100 * struck / all),
                .style = SeriesStyle::horizontal_line,
                .y = {100 * finite / all}};
}

Panel distribution_panel(const study::StudyAnswers& answers, std::size_t i, const UnitSystem& units) {
  const std::string name = response_name(answers, i);
  const double scale = shown_as(si_unit_of(name), units).scale;
  Panel panel{.title = title_of(name),
              .x = {.label = label(name, units)},
              .y = {.label = "Cumulative share of rows (%)", .low = 0, .high = 100}};
  for (std::size_t group = 0; group < std::min(answers.groups.size(), max_lines_drawn); ++group) {
    const study::Group& of = answers.groups[group].group;
    const std::vector<double> values =
        study::values_of(answers.study, answers.records, of, answers.responses[i]);
    panel.series.push_back(distribution_function(values, scale));
    panel.series.back().label = words_of_levels(answers, of, units);
    panel.series.back().palette_index = group;
    if (std::optional<Series> rest = struck_through_line(values)) {
      rest->palette_index = group;
      panel.series.push_back(*std::move(rest));
    }
  }
  panel.add(limit_lines(answers, name, SeriesStyle::vertical_line, units));
  return panel;
}

Panel scatter_panel(const study::StudyAnswers& answers, std::size_t factor, std::size_t response,
                    const UnitSystem& units) {
  const study::Factor& of = answers.study.factors[factor];
  const std::string& name = answers.study.responses[response];
  const ScaledUnit x = shown_as(of.unit, units), y = shown_as(si_unit_of(name), units);
  Panel panel{.title = fmt::format("{} against {}", title_of(name), factor_words(of.key)),
              .x = axis_of_factor(of, units),
              .y = {.label = label(name, units)}};
  const std::size_t groups = std::min(answers.groups.size(), max_lines_drawn);
  Series struck = struck_through_marks();
  for (std::size_t i = 0; i < groups; ++i) {
    const study::Group& group = answers.groups[i].group;
    const std::vector<std::size_t>& places = group.places;
    const std::vector<double> values = study::values_of(answers.study, answers.records, group, response);
    Series points{
        .label = words_of_levels(answers, group, units), .style = SeriesStyle::points, .palette_index = i};
    for (const std::size_t k : rows_drawn(places.size(), max_plain_dots / groups)) {
      Series& of_row = std::isinf(values[k]) ? struck : points;
      of_row.add(x.scale * answers.records.factors[factor][places[k]], y.scale * values[k]);
    }
    panel.series.push_back(std::move(points));
  }
  struck.y.assign(struck.x.size(), above_all(panel.series));
  if (!struck.x.empty()) panel.series.push_back(std::move(struck));
  return panel;
}

/// A point and its interval, a narrow band at that height.
void add_index(Panel& panel, const study::Estimate& estimate, double height, std::size_t palette_index,
               const std::string& name) {
  constexpr double half_width = 0.08;
  panel.series.push_back({.style = SeriesStyle::band,
                          .x = {estimate.low, estimate.high},
                          .y = {height - half_width, height - half_width},
                          .y2 = {height + half_width, height + half_width},
                          .palette_index = palette_index,
                          .of = name});
  panel.series.push_back({.label = name,
                          .style = SeriesStyle::points,
                          .x = {estimate.value},
                          .y = {height},
                          .palette_index = palette_index});
}

/// The factors below each other, that which matters most on top.
Panel index_panel(const std::string& response, const study::Sensitivity& sensitivity) {
  constexpr double apart = 0.14;
  std::vector<study::Sensitivity::Index> indices = sensitivity.indices;
  std::ranges::stable_sort(indices, std::ranges::greater(),
                           [](const study::Sensitivity::Index& index) { return index.total.value; });
  Panel panel{.title = title_of(response),
              .x = {.label = "Share of the variance"},
              .y = {.has_numbers = false, .low = 0.5, .high = static_cast<double>(indices.size()) + 0.5},
              .series = {{.style = SeriesStyle::vertical_line, .x = {0}}}};
  for (std::size_t i = 0; i < indices.size(); ++i) {
    const auto height = static_cast<double>(indices.size() - i);
    panel.series.push_back({.style = SeriesStyle::solid_line,
                            .x = {0, indices[i].total.value},
                            .y = {height - apart, height - apart},
                            .palette_index = 1,
                            .end_label = factor_title(indices[i].factor)});
    add_index(panel, indices[i].first, height + apart, 0, "by itself (first order)");
    add_index(panel, indices[i].total, height - apart, 1, "with interactions (total)");
  }
  return panel;
}

/// Whether rows lie anywhere along a factor: drawn values, or those of a table whose rows are no grid.
bool is_scattered(const study::StudyAnswers& answers, std::size_t factor) {
  const study::Factor& of = answers.study.factors[factor];
  if (of.is_sampled()) return true;
  const std::vector<double>& values = *of.given_values();
  return std::holds_alternative<study::ByRow>(of.spread) && !of.unit.empty() &&
         answers.study.factors.size() > 1 && !answers.groups.front().group.drawn &&
         std::ranges::any_of(values, [&](double value) { return value != values.front(); });
}

}  // namespace

std::vector<CaptionedPlot> distribution_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::vector<CaptionedPlot> figures;
  // A single row has no distribution.
  if (answers.records.rows.size() < 2) return figures;
  const std::string note =
      answers.groups.size() > max_lines_drawn
          ? fmt::format("Only the first {} combinations of levels are shown.", max_lines_drawn)
          : "";
  for (std::size_t i = 0; i < answers.responses.size(); ++i)
    figures.push_back(study_figure(answers,
                                   "Distribution of " + uncapitalised(title_of(response_name(answers, i))),
                                   {distribution_panel(answers, i, units)}, note));
  return figures;
}

std::vector<CaptionedPlot> scatter_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::vector<CaptionedPlot> figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    std::vector<Panel> panels;
    for (std::size_t factor = 0; factor < answers.study.factors.size(); ++factor)
      if (is_scattered(answers, factor))
        panels.push_back(scatter_panel(answers, factor, answers.responses[i], units));
    if (!panels.empty())
      figures.push_back(study_figure(
          answers, title_of(response_name(answers, i)) + " against each factor", std::move(panels),
          answers.records.rows.size() > max_plain_dots
              ? fmt::format("Only {} rows, chosen at random, are drawn.", max_plain_dots)
              : ""));
  }
  return figures;
}

std::vector<CaptionedPlot> index_figures(const study::StudyAnswers& answers) {
  std::vector<CaptionedPlot> figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::optional<study::Sensitivity>& sensitivity = answers.groups.front().sensitivities[i];
    if (sensitivity)
      figures.push_back(study_figure(answers, "Sobol' indices for " + title_of(response_name(answers, i)),
                                     {index_panel(response_name(answers, i), *sensitivity)},
                                     "Bands: 95 % intervals, bootstrapped over the draws."));
  }
  return figures;
}

}  // namespace dashpad::output
