#include "dashpad/injury/peak.hpp"

#include <cmath>

namespace dashpad {

Peak peak(const Pulse& pulse) {
  check(pulse);
  Peak peak{std::abs(pulse.acceleration[0]), pulse.time[0]};
  for (std::size_t i = 1; i < pulse.time.size(); ++i)
    if (std::abs(pulse.acceleration[i]) > peak.magnitude)
      peak = {std::abs(pulse.acceleration[i]), pulse.time[i]};
  return peak;
}

/// The rest that each addition rounds away is kept and added at the end (Neumaier's sum).
double velocity_change(const Pulse& pulse) {
  check(pulse);
  double sum = 0;
  double rest = 0;
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const double mean = pulse.acceleration[i - 1] / 2 + pulse.acceleration[i] / 2;
    const double gain = mean * (pulse.time[i] - pulse.time[i - 1]);
    const double next = sum + gain;
    rest += std::abs(sum) >= std::abs(gain) ? (sum - next) + gain : (gain - next) + sum;
    sum = next;
  }
  return sum + rest;
}

}  // namespace dashpad
