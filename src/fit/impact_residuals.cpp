#include "fit/impact_residuals.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>

#include "dashpad/impact/case_quantity.hpp"
#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solver.hpp"
#include "dashpad/injury/clip.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/hic.hpp"
#include "dashpad/injury/peak.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "fit/problem.hpp"
#include "fit/smooth_curve.hpp"

namespace dashpad::fit {

namespace {

constexpr int points_per_step = 4;  ///< of the curve through the steps of the solver

using Setter = std::function<void(ImpactCase&, double)>;

/// How each unknown gets into an impact. Throws std::invalid_argument where that has no such quantity.
std::vector<Setter> setters_of(const Fit& fit, const std::string& file, const ImpactCase& impact) {
  std::vector<Setter> setters;
  const std::vector<CaseQuantity> quantities = quantities_of(impact);
  for (const Unknown& unknown : fit.unknowns) {
    const auto found = std::ranges::find(quantities, unknown.key, &CaseQuantity::key);
    if (found == quantities.end()) throw std::invalid_argument(file + " has no " + unknown.key);
    setters.push_back(found->set);
  }
  return setters;
}

double figure_of(const Pulse& pulse, ImpactFigure figure) {
  constexpr double three_milliseconds = 3e-3;
  switch (figure) {
    case ImpactFigure::hic15: return injury::hic(pulse, injury::hic15_window).value;
    case ImpactFigure::hic36: return injury::hic(pulse, 36e-3).value;
    case ImpactFigure::hic_unlimited: return injury::hic(pulse, injury::unlimited_window).value;
    case ImpactFigure::clip_3ms: return injury::contiguous_clip(pulse, three_milliseconds).level;
    case ImpactFigure::cumulative_3ms: return injury::cumulative_clip(pulse, three_milliseconds).level;
    case ImpactFigure::velocity_change: return injury::velocity_change(pulse);
    default: return no_figure;
  }
}

std::optional<double> figure_in(const Solution& solution, ImpactFigure figure) {
  const Summary& summary = solution.summary;
  switch (figure) {
    case ImpactFigure::peak_force: return summary.peak_force;
    case ImpactFigure::peak_acceleration: return summary.peak_acceleration;
    case ImpactFigure::time_of_peak: return summary.time_of_peak_force;
    case ImpactFigure::rebound_speed: return summary.rebound_speed;
    case ImpactFigure::peak_penetration: return summary.peak_penetration;
    case ImpactFigure::contact_time:
      if (summary.contact_end) return summary.contact_end->time;
      return std::nullopt;
    default:
      if (const std::optional<Pulse> pulse = smooth_pulse(solution)) return figure_of(*pulse, figure);
      return std::nullopt;
  }
}

/// The computed deceleration with the filter of the measured one.
SmoothCurve filtered(const SmoothCurve& curve, double end, const MeasuredDeceleration& measured) {
  Pulse pulse;
  for (std::size_t i = 0;; ++i) {
    const double time = measured.interval * static_cast<double>(i);
    if (time > end) break;
    pulse.time.push_back(time);
    pulse.acceleration.push_back(curve.at(time));
  }
  if (pulse.time.size() < 2) return curve;  // a pulse between two samples
  pulse = injury::filtered_like(measured.filter, measured.interval, pulse);
  return {std::move(pulse.time), std::move(pulse.acceleration)};
}

/// The deceleration at times since the onset; nothing before first contact and after the end of contact.
bool predict_pulse(const Solution& solution, const MeasuredDeceleration& measured, double shift,
                   std::span<double> predicted) {
  const History& history = solution.history;
  if (!solution.summary.peak_acceleration || history.size() < 2)
    return false;  // bottomed out on a rigid support
  std::vector<double> deceleration;
  for (const double a : history.acceleration) {
    if (!std::isfinite(a)) return false;
    deceleration.push_back(-a);
  }
  SmoothCurve curve(history.time, std::move(deceleration));
  double peak = *solution.summary.peak_acceleration;
  if (measured.filter) {
    const double end = history.time.back();
    curve = filtered(curve, end, measured);
    peak = 0;
    for (double time = 0; time <= end; time += measured.interval) peak = std::max(peak, curve.at(time));
  }
  // A foam that answers at first contact has its onset there.
  const double onset = curve.first_at(injury::onset_share * peak);
  for (std::size_t i = 0; i < predicted.size(); ++i)
    predicted[i] = curve.at(onset + measured.time[i] - shift);
  return true;
}

}  // namespace

const std::vector<ImpactFigureName>& impact_figure_names() {
  static const std::vector<ImpactFigureName> names{
      {ImpactFigure::peak_force, "peak_force", "N"},
      {ImpactFigure::peak_acceleration, "peak_acceleration", "m/s2"},
      {ImpactFigure::time_of_peak, "time_of_peak", "s"},
      {ImpactFigure::rebound_speed, "rebound_speed", "m/s"},
      {ImpactFigure::peak_penetration, "peak_penetration", "m"},
      {ImpactFigure::contact_time, "contact_time", "s"},
      {ImpactFigure::hic15, "hic15", "1"},
      {ImpactFigure::hic36, "hic36", "1"},
      {ImpactFigure::hic_unlimited, "hic_unlimited", "1"},
      {ImpactFigure::clip_3ms, "clip_3ms", "m/s2"},
      {ImpactFigure::cumulative_3ms, "cumulative_3ms", "m/s2"},
      {ImpactFigure::velocity_change, "velocity_change", "m/s"},
  };
  return names;
}

std::optional<Pulse> smooth_pulse(const Solution& solution) {
  const History& history = solution.history;
  const auto finite = [](double value) { return std::isfinite(value); };
  if (!pulse_is_whole(solution.summary) || history.size() < 2 ||
      !std::ranges::all_of(history.acceleration, finite))
    return std::nullopt;
  const SmoothCurve curve(history.time, history.acceleration);
  Pulse pulse{{history.time.front()}, {history.acceleration.front()}};
  for (std::size_t i = 1; i < history.size(); ++i)
    for (int part = 1; part <= points_per_step; ++part) {
      const double time = part == points_per_step ? history.time[i]
                                                  : std::lerp(history.time[i - 1], history.time[i],
                                                              static_cast<double>(part) / points_per_step);
      pulse.time.push_back(time);
      pulse.acceleration.push_back(curve.at(time));
    }
  return pulse;
}

ImpactCase impact_with(const Fit& fit, const ImpactMeasurement& measured, std::span<const double> values) {
  ImpactCase impact = measured.impact;
  impact.pad.material = fit.base.pad.material;
  const std::vector<Setter> setters = setters_of(fit, measured.file, impact);
  for (std::size_t i = 0; i < setters.size(); ++i) setters[i](impact, values[i]);
  return impact;
}

Predict prediction_of(const Fit& fit, const ImpactMeasurement& measured, int runs,
                      std::optional<std::size_t> shift) {
  ImpactCase impact = measured.impact;
  impact.pad.material = fit.base.pad.material;
  const std::vector<Setter> setters = setters_of(fit, measured.file, impact);
  Options options = measured.options;
  options.fixed_runs = runs;
  using Solvers = tbb::enumerable_thread_specific<Solver>;
  return
      [impact, options, setters, figures = measured.figures, pulse = measured.pulse, shift,
       solvers = std::make_shared<Solvers>()](std::span<const double> values, std::span<double> predicted) {
        try {
          ImpactCase with_values = impact;
          for (std::size_t i = 0; i < setters.size(); ++i) setters[i](with_values, values[i]);
          const Solution& solution = solvers->local().solve(with_values, options);
          for (std::size_t i = 0; i < figures.size(); ++i) {
            // None, such as a peak force where the pad bottoms out, is no number.
            predicted[i] = figure_in(solution, figures[i].figure).value_or(no_figure);
          }
          return !pulse || predict_pulse(solution, *pulse, shift ? values[*shift] : 0,
                                         predicted.subspan(figures.size()));
        } catch (const std::invalid_argument&) {
          return false;
        }
      };
}

}  // namespace dashpad::fit
