#pragma once
/// What the steps of the solver leave in a figure of its history, by the run before the finest.

#include <cmath>

#include "dashpad/impact/solution.hpp"

namespace dashpad::injury {

/// Whether there is a coarser run to compare with.
inline bool has_coarser_run(const Solution& solution) { return solution.coarser.time.size() >= 2; }

/// Relative error of a figure that is `coarser` with twice the step. The step is of second order, so that a
/// third of the difference is left; twice that is taken, for times of events fall anywhere in a step.
inline double step_error(double value, double coarser) {
  return value == 0 ? std::abs(coarser) : 2.0 / 3 * std::abs(coarser / value - 1);
}

}  // namespace dashpad::injury
