#include "dashpad/report1986/validation/trends.hpp"

#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/report1986/validation/energy.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation/trends_least_squares.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::report1986 {

namespace {

Estimate estimate(double value, double half_width) { return {value, value - half_width, value + half_width}; }

/// Fieller's theorem: the interval of all r for which intercept - r slope may be 0. `t2_aa` etc. are t^2
/// times the covariances.
Estimate ratio_of(double intercept, double slope, double t2_aa, double t2_ab, double t2_bb) {
  const double ratio = intercept / slope;
  const double a = slope * slope - t2_bb;
  const double b = intercept * slope - t2_ab;
  const double c = intercept * intercept - t2_aa;
  if (!(a > 0)) return {ratio, -infinite, infinite};
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  return {ratio, (b - root) / a, (b + root) / a};
}

using Tests = std::vector<MeasuredTest>;

using Fit = ProportionalFit;

struct Trend {
  FittedConstant constant;  ///< the members that are known before the fit
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

/// Omits the lost readings that cannot belong to a test of the trend.
MeasuredTests with_groups_of(const Trend& trend, MeasuredTests measured) {
  std::erase_if(measured.unplaced, [&](const UnplacedReadings& group) {
    const auto free = free_tests(measured, group);
    return std::ranges::none_of(free, [&](const MeasuredTest* test) { return trend.takes(*test); });
  });
  return measured;
}

FittedConstant fitted(const Trend& trend, const ValidationData& data) {
  const Tests certain = taken(trend, data.measured.tests);
  const auto [estimate, scatter] = trend.fit(certain);
  FittedConstant constant = trend.constant;
  constant.printed = data.constant(constant.name);
  constant.value = estimate.value;
  constant.confidence = {estimate.low, estimate.high};
  constant.scatter = scatter;
  for (const MeasuredTest& test : certain) constant.tests.push_back(test.number);

  constant.over_placings = constant.confidence_over_placings = nowhere;
  for_each_placing(with_groups_of(trend, data.measured), trend.column, [&](const Tests& tests) {
    const Estimate placed = trend.fit(taken(trend, tests)).constant;
    constant.over_placings.include(placed.value);
    constant.confidence_over_placings.include(placed.low);
    constant.confidence_over_placings.include(placed.high);
    ++constant.placings;
  });
  constant.printed_in_confidence = constant.confidence.holds(constant.printed);
  constant.printed_in_placings = constant.over_placings.holds(constant.printed);
  return constant;
}

template <class PointOf>
std::vector<Point> points_of(const Tests& tests, PointOf point_of) {
  std::vector<Point> points;
  for (const MeasuredTest& test : tests) points.push_back(point_of(test));
  return points;
}

bool on_load_cell(const MeasuredTest& test) { return test.support == TestSupport::load_cell; }
bool on_plate(const MeasuredTest& test) { return test.support == TestSupport::plate; }

template <class PointOf>
std::function<Fit(const Tests&)> proportional(PointOf point_of) {
  return [point_of](const Tests& tests) { return fit_proportional(points_of(tests, point_of)); };
}

Point rebound_over_speed(const MeasuredTest& test) { return {test.speed_mph, *test.rebound_mph}; }

Point time_over_slowness(const MeasuredTest& test) {
  return {1e3 / (inch_per_s_of_mph * test.speed_mph), *test.time_to_peak_ms};
}

// --- Energy over force: ln U = exponent (ln factor + ln F) ---

/// The line of ln U over ln F or, if `is_inverse`, of ln F over ln U.
LineFit line_of(const Tests& tests, bool is_inverse) {
  return fit_line(points_of(tests, [is_inverse](const MeasuredTest& test) {
    const double force = std::log(*test.peak_force_lb), energy = std::log(test.energy_in_lb);
    return is_inverse ? Point{energy, force} : Point{force, energy};
  }));
}

Estimate exponential(const Estimate& logarithm) {
  return {std::exp(logarithm.value), std::exp(logarithm.low), std::exp(logarithm.high)};
}

Estimate negative(const Estimate& estimate) { return {-estimate.value, -estimate.high, -estimate.low}; }

/// The interval is only useful if the estimate is positive with its whole interval.
Estimate reciprocal(const Estimate& estimate) {
  if (estimate.low <= 0) return {1 / estimate.value, 0, infinite};
  return {1 / estimate.value, 1 / estimate.high, 1 / estimate.low};
}

void add_energy_trends(const ValidationData& data, std::vector<Trend>& trends) {
  const double from = data.constant("energy_trend_from_in_lb");
  const auto add = [&](const char* constant, bool is_inverse, const char* more,
                       Estimate (*constant_of)(const LineFit&)) {
    const char *const y = is_inverse ? "ln F" : "ln U", *const x = is_inverse ? "ln U" : "ln F";
    trends.push_back(
        {{.name = fmt::format("energy_trend_{}", constant),
          .title = fmt::format("{} of U = (factor F)^exponent, {} on {}", constant, y, x),
          .unit = "1",
          .residual_unit = fmt::format("of {}", y),
          .method = fmt::format("least squares of {} against {}, load cell, energies above 300 in.lb{}", y, x,
                                more)},
         "peak_force_lb",
         [from](const MeasuredTest& test) { return on_load_cell(test) && test.energy_in_lb > from; },
         [is_inverse, constant_of](const Tests& tests) {
           const LineFit line = line_of(tests, is_inverse);
           return Fit{constant_of(line), line.scatter};
         }});
  };
  add("exponent", false, "", [](const LineFit& line) { return line.slope; });
  add("factor", false, "; interval for the zero of the line by Fieller's theorem",
      [](const LineFit& line) { return exponential(line.ratio); });
  add("exponent", true, "", [](const LineFit& line) { return reciprocal(line.slope); });
  add("factor", true, "", [](const LineFit& line) { return exponential(negative(line.intercept)); });
}

std::vector<Trend> trends_of(const ValidationData& data) {
  std::vector<Trend> trends{
      {{.name = "travel_in",
        .title = "VT, load cell",
        .unit = "in",
        .residual_unit = "ms",
        .method = "least squares of T against 1/V; 1 mph = 17.64 in/s, as in the report"},
       "time_to_peak_ms",
       on_load_cell,
       proportional(time_over_slowness)}};
  const auto add_rebound = [&](const char* name, const char* title, const std::string& of_which,
                               std::function<bool(const MeasuredTest&)> takes) {
    trends.push_back({{.name = name,
                       .title = title,
                       .unit = "1",
                       .residual_unit = "mph",
                       .method = "least squares of V_R against V through the origin" + of_which},
                      "rebound_mph",
                      std::move(takes),
                      proportional(rebound_over_speed)});
  };
  add_rebound("rebound_ratio_load_cell", "V_R/V, load cell", "", on_load_cell);
  add_rebound("rebound_ratio_plate", "V_R/V, flexible plate", ", all tests on the plate", on_plate);
  const double high_speed = data.constant("plate_speed_mph");
  add_rebound(
      "rebound_ratio_plate", "V_R/V, flexible plate, without the fastest test",
      ", the two tests through which the report draws the line",
      [high_speed](const MeasuredTest& test) { return on_plate(test) && test.speed_mph < high_speed; });
  add_energy_trends(data, trends);
  return trends;
}

}  // namespace

ProportionalFit fit_proportional(const std::vector<Point>& points) {
  double xx = 0;
  double xy = 0;
  for (const Point& point : points) {
    xx += point.x * point.x;
    xy += point.x * point.y;
  }
  const double constant = xy / xx;
  double squares = 0;
  for (const Point& point : points) squares += std::pow(point.y - constant * point.x, 2);

  const auto freedom = static_cast<double>(points.size() - 1);
  if (freedom == 0) return {estimate(constant, infinite), 0};
  const double scatter = std::sqrt(squares / freedom);
  return {estimate(constant, uncertainty::student_95(freedom) * scatter / std::sqrt(xx)), scatter};
}

LineFit fit_line(const std::vector<Point>& points) {
  const auto n = static_cast<double>(points.size());
  Point mean;
  for (const Point& point : points) {
    mean.x += point.x / n;
    mean.y += point.y / n;
  }
  double xx = 0;
  double xy = 0;
  for (const Point& point : points) {
    xx += (point.x - mean.x) * (point.x - mean.x);
    xy += (point.x - mean.x) * (point.y - mean.y);
  }
  const double slope = xy / xx;
  const double intercept = mean.y - slope * mean.x;
  double squares = 0;
  for (const Point& point : points) squares += std::pow(point.y - intercept - slope * point.x, 2);

  const auto freedom = static_cast<double>(points.size() - 2);
  if (freedom == 0)
    return {estimate(intercept, infinite), estimate(slope, infinite), estimate(intercept / slope, infinite),
            0};
  const double variance = squares / freedom;
  const double t2 = std::pow(uncertainty::student_95(freedom), 2) * variance;
  const double t2_bb = t2 / xx;
  const double t2_aa = t2 / n + mean.x * mean.x * t2_bb;
  const double t2_ab = -mean.x * t2_bb;
  return {estimate(intercept, std::sqrt(t2_aa)), estimate(slope, std::sqrt(t2_bb)),
          ratio_of(intercept, slope, t2_aa, t2_ab, t2_bb), std::sqrt(variance)};
}

std::vector<FittedConstant> fit_trends(const ValidationData& data) {
  std::vector<FittedConstant> constants;
  for (const Trend& trend : trends_of(data)) constants.push_back(fitted(trend, data));
  return constants;
}

}  // namespace dashpad::report1986
