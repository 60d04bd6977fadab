#include "dashpad/injury/severity_index.hpp"

#include <algorithm>
#include <cmath>

#include "dashpad/impact/solution.hpp"
#include "injury/accurate_sum.hpp"

namespace dashpad {
namespace {

double power_2_5(double a) { return a * a * std::sqrt(a); }

/// Mean of |a|^2.5 over a line between two levels of the same sign. With p = sqrt|a|, q = sqrt|b| it is
///   2/7 (q^7 - p^7) / (q^2 - p^2) = 2/7 (q^6 + q^5 p + ... + p^6) / (q + p),
/// in which nothing cancels where the line is level.
double mean_between(double a, double b) {
  const double large = std::max(std::abs(a), std::abs(b));
  const double small = std::min(std::abs(a), std::abs(b));
  if (large == 0) return 0;
  const double r = std::sqrt(small / large);
  const double sum = 1 + r * (1 + r * (1 + r * (1 + r * (1 + r * (1 + r)))));
  return 2.0 / 7 * power_2_5(large) * sum / (1 + r);
}

/// The same where the line may cross zero: then it is two triangles.
double mean_along(double a, double b) {
  if ((a >= 0) == (b >= 0)) return mean_between(a, b);
  const double share = a / (a - b);
  return share * mean_between(a, 0) + (1 - share) * mean_between(0, b);
}

}  // namespace

double severity_index(const Pulse& pulse) {
  check(pulse);
  AccurateSum sum;
  for (std::size_t i = 0; i + 1 < pulse.time.size(); ++i)
    sum.add((pulse.time[i + 1] - pulse.time[i]) * mean_along(pulse.acceleration[i] / standard_gravity,
                                                             pulse.acceleration[i + 1] / standard_gravity));
  return sum.value();
}

}  // namespace dashpad
