#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// The duration less the rounding of the times: a plateau from 3.5 to 6.5 ms lasts 3 ms, although the
/// difference of the two doubles is less than the double 0.003.
inline double attainable(const Pulse& pulse, double duration) {
  const double latest = std::max(std::abs(pulse.time.front()), std::abs(pulse.time.back()));
  return std::max(0.0, duration - 8 * std::numeric_limits<double>::epsilon() * latest);
}

}  // namespace dashpad::injury
