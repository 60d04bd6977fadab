// What is drawn and what is printed of fits, against their reports, in every system of units.

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "distinct_numbers.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/text/fit_words.hpp"
#include "shown_values.hpp"

namespace dashpad::test {
namespace {

using namespace output;

TEST(ShownFits, AreItsPointsAndTheModelWithTheOffset) {
  const fit::FitReport report = fit_with_numbers();
  const fit::MetTest& test = report.tests[0];
  const double offset = *test.offset;
  for (const UnitSystem& units : unit_systems()) {
    const Plot plot = fit_test_figure(test, units).plot;
    const Panel stress = panel_in_si(plot.panels.at(0)), off = panel_in_si(plot.panels.at(1));
    expect_values(series_of(stress, "test, loading").y, {test.measured[0]}, "up");
    expect_values(series_of(stress, "test, unloading").y, {test.measured[1]}, "down");
    expect_values(series_of(stress, "model, loading").y, {test.computed[0] + offset}, "model up");
    expect_values(series_of(stress, "model, unloading").y,
                  {NAN, test.computed[0] + offset, test.computed[1] + offset}, "model down");
    expect_values(series_of(off, "loading").y, {test.computed[0] + offset - test.measured[0]}, "off");
    expect_values(series_of(off, "unloading").x, {test.strain[1]}, "off");
    const fit::MetPulse& pulse = report.pulses[0];
    const Plot over_time = fit_pulse_figure(pulse, units).plot;
    expect_series(over_time.panels.at(0), "pulse", pulse.time, pulse.measured);
    expect_series(over_time.panels.at(0), "model", pulse.time, pulse.computed);
    std::vector<double> rest = pulse.computed;
    for (std::size_t i = 0; i < rest.size(); ++i) rest[i] -= pulse.measured[i];
    expect_series(over_time.panels.at(1), "pulse", pulse.time, rest);
  }
}

TEST(ShownFits, TablesAreThoseOfTheReport) {
  const fit::FitReport report = fit_with_numbers();
  const fit::FittedUnknown& unknown = report.unknowns[0];
  const fit::MetTest& test = report.tests[0];
  const fit::MetFigure& figure = report.figures[0];
  const fit::MetPulse& pulse = report.pulses[0];
  const fit::ImpactComparison& compared = report.comparison[0];
  const auto expect_table = [](const Table& table, const std::vector<double>& expected) {
    const std::vector<double> shown = numbers_in(table);
    ASSERT_EQ(shown.size(), expected.size()) << table.columns.front();
    for (std::size_t i = 0; i < shown.size(); ++i)
      EXPECT_NEAR(shown[i], expected[i], 0.05 * std::abs(expected[i]) + 0.03)
          << table.columns.front() << " " << i;
  };
  for (const UnitSystem& units : unit_systems()) {
    expect_table(table_of_unknowns(report, units),
                 {unknown.value, *unknown.standard_error, *unknown.low, *unknown.high});
    const double share = 100 / test.largest_stress;
    const fit::Loop& loop = test.loops[0];
    expect_table(table_of_tests(report, units),
                 {101, *test.rms_loading, *test.rms_loading * share, *test.rms_unloading,
                  *test.rms_unloading * share, loop.measured_return, loop.computed_return});
    expect_table(table_of_figures(report, units),
                 {figure.measured, figure.deviation, *figure.computed, 1.96 * *figure.prediction_deviation,
                  (*figure.computed - figure.measured) / figure.deviation});
    expect_table(table_of_comparison(report, units),
                 {compared.measured, *compared.computed, 100 * (*compared.computed / compared.measured - 1)});
    expect_table(table_of_loops(report), {loop.largest_strain, loop.measured_return, loop.computed_return});
    expect_table(table_of_pulses(report, units),
                 {3, 102, pulse.measured_peak, *pulse.computed_peak, *pulse.rms,
                  100 * *pulse.rms / pulse.measured_peak, *pulse.shift});
  }
}

}  // namespace
}  // namespace dashpad::test
