#pragma once
/// Guesses of the penetration rate and of the pad's stiffness in the next step, from the steps before.
///
/// A guess affects the number of trials of a step, not its solution.

#include <algorithm>
#include <cmath>
#include <optional>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "impact/numerics.hpp"
#include "impact/trial.hpp"

namespace dashpad {

/// Guess of the penetration rate in the next step, m/s, by the mean rates of the last three steps.
///
/// The rate is nearly exponential in time, so its logarithm is extrapolated by divided differences.
class RateTrend {
 public:
  /// Forgets all rates, as after an event the rate may be another.
  void restart() { *this = {}; }

  /// Adds the mean rate, not 0, over a step of length `step`; all rates since the restart have one sign.
  void add(double rate, double step) {
    const double log_rate = portable::log(std::abs(rate));
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
    return rate_ * portable::exp(std::clamp(change, -max_change, max_change));
  }
  /// Time in which the rate changes by a factor of e, s; infinite while it is not known.
  [[nodiscard]] double time_scale() const { return slope_ != 0 ? 1 / std::abs(slope_) : infinite; }
  /// Rate at the end of the last step.
  [[nodiscard]] double now() const {
    return rate_ * portable::exp(std::clamp(slope_ * step_ / 2, -1.0, 1.0));
  }

 private:
  static constexpr double max_change = 2;

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
  /// Starts at first contact with `speed`, m/s, and the `stiffness` of the pad, N/m.
  void start(double speed, double stiffness) {
    *this = {};
    pad_rate_ = speed;
    pad_stiffness_ = stiffness_to_resolve_ = spring_ = stiffness;
  }

  /// Mean rate of the penetration over the last step, or that at the start of a new phase, m/s.
  [[nodiscard]] double pad_rate() const { return pad_rate_; }
  /// dF/dY over the last step, N/m; next_stiffness() is a guess of that over the next.
  [[nodiscard]] double pad_stiffness() const { return pad_stiffness_; }
  /// Stiffness that steps must resolve, N/m (Trial::stiffness_to_resolve()).
  [[nodiscard]] double stiffness_to_resolve() const { return stiffness_to_resolve_; }
  [[nodiscard]] double next_stiffness() const { return pad_stiffness_ * stiffening_; }
  /// Time in which the rate changes by a factor of e, s.
  [[nodiscard]] double time_scale() const { return trend_.time_scale(); }
  /// Time until the drive is 0, by its change in the last step, s.
  [[nodiscard]] double time_to_turning(const State& now) const { return -now.drive / drive_rate_; }

  /// Mean rate over a step: by its trend, or between the present rate and that of the last step tried from
  /// here, since the search of an event tries many. Nothing just after an event.
  [[nodiscard]] std::optional<double> next_rate(double step) const {
    if (tried_step_ == 0) return trend_.is_known() ? std::optional(trend_.over(step)) : std::nullopt;
    if (!trend_.is_known()) return tried_rate_;
    const double rate = trend_.now();
    return rate + (tried_rate_ - rate) * step / tried_step_;
  }

  /// Records a trial, which may not be accepted.
  void learn_from_try(const Trial& trial) {
    if (trial.obstacle == Event::none && trial.pad.advance != 0)
      tried_step_ = trial.step, tried_rate_ = trial.pad_rate();
  }
  /// Records an accepted trial, which began at the state `before` and ends with `event`.
  void learn(Phase phase, const State& before, const Trial& trial, Event event) {
    const double rate = trial.pad_rate();
    tried_step_ = 0;
    if (phase == Phase::loading && rate > numerics.breakdown_of_rate * pad_rate_)
      spring_ = trial.stiffness_to_resolve();
    pad_rate_ = rate;
    if (phase != Phase::held) {
      // The stiffness of a first trial is a guess, which must not grow by itself.
      guesses_ = trial.pad_stiffness == next_stiffness() ? guesses_ + 1 : 0;
      const double least = 1 / numerics.max_stiffening;
      const bool is_mere_guess = guesses_ > numerics.max_guesses;
      const double most = is_mere_guess ? 1 : numerics.max_stiffening;
      // A pad of constant force has no stiffness, and 0 / 0 is no trend.
      const bool has_trend = trend_.is_known() && pad_stiffness_ > 0;
      stiffening_ = has_trend ? std::clamp(trial.pad_stiffness / pad_stiffness_, least, most) : 1;
      pad_stiffness_ = trial.pad_stiffness;
      stiffness_to_resolve_ = trial.stiffness_to_resolve();
      if (is_mere_guess && trial.pad.advance != 0) {
        const double shown = (trial.end.force - before.force) / trial.pad.whole_advance();
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
  /// Prepares for the phase that begins with `event` at the state `now`.
  void begin_phase(Event event, const State& now) {
    tried_step_ = 0;
    const double approach = now.velocity - now.back.velocity();
    if (event == Event::turning || event == Event::reloading) {
      // The stiffness of the last step may be a quotient of roundings.
      pad_stiffness_ = stiffness_to_resolve_ = spring_;
      stiffening_ = 1;
    }
    if (event == Event::turning) pad_rate_ = std::min(approach, 0.0);
    if (event == Event::reloading || event == Event::yielding || event == Event::touch)
      pad_rate_ = std::max(approach, 0.0);
    if (event == Event::unlock || event == Event::release) pad_rate_ = approach;
  }
  /// Forgets the rate, as the pad was held for a moment.
  void forget_rate() {
    pad_rate_ = tried_step_ = 0;
    trend_.restart();
  }

 private:
  double pad_rate_ = 0;
  double pad_stiffness_ = 0;
  double stiffness_to_resolve_ = 0;
  double spring_ = 0;      ///< stiffness before the rate broke down towards the turning point
  double stiffening_ = 1;  ///< factor of the stiffness from the step before to the last
  int guesses_ = 0;        ///< number of consecutive guesses of the stiffness
  double drive_rate_ = 0;
  double tried_step_ = 0;  ///< last solved step tried from the present state; 0: none
  double tried_rate_ = 0;
  RateTrend trend_;
};

}  // namespace dashpad
