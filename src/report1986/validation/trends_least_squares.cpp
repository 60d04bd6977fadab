#include "report1986/validation/trends_least_squares.hpp"

#include <algorithm>
#include <cmath>

#include "dashpad/quantities/constants.hpp"
#include "uncertainty/line.hpp"

namespace dashpad::report1986 {

namespace {

Estimate estimate(double value, double half_width) { return {value, value - half_width, value + half_width}; }

/// Fieller: all r for which intercept - r slope may be 0. `t2_aa` and so on: t^2 times the covariances.
Estimate ratio_of(double intercept, double slope, double t2_aa, double t2_ab, double t2_bb) {
  const double ratio = intercept / slope;
  const double a = slope * slope - t2_bb;
  const double b = intercept * slope - t2_ab;
  const double c = intercept * intercept - t2_aa;
  if (!(a > 0)) return {ratio, -infinite, infinite};
  const double root = std::sqrt(std::max(0.0, b * b - a * c));
  return {ratio, (b - root) / a, (b + root) / a};
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

}  // namespace dashpad::report1986
