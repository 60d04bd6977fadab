#include "dashpad/injury/metrics.hpp"

#include <cmath>

#include "dashpad/impact/solution.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

/// |a| in g, and its root.
struct Level {
  double size, root;
};

Level level_of(double acceleration) {
  const double size = std::abs(acceleration) * (1 / standard_gravity);
  return {size, std::sqrt(size)};
}

/// Mean of |a|^2.5 over a line between two levels of the same sign. With p = sqrt|a|, q = sqrt|b| it is
///   2/7 (q^7 - p^7) / (q^2 - p^2) = 2/7 (q^6 + q^5 p + ... + p^6) / (q + p),
/// without cancellation where the line is level. Even powers are those of |a| and |b|.
double mean_between(const Level& a, const Level& b) {
  const double product = a.root * b.root, sum = a.size + b.size;
  const double powers = b.size * b.size * (sum + product) + a.size * (a.size + product) * sum;
  return powers == 0 ? 0 : 2.0 / 7 * powers / (a.root + b.root);
}

/// The mean where the line crosses zero: two triangles.
double mean_across(const Level& a, const Level& b) {
  const double share = a.size / (a.size + b.size);
  return share * mean_between(a, {0, 0}) + (1 - share) * mean_between({0, 0}, b);
}

}  // namespace

double severity_index(const Pulse& pulse) {
  check(pulse);
  AccurateSum sum;
  Level before = level_of(pulse.acceleration[0]);
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const Level now = level_of(pulse.acceleration[i]);
    const bool crosses = (pulse.acceleration[i - 1] < 0) != (pulse.acceleration[i] < 0);
    const double mean =
        crosses && before.size + now.size > 0 ? mean_across(before, now) : mean_between(before, now);
    sum.add((pulse.time[i] - pulse.time[i - 1]) * mean);
    before = now;
  }
  return sum.value();
}

}  // namespace dashpad::injury
