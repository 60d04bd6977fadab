#pragma once
/// The speed of penetration that keeps pad and support in equilibrium: a scalar equation in ln|v|.

#include <algorithm>
#include <cmath>
#include <limits>

namespace dashpad::oracle {

/// Below it a speed is none: exp(-690) is about the smallest double.
inline constexpr double log_of_no_speed = -690;

/// Finds where f(x) goes from negative to positive, x = ln|v|, near the root of the call before: secant steps
/// inside a bracket that grows as it must. Remembers root and slope, so that a smooth sequence of calls costs
/// two or three evaluations each.
class SpeedRoot {
 public:
  explicit SpeedRoot(double guess = 0) : x_(guess) {}
  void guess(double x) { x_ = x, slope_ = 0; }

  template <class Function>
  double find(const Function& f) {
    double low = -std::numeric_limits<double>::infinity();
    double high = std::numeric_limits<double>::infinity();
    double x = std::max(x_, log_of_no_speed);
    double fx = f(x);
    double stride = 1e-3;
    bool local = true;  // whether the slope is that of a short chord; a long one can feign convergence
    for (int k = 0; k < 200 && fx != 0; ++k) {
      (fx < 0 ? low : high) = x;
      if (fx > 0 && x <= log_of_no_speed) break;
      double next = x - (slope_ > 0 ? fx / slope_ : std::copysign(stride, fx));
      next = std::clamp(next, x - 64 * stride, x + 64 * stride);
      const bool settled = std::fabs(next - x) <= tolerance;
      const bool bracketed = high - low < std::numeric_limits<double>::infinity();
      if (!(next > low && next < high) || (settled && !local) || (bracketed && high - low > widest)) {
        if (bracketed) {
          next = (low + high) / 2;
        } else {
          next = fx > 0 ? x - stride : x + stride;
        }
      }
      next = std::max(next, log_of_no_speed);
      if (std::fabs(next - x) <= tolerance) {
        x = next;
        break;
      }
      const double f_next = f(next);
      slope_ = std::isfinite(f_next - fx) ? (f_next - fx) / (next - x) : 0;
      local = std::fabs(next - x) < 0.1;
      x = next, fx = f_next;
      stride *= 4;
    }
    return x_ = x;
  }

  static constexpr double tolerance = 2e-13;
  static constexpr double widest = 8;  ///< a wider bracket is halved

 private:
  double x_ = 0;
  double slope_ = 0;  ///< of f at the last root; 0 when unknown
};

}  // namespace dashpad::oracle
