#include "output/plot/material_test.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/material_test_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Axis plain_axis(const char* meaning) {
  Axis of;
  of.label = meaning;
  return of;
}

using Values = std::vector<double>;

Series curve(const laboratory::MaterialTestReport& report, std::size_t run, Values x, Values y) {
  Series series;
  series.label = rate_words(report.runs[run]);
  series.style = SeriesStyle::line;
  series.turn = run;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

/// One curve a run; x and y are taken of the run by functions.
template <class X, class Y>
void add_curves(Panel& panel, const laboratory::MaterialTestReport& report, X x_of, Y y_of) {
  for (std::size_t i = 0; i < report.runs.size(); ++i)
    panel.series.push_back(curve(report, i, x_of(report.runs[i]), y_of(report.runs[i])));
}

/// The points of the update of 1984, in the colour of the exact curve.
template <class X>
void add_points_of_1984(Panel& panel, const laboratory::MaterialTestReport& report, const UnitSystem& units,
                        X x_of) {
  if (!report.test.steps_of_1984) return;
  for (std::size_t i = 0; i < report.runs.size(); ++i) {
    const laboratory::UpdateOf1984& update = *report.runs[i].update_of_1984;
    Series points = curve(report, i, x_of(update), values_in(units, update.stress, "Pa"));
    points.label = fmt::format("1984, {} steps, {}", *report.test.steps_of_1984, points.label);
    points.style = SeriesStyle::points;
    const double peak = value_in(units, report.runs[i].figures.peak_stress, "Pa");
    for (double& stress : points.y)
      if (stress < laboratory::lowest_drawn * peak || stress > laboratory::highest_drawn * peak) stress = NAN;
    panel.series.push_back(std::move(points));
  }
}

Axis time_axis(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  Axis of = axis_with_unit("Time", "s", units);
  Values ends;
  for (const laboratory::MaterialTestRun& run : report.runs) ends.push_back(run.column.time.back());
  const auto [shortest, longest] = std::ranges::minmax(ends);
  const bool held =
      report.test.kind == laboratory::TestKind::relaxation || report.test.kind == laboratory::TestKind::creep;
  if (!held && longest < 5 * shortest) return of;
  of.logarithmic = true;
  double first = shortest;
  for (const laboratory::MaterialTestRun& run : report.runs) {
    const auto moving = held ? run.column.time.back() - report.test.hold : run.column.time.back();
    first = std::min(first, moving);
  }
  of.low = value_in(units, std::max(0.05 * first, 1e-9 * longest), "s");
  return of;
}

Values time_of(const laboratory::MaterialTestRun& run, const UnitSystem& units) {
  return values_in(units, run.column.time, "s");
}
Values stress_of(const laboratory::MaterialTestRun& run, const UnitSystem& units) {
  return values_in(units, run.column.stress, "Pa");
}

/// Version, material and its source.
std::string source_words(const laboratory::MaterialTestReport& report) {
  const Material& material = report.material;
  return fmt::format("dashpad {}; {}: {}", version(), one_line(material.name),
                     material.source.empty() ? "source not stated" : one_line(material.source));
}

}  // namespace

Panel stress_over_strain(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  Panel panel{"Stress over strain", plain_axis("Strain"), axis_with_unit("Stress", "Pa", units), {}};
  panel.x.low = 0;
  add_curves(
      panel, report, [](const auto& run) { return run.column.strain; },
      [&](const auto& run) { return stress_of(run, units); });
  for (Series& loop : panel.series) loop.has_arrow = true;
  add_points_of_1984(panel, report, units, [](const laboratory::UpdateOf1984& of) { return of.strain; });
  return panel;
}

Panel stress_over_time(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  Panel panel{"Stress over time", time_axis(report, units), axis_with_unit("Stress", "Pa", units), {}};
  add_curves(
      panel, report, [&](const auto& run) { return time_of(run, units); },
      [&](const auto& run) { return stress_of(run, units); });
  add_points_of_1984(panel, report, units,
                     [&](const laboratory::UpdateOf1984& of) { return values_in(units, of.time, "s"); });
  return panel;
}

Panel strain_over_time(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  Panel panel{"Strain over time", time_axis(report, units), plain_axis("Strain"), {}};
  panel.y.low = 0;
  add_curves(
      panel, report, [&](const auto& run) { return time_of(run, units); },
      [](const auto& run) { return run.column.strain; });
  return panel;
}

Panel energy_over_strain(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  Panel panel{"Energy absorbed per volume, first loading", plain_axis("Strain"), plain_axis(""), {}};
  panel.y.label = fmt::format("Energy ({})", energy_density_unit(units));
  panel.x.low = panel.y.low = 0;
  add_curves(
      panel, report, [](const auto& run) { return run.cushion.strain; },
      [&](const auto& run) { return values_in(units, run.cushion.energy, "Pa"); });
  return panel;
}

Panel efficiency_over_strain(const laboratory::MaterialTestReport& report) {
  Panel panel{"Efficiency over strain", plain_axis("Strain"), plain_axis("Efficiency"), {}};
  panel.x.low = panel.y.low = 0;
  add_curves(
      panel, report, [](const auto& run) { return run.cushion.strain; },
      [](const auto& run) { return run.cushion.efficiency; });
  return panel;
}

Panel ideality_over_strain(const laboratory::MaterialTestReport& report) {
  Panel panel{"Ideality over strain", plain_axis("Strain"), plain_axis("Ideality"), {}};
  panel.x.low = panel.y.low = 0;
  add_curves(
      panel, report, [](const auto& run) { return run.cushion.strain; },
      [](const auto& run) { return run.cushion.ideality; });
  return panel;
}

Panel efficiency_over_stress(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  Panel panel{"Efficiency over stress, first loading",
              axis_with_unit("Stress", "Pa", units),
              plain_axis("Efficiency"),
              {}};
  panel.y.low = 0;
  panel.x.logarithmic = true;
  double most = 0;
  for (const laboratory::MaterialTestRun& run : report.runs) most = std::max(most, run.figures.peak_stress);
  panel.x.low = value_in(units, 1e-3 * most, "Pa");
  add_curves(
      panel, report, [&](const auto& run) { return values_in(units, run.cushion.stress, "Pa"); },
      [](const auto& run) { return run.cushion.efficiency; });
  for (const double limit : report.test.stress_limits) {
    Series line;
    line.label = "limit " + brief_quantity(limit, "Pa", units);
    line.style = SeriesStyle::vertical_line;
    line.x = {value_in(units, limit, "Pa")};
    panel.series.push_back(std::move(line));
  }
  return panel;
}

Plot material_test_plot(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  std::string small_print = test_words(report.test, units) + " " + source_words(report);
  for (const std::string& flag : flag_words(report)) small_print += "; " + flag;
  Panel first = stress_over_strain(report, units);
  if (report.test.kind == laboratory::TestKind::relaxation) first = stress_over_time(report, units);
  if (report.test.kind == laboratory::TestKind::creep) first = strain_over_time(report, units);
  return {material_words(report.material),
          {std::move(first), efficiency_over_stress(report, units)},
          small_print};
}

}  // namespace dashpad::output
