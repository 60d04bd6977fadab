// The document of a fit: how well it meets the data, what it found and how certain that is.

#include <algorithm>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/fit.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/version.hpp"
#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/text/capitals.hpp"
#include "output/text/case_toml.hpp"
#include "output/text/fit_words.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

double place_of(const fit::FittedUnknown& unknown, double value) {
  return std::clamp(fit::place_between(unknown.lowest, unknown.highest, unknown.is_logarithmic, value), 0.0,
                    1.0);
}

RangeBar bar_of(const fit::FittedUnknown& unknown, const UnitSystem& units) {
  const auto shown = [&](double value) { return brief_quantity(value, unknown.unit, units, 4); };
  std::string error;  // an open interval has none
  if (unknown.is_identified())
    error = unknown.standard_error
                ? "; standard error " + brief_quantity(*unknown.standard_error, unknown.unit, units, 2)
                : "; no standard error";
  return {.label = factor_title(unknown.key),
          .value = shown(unknown.value),
          .words = interval_words(unknown, units) + error +
                   (unknown.is_logarithmic ? "; the bar is logarithmic" : ""),
          .lowest = shown(unknown.lowest),
          .highest = shown(unknown.highest),
          .place = place_of(unknown, unknown.value),
          .from = unknown.low ? place_of(unknown, *unknown.low) : 0,
          .to = unknown.high ? place_of(unknown, *unknown.high) : 1,
          .open_below = !unknown.low && !unknown.is_identified(),
          .open_above = !unknown.high && !unknown.is_identified()};
}

/// Findings that could change the answer.
std::vector<std::string> fit_warnings(const fit::FitReport& report, const UnitSystem& units) {
  std::vector<std::string> all;
  for (const std::string& line : open_matters(report)) all.push_back("NOT DISTINGUISHED: " + line);
  for (const fit::FittedUnknown& unknown : report.unknowns)
    if (!unknown.is_identified() && !unknown.is_nuisance)
      all.push_back(fmt::format("NOT DETERMINED: the data do not determine the {} (95 % interval {}).",
                                factor_words(unknown.key), interval_words(unknown, units)));
  for (const fit::FittedUnknown& unknown : report.unknowns)
    if (unknown.is_identified() && unknown.rests_on_prior() && !unknown.is_nuisance)
      all.push_back(fmt::format("FROM ITS PRIOR: the {} is set mainly by its prior; the data add little.",
                                factor_words(unknown.key)));
  for (const fit::FittedUnknown& unknown : report.unknowns)
    if (unknown.wants_beyond())
      all.push_back(fmt::format("AT A BOUND: the {} is at its {} bound; the data favour a value beyond it.",
                                factor_words(unknown.key), unknown.is_at_lowest ? "lower" : "upper"));
  if (report.starts > 1 && report.starts_at_best <= 1)
    all.push_back(
        fmt::format("ONE START: {} of {} starts converged to this misfit, so there may be a better fit.",
                    report.starts_at_best, report.starts));
  return all;
}

void add_misses(std::vector<ValueRow>& figures, const fit::FitReport& report, bool held_out) {
  const Misses of = misses(report, held_out);
  const auto add = [&](const char* what, const std::optional<double>& miss, const char* unit,
                       const char* share_of) {
    if (!miss) return;
    figures.push_back({.label = (held_out ? "Prediction error for " : "Deviation from ") + std::string(what),
                       .value = fmt::format("{:.3g}{}", *unit == 0 ? *miss : 100 * *miss, unit),
                       .remark = share_of});
  };
  add("tests", of.tests, " %", "root mean square, relative to the largest stress");
  add("impact figures", of.figures, "", "times the stated deviation");
  add("pulses", of.pulses, " %", "root mean square, relative to the peak");
}

/// The misfits, then the unknowns of the material, beginning with those that the data leave open.
std::vector<ValueRow> fit_figures(const fit::FitReport& report, const UnitSystem& units) {
  std::vector<ValueRow> figures;
  add_misses(figures, report, false);
  add_misses(figures, report, true);
  for (const bool identified : {false, true})
    for (const fit::FittedUnknown& unknown : report.unknowns)
      if (!unknown.is_nuisance && unknown.is_identified() == identified)
        figures.push_back({.label = capitalised(factor_words(unknown.key)),
                           .value = brief_quantity(unknown.value, unknown.unit, units, 3),
                           .remark = (unknown.rests_on_prior() ? "mostly from its prior; 95 % interval "
                                                               : "95 % interval ") +
                                     interval_words(unknown, units),
                           .tone = identified && !unknown.rests_on_prior() ? Tone::plain : Tone::doubtful});
  return figures;
}

Section curves_section(const fit::FitReport& report, const UnitSystem& units) {
  Section curves{.heading = "Model and measurements", .seen = Seen::on_pages};
  for (const fit::MetTest& test : report.tests) curves.figures.push_back(fit_test_figure(test, units));
  for (const fit::MetPulse& pulse : report.pulses) curves.figures.push_back(fit_pulse_figure(pulse, units));
  std::vector<Panel>& first = curves.figures.front().plot.panels;
  if (first.size() > 1) first.erase(first.begin());  // the lead shows it
  return curves;
}

