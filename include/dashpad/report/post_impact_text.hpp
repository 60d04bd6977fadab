#pragma once
/// The motion after an impact and where its energy went, for people and for programs.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/post_impact.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/io/unit_system.hpp"

namespace dashpad {

/// Where the energy is at two moments, J: when the force is largest, and at the end.
struct EnergySplit {
  double impact = 0;  ///< M V0^2 / 2 of the impactor as solved
  double kinetic_at_peak = 0, support_at_peak = 0, pad_at_peak = 0;
  double rebound = 0, support_at_end = 0, pad = 0;  ///< pad: absorbed
};
EnergySplit energy_split(const ImpactCase& impact, const Solution& solution);

/// `impact` is the case as solved: with the reduced mass M1 M2 / (M1 + M2) and the speed of approach V1 - V2,
/// with which the relative motion of two free bodies is that of one body against a wall.
std::string post_impact_text(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution, const UnitSystem& units);
std::string post_impact_json(const Body& first, const Body& second, const ImpactCase& impact,
                             const Solution& solution);

/// The case that describes how two free bodies approach: mass and speed of the impactor replaced.
ImpactCase relative_motion(ImpactCase impact, const Body& first, const Body& second);

}  // namespace dashpad
