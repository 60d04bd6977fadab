#pragma once
/// Windows of a pulse that is linear between its samples: how long they are and what velocity they gain.

#include <cmath>
#include <cstddef>
#include <vector>

#include "dashpad/impact/pulse.hpp"
#include "injury/accurate_sum.hpp"

namespace dashpad::injury::hic_search {

/// A window from `before` (s) ahead of sample `first` to `after` (s) past sample `last`, first <= last. Each
/// end is told from a sample near to it, so that no late time and no long pulse costs it digits.
struct Window {
  std::size_t first = 0, last = 0;
  double before = 0, after = 0;
};

/// The pulse times a factor, and its integral at the samples.
class Curve {
 public:
  Curve() = default;
  Curve(const Pulse& pulse, double factor) { assign(pulse, factor); }

  /// Keeps a reference to `pulse`. A power of two as factor is exact. Memory is used again.
  void assign(const Pulse& pulse, double factor);

  [[nodiscard]] std::size_t samples() const { return time_->size(); }
  [[nodiscard]] double time(std::size_t sample) const { return (*time_)[sample]; }
  [[nodiscard]] double level(std::size_t sample) const { return level_[sample]; }
  /// Between two samples: seconds, and the integral of the acceleration.
  [[nodiscard]] double elapsed(std::size_t from, std::size_t to) const {
    return (*time_)[to] - (*time_)[from];
  }
  [[nodiscard]] double gained(std::size_t from, std::size_t to) const {
    return (velocity_[to].high - velocity_[from].high) + (velocity_[to].low - velocity_[from].low);
  }
  /// Interval i is that from sample i to sample i + 1.
  [[nodiscard]] double length(std::size_t interval) const { return elapsed(interval, interval + 1); }
  [[nodiscard]] double slope(std::size_t interval) const {
    return (level_[interval + 1] - level_[interval]) / length(interval);
  }
  [[nodiscard]] double duration(const Window& window) const {
    return window.before + elapsed(window.first, window.last) + window.after;
  }
  [[nodiscard]] double gain(const Window& window) const;

 private:
  struct Velocity {
    double high, low;  // the integral is their sum
  };
  const std::vector<double>* time_ = nullptr;
  std::vector<double> level_;
  std::vector<Velocity> velocity_;
};

/// duration * (gain / duration)^2.5; 0 where there is no gain.
inline double criterion(double duration, double gain) {
  if (!(gain > 0) || !(duration > 0)) return 0;
  const double mean = gain / duration;
  return gain * mean * std::sqrt(mean);
}

}  // namespace dashpad::injury::hic_search