/// The first curve alone: the panels below it are what is left of the misfit.
Plot leading_curve(const fit::FitReport& report, const UnitSystem& units) {
  Plot plot = report.tests.empty() ? fit_pulse_figure(report.pulses.front(), units).plot
                                   : fit_test_figure(report.tests.front(), units).plot;
  plot.panels.resize(1);
  plot.panels.front().title = plot.title;
  return untitled(std::move(plot));
}

Section unknowns_section(const fit::FitReport& report, const UnitSystem& units) {
  Section unknowns{.heading = "Fitted values", .seen = Seen::on_pages};
  unknowns.paragraphs = {
      "Value and 95 % interval of each unknown, between its lowest and highest permitted values. Where a bar "
      "fades, the interval is unbounded: the data do not bound it."};
  for (const fit::FittedUnknown& unknown : report.unknowns) unknowns.ranges.push_back(bar_of(unknown, units));
  return unknowns;
}

Section misfit_section(const fit::FitReport& report, const UnitSystem& units) {
  Section misfit{.heading = "Agreement with the data", .seen = Seen::always};
  const auto add = [&](const char* caption, Table table) {
    if (table.rows.empty()) return;
    table.caption = caption;
    misfit.tables.push_back(std::move(table));
  };
  add("Peak, HIC and rebound of the impacts, measured and computed", table_of_comparison(report, units));
  add("Root mean square of model minus test, also as a share of the largest stress",
      table_of_tests(report, units));
  add("Share of the energy returned, by strain at reversal", table_of_loops(report));
  add("Impact figures", table_of_figures(report, units));
  add("Impact pulses", table_of_pulses(report, units));
  for (const std::string& remark : report.remarks) misfit.paragraphs.push_back("REMARK: " + one_line(remark));
  return misfit;
}

/// The unknowns by their keys, for users who edit the fit file next.
Section keys_section(const fit::FitReport& report, const UnitSystem& units) {
  return {.heading = "Fitted values", .seen = Seen::in_brief, .tables = {table_of_unknowns(report, units)}};
}

Document failed(const fit::FitReport& report) {
  return {.title = one_line(report.title),
          .lead = Lead{.answer = "The fit did not converge: " + one_line(report.why_not),
                       .tone = Tone::bad,
                       .subject = {one_line(report.title)}},
          .summary = {"No card was written. Start closer to the solution (start = ...), narrow the bounds, "
                      "try more starts, or fix unknowns that the data do not determine."}};
}

}  // namespace

Document fit_document(const fit::FitReport& report, const UnitSystem& units, Pictures pictures) {
  if (!report.converged) return failed(report);
  Document document{.title = fit_headline(report),
                    .lead = Lead{.answer = fit_headline(report),
                                 .subject = {one_line(report.title)},
                                 .figures = fit_figures(report, units)},
                    .summary = {fit_answer(report), words_on_added(report), prediction_words(report)},
                    .warnings = fit_warnings(report, units)};
  std::erase(document.summary, "");
  if (pictures == Pictures::drawn && !(report.tests.empty() && report.pulses.empty())) {
    document.lead->curve = leading_curve(report, units);
    document.sections.push_back(curves_section(report, units));
  }
  if (pictures == Pictures::drawn && violations(report.material).empty())
    document.sections.push_back({.heading = "The fitted foam",
                                 .seen = Seen::on_pages,
                                 .figures = {{.name = "Stress in first loading",
                                              .plot = material_plot(report.material, units),
                                              .note = "From the card, at each tested rate."}}});
  document.sections.push_back(unknowns_section(report, units));
  document.sections.push_back(keys_section(report, units));
  document.sections.push_back(misfit_section(report, units));
  const Basis card{.what = "Card",
                   .value = material_words(report.material),
                   .source = report.material.source,
                   .doubt = doubts_about(report.material)};
  document.sections.push_back(
      {.heading = basis_heading,
       .seen = Seen::always,
       .paragraphs = notes_on_noise(report),
       .tables = {basis_table(
           {card,
            {"Search",
             fmt::format("{} evaluations in {}", report.evaluations, duration_words(report.wall_time)),
             fmt::format("dashpad {}", version())}})}});
  return document;
}

std::string fitted_case_toml(const fit::FitReport& report) {
  return case_toml(report.fitted_case.value().impact, report.fitted_case->options);
}

std::string posterior_csv(const fit::FitReport& report) {
  std::string text;
  for (const fit::FittedUnknown& unknown : report.unknowns)
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", unknown.key,
                        unknown.unit == "1" ? "" : fmt::format(" [{}]", unknown.unit));
  text += "\n";
  for (const std::vector<double>& draw : report.posterior) {
    std::string row;
    for (const double value : draw) row += fmt::format("{}{}", row.empty() ? "" : ",", value);
    text += row + "\n";
  }
  return text;
}

}  // namespace dashpad::output
