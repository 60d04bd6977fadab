#pragma once
/// An acceleration over time, measured or computed: the input of all injury metrics.

#include <vector>

namespace dashpad {

/// Samples at increasing times, with the acceleration linear between them and 0 outside.
struct Pulse {
  std::vector<double> time;          ///< s, strictly increasing
  std::vector<double> acceleration;  ///< m/s2, of either sign
};

/// Throws std::invalid_argument that names the fault: arrays of different length, fewer than two samples, a
/// number that is not finite, times that do not increase. Every metric calls it first.
void check(const Pulse& pulse);

}  // namespace dashpad
