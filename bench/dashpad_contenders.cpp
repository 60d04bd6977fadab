// Dashpad's own settings.

#include <fmt/format.h>

#include <cmath>
#include <memory>

#include "contenders.hpp"
#include "dashpad/impact/solve.hpp"
#include "fixed_run.hpp"

namespace dashpad::bench {
namespace {

Options with_tolerance(double tolerance) {
  Options options;
  options.tolerance = tolerance;
  return options;
}

std::optional<Outcome> outcome_of(const Summary& s) {
  if (!s.trustworthy() || !s.peak_force || !s.rebound_speed) return std::nullopt;
  return Outcome{*s.peak_force, s.peak_penetration, *s.rebound_speed};
}

std::optional<Outcome> outcome_of(const Figures& figures) {
  if (!figures.release) return std::nullopt;
  return Outcome{figures.peak_force, figures.peak_penetration, std::abs(figures.release->velocity)};
}

}  // namespace

ImpactCase at_speed(ImpactCase impact, double share) {
  impact.impactor.speed *= share;
  return impact;
}

std::vector<Contender> dashpad_contenders(const ImpactCase& impact) {
  std::vector<Contender> contenders;
  const auto solver = std::make_shared<Solver>();
  const auto runs = std::make_shared<FixedRuns>();
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5, 1e-6}) {
    const std::string setting = fmt::format("tolerance {:.0e}", tolerance);
    const Options options = with_tolerance(tolerance);
    contenders.push_back({"Dashpad", setting, [=](double share) {
                            return outcome_of(solver->solve(at_speed(impact, share), options).summary);
                          }});
    contenders.push_back({"Dashpad (called once)", setting, [=](double share) {
                            return outcome_of(solve(at_speed(impact, share), options).summary);
                          }});
  }
  for (const double resolution : {0.4, 0.2, 0.1, 0.05, 0.025}) {
    contenders.push_back({"one run", fmt::format("resolution {}", resolution), [=](double share) {
                            return outcome_of(runs->run(at_speed(impact, share), resolution, false));
                          }});
    contenders.push_back(
        {"two runs", fmt::format("resolutions {} and {}", 2 * resolution, resolution),
         [=](double share) { return outcome_of(runs->run(at_speed(impact, share), resolution, true)); }});
  }
  return contenders;
}

}  // namespace dashpad::bench
