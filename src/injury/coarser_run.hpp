#pragma once
/// What the steps of the solver leave in a figure of its history, by the run before the finest and by the
/// bend of the history itself.

#include <algorithm>
#include <cmath>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"

namespace dashpad::injury {

/// Whether there is a coarser run to compare with.
inline bool has_coarser_run(const Solution& solution) { return solution.coarser.time.size() >= 2; }

/// Relative error of a figure that is `coarser` with twice the step. The step is of second order, so that a
/// third of the difference is left; twice that is taken, for times of events fall anywhere in a step.
inline double step_error(double value, double coarser) {
  return value == 0 ? std::abs(coarser) : 2.0 / 3 * std::abs(coarser / value - 1);
}

/// Relative error of the level of a clip, by the chords between samples that cross it: the curve leaves a
/// chord of length h by at most h^2 |a''| / 8, with a'' by the second differences at its ends. The level is
/// read at few places, whose errors in two runs may be equal by chance.
double chord_error(const Pulse& pulse, const Clip& clip);

inline double step_error(const Pulse& pulse, const Clip& clip, const Clip& coarser) {
  return std::max(step_error(clip.level, coarser.level), chord_error(pulse, clip));
}

}  // namespace dashpad::injury
