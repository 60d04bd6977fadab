#include "fit/problem.hpp"

#include <algorithm>
#include <memory>
#include <stdexcept>

#include <tbb/enumerable_thread_specific.h>
#include <boost/math/tools/minima.hpp>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "result/summary_values.hpp"

namespace dashpad::fit {

namespace {

/// A smooth curve through points, 0 outside. What is read between the steps of the solver must not jump when
/// their number changes with the unknowns.
///
/// It consists of cubics with the values at the points and the slopes of parabolas through three neighbours.
class SmoothCurve {
 public:
  /// Needs two points or more, at increasing times.
  SmoothCurve(std::vector<double> time, std::vector<double> value)
      : time_(std::move(time)), value_(std::move(value)), slope_(time_.size()) {
    const std::size_t last = time_.size() - 1;
    const auto chord = [&](std::size_t i) { return (value_[i + 1] - value_[i]) / (time_[i + 1] - time_[i]); };
    for (std::size_t i = 1; i < last; ++i) {
      const double before = time_[i] - time_[i - 1], after = time_[i + 1] - time_[i];
      slope_[i] = (after * chord(i - 1) + before * chord(i)) / (before + after);
    }
    slope_.front() = last > 1 ? 2 * chord(0) - slope_[1] : chord(0);
    slope_.back() = last > 1 ? 2 * chord(last - 1) - slope_[last - 1] : chord(0);
  }

  [[nodiscard]] double at(double time) const {
    if (time < time_.front() || time > time_.back()) return 0;
    const auto next = std::upper_bound(time_.begin() + 1, time_.end() - 1, time);
    return within(static_cast<std::size_t>(next - time_.begin()) - 1, time);
  }

  /// The time when the curve first reaches a level; the first time if it begins there or never reaches it.
  [[nodiscard]] double first_at(double level) const {
    const auto first = std::ranges::find_if(value_, [&](double value) { return value >= level; });
    if (first == value_.begin() || first == value_.end()) return time_.front();
    const auto i = static_cast<std::size_t>(first - value_.begin()) - 1;
    double low = time_[i], high = time_[i + 1];
    for (int step = 0; step < 60; ++step) {
      const double middle = (low + high) / 2;
      (within(i, middle) < level ? low : high) = middle;
    }
    return high;
  }

 private:
  [[nodiscard]] double within(std::size_t i, double time) const {
    const double h = time_[i + 1] - time_[i];
    const double t = (time - time_[i]) / h, rise = value_[i + 1] - value_[i];
    const double a = h * slope_[i], b = h * slope_[i + 1];
    return value_[i] + t * (a + t * (3 * rise - 2 * a - b + t * (a + b - 2 * rise)));
  }

