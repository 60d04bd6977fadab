#include "dashpad/impact/post_impact.hpp"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

namespace dashpad {
namespace {

void check(const Body& body, const char* name) {
  if (!(body.mass > 0))
    throw std::invalid_argument(std::string("post impact: the mass of the ") + name +
                                " body is not positive");
  if (!std::isfinite(body.velocity))
    throw std::invalid_argument(std::string("post impact: the velocity of the ") + name +
                                " body is not finite");
}

/// M / (M + other), the share of a mass, which may be infinite.
double share(double mass, double other) { return std::isinf(mass) ? 1 : mass / (mass + other); }

}  // namespace

/// Eqs. 1 and 2 as changes of velocity: (1 + sqrt(C)) times the speed of approach times the other's share.
PostImpact post_impact(Body first, Body second, double absorbed_fraction, double error) {
  check(first, "first");
  check(second, "second");
  if (std::isinf(first.mass) && std::isinf(second.mass))
    throw std::invalid_argument("post impact: both masses are infinite");
  if (!(first.velocity > second.velocity))
    throw std::invalid_argument("post impact: the bodies do not approach each other");
  if (!(absorbed_fraction >= 0 && absorbed_fraction <= 1))
    throw std::invalid_argument("post impact: the absorbed fraction is not between 0 and 1");
  if (!(error >= 0)) throw std::invalid_argument("post impact: the error of the energy is negative");

  const double first_share = share(first.mass, second.mass);
  const double second_share = share(second.mass, first.mass);
  const double approach = first.velocity - second.velocity;
  const double reduced_mass =
      first.mass <= second.mass ? first.mass * second_share : second.mass * first_share;

  PostImpact after;
  after.energy_coefficient = 1 - absorbed_fraction;
  after.restitution = std::sqrt(after.energy_coefficient);
  after.first_velocity = first.velocity - (1 + after.restitution) * second_share * approach;
  after.second_velocity = second.velocity + (1 + after.restitution) * first_share * approach;
  after.available_energy = reduced_mass * approach * approach / 2;

  // The square root is steeper below C than above.
  after.errors.restitution = after.restitution - std::sqrt(std::max(0.0, after.energy_coefficient - error));
  if (after.energy_coefficient < error)
    after.errors.restitution =
        std::max(after.restitution, std::sqrt(after.energy_coefficient + error) - after.restitution);
  after.errors.first_velocity = after.errors.restitution * second_share * approach;
  after.errors.second_velocity = after.errors.restitution * first_share * approach;
  return after;
}

PostImpact post_impact(Body first, Body second, const Solution& solution) {
  return post_impact(first, second, std::clamp(solution.summary.energy_absorbed_fraction, 0.0, 1.0),
                     solution.summary.errors.energy_absorbed);
}

ImpactCase relative_motion(ImpactCase impact, const Body& first, const Body& second) {
  impact.impactor.mass = first.mass * share(second.mass, first.mass);
  impact.impactor.speed = first.velocity - second.velocity;
  return impact;
}

EnergySplit energy_split(const ImpactCase& impact, const Solution& solution) {
  const History& history = solution.history;
  const EnergyLedger& end = solution.summary.energy;
  EnergySplit split;
  split.impact = end.impact;
  split.rebound = end.kinetic;
  split.support_at_end = end.support;
  split.pad = end.pad;
  const auto peak = std::max_element(history.force.begin(), history.force.end()) - history.force.begin();
  const auto i = static_cast<std::size_t>(peak);
  split.kinetic_at_peak = 0.5 * impact.impactor.mass * history.velocity[i] * history.velocity[i];
  split.support_at_peak = impact.support.energy(history.force[i]);
  split.pad_at_peak = split.impact - split.kinetic_at_peak - split.support_at_peak;
  return split;
}

}  // namespace dashpad
