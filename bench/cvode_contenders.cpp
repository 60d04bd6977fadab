// CVODE on the same equations (tests/oracle), as a contender and as the reference.

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>

#include "contenders.hpp"
#include "oracle/cvode_impact.hpp"
#include "oracle/reference_cases.hpp"

namespace dashpad::bench {
namespace {

std::optional<Outcome> outcome_of(const oracle::CvodeImpact& result) {
  if (result.ending != oracle::Ending::released || !result.release) return std::nullopt;
  return Outcome{result.peak_force, result.peak_penetration, std::abs(result.release->velocity)};
}

Contender contender(const char* solver, const ImpactCase& impact, const oracle::CvodeOptions& options) {
  return {
      solver,
      fmt::format("{}+{} columns edge {} rtol {:.0e}", options.loading_columns, options.unloading_columns,
                  options.edge_power, options.rtol),
      [=](double share) { return outcome_of(oracle::solve_with_cvode(at_speed(impact, share), options)); }};
}

}  // namespace

std::vector<Contender> cvode_contenders(const ImpactCase& impact, bool quick) {
  std::vector<int> loading{8, 12, 16, 24, 32, 48};
  std::vector<int> unloading{24, 40, 80, 160, 320, 640};
  std::vector<double> tolerances{1e-3, 1e-4, 1e-5, 1e-6, 1e-7, 1e-8, 1e-9};
  std::vector<double> edges{3, 5};
  if (quick) loading = {12, 24}, unloading = {40, 160}, tolerances = {1e-4, 1e-6}, edges = {5};
  std::vector<Contender> contenders;
  for (const double tolerance : tolerances) {
    oracle::CvodeOptions options;
    options.rtol = tolerance;
    contenders.push_back(contender(untuned_cvode, impact, options));
    for (const int loads : loading)
      for (const int unloads : unloading)
        for (const double edge : edges) {
          options.loading_columns = loads;
          options.unloading_columns = unloads;
          options.edge_power = edge;
          contenders.push_back(contender(tuned_cvode, impact, options));
        }
  }
  return contenders;
}

References reference_solutions(const ImpactCase& impact, bool quick) {
  oracle::CvodeOptions options;
  options.loading_columns = 64;
  options.unloading_columns = quick ? 640 : 2560;
  options.rtol = quick ? 1e-10 : 1e-11;
  options.gravity = oracle::reference_gravity;
  References references;
  for (const double share : speed_shares) {
    const oracle::CvodeImpact result = oracle::solve_with_cvode(at_speed(impact, share), options);
    const auto outcome = outcome_of(result);
    if (!outcome || !result.weight) throw std::runtime_error("CVODE gave up on the reference solution");
    references[share] = {*outcome, std::abs(result.weight->velocity)};
  }
  return references;
}

}  // namespace dashpad::bench
