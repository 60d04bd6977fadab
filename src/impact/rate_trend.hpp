#pragma once
/// Where the penetration rate of the next step is likely to lie, by the mean rates of the last three steps.
///
/// The rate falls and grows like an exponential for most of an impact, so its logarithm is extrapolated, by
/// divided differences over the middles of the steps.

#include <algorithm>
#include <cmath>
#include <limits>

namespace dashpad {

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
  [[nodiscard]] double time_scale() const {
    return slope_ != 0 ? 1 / std::abs(slope_) : std::numeric_limits<double>::infinity();
  }
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

}  // namespace dashpad
