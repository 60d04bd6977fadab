#include "dashpad/injury/peak.hpp"

#include <cmath>

#include "injury/accurate_sum.hpp"

namespace dashpad::injury {

Peak peak(const Pulse& pulse) {
  check(pulse);
  Peak peak{std::abs(pulse.acceleration[0]), pulse.time[0]};
  for (std::size_t i = 1; i < pulse.time.size(); ++i)
    if (std::abs(pulse.acceleration[i]) > peak.magnitude)
      peak = {std::abs(pulse.acceleration[i]), pulse.time[i]};
  return peak;
}

double velocity_change(const Pulse& pulse) {
  check(pulse);
  AccurateSum sum;
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const double mean = pulse.acceleration[i - 1] / 2 + pulse.acceleration[i] / 2;
    sum.add(mean * (pulse.time[i] - pulse.time[i - 1]));
  }
  return std::abs(sum.value());
}

}  // namespace dashpad::injury
