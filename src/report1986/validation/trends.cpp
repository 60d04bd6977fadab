#include "dashpad/report1986/validation/trends.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <utility>

#include "dashpad/report1986/validation/energy.hpp"
#include "report1986/validation/measured_tests_columns.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation/trends_least_squares.hpp"

namespace dashpad::report1986 {

namespace {

using Tests = std::vector<MeasuredTest>;

struct Fit {
  Estimate constant;
  double scatter = 0;
};

/// A constant to be fitted to the readings of one column.
struct Trend {
  std::string name, title, unit, residual_unit, method;
  std::string column;
  std::function<bool(const MeasuredTest&)> takes;  ///< of the tests with a reading
  std::function<Fit(const Tests&)> fit;
};

Tests taken(const Trend& trend, const Tests& tests) {
  const auto reading = measured_column(trend.column).reading;
  Tests chosen;
  for (const MeasuredTest& test : tests)
    if (test.*reading && trend.takes(test)) chosen.push_back(test);
  return chosen;
}

/// Without the lost readings that cannot belong to a test of the trend.
MeasuredTests with_groups_of(const Trend& trend, MeasuredTests measured) {
  std::erase_if(measured.unplaced, [&](const UnplacedReadings& group) {
    const auto free = free_tests(measured, group);
    return std::ranges::none_of(free, [&](const MeasuredTest* test) { return trend.takes(*test); });
  });
  return measured;
}

FittedConstant fitted(const Trend& trend, const ValidationData& data) {
  const Tests certain = taken(trend, data.measured.tests);
  const Fit fit = trend.fit(certain);
  FittedConstant constant;
  constant.name = trend.name;
  constant.title = trend.title;
  constant.unit = trend.unit;
  constant.printed = data.constant(trend.name);
  constant.value = fit.constant.value;
  constant.confidence = fit.constant.confidence;
  constant.scatter = fit.scatter;
  constant.residual_unit = trend.residual_unit;
  constant.method = trend.method;
  for (const MeasuredTest& test : certain) constant.tests.push_back(test.number);

  const double infinity = std::numeric_limits<double>::infinity();
  Interval& values = constant.over_placings;
  Interval& intervals = constant.confidence_over_placings;
  values = intervals = {infinity, -infinity};
  for_each_placing(with_groups_of(trend, data.measured), trend.column, [&](const Tests& tests) {
    const Estimate estimate = trend.fit(taken(trend, tests)).constant;
    values = {std::min(values.low, estimate.value), std::max(values.high, estimate.value)};
    intervals = {std::min(intervals.low, estimate.confidence.low),
                 std::max(intervals.high, estimate.confidence.high)};
    ++constant.placings;
  });
  constant.printed_in_confidence = constant.confidence.holds(constant.printed);
  constant.printed_in_placings = values.holds(constant.printed);
  return constant;
}

bool on_load_cell(const MeasuredTest& test) { return test.support == TestSupport::load_cell; }
bool on_plate(const MeasuredTest& test) { return test.support == TestSupport::plate; }

// --- Time to peak ---

Fit fit_travel(const Tests& tests) {
  std::vector<Point> points;
  for (const MeasuredTest& test : tests)
    points.push_back({1e3 / (inch_per_s_of_mph * test.speed_mph), *test.time_to_peak_ms});
  const ProportionalFit fit = fit_proportional(points);
  return {fit.constant, fit.scatter};
}

// --- Rebound ---

Fit fit_rebound(const Tests& tests) {
  std::vector<Point> points;
  for (const MeasuredTest& test : tests) points.push_back({test.speed_mph, *test.rebound_mph});
  const ProportionalFit fit = fit_proportional(points);
  return {fit.constant, fit.scatter};
}

// --- Energy over force: ln U = exponent (ln factor + ln F) ---

Point logarithms(const MeasuredTest& test) {
  return {std::log(*test.peak_force_lb), std::log(test.energy_in_lb)};
}

LineFit line_of_energy(const Tests& tests) {
  std::vector<Point> points;
  for (const MeasuredTest& test : tests) points.push_back(logarithms(test));
  return fit_line(points);
}

LineFit line_of_force(const Tests& tests) {
  std::vector<Point> points;
  for (const MeasuredTest& test : tests) points.push_back({logarithms(test).y, logarithms(test).x});
  return fit_line(points);
}

Estimate exponential(const Estimate& logarithm) {
  return {std::exp(logarithm.value),
          {std::exp(logarithm.confidence.low), std::exp(logarithm.confidence.high)}};
}

Estimate negative(const Estimate& estimate) {
  return {-estimate.value, {-estimate.confidence.high, -estimate.confidence.low}};
}

/// Of an estimate that is above 0 with its interval; else the interval is of no use.
Estimate reciprocal(const Estimate& estimate) {
  if (estimate.confidence.low <= 0) return {1 / estimate.value, {0, std::numeric_limits<double>::infinity()}};
  return {1 / estimate.value, {1 / estimate.confidence.high, 1 / estimate.confidence.low}};
}

std::vector<Trend> energy_trends(const ValidationData& data) {
  const double from = data.constant("energy_trend_from_in_lb");
  Trend trend{
      .name = "energy_trend_exponent",
      .title = "exponent of U = (factor F)^exponent, ln U on ln F",
      .unit = "1",
      .residual_unit = "of ln U",
      .method = "least squares of ln U over ln F, load cell, energies above 300 in.lb",
      .column = "peak_force_lb",
      .takes = [from](const MeasuredTest& test) { return on_load_cell(test) && test.energy_in_lb > from; },
      .fit =
          [](const Tests& tests) {
            const LineFit line = line_of_energy(tests);
            return Fit{line.slope, line.scatter};
          }};
  std::vector<Trend> trends{trend};
  trend.name = "energy_trend_factor";
  trend.title = "factor of U = (factor F)^exponent, ln U on ln F";
  trend.method += "; interval of the line's zero by Fieller's theorem";
  trend.fit = [](const Tests& tests) {
    const LineFit line = line_of_energy(tests);
    return Fit{exponential(line.ratio), line.scatter};
  };
  trends.push_back(trend);

  trend.name = "energy_trend_exponent";
  trend.title = "exponent of U = (factor F)^exponent, ln F on ln U";
  trend.residual_unit = "of ln F";
  trend.method = "least squares of ln F over ln U, load cell, energies above 300 in.lb";
  trend.fit = [](const Tests& tests) {
    const LineFit line = line_of_force(tests);
    return Fit{reciprocal(line.slope), line.scatter};
  };
  trends.push_back(trend);
  trend.name = "energy_trend_factor";
  trend.title = "factor of U = (factor F)^exponent, ln F on ln U";
  trend.fit = [](const Tests& tests) {
    const LineFit line = line_of_force(tests);
    return Fit{exponential(negative(line.intercept)), line.scatter};
  };
  trends.push_back(trend);
  return trends;
}

std::vector<Trend> trends_of(const ValidationData& data) {
  const double high_speed = data.constant("plate_speed_mph");
  std::vector<Trend> trends{
      {.name = "travel_in",
       .title = "V T, load cell",
       .unit = "in",
       .residual_unit = "ms",
       .method = "least squares of T over 1/V; 17.64 in/s to the mile per hour, as in the report",
       .column = "time_to_peak_ms",
       .takes = on_load_cell,
       .fit = fit_travel},
      {.name = "rebound_ratio_load_cell",
       .title = "V_R/V, load cell",
       .unit = "1",
       .residual_unit = "mph",
       .method = "least squares of V_R over V through the origin",
       .column = "rebound_mph",
       .takes = on_load_cell,
       .fit = fit_rebound},
      {.name = "rebound_ratio_plate",
       .title = "V_R/V, flexible plate",
       .unit = "1",
       .residual_unit = "mph",
       .method = "least squares of V_R over V through the origin, all tests on the plate",
       .column = "rebound_mph",
       .takes = on_plate,
       .fit = fit_rebound},
      {.name = "rebound_ratio_plate",
       .title = "V_R/V, flexible plate without the fastest test",
       .unit = "1",
       .residual_unit = "mph",
       .method =
           "least squares of V_R over V through the origin, the two tests that the report lays the line by",
       .column = "rebound_mph",
       .takes =
           [high_speed](const MeasuredTest& test) { return on_plate(test) && test.speed_mph < high_speed; },
       .fit = fit_rebound}};
  for (Trend& trend : energy_trends(data)) trends.push_back(std::move(trend));
  return trends;
}

}  // namespace

std::vector<FittedConstant> fit_trends(const ValidationData& data) {
  std::vector<FittedConstant> constants;
  for (const Trend& trend : trends_of(data)) constants.push_back(fitted(trend, data));
  return constants;
}

}  // namespace dashpad::report1986
