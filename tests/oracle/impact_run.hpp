#pragma once
/// What the phases of the CVODE oracle hand to one another.

#include <array>
#include <cmath>
#include <vector>

#include "dashpad/model/support/support.hpp"
#include "oracle/cvode_impact.hpp"
#include "oracle/ode_session.hpp"
#include "oracle/support_line.hpp"

namespace dashpad::oracle {

/// The inputs, SI, and the results so far.
struct ImpactRun {
  double mass = 0;       ///< kg
  double radius = 0;     ///< m
  double speed = 0;      ///< m/s
  double thickness = 0;  ///< m
  double earlier = 0;    ///< largest penetration of earlier blows, m; of foams only
  SupportLine support;
  Backing backing;     ///< foams by curves only, on a linear support
  double gravity = 0;  ///< m/s2
  CvodeOptions options;
  CvodeImpact result;

  /// Keeps a force if it is the largest so far.
  void note_force(double time, double force) {
    if (force <= result.peak_force) return;
    result.peak_force = force;
    result.time_of_peak_force = time;
  }
  void note_drift(double pad_force, double support_force) {
    result.drift = std::fmax(result.drift, std::fabs(pad_force - support_force) / result.peak_force);
  }
  void note_work(const OdeSession& session) {
    result.derivative_calls += session.derivative_calls();
    result.steps += session.steps();
  }
};

/// The first three unknowns of every phase.
enum : std::size_t { motion = 0, velocity = 1, penetration = 2, first_column = 3 };

/// State of the pad where loading ends: q = stress/A over the Chebyshev points.
struct TurningPoint {
  double time = 0;
  std::array<double, 3> state{};
  std::vector<double> ratio;  ///< stress/A, Pa
};

}  // namespace dashpad::oracle
