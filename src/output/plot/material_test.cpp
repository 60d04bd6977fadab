#include "dashpad/output/materials.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using laboratory::MaterialTestReport;
using laboratory::MaterialTestRun;
using Values = std::vector<double>;

/// A quantity of a run on its axis, in the unit of that.
struct OfRun {
  Axis axis;
  std::function<Values(const MaterialTestRun&)> values;
};

OfRun strain_of_column() {
  return {{.label = "Strain", .low = 0}, [](const MaterialTestRun& run) { return run.column.strain; }};
}
/// A pure number of the first loading.
OfRun of_cushion(const char* label, Values laboratory::CushionCurve::*values) {
  return {{.label = label, .low = 0}, [values](const MaterialTestRun& run) { return run.cushion.*values; }};
}
OfRun strain_of_cushion() { return of_cushion("Strain", &laboratory::CushionCurve::strain); }
OfRun efficiency() { return of_cushion("Efficiency", &laboratory::CushionCurve::efficiency); }
OfRun stress_of_column(const UnitSystem& units) {
  return {axis_with_unit("Stress", "Pa", units),
          [&](const MaterialTestRun& run) { return values_in(units, run.column.stress, "Pa"); }};
}

OfRun time_of_column(const MaterialTestReport& report, const UnitSystem& units) {
  Axis axis = axis_with_unit("Time", "s", units);
  Values ends;
  for (const MaterialTestRun& run : report.runs) ends.push_back(run.column.time.back());
  const auto [shortest, longest] = std::ranges::minmax(ends);
  const bool held =
      report.test.kind == laboratory::TestKind::relaxation || report.test.kind == laboratory::TestKind::creep;
  axis.logarithmic = held || longest >= 5 * shortest;
  const double first = held ? shortest - report.test.hold : shortest;
  if (axis.logarithmic) axis.low = value_in(units, std::max(0.05 * first, 1e-9 * longest), "s");
  return {axis, [&](const MaterialTestRun& run) { return values_in(units, run.column.time, "s"); }};
}

Series curve_of_run(const MaterialTestReport& report, std::size_t run, Values x, Values y) {
  return {.label = rate_words(report.runs[run]), .x = std::move(x), .y = std::move(y), .palette_index = run};
}

/// A panel with one curve for each run.
Panel panel_of_runs(const MaterialTestReport& report, const char* title, const OfRun& x, const OfRun& y) {
  Panel panel{.title = title, .x = x.axis, .y = y.axis};
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    panel.series.push_back(curve_of_run(report, i, x.values(report.runs[i]), y.values(report.runs[i])));
  return panel;
}

/// The points of the update of 1984, in the colour of the exact curve.
template <class X>
void add_points_of_1984(Panel& panel, const MaterialTestReport& report, const UnitSystem& units, X x_of) {
  if (!report.test.steps_of_1984) return;
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const laboratory::UpdateOf1984& update = *report.runs[i].update_of_1984;
    Series points = curve_of_run(report, i, x_of(update), values_in(units, update.stress, "Pa"));
    points.label = fmt::format("1984 update, {}, {}", plural(std::size_t(*report.test.steps_of_1984), "step"),
                               points.label);
    points.style = SeriesStyle::points;
    const double peak = value_in(units, report.runs[i].figures.peak_stress, "Pa");
    for (double& stress : points.y)
      if (stress < laboratory::lowest_drawn * peak || stress > laboratory::highest_drawn * peak) stress = NAN;
    panel.series.push_back(std::move(points));
  }
}

/// Version, material and its source.
std::string source_words(const MaterialTestReport& report) {
  const Material& material = report.material;
  return fmt::format("dashpad {}; {}: {}", version(), one_line(material.name),
                     material.source.empty() ? "source not stated" : one_line(material.source));
}

}  // namespace

Panel stress_over_strain(const MaterialTestReport& report, const UnitSystem& units) {
  Panel panel = panel_of_runs(report, "Stress against strain", strain_of_column(), stress_of_column(units));
  for (Series& loop : panel.series) loop.has_arrow = true;
  add_points_of_1984(panel, report, units,
                     [](const laboratory::UpdateOf1984& update) { return update.strain; });
  return panel;
}

Panel stress_over_time(const MaterialTestReport& report, const UnitSystem& units) {
  Panel panel =
      panel_of_runs(report, "Stress over time", time_of_column(report, units), stress_of_column(units));
  add_points_of_1984(panel, report, units, [&](const laboratory::UpdateOf1984& update) {
    return values_in(units, update.time, "s");
  });
  return panel;
}

Panel strain_over_time(const MaterialTestReport& report, const UnitSystem& units) {
  return panel_of_runs(report, "Strain over time", time_of_column(report, units), strain_of_column());
}

Panel energy_over_strain(const MaterialTestReport& report, const UnitSystem& units) {
  const OfRun energy{{.label = fmt::format("Energy ({})", energy_density_unit(units)), .low = 0},
                     [&](const MaterialTestRun& run) { return values_in(units, run.cushion.energy, "Pa"); }};
  return panel_of_runs(report, "Energy absorbed per unit volume, first loading", strain_of_cushion(), energy);
}

Panel efficiency_over_strain(const MaterialTestReport& report) {
  return panel_of_runs(report, "Efficiency against strain", strain_of_cushion(), efficiency());
}

Panel ideality_over_strain(const MaterialTestReport& report) {
  return panel_of_runs(report, "Ideality against strain", strain_of_cushion(),
                       of_cushion("Ideality", &laboratory::CushionCurve::ideality));
}

Panel efficiency_over_stress(const MaterialTestReport& report, const UnitSystem& units) {
  OfRun stress{axis_with_unit("Stress", "Pa", units),
               [&](const MaterialTestRun& run) { return values_in(units, run.cushion.stress, "Pa"); }};
  double most = 0;
  for (const MaterialTestRun& run : report.runs) most = std::max(most, run.figures.peak_stress);
  stress.axis.logarithmic = true;
  stress.axis.low = value_in(units, 1e-3 * most, "Pa");
  Panel panel = panel_of_runs(report, "Efficiency against stress, first loading", stress, efficiency());
  for (const double limit : report.test.stress_limits)
    panel.series.push_back({.label = "limit " + brief_quantity(limit, "Pa", units),
                            .style = SeriesStyle::vertical_line,
                            .x = {value_in(units, limit, "Pa")}});
  return panel;
}

Plot material_test_plot(const MaterialTestReport& report, const UnitSystem& units) {
  std::string small_print = test_words(report.test, units) + " " + source_words(report);
  for (const std::string& flag : flag_words(report)) small_print += "; " + flag;
  Panel first = stress_over_strain(report, units);
  if (report.test.kind == laboratory::TestKind::relaxation) first = stress_over_time(report, units);
  if (report.test.kind == laboratory::TestKind::creep) first = strain_over_time(report, units);
  return {.title = material_words(report.material),
          .panels = {std::move(first), efficiency_over_stress(report, units)},
          .source = small_print};
}

}  // namespace dashpad::output
