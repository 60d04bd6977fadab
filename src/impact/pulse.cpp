#include "dashpad/impact/pulse.hpp"

#include <cmath>
#include <stdexcept>
#include <string>

namespace dashpad {

void check(const Pulse& pulse) {
  const std::size_t size = pulse.time.size();
  if (pulse.acceleration.size() != size)
    throw std::invalid_argument("pulse: " + std::to_string(size) + " times but " +
                                std::to_string(pulse.acceleration.size()) + " accelerations");
  if (size < 2) throw std::invalid_argument("pulse: at least two samples are needed");
  // Most pulses are sound, which is checked without a branch for each sample: x - x is 0 if x is finite.
  double doubt = pulse.time[0] - pulse.time[0] + (pulse.acceleration[0] - pulse.acceleration[0]);
  unsigned disorder = 0;
  for (std::size_t i = 1; i < size; ++i) {
    doubt += (pulse.time[i] - pulse.time[i]) + (pulse.acceleration[i] - pulse.acceleration[i]);
    disorder |= pulse.time[i] > pulse.time[i - 1] ? 0U : 1U;
  }
  if (doubt == 0 && disorder == 0) return;
  for (std::size_t i = 0; i < size; ++i) {
    if (!std::isfinite(pulse.time[i]) || !std::isfinite(pulse.acceleration[i]))
      throw std::invalid_argument("pulse: sample " + std::to_string(i + 1) + " is not finite");
    if (i > 0 && !(pulse.time[i] > pulse.time[i - 1]))
      throw std::invalid_argument("pulse: sample " + std::to_string(i + 1) +
                                  " is not later than the previous one");
  }
}

}  // namespace dashpad
