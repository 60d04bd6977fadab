// What each number of a case does to the figures.

#include "dashpad/output/sensitivity.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include <fmt/format.h>

#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "output/text/capitals.hpp"
#include "output/text/sensitivity_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t max_rows = 8;

/// The figures of the table in short: those that people ask for first, and the chosen one.
std::vector<std::size_t> main_figures(const sensitivity::Answer& answer, std::size_t chosen) {
  std::vector<std::size_t> figures{chosen};
  for (const char* key : {"peak_acceleration", "hic15", "hic36", "peak_penetration", "rebound_speed"})
    for (std::size_t i = 0; i < answer.figures.size(); ++i)
      if (key == std::string(answer.figures[i]->key) && i != chosen) figures.push_back(i);
  return figures;
}

Table elasticities_table(const sensitivity::Answer& answer, const std::vector<std::size_t>& figures,
                         std::size_t sorted_by, std::size_t max) {
  Table table{.columns = {"1 % of"}};
  for (const std::size_t i : figures) table.columns.emplace_back(answer.figures[i]->title);
  for (const std::size_t k : by_effect(answer, sorted_by)) {
    if (table.rows.size() == max) break;
    std::vector<std::string> row{factor_title(answer.inputs[k].key)};
    for (const std::size_t i : figures) row.push_back(effect_words(answer.inputs[k].elasticities[i]));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// A figure a row: its derivative by a number in the units shown.
Table derivatives_table(const sensitivity::Answer& answer, std::size_t figure, const UnitSystem& units) {
  Table table{.columns = {"Number", "Value", "Derivative", "Error"}};
  const ScaledUnit shown = shown_as(answer.figures[figure]->si_unit, units);
  for (const std::size_t k : by_effect(answer, figure)) {
    const sensitivity::Input& input = answer.inputs[k];
    const ScaledUnit by = shown_as(input.unit, units);
    const double derivative = sensitivity::derivative(answer, k, figure) * shown.scale / by.scale;
    const sensitivity::Elasticity& elasticity = input.elasticities[figure];
    const std::string unit = by.unit.empty()      ? shown.unit
                             : shown.unit.empty() ? "per " + by.unit
                                                  : shown.unit + " per " + by.unit;
    table.rows.push_back(
        {factor_title(input.key), brief_quantity(input.value, input.unit, units, 4),
         std::isfinite(derivative) ? with_unit(brief(derivative, 4), unit) : to_string(elasticity.course),
         std::isfinite(derivative) && elasticity.value != 0
             ? percentage(elasticity.error / std::abs(elasticity.value))
             : "-"});
  }
  return table;
}

/// A figure a row: its 95 % interval by what is uncertain of foam and model, relative to it.
Table doubts_table(const sensitivity::Answer& answer, const std::vector<std::size_t>& figures) {
  Table table{.columns = {"Figure", "95 % interval"}};
  for (const std::size_t i : figures)
    if (const FigureInterval* const interval = answer.intervals->find(answer.figures[i]->key))
      table.rows.push_back({answer.figures[i]->title, interval_of_foam(*interval)});
  return table;
}

std::vector<ValueRow> rows_of(const sensitivity::Answer& answer, std::size_t figure,
                              const UnitSystem& units) {
  std::vector<ValueRow> rows;
  for (const std::size_t k : seen_effects(answer, figure, max_rows)) {
    const sensitivity::Input& input = answer.inputs[k];
    rows.push_back({.label = factor_title(input.key),
                    .value = effect_words(input.elasticities[figure]),
                    .remark = fmt::format("at {}{}", brief_quantity(input.value, input.unit, units, 4),
                                          input.is_one_sided ? ", to one side only: its bound" : "")});
  }
  return rows;
}

}  // namespace

Document sensitivity_document(const sensitivity::Answer& answer, std::size_t figure, const std::string& file,
                              const UnitSystem& units, Pictures pictures) {
  const std::string title = one_line(answer.impact.title);
  Document document{
      .title = title,
      .lead = Lead{.answer = sensitivity_answer(answer, figure),
                   .subject = {title.empty() ? "Case: " + file : fmt::format("Case: {} ({})", title, file),
                               fmt::format("{} {}; the rows show its change if one number grows by 1 %",
                                           answer.figures[figure]->title,
                                           brief_quantity(answer.values[figure],
                                                          answer.figures[figure]->si_unit, units, 4))},
                   .figures = rows_of(answer, figure, units)}};
  document.warnings = by_severity(answer.flags);
  const std::vector<std::size_t> main = main_figures(answer, figure);
  std::vector<std::size_t> all(answer.figures.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::vector<std::string> lines;
  if (answer.intervals)
    if (const FigureInterval* const interval = answer.intervals->find(answer.figures[figure]->key))
      lines.push_back(fmt::format("The uncertainty of foam and model changes it by {} (95 %).",
                                  interval_of_foam(*interval)));
  std::string bent;
  for (const sensitivity::Input& input : answer.inputs)
    for (const std::size_t i : main)
      if (const auto course = input.elasticities[i].course;
          course == sensitivity::Course::kink || course == sensitivity::Course::jump)
        bent +=
            fmt::format("{}{} over {} ({})", bent.empty() ? "" : ", ", title_in_sentence(*answer.figures[i]),
                        factor_words(input.key), to_string(course));
  if (!bent.empty()) lines.push_back("Not smooth at the value of the case: " + bent + ".");
  lines.push_back(fmt::format("{} solved in {:.2g} s, {} runs each.", plural(answer.impacts, "impact"),
                              answer.seconds, answer.runs));
  document.sections.push_back({.seen = Seen::always, .paragraphs = std::move(lines)});
  document.sections.push_back({.heading = "Change of each figure, in per cent",
                               .seen = Seen::in_brief,
                               .tables = {elasticities_table(answer, main, figure, max_rows)}});
  document.sections.push_back({.heading = "Change of each figure, in per cent",
                               .tables = {elasticities_table(answer, main, figure, answer.inputs.size())}});
  document.sections.push_back({.heading = "Derivatives of the " + title_in_sentence(*answer.figures[figure]),
                               .tables = {derivatives_table(answer, figure, units)}});
  if (answer.intervals)
    document.sections.push_back(
        {.heading = "Effect of the uncertainties", .tables = {doubts_table(answer, all)}});
  if (!answer.left_out.empty())
    document.sections.push_back(
        {.heading = "Left out",
         .paragraphs = {fmt::format("Numbers that are 0, or cannot be varied to either side: {}.",
                                    fmt::join(answer.left_out, ", "))}});
  document.sections.push_back(
      {.heading = basis_heading, .tables = {basis_table(case_basis(answer.impact, units))}});
  if (pictures == Pictures::drawn) document.lead->curve = untitled(sensitivity_plot(answer, figure));
  return document;
}

}  // namespace dashpad::output
