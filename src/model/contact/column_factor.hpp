#pragma once
/// By what the force of independent columns is multiplied, since their neighbours help them: theory.md, Eq.
/// 57.
///
///   g(Y) = first + slope Y + bend Y^2 up to a penetration, and from there on what it is there
///
/// Penetration in m from the surface of the new pad; g without a unit, positive up to the lock.

#include <algorithm>
#include <limits>

namespace dashpad {

struct ColumnFactor {
  double first = 1;
  double slope = 0;                                        ///< 1/m
  double bend = 0;                                         ///< 1/m2
  double until = std::numeric_limits<double>::infinity();  ///< m

  [[nodiscard]] bool is_one() const { return first == 1 && slope == 0 && bend == 0; }
  [[nodiscard]] double operator()(double y) const {
    const double x = std::clamp(y, 0.0, until);
    return first + x * (slope + x * bend);
  }
  /// Work of the force g F from 0 to y, by parts: `integral(y, n)` is F integrated n times from 0.
  ///
  ///   W = g I1 - g' I2 + g'' I3
  template <class Integral>
  [[nodiscard]] double work(double y, const Integral& integral) const {
    const double x = std::min(y, until);
    const double within = (*this)(x)*integral(x, 1) - (slope + 2 * bend * std::max(x, 0.0)) * integral(x, 2) +
                          2 * bend * integral(x, 3);
    return y > until ? within + (*this)(until) * (integral(y, 1) - integral(until, 1)) : within;
  }

  bool operator==(const ColumnFactor&) const = default;
};

}  // namespace dashpad
