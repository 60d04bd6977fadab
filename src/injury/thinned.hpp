#pragma once
/// A pulse with half the samples: what their number leaves out shows in the difference.

#include <cstddef>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// With fewer samples nothing is left out, and a comparison says nothing.
inline constexpr std::size_t fewest_to_compare = 4;

/// Every second sample, both ends kept, into a pulse whose memory is used again.
inline void thin(const Pulse& pulse, Pulse& half) {
  half.time.clear();
  half.acceleration.clear();
  const std::size_t last = pulse.time.size() - 1;
  for (std::size_t i = 0; i <= last; i += i + 1 == last ? 1 : 2) {
    half.time.push_back(pulse.time[i]);
    half.acceleration.push_back(pulse.acceleration[i]);
  }
}

inline Pulse thinned(const Pulse& pulse) {
  Pulse half;
  thin(pulse, half);
  return half;
}

}  // namespace dashpad::injury
