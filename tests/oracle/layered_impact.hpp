#pragma once
/// Foams in layers below a flat disc, on a rigid support, written anew for the oracle: nothing here comes
/// from dashpad's own formulas.
///
///   dy/dt = V,  M dV/dt = -a stress,  dp_i/dt = u_i(e_i - p_i):  p_i is the strain of a layer that has
///   slipped the stress is the root of  sum L_i e_i(stress) = y,  and e_i that of  stress_i(e_i, e_i - p_i) =
///   stress
///
/// by bisection, with the classical method of Runge and Kutta in even steps, short against the lag.

#include <memory>
#include <vector>

#include "oracle/foam_formulas.hpp"

namespace dashpad::oracle {

struct FoamInLayer {
  double thickness = 0;  ///< m
  const FoamFormulas* foam = nullptr;
};

struct LayeredRun {
  double mass = 0;   ///< kg
  double speed = 0;  ///< m/s at first contact
  double area = 0;   ///< of the disc, m2
  double step = 0;   ///< s
};

/// Forces in N, lengths in m.
struct LayeredPeaks {
  double force = 0;
  double penetration = 0;
  std::vector<double> strain;  ///< of each layer
  double rebound_speed = 0;    ///< when the force has gone; m/s
};

LayeredPeaks solve_layers(const LayeredRun& run, const std::vector<FoamInLayer>& layers);

}  // namespace dashpad::oracle