  std::vector<double> time_, value_, slope_;
};

constexpr int points_per_step = 4;  ///< points of the smooth curve per step of the solver

using Setter = std::function<void(ImpactCase&, double)>;

/// Functions that set the unknowns. Throws std::invalid_argument if the impact has no such quantity.
std::vector<Setter> setters_of(const Fit& fit, const std::string& file, const ImpactCase& impact) {
  std::vector<Setter> setters;
  const CaseQuantities quantities = quantities_of(impact);
  for (const Unknown& unknown : fit.unknowns) {
    const CaseQuantity* const found = quantities.find(unknown.key);
    if (found == nullptr) throw std::invalid_argument(file + " has no " + unknown.key);
    setters.push_back(found->set);
  }
  return setters;
}

/// A figure of the solution, SI; `no_figure` if it is absent. Figures of the pulse share `pulse`.
double figure_in(const Solution& solution, std::optional<Pulse>& pulse, ImpactFigure figure) {
  const ResultQuantity* const quantity = name_of(figure).quantity;
  if (quantity->part != Part::pulse)
    return std::ranges::find(summary_quantities(), quantity, &SummaryQuantity::quantity)
        ->of(solution.summary)
        .value;
  if (!pulse) pulse = smooth_pulse(solution);
  if (!pulse) return no_figure;
  switch (figure) {
    case ImpactFigure::hic15: return injury::hic(*pulse, injury::hic15_window).value;
    case ImpactFigure::hic36: return injury::hic(*pulse, injury::hic36_window).value;
    case ImpactFigure::hic_unlimited: return injury::hic(*pulse, injury::unlimited_window).value;
    case ImpactFigure::clip_3ms: return injury::contiguous_clip(*pulse, injury::usual_clip).level;
    case ImpactFigure::cumulative_3ms: return injury::cumulative_clip(*pulse, injury::usual_clip).level;
    case ImpactFigure::velocity_change: return injury::velocity_change(*pulse);
    default: return no_figure;
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

/// A computed deceleration and its onset.
struct ComputedPulse {
  SmoothCurve curve;
  double onset = 0;

  /// The deceleration at a time since the measured onset; 0 outside contact.
  [[nodiscard]] double at(double time, double shift) const { return curve.at(onset + time - shift); }
};

std::optional<ComputedPulse> computed_pulse(const Solution& solution, const MeasuredDeceleration& measured) {
  const History& history = solution.history;
  if (!solution.summary.peak_acceleration || history.size() < 2)
    return std::nullopt;  // bottomed out on a rigid support
  std::vector<double> deceleration;
  for (const double a : history.acceleration) {
    if (!std::isfinite(a)) return std::nullopt;
    deceleration.push_back(-a);
  }
  SmoothCurve curve(history.time, std::move(deceleration));
  double peak = *solution.summary.peak_acceleration;
  if (measured.filter) {
    const double end = history.time.back();
    curve = filtered(curve, end, measured);
    peak = 0;
    const auto last = static_cast<std::size_t>(end / measured.interval);
    for (std::size_t i = 0; i <= last; ++i)
      peak = std::max(peak, curve.at(static_cast<double>(i) * measured.interval));
  }
  // A foam that answers at first contact has its onset there.
  const double onset = curve.first_at(injury::onset_share * peak);
  return ComputedPulse{std::move(curve), onset};
}

/// The shift within bounds at which a computed pulse meets the measured one best. An edge of a pulse, as at
/// the turning point of a foam with a rate effect, makes a dent in the misfit for each sample that passes it;
/// so all dents are examined, on chords, and the best two are refined.
double best_shift(const ComputedPulse& computed, const MeasuredDeceleration& measured, double lowest,
                  double highest) {
  constexpr double looks_per_sample = 3;
  constexpr int fewest_looks = 16, max_looks = 200, bits = 22;
  const std::vector<double>& time = measured.time;
  const double spacing = (time.back() - time.front()) / static_cast<double>(time.size() - 1);
  const int looks = static_cast<int>(
      std::clamp<double>(looks_per_sample * (highest - lowest) / spacing, fewest_looks, max_looks));
  const double look = (highest - lowest) / looks;

  // The curve at even times, from the earliest that any look reads.
  const double begin = time.front() - highest, fine = look / 2;
  std::vector<double> chords;
  const auto last = static_cast<std::size_t>((time.back() - lowest - begin) / fine + 2);
  for (std::size_t i = 0; i <= last; ++i)
    chords.push_back(computed.at(begin + static_cast<double>(i) * fine, 0));
  const auto misses_of = [&](const auto& deceleration_at) {
    double squares = 0;
    for (std::size_t i = 0; i < time.size(); ++i) {
      const double off = deceleration_at(time[i]) - measured.deceleration[i];
      squares += off * off;
    }
    return squares;
  };
  const auto misses = [&](double place) {
    return misses_of([&](double t) { return computed.at(t, std::lerp(lowest, highest, place)); });
  };
  std::vector<double> looked;
  for (int i = 0; i <= looks; ++i)
    looked.push_back(misses_of([&](double t) {
      const double at = std::max((t - (lowest + look * i) - begin) / fine, 0.0);
      const auto k = std::min(static_cast<std::size_t>(at), chords.size() - 2);
      return chords[k] + (at - static_cast<double>(k)) * (chords[k + 1] - chords[k]);
    }));
  std::vector<std::size_t> dents;
  for (std::size_t i = 0; i < looked.size(); ++i)
    if ((i == 0 || looked[i] <= looked[i - 1]) && (i + 1 == looked.size() || looked[i] < looked[i + 1]))
      dents.push_back(i);
  std::ranges::sort(dents, {}, [&](std::size_t i) { return looked[i]; });
  double best = 0.5, least = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < std::min<std::size_t>(dents.size(), 2); ++k) {
    const double place = static_cast<double>(dents[k]) / looks;
    const auto [found, of] = boost::math::tools::brent_find_minima(misses, std::max(place - 1.0 / looks, 0.0),
                                                                   std::min(place + 1.0 / looks, 1.0), bits);
    if (of < least) best = found, least = of;
  }
  // A bound itself is never tried by that.
  for (const double bound : {0.0, 1.0})
    if (const double value = misses(bound); value < least) best = bound, least = value;
  return std::lerp(lowest, highest, best);
}

/// Solves an impact with the values of the unknowns.
class ImpactPrediction {
 public:
  ImpactPrediction(const Fit& fit, const ImpactMeasurement& measured, int runs)
      : impact_(measured.impact),
        options_(measured.options),
        figures_(measured.figures),
        pulse_(measured.pulse) {
    impact_.pad.material = fit.base.pad.material;
    options_.fixed_runs = runs;
    setters_ = setters_of(fit, measured.file, impact_);
  }

  [[nodiscard]] const MeasuredDeceleration& pulse() const { return *pulse_; }

  /// `shift_of` says by how much a computed pulse comes later.
  template <class ShiftOf>
  bool operator()(std::span<const double> values, std::span<double> predicted, ShiftOf&& shift_of) const {
    try {
      ImpactCase with_values = impact_;
      for (std::size_t i = 0; i < setters_.size(); ++i) setters_[i](with_values, values[i]);
      const Solution& solution = solvers_->local().solve(with_values, options_);
      std::optional<Pulse> pulse;
      for (std::size_t i = 0; i < figures_.size(); ++i)
        predicted[i] = figure_in(solution, pulse, figures_[i].figure);
      if (!pulse_) return true;
      const std::optional<ComputedPulse> computed = computed_pulse(solution, *pulse_);
      if (!computed) return false;
      const double shift = shift_of(*computed);
      for (std::size_t i = 0; i < pulse_->time.size(); ++i)
        predicted[figures_.size() + i] = computed->at(pulse_->time[i], shift);
      return true;
    } catch (const std::invalid_argument&) {
      return false;
    }
  }

 private:
  using Solvers = tbb::enumerable_thread_specific<Solver>;
  ImpactCase impact_;
  Options options_;
  std::vector<MeasuredFigure> figures_;
  std::optional<MeasuredDeceleration> pulse_;
  std::vector<Setter> setters_;
  std::shared_ptr<Solvers> solvers_ = std::make_shared<Solvers>();
};

}  // namespace

const std::vector<ImpactFigureName>& impact_figure_names() {
  static const std::vector<ImpactFigureName> names = [] {
    std::vector<ImpactFigureName> all;
    // The order is that of ImpactFigure.
    for (const auto& [key, quantity] : {std::pair{"peak_force", "peak_force"},
                                        {"peak_acceleration", "peak_acceleration"},
                                        {"time_of_peak", "time_to_peak_force"},
                                        {"rebound_speed", "rebound_speed"},
                                        {"peak_penetration", "peak_penetration"},
                                        {"contact_time", "contact_end"},
                                        {"hic15", "hic15"},
                                        {"hic36", "hic36"},
                                        {"hic_unlimited", "hic_unlimited"},
                                        {"clip_3ms", "clip_3ms"},
                                        {"cumulative_3ms", "cumulative_3ms"},
                                        {"velocity_change", "velocity_change"}})
      all.push_back({static_cast<ImpactFigure>(all.size()), key, &result_quantity(quantity)});
    return all;
  }();
  return names;
}

const ImpactFigureName& name_of(ImpactFigure figure) {
  return impact_figure_names().at(static_cast<std::size_t>(figure));
}

std::optional<Pulse> smooth_pulse(const Solution& solution) {
  const History& history = solution.history;
  if (!injury::has_whole_pulse(solution)) return std::nullopt;
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
  return [shift, predict = ImpactPrediction(fit, measured, runs)](std::span<const double> values,
                                                                  std::span<double> predicted) {
    return predict(values, predicted, [&](const ComputedPulse&) { return shift ? values[*shift] : 0.0; });
  };
}

Settle settling_of(const Fit& fit, const ImpactMeasurement& measured, int runs, std::size_t shift,
                   double lowest, double highest) {
  return [shift, lowest, highest, predict = ImpactPrediction(fit, measured, runs)](
             std::span<double> values, std::span<double> predicted) {
    return predict(values, predicted, [&](const ComputedPulse& computed) {
      return values[shift] = best_shift(computed, predict.pulse(), lowest, highest);
    });
  };
}

}  // namespace dashpad::fit
