// What is said of a material test: where the foam is used best first, then why.

#include "dashpad/output/materials.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/document.hpp"
#include "output/documents/basis.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using laboratory::CushionPoint;
using laboratory::MaterialTestReport;
using laboratory::MaterialTestRun;

void add_hold(std::vector<ValueRow>& figures, const MaterialTestReport& report, const MaterialTestRun& run,
              const MaterialTestValues& shown) {
  const std::string hold = "after " + brief_quantity(report.test.hold, "s", shown.units, 3);
  if (run.relaxed) {
    figures.push_back(
        {.label = "Stress at the end of the ramp", .value = shown.stress(run.relaxed->at_end_of_ramp)});
    figures.push_back(
        {.label = "Stress held", .value = shown.stress(run.relaxed->after_hold), .remark = hold});
  }
  if (run.crept) {
    figures.push_back({.label = "Strain at the end of loading",
                       .value = MaterialTestValues::strain(run.crept->at_end_of_loading)});
    figures.push_back(
        {.label = "Strain held", .value = MaterialTestValues::strain(run.crept->after_hold), .remark = hold});
  }
}

void add_limits(std::vector<ValueRow>& figures, const MaterialTestReport& report, const MaterialTestRun& run,
                const MaterialTestValues& shown) {
  constexpr std::size_t max_limits = 2;
  for (std::size_t i = 0; i < run.at_limits.size() && i < max_limits; ++i) {
    const std::optional<CushionPoint>& at = run.at_limits[i];
    figures.push_back(
        {.label = "Energy below " + shown.stress(report.test.stress_limits[i]),
         .value = shown.energy(at ? at->energy : run.figures.energy_in),
         .remark = at ? "at a strain of " + MaterialTestValues::strain(at->strain) : "which is not reached"});
  }
}

ValueRow strain_reached(const MaterialTestReport& report, const MaterialTestRun& run) {
  ValueRow figure{.label = "Strain reached", .value = MaterialTestValues::strain(run.column.largest_strain)};
  if (const auto range = range_of(report.material)) {
    figure.remark = fmt::format("{} up to {}", how_known(report.material),
                                MaterialTestValues::strain(range->highest_strain));
    figure.share = run.column.largest_strain / range->highest_strain;
    if (is_beyond(run.column.largest_strain, *range)) figure.tone = Tone::doubtful;
  }
  return figure;
}

std::vector<ValueRow> test_figures(const MaterialTestReport& report, const MaterialTestRun& run,
                                   const MaterialTestValues& shown) {
  const laboratory::CushionFigures& cushion_figures = run.figures;
  std::vector<ValueRow> figures;
  add_hold(figures, report, run, shown);
  add_limits(figures, report, run, shown);
  if (runs_out(run)) {
    figures.push_back({.label = "Best used at",
                       .value = shown.stress(cushion_figures.best_efficiency.stress),
                       .remark = "the highest energy for its stress"});
    figures.push_back({.label = "Energy taken by then",
                       .value = shown.energy(cushion_figures.best_efficiency.energy),
                       .remark = "efficiency " + brief(cushion_figures.best_efficiency.efficiency, 3)});
    figures.push_back({.label = "Runs out at a strain of",
                       .value = MaterialTestValues::strain(cushion_figures.best_efficiency.strain),
                       .remark = "beyond, stress grows faster than energy"});
  } else
    figures.push_back({.label = "Energy taken",
                       .value = shown.energy(cushion_figures.best_efficiency.energy),
                       .remark = "efficiency " + brief(cushion_figures.best_efficiency.efficiency, 3)});
  if (run.unloads)
    figures.push_back(
        {.label = "Given back",
         .value = cushion_figures.energy_in > 0
                      ? MaterialTestValues::share(cushion_figures.energy_returned / cushion_figures.energy_in)
                      : "none",
         .remark = fmt::format("{} of {}", shown.energy(cushion_figures.energy_returned),
                               shown.energy(cushion_figures.energy_in))});
  figures.push_back(strain_reached(report, run));
  figures.push_back(
      {.label = "Largest stress",
       .value = shown.stress(cushion_figures.peak_stress),
       .remark = "at a strain of " + MaterialTestValues::strain(cushion_figures.strain_at_peak)});
  return figures;
}

/// Stress over strain, not so high that what is pressed flat hides the rest, with the place that the answer
/// speaks of and where the foam was tested.
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
      panel.title =
          fmt::format("The stress goes on to {}", MaterialTestValues{units}.stress(run.figures.peak_stress));
    }
  }
  for (const double limit : report.test.stress_limits)
    panel.series.push_back({.label = "limit " + brief_quantity(limit, "Pa", units),
                            .style = SeriesStyle::horizontal_line,
                            .y = {value_in(units, limit, "Pa")}});
  if (std::optional<Series> line = line_of_range(report.material)) panel.series.push_back(*std::move(line));
  return panel;
}

Panel deciding_panel(const MaterialTestReport& report, const MaterialTestRun& run, const UnitSystem& units) {
  Panel panel;
  if (run.relaxed)
    panel = stress_over_time(report, units);
  else if (run.crept)
    panel = strain_over_time(report, units);
  else
    panel = stress_panel(report, run, units);
  if (run.relaxed || run.crept) panel.title.clear();
  return panel;
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
       .figures = {
           figure(energy_over_strain(report, units)),
           figure(efficiency_over_strain(report), "Efficiency is energy over the largest stress so far."),
           figure(ideality_over_strain(report), "Ideality is efficiency over the strain."),
           figure(efficiency_over_stress(report, units),
                  "The foam is used best at the stress where the efficiency is highest.")}});
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
