#pragma once
/// A pulse with half the samples: what their number leaves out shows in the difference.

#include <cmath>
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

/// Relative error that the chords between the samples leave in a figure, which is `coarser` with every second
/// of them. A chord differs from the curve by the square of the step, so the full pulse misses a third of the
/// difference; twice that is taken, for steps are uneven and the force has kinks.
inline double chord_error(double value, double coarser) {
  return value == 0 ? std::abs(coarser) : 2.0 / 3 * std::abs(coarser / value - 1);
}

}  // namespace dashpad::injury
