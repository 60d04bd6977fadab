#pragma once
/// A third solver of the impact, for the question which branch the pad takes where the equations admit
/// several: the support gets a dashpot, and the dashpot is made weaker and weaker.
///
///   pad force = Fs(X - Y) + c d(X - Y)/dt,   M dV/dt = -pad force,   dX/dt = V
///
/// With c > 0 the penetration's rate v = V - (pad force - Fs) / c is a continuous function of time and the
/// equations have one solution: where the pad's force outgrows the support's, v falls, otherwise it rises. No
/// rule about loading and unloading is needed. With c -> 0 this is the motion that docs/theory.md asks for.
///
/// Implicit steps of fixed length, of first order where v jumps; fixed columns, trapezoidal rule over the
/// depth. The columns follow their law exactly at a constant rate. Laws 2, 4 and 5, yielding supports. The
/// penetration must stay below the sphere's radius.

#include <vector>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::oracle {

struct DampedOptions {
  double damping = 0;   ///< c, N s/m, > 0
  double step = 0;      ///< s, > 0
  int columns = 600;    ///< >= 8
  double longest = 10;  ///< s
};

struct DampedImpact {
  bool released = false;
  double peak_force = 0;           ///< N
  double peak_penetration = 0;     ///< m
  double rebound_speed = 0;        ///< m/s
  double release_time = 0;         ///< s
  std::vector<double> turnings;    ///< s: the penetration begins to fall
  std::vector<double> reloadings;  ///< s: and to grow again
};

/// Throws std::invalid_argument for a law without memory, a rigid support or a penetration beyond the
/// sphere's radius.
DampedImpact solve_damped(const ImpactCase& impact, const DampedOptions& options);

}  // namespace dashpad::oracle
