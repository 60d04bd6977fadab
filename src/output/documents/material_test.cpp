// The document of a material test: where the foam is used best, then the details.

#include "dashpad/output/materials.hpp"

#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using laboratory::CushionPoint;
using laboratory::MaterialTestReport;
using laboratory::MaterialTestRun;

std::vector<ValueRow> test_figures(const MaterialTestReport& report, const MaterialTestRun& run,
                                   const MaterialTestValues& shown) {
  constexpr std::size_t max_limits = 2;
  const laboratory::CushionFigures& of_run = run.figures;
  const CushionPoint& best = of_run.best_efficiency;
  std::vector<ValueRow> figures;
  const auto add = [&](const std::string& label, const std::string& value, const std::string& remark = "") {
    figures.push_back({.label = label, .value = value, .remark = remark});
  };
  const std::string hold = "after " + brief_quantity(report.test.hold, "s", shown.units, 3);
  if (run.relaxed) {
    add("Stress at the end of the ramp", shown.stress(run.relaxed->at_end_of_ramp));
    add("Remaining stress", shown.stress(run.relaxed->after_hold), hold);
  }
  if (run.crept) {
    add("Strain at the end of loading", brief(run.crept->at_end_of_loading, 3));
    add("Strain at the end of the hold", brief(run.crept->after_hold, 3), hold);
  }
  for (std::size_t i = 0; i < run.at_limits.size() && i < max_limits; ++i) {
    const std::optional<CushionPoint>& at = run.at_limits[i];
    add("Energy below " + shown.stress(report.test.stress_limits[i]),
        shown.energy(at ? at->energy : of_run.energy_in),
        at ? "at a strain of " + brief(at->strain, 3) : "this stress is not reached");
  }
  const bool has_best = runs_out(run);
  if (has_best) add("Best used at", shown.stress(best.stress), "highest ratio of energy to stress");
  const bool repeats = report.test.kind == laboratory::TestKind::cyclic && report.test.cycles > 1;
  add(has_best ? "Energy absorbed by then" : "Energy input", shown.energy(best.energy),
      "efficiency " + brief(best.efficiency, 3) + (repeats ? ", in the first loading" : ""));
  if (has_best) add("Strain at best use", brief(best.strain, 3), "above it, stress grows faster than energy");
  if (run.unloads)
    add("Energy returned",
        of_run.energy_in > 0 ? MaterialTestValues::share(of_run.energy_returned / of_run.energy_in) : "none",
        fmt::format("{} of {}{}", shown.energy(of_run.energy_returned), shown.energy(of_run.energy_in),
                    repeats ? fmt::format(" in all {} cycles", report.test.cycles) : ""));
  const double reached = run.column.largest_strain;
  add("Strain reached", brief(reached, 3));
  if (const auto range = range_of(report.material)) {
    ValueRow& figure = figures.back();
    figure.remark = fmt::format("{} up to {}", how_known(report.material), brief(range->highest_strain, 3));
    figure.share = reached / range->highest_strain;
    if (is_beyond(reached, *range)) figure.tone = Tone::doubtful;
  }
  add("Largest stress", shown.stress(of_run.peak_stress),
      "at a strain of " + brief(of_run.strain_at_peak, 3));
  return figures;
}

