#pragma once
/// The largest magnitude of a pulse, and its velocity change.

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

// Both throw std::invalid_argument for a pulse that check() refuses.

struct Peak {
  double magnitude = 0;  ///< m/s2
  double time = 0;       ///< s, of the first sample that has it
};

Peak peak(const Pulse& pulse);

/// Magnitude of the integral of a over the whole pulse, m/s: how a sensor is mounted does not change it.
double velocity_change(const Pulse& pulse);

}  // namespace dashpad::injury
