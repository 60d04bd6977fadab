#include <algorithm>
#include <cmath>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/report1986/validation/energy.hpp"
#include "dashpad/report1986/validation/verdict.hpp"
#include "report1986/validation/trends_least_squares.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double ratio_tolerance = 0.25;  ///< docs/decisions/0007-validation-rules.md

/// The force at which an increasing curve of speed over force reaches a speed.
template <class Curve>
double force_at(double speed_mph, Curve&& speed_of) {
  double low = 1, high = 1e6;
  for (int i = 0; i < 60; ++i) {
    const double middle = std::sqrt(low * high);
    (speed_of(middle) < speed_mph ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

double tail_force_lb(const ValidationData& data) {
  double sum = 0;
  int readings = 0;
  for (const MeasuredTest& test : data.measured.tests)
    if ((test.number == 1 || test.number == 24) && test.peak_force_lb) sum += *test.peak_force_lb, ++readings;
  return readings > 0 ? sum / readings : 0;
}

Estimate slope_of(const std::vector<Point>& points) {
  const auto [least, greatest] = std::ranges::minmax_element(points, {}, &Point::x);
  if (points.empty() || least->x == greatest->x) return {no_value, no_value, no_value};
  return fit_line(points).slope;
}

bool gives_the_printed_ratios(const ValidationData& data, const ForceTrend& trend) {
  return std::ranges::all_of(printed_ratios, [&](const PrintedRatio& printed) {
    return std::abs(trend.*printed.ours / data.constant(printed.constant) - 1) <= ratio_tolerance;
  });
}

}  // namespace

double curve_a_force_lb(const ValidationData& data, Projectile projectile, double speed_mph) {
  const double trend =
      force_at(speed_mph, [&](double force) { return curve_a_speed_mph(data, projectile, force); });
  return projectile == Projectile::aluminium ? std::max(trend, tail_force_lb(data)) : trend;
}

double curve_b_force_lb(const ValidationData& data, Projectile projectile, double speed_mph) {
  return force_at(speed_mph, [&](double force) { return curve_b_speed_mph(data, projectile, force); });
}

ForceTrend force_trend(const ValidationData& data, const std::vector<Prediction>& at_tests,
                       const std::vector<Prediction>& on_curves, Program program, double radius_in) {
  ForceTrend trend;
  trend.program = program;
  trend.radius_in = radius_in;
  const Score force =
      score(data.measured, at_tests, program, TestSupport::load_cell, Quantity::peak_force, radius_in);
  std::vector<Point> all, aluminium;
  for (const TestError& error : force.errors) {
    const MeasuredTest& test = *std::ranges::find(data.measured.tests, error.test, &MeasuredTest::number);
    all.push_back({std::log(test.speed_mph), std::log(error.predicted / error.measured)});
    if (test.projectile == Projectile::aluminium) aluminium.push_back(all.back());
  }
  trend.tests = static_cast<int>(all.size());
  const Estimate both = slope_of(all), one = slope_of(aluminium);
  trend.slope = both.value;
  trend.slope_confidence = {both.low, both.high};
  trend.aluminium_slope = one.value;
  trend.aluminium_slope_confidence = {one.low, one.high};
  for (const auto& [projectile, speed, constant, ours] : printed_ratios) {
    const auto peak = predicted(on_curves, program, {projectile, TestSupport::load_cell, speed, radius_in},
                                Quantity::peak_force);
    trend.*ours = peak ? *peak / curve_a_force_lb(data, projectile, speed) : no_value;
  }
  return trend;
}

AnomalyVerdict judge_anomaly(const ValidationData& data, std::vector<ForceTrend> trends, bool force_passed) {
  AnomalyVerdict verdict;
  const auto first = std::ranges::find(trends, Program::accurate_first_slope, &ForceTrend::program);
  const auto curve = std::ranges::find(trends, Program::accurate, &ForceTrend::program);
  if (first != trends.end() && curve != trends.end()) {
    verdict.first_slope_gives_the_fall = gives_the_printed_ratios(data, *first);
    verdict.curve_removes_the_fall = curve->slope_confidence.holds(0) && force_passed;
    verdict.slope_halves = std::abs(curve->slope) <= std::abs(first->slope) / 2;
  }
  if (verdict.first_slope_gives_the_fall && verdict.curve_removes_the_fall)
    verdict.explanation = Explanation::explains;
  else if (verdict.first_slope_gives_the_fall && verdict.slope_halves)
    verdict.explanation = Explanation::in_part;
  verdict.trends = std::move(trends);
  return verdict;
}

}  // namespace dashpad::report1986