/// Stress over strain. Where the foam is pressed flat its stress would hide the rest: the axis ends before.
/// Marks show the point that the answer speaks of and the strain up to which the foam was tested.
Panel stress_panel(const MaterialTestReport& report, const MaterialTestRun& run, const UnitSystem& units) {
  constexpr double max_over_best = 4;
  Panel panel = stress_over_strain(report, units);
  panel.title.clear();
  const CushionPoint& best = run.figures.best_efficiency;
  if (runs_out(run)) {
    panel.series.push_back({.label = "best used",
                            .style = SeriesStyle::points,
                            .x = {best.strain},
                            .y = {value_in(units, best.stress, "Pa")},
                            .palette_index = report.runs.size(),
                            .label_place = LabelPlace::middle});
    if (run.figures.peak_stress > max_over_best * best.stress) {
      panel.y.low = 0;
      panel.y.high = value_in(units, max_over_best * best.stress, "Pa");
      panel.title = fmt::format("Beyond the plot, the stress rises to {}",
                                MaterialTestValues{units}.stress(run.figures.peak_stress));
    }
  }
  for (const double limit : report.test.stress_limits)
    panel.series.push_back({.label = "limit " + brief_quantity(limit, "Pa", units),
                            .style = SeriesStyle::horizontal_line,
                            .y = {value_in(units, limit, "Pa")},
                            .palette_index = report.runs.size() + 1});
  if (std::optional<Series> line = line_of_range(report.material)) panel.series.push_back(*std::move(line));
  return panel;
}

Panel deciding_panel(const MaterialTestReport& report, const MaterialTestRun& run, const UnitSystem& units) {
  if (!run.relaxed && !run.crept) return stress_panel(report, run, units);
  return run.relaxed ? stress_over_time(report, units) : strain_over_time(report, units);
}

/// Whether the answer speaks of a strain or a rate beyond what the foam was tested for.
bool is_beyond_tests(const MaterialTestReport& report, const MaterialTestRun& run) {
  const std::optional<FittedRange> range = range_of(report.material);
  if (run.flags.empty()) return false;
  if (!range || (run.rate && *run.rate > range->highest_rate)) return true;
  if (run.at_limits.empty()) return is_beyond(run.figures.best_efficiency.strain, *range);
  const std::optional<CushionPoint>& at = run.at_limits.front();
  return is_beyond(at ? at->strain : run.column.largest_strain, *range);
}

void add_plots(Document& document, const MaterialTestReport& report, const UnitSystem& units) {
  const auto figure = [](Panel panel, std::string note = {}) {
    std::string title = panel.title;
    return CaptionedPlot{.plot = {.title = std::move(title), .panels = {std::move(panel)}},
                         .note = std::move(note)};
  };
  document.sections.push_back(
      {.heading = "Stress",
       .seen = Seen::on_pages,
       .figures = {figure(stress_over_strain(report, units)), figure(stress_over_time(report, units)),
                   figure(strain_over_time(report, units))}});
  document.sections.push_back(
      {.heading = "Cushioning",
       .seen = Seen::on_pages,
       .figures = {figure(energy_over_strain(report, units)),
                   figure(efficiency_over_strain(report),
                          "Efficiency is energy divided by the largest stress so far."),
                   figure(ideality_over_strain(report), "Ideality is efficiency divided by the strain."),
                   figure(efficiency_over_stress(report, units),
                          "The foam is best used at the stress of highest efficiency.")}});
}

}  // namespace

Document material_test_document(const MaterialTestReport& report, const UnitSystem& units,
                                Pictures pictures) {
  const MaterialTestRun& run = headline_run(report);
  Document document{
      .title = material_words(report.material),
      .lead = Lead{.answer = material_test_answer(report, units),
                   .tone = is_beyond_tests(report, run) ? Tone::doubtful : Tone::plain,
                   .subject = {material_words(report.material), test_words(report.test, units)},
                   .figures = test_figures(report, run, {units})},
      .warnings = flag_words(report),
      .sections = {{.heading = "Figures", .seen = Seen::always, .tables = tables_of(report, units)},
                   {.heading = basis_heading,
                    .seen = Seen::always,
                    .paragraphs = notes_on(report),
                    .tables = {basis_table(
                        {foam_basis(report.material, units),
                         {"Test", test_words(report.test, units), fmt::format("dashpad {}", version())}})}}}};
  if (pictures == Pictures::left_out) return document;
  document.lead->curve = Plot{.panels = {deciding_panel(report, run, units)}};
  add_plots(document, report, units);
  return document;
}

}  // namespace dashpad::output
