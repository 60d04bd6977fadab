#pragma once
/// Least squares for one or two constants, with 95 % intervals by Student's t, infinite without freedom.

#include <vector>

#include "dashpad/study/answers.hpp"

namespace dashpad::report1986 {

using study::Estimate;

struct Point {
  double x = 0, y = 0;
};

/// y = constant x, for at least one point.
struct ProportionalFit {
  Estimate constant;
  double scatter = 0;  ///< standard deviation of the residuals, n - 1; 0 for one point
};
ProportionalFit fit_proportional(const std::vector<Point>& points);

/// y = intercept + slope x, for at least two points of different x.
struct LineFit {
  Estimate intercept, slope;
  Estimate ratio;      ///< intercept / slope, interval by Fieller's theorem; infinite if the slope may be 0
  double scatter = 0;  ///< standard deviation of the residuals, n - 2; 0 for two points
};
LineFit fit_line(const std::vector<Point>& points);

}  // namespace dashpad::report1986
