#include "dashpad/injury/metrics.hpp"

#include <cmath>

#include "injury/pulse_line.hpp"

namespace dashpad::injury {

Peak peak(const Pulse& pulse) {
  check(pulse);
  const std::size_t top = peak_sample(pulse);
  return {std::abs(pulse.acceleration[top]), pulse.time[top]};
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
