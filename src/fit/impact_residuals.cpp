#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>

#include "dashpad/impact/case_quantity.hpp"
#include "dashpad/impact/solver.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "fit/problem.hpp"
#include "fit/smooth_curve.hpp"

namespace dashpad::fit {

namespace {

std::optional<double> figure_in(const Summary& summary, ImpactFigure figure) {
  switch (figure) {
    case ImpactFigure::peak_force: return summary.peak_force;
    case ImpactFigure::peak_acceleration: return summary.peak_acceleration;
    case ImpactFigure::time_of_peak: return summary.time_of_peak_force;
    case ImpactFigure::rebound_speed: return summary.rebound_speed;
    case ImpactFigure::peak_penetration: return summary.peak_penetration;
    case ImpactFigure::contact_time:
      if (summary.contact_end) return summary.contact_end->time;
      return std::nullopt;
  }
  return std::nullopt;
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
  };
  return names;
}

Predict prediction_of(const Fit& fit, const ImpactMeasurement& measured, int runs,
                      std::optional<std::size_t> shift) {
  ImpactCase impact = measured.impact;
  impact.pad.material = fit.base.pad.material;
  std::vector<std::function<void(ImpactCase&, double)>> setters;
  const std::vector<CaseQuantity> quantities = quantities_of(impact);
  for (const Unknown& unknown : fit.unknowns) {
    const auto found = std::ranges::find(quantities, unknown.key, &CaseQuantity::key);
    if (found == quantities.end()) throw std::invalid_argument(measured.file + " has no " + unknown.key);
    setters.push_back(found->set);
  }
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
          const Summary& summary = solution.summary;
          for (std::size_t i = 0; i < figures.size(); ++i) {
            // None, such as a peak force where the pad bottoms out, is no number.
            predicted[i] = figure_in(summary, figures[i].figure).value_or(no_figure);
          }
          return !pulse || predict_pulse(solution, *pulse, shift ? values[*shift] : 0,
                                         predicted.subspan(figures.size()));
        } catch (const std::invalid_argument&) {
          return false;
        }
      };
}

}  // namespace dashpad::fit
