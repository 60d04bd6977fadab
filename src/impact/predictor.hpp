#pragma once
/// Guesses for the next step, from the steps before: rate of the penetration, and stiffness of the pad.
///
/// A guess decides how many trials a step needs, not what its solution is.

#include <algorithm>
#include <cmath>
#include <optional>

#include "dashpad/quantities/constants.hpp"
#include "impact/numerics.hpp"
#include "impact/trial.hpp"

namespace dashpad {

/// Where the penetration rate of the next step is likely to lie, by the mean rates of the last three steps.
///
/// The rate falls and grows like an exponential for most of an impact, so its logarithm is extrapolated, by
/// divided differences over the middles of the steps.
class RateTrend {
 public:
  /// Forgets: after an event the rate may be another one.
  void restart() { *this = {}; }

  /// Mean rate (not 0) over a step of length `step`; all since the restart have one sign.
  void add(double rate, double step) {
    const double log_rate = std::log(std::abs(rate));
    if (steps_ > 0) {
      const double slope = (log_rate - log_rate_) * 2 / (step_ + step);
      bend_ = steps_ > 1 ? (slope - slope_) * 2 / (step_before_ + 2 * step_ + step) : 0;
      slope_ = slope;
    }
    rate_ = rate;
    log_rate_ = log_rate;
    step_before_ = step_;
    step_ = step;
    steps_ = std::min(steps_ + 1, 3);
  }

  [[nodiscard]] bool is_known() const { return steps_ > 0; }
  /// Mean rate over the next step.
  [[nodiscard]] double over(double step) const {
    const double ahead = (step_ + step) / 2;
    const double change = ahead * (slope_ + bend_ * (ahead + (step_before_ + step_) / 2));
    return rate_ * std::exp(std::clamp(change, -most_change, most_change));
  }
  /// In which the rate changes by a factor of e, s; infinite while that is not known.
  [[nodiscard]] double time_scale() const { return slope_ != 0 ? 1 / std::abs(slope_) : infinite; }
  /// Rate at the end of the last step.
  [[nodiscard]] double now() const { return rate_ * std::exp(std::clamp(slope_ * step_ / 2, -1.0, 1.0)); }

 private:
  static constexpr double most_change = 2;

  double rate_ = 0;
  double log_rate_ = 0;
  double slope_ = 0;
  double bend_ = 0;
  double step_ = 0;
  double step_before_ = 0;
  int steps_ = 0;
};

class Predictor {
 public:
  /// `speed` at first contact, m/s; `stiffness` of the pad there, N/m.
  void start(double speed, double stiffness) {
    *this = {};
    pad_rate_ = speed;
    pad_stiffness_ = stiffness_to_resolve_ = spring_ = stiffness;
  }

  /// Mean rate of the penetration over the last step, or what a new phase begins with, m/s.
  [[nodiscard]] double pad_rate() const { return pad_rate_; }
  /// dF/dY over the last step, N/m, and what it is likely to be over the next.
  [[nodiscard]] double pad_stiffness() const { return pad_stiffness_; }
  /// As Trial::stiffness_to_resolve().
  [[nodiscard]] double stiffness_to_resolve() const { return stiffness_to_resolve_; }
  [[nodiscard]] double next_stiffness() const { return pad_stiffness_ * stiffening_; }
  /// In which the rate changes by a factor of e, s.
  [[nodiscard]] double time_scale() const { return trend_.time_scale(); }
  /// How long until the drive is 0, by the last step, s.
  [[nodiscard]] double time_to_turning(const State& now) const { return -now.drive / drive_rate_; }

  /// Mean rate over a step: by its trend, or between the rate now and that of the last step that was tried
  /// from here, of which events take many. None just after an event.
  [[nodiscard]] std::optional<double> next_rate(double step) const {
    if (tried_step_ == 0) return trend_.is_known() ? std::optional(trend_.over(step)) : std::nullopt;
    if (!trend_.is_known()) return tried_rate_;
    const double rate = trend_.now();
    return rate + (tried_rate_ - rate) * step / tried_step_;
  }

  /// A trial that had a solution, though it may not be accepted.
  void learn_from_try(const Trial& trial) {
    if (trial.obstacle == Event::none && trial.pad.advance != 0)
      tried_step_ = trial.step, tried_rate_ = trial.pad_rate();
  }
  /// A trial that is accepted, from the state `before` on; `event`: what it ends with.
  void learn(Phase phase, const State& before, const Trial& trial, Event event) {
    const double rate = trial.pad_rate();
    tried_step_ = 0;
    if (phase == Phase::loading && rate > numerics.breakdown_of_rate * pad_rate_)
      spring_ = trial.stiffness_to_resolve();
    pad_rate_ = rate;
    if (phase != Phase::held) {
      // What a first trial is left with is a guess, and must not go on to grow by itself.
      guesses_ = trial.pad_stiffness == next_stiffness() ? guesses_ + 1 : 0;
      const double least = 1 / numerics.most_stiffening;
      const bool is_mere_guess = guesses_ > numerics.most_guesses;
      const double most = is_mere_guess ? 1 : numerics.most_stiffening;
      // A pad of constant force has none, and 0 / 0 is no trend.
      const bool has_trend = trend_.is_known() && pad_stiffness_ > 0;
      stiffening_ = has_trend ? std::clamp(trial.pad_stiffness / pad_stiffness_, least, most) : 1;
      pad_stiffness_ = trial.pad_stiffness;
      stiffness_to_resolve_ = trial.stiffness_to_resolve();
      if (is_mere_guess && trial.pad.advance != 0) {
        const double shown = (trial.end.force - before.force) / trial.pad.advance;
        pad_stiffness_ = std::clamp(shown, 0.0, pad_stiffness_);
        stiffness_to_resolve_ =
            std::min(stiffness_to_resolve_, std::max(pad_stiffness_, trial.lasting_stiffness));
      }
    }
    if (event == Event::none && rate != 0)
      trend_.add(rate, trial.step);
    else
      trend_.restart();
    drive_rate_ = (trial.end.drive - before.drive) / trial.step;
  }
  /// A phase that begins with `event` at the state `now`.
  void begin_phase(Event event, const State& now) {
    tried_step_ = 0;
    const double approach = now.velocity - now.back.velocity();
    if (event == Event::turning || event == Event::reloading) {
      // What the last step had may be the quotient of two roundings.
      pad_stiffness_ = stiffness_to_resolve_ = spring_;
      stiffening_ = 1;
    }
    if (event == Event::turning) pad_rate_ = std::min(approach, 0.0);
    if (event == Event::reloading || event == Event::yielding || event == Event::touch)
      pad_rate_ = std::max(approach, 0.0);
    if (event == Event::unlock || event == Event::release) pad_rate_ = approach;
  }
  /// The pad was held for a moment.
  void forget_rate() {
    pad_rate_ = tried_step_ = 0;
    trend_.restart();
  }

 private:
  double pad_rate_ = 0;
  double pad_stiffness_ = 0;
  double stiffness_to_resolve_ = 0;
  double spring_ = 0;      ///< stiffness before the rate broke down towards the turning point
  double stiffening_ = 1;  ///< of the pad from the step before to the last
  int guesses_ = 0;        ///< of the stiffness, one after the other
  double drive_rate_ = 0;
  double tried_step_ = 0;  ///< the last that was tried from the state now and had a solution; 0: none
  double tried_rate_ = 0;
  RateTrend trend_;
};

}  // namespace dashpad
