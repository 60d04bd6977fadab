#pragma once
/// The motion of two bodies after an impact with a known absorbed energy.
///
///   V1' = ((M1 - M2 sqrt(C)) V1 + (1 + sqrt(C)) M2 V2) / (M1 + M2)                          (report, Eq. 1)
///   V2' = ((1 + sqrt(C)) M1 V1 + (M2 - M1 sqrt(C)) V2) / (M1 + M2)                          (report, Eq. 2)
///   1 - C = E_absorbed / E_available                                                        (report, Eq. 3)
///   E_available = M1 M2 (V1 - V2)^2 / (2 (M1 + M2))                                         (report, Eq. 4)
///
/// The report calls C the coefficient of restitution, which usually means its square root, a ratio of speeds.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

struct Body {
  double mass = 0;      ///< kg, > 0; infinite for an immovable body
  double velocity = 0;  ///< m/s
};

struct PostImpact {
  double first_velocity = 0;      ///< V1', m/s
  double second_velocity = 0;     ///< V2', m/s
  double energy_coefficient = 0;  ///< C
  double restitution = 0;         ///< sqrt(C): the ratio of the speeds of separation and approach
  double available_energy = 0;    ///< J

  /// Errors of sqrt(C), V1' and V2' (m/s) by that of the absorbed fraction: taken as differences, since the
  /// derivative of sqrt(C) has no bound as C goes to 0.
  struct Errors {
    double restitution = 0, first_velocity = 0, second_velocity = 0;
  } errors;
};

/// `absorbed_fraction` is 1 - C, in [0, 1], known to within `error`, >= 0. Throws std::invalid_argument for a
/// fraction outside that range, a negative error, a mass that is not positive, two infinite masses, a
/// velocity that is not finite, or bodies that do not approach (V1 <= V2).
PostImpact post_impact(Body first, Body second, double absorbed_fraction, double error = 0);
/// The same with the fraction absorbed in a solved impact, limited to [0, 1], and its estimated error.
PostImpact post_impact(Body first, Body second, const Solution& solution);

/// Energies when the force is largest and at the end, J.
struct EnergySplit {
  double impact = 0;  ///< M V0^2 / 2 of the impactor
  double kinetic_at_peak = 0, support_at_peak = 0, pad_at_peak = 0;
  double rebound = 0, support_at_end = 0, pad = 0;  ///< `pad`: absorbed
};
EnergySplit energy_split(const ImpactCase& impact, const Solution& solution);

/// The case of two free bodies in relative motion: reduced mass and speed of approach for the impactor.
ImpactCase relative_motion(ImpactCase impact, const Body& first, const Body& second);

}  // namespace dashpad
