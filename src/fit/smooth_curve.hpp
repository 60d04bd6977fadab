#pragma once
/// A curve through points, smooth where they are: what is read off between the steps of the solver must not
/// jump when their number changes, as it does with the unknowns.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace dashpad::fit {

/// Cubics with the values at the points, and the slopes there of the parabolas through three neighbours. 0
/// outside.
class SmoothCurve {
 public:
  /// Two points or more, at increasing times.
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

  /// When the curve first reaches a level; the first time where it is there already or never comes there.
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

}  // namespace dashpad::fit
