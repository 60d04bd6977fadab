#include "output/plot/impact_energies.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace dashpad::output {

namespace {

/// Integral of a force over the way that it goes, up to each entry, by trapezoids.
template <class Way>
std::vector<double> work_of(const std::vector<double>& force, Way&& way) {
  std::vector<double> work(force.size(), 0.0);
  for (std::size_t i = 1; i < force.size(); ++i)
    work[i] = work[i - 1] + (force[i - 1] + force[i]) / 2 * (way(i) - way(i - 1));
  return work;
}

}  // namespace

ImpactEnergies impact_energies(const ImpactCase& impact, const History& history) {
  const std::vector<double> back = work_of(history.force_of_pad(), [&](std::size_t i) {
    return history.support_deflection[i] + (history.body_motion.empty() ? 0 : history.body_motion[i]);
  });
  // With the sheet on it, which takes its share from the impactor.
  const bool has_sheet = !history.pad_force.empty();
  ImpactEnergies energies;
  energies.pad = work_of(
      history.force, [&](std::size_t i) { return has_sheet ? history.motion[i] : history.penetration[i]; });
  const double weight = impact.impactor.mass * impact.impactor.gravity;
  for (std::size_t i = 0; i < history.size(); ++i) {
    if (has_sheet) energies.pad[i] -= back[i];
    energies.kinetic.push_back(impact.impactor.mass * history.velocity[i] * history.velocity[i] / 2);
    // What a support has taken is a function of the force as long as it is only elastic.
    const double elastic = impact.support.is_rigid() ? 0.0 : impact.support.energy(history.force_of_pad()[i]);
    energies.support.push_back(history.body_motion.empty() ? elastic : back[i]);
    energies.total.push_back(energies.kinetic[i] + energies.support[i] + energies.pad[i] -
                             weight * history.motion[i]);
    energies.largest_deviation =
        std::max(energies.largest_deviation, std::abs(energies.total[i] / energies.kinetic.front() - 1));
  }
  return energies;
}

}  // namespace dashpad::output
