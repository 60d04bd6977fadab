#pragma once
/// An acceleration over time, measured or computed: what all injury metrics take.

#include <vector>

namespace dashpad {

/// Samples at increasing times, evenly spaced or not; between two samples the acceleration is linear, and
/// outside the pulse there is none.
struct Pulse {
  std::vector<double> time;          ///< s, strictly increasing
  std::vector<double> acceleration;  ///< m/s2, of either sign
};

/// Throws std::invalid_argument that says what is wrong: columns of different length, fewer than two samples,
/// a number that is not finite, times that do not increase. Every metric calls it first.
void check(const Pulse& pulse);

}  // namespace dashpad
