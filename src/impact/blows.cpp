#include "dashpad/impact/blows.hpp"

#include <algorithm>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solver.hpp"
#include "impact/blow_series.hpp"

namespace dashpad {

ImpactCase first_blow(const ImpactCase& series) {
  ImpactCase blow = series;
  blow.blows.reset();
  return blow;
}

std::optional<ImpactCase> next_blow(const ImpactCase& series, const ImpactCase& blow, const Summary& summary,
                                    const Options& options) {
  const bool leaves_a_pad =
      options.fixed_runs > 0 ? summary.release && !summary.bottomed : leaves_a_known_pad(summary);
  if (summary.blow >= summary.blows || !leaves_a_pad) return std::nullopt;
  ImpactCase next = blow;
  if (blow_memory(blow.pad.material.law) != BlowMemory::none)
    next.pad.earlier_penetration =
        (1 - series.blows->recovery) * std::max(blow.pad.earlier_penetration, summary.peak_penetration);
  // Below its preload a support stays where it is.
  if (summary.support && summary.support->crushing_force > blow.backing.preload)
    next.backing.earlier_force = std::max(blow.backing.earlier_force, summary.support->crushing_force);
  return next;
}

std::vector<Blow> solve_blows(const ImpactCase& impact, const Options& options) {
  std::vector<Blow> blows;
  Solver().solve_each_blow(impact, options, [&](const ImpactCase& blow, const Solution& solution) {
    blows.push_back({blow, solution});
  });
  return blows;
}

}  // namespace dashpad
