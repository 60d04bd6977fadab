#include "fit/comparison.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <stdexcept>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "fit/impact_residuals.hpp"
#include "fit/met.hpp"

namespace dashpad::fit {

namespace {

/// What a verdict may rest on.
constexpr std::array of_verdicts{ImpactFigure::peak_force,      ImpactFigure::peak_acceleration,
                                 ImpactFigure::hic15,           ImpactFigure::hic36,
                                 ImpactFigure::hic_unlimited,   ImpactFigure::rebound_speed,
                                 ImpactFigure::peak_penetration};

/// By the velocity change less the speed, and less what gravity adds while the sensor, in free fall at zero,
/// feels the pad.
std::optional<double> rebound_of(const MeasuredDeceleration& pulse, const Impactor& impactor) {
  const double rebound = pulse.velocity_change - impactor.speed - impactor.gravity * pulse.time.back();
  return rebound > 0 && rebound <= impactor.speed ? std::optional{rebound} : std::nullopt;
}

/// What the impact computes, filtered as the measured pulse was.
struct Computed {
  std::optional<double> peak, hic, rebound;
};

Computed computed_of(const Solution& solution, const MeasuredDeceleration& measured) {
  Computed of;
  of.peak = solution.summary.peak_acceleration;
  of.rebound = solution.summary.rebound_speed;
  std::optional<Pulse> pulse = smooth_pulse(solution);
  if (pulse && measured.filter) {
    pulse = injury::filtered_like(measured.filter, measured.interval, *pulse);
    of.peak = injury::peak(*pulse).magnitude;
  }
  if (pulse) of.hic = injury::hic(*pulse, injury::unlimited_window).value;
  return of;
}

}  // namespace

std::vector<ImpactComparison> compared(const Fit& fit, const ImpactMeasurement& impact,
                                       std::span<const double> values) {
  std::vector<ImpactComparison> all;
  const auto add = [&](ImpactFigure figure, double measured, std::optional<double> computed,
                       std::optional<double> deviation) {
    all.push_back({impact.file, figure, impact.is_held_out, !deviation, measured, computed, deviation});
  };
  if (const auto& pulse = impact.pulse) {
    Computed of;
    const ImpactCase with_values = impact_with(fit, impact, values);
    if (violations(with_values).empty()) of = computed_of(solve(with_values, impact.options), *pulse);
    add(ImpactFigure::peak_acceleration, pulse->peak, of.peak, {});
    add(ImpactFigure::hic_unlimited, pulse->hic, of.hic, {});
    if (const auto rebound = rebound_of(*pulse, with_values.impactor))
      add(ImpactFigure::rebound_speed, *rebound, of.rebound, {});
  }
  const auto is_there = [&](ImpactFigure figure) {
    return std::ranges::any_of(all, [&](const ImpactComparison& of) { return of.figure == figure; });
  };
  for (const MetFigure& met : met_figures(fit, impact, values))
    if (met.measured > 0 && std::ranges::count(of_verdicts, met.figure) > 0 && !is_there(met.figure))
      add(met.figure, met.measured, met.computed, met.deviation);
  return all;
}

}  // namespace dashpad::fit
