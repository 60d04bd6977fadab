#pragma once
/// Windows of a pulse that is linear between its samples: their durations and velocity gains.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/injury/metrics.hpp"
#include "injury/pulse_line.hpp"

namespace dashpad::injury::hic_search {

/// A window from `before` (s) ahead of sample `first` to `after` (s) past sample `last`, first <= last. Ends
/// are relative to a nearby sample, so that late times and long pulses cost no digits.
struct Window {
  std::size_t first = 0, last = 0;
  double before = 0, after = 0;
};

/// The pulse times a factor, and its integral up to each sample.
class Curve {
 public:
  Curve() = default;
  Curve(const Pulse& pulse, double factor) { assign(pulse, factor); }

  /// Keeps a reference to `pulse` and reuses memory. A power of two as factor is exact.
  void assign(const Pulse& pulse, double factor);

  [[nodiscard]] std::size_t samples() const { return time_->size(); }
  [[nodiscard]] double time(std::size_t sample) const { return (*time_)[sample]; }
  [[nodiscard]] double level(std::size_t sample) const { return level_[sample]; }
  /// Seconds, and the integral of the acceleration, between two samples.
  [[nodiscard]] double elapsed(std::size_t from, std::size_t to) const {
    return (*time_)[to] - (*time_)[from];
  }
  [[nodiscard]] double gained(std::size_t from, std::size_t to) const {
    return (velocity_[to].high - velocity_[from].high) + (velocity_[to].low - velocity_[from].low);
  }
  /// Interval i is the one from sample i to sample i + 1.
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

// Candidates for the best window among those that begin in one interval and end in another. docs/injury.md,
// HIC, proves that they suffice.

/// Values with a smaller relative difference are equal.
inline constexpr double rounding = 1e-13;

/// The best window so far; the earliest of equal ones.
class Best {
 public:
  void offer(const Curve& curve, const Window& window);

  /// Whether windows with values of at most `bound` that begin at `begin` (s) or later are irrelevant.
  [[nodiscard]] bool rules_out(double bound, double begin) const {
    return bound <= highest_ * (1 + (begin < begin_ ? -2 : 1) * rounding);
  }

  [[nodiscard]] double value() const { return value_; }
  [[nodiscard]] double begin() const { return begin_; }
  [[nodiscard]] double end() const { return end_; }

 private:
  double highest_ = 0;
  double value_ = 0, begin_ = 0, end_ = 0;
};

/// Offers the best of the windows of length `longest` that begin in interval i and end in interval j >= i.
void offer_longest(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best);

/// Offers every window up to `longest` that begins in interval i, ends in j >= i and can be the best.
void offer_candidates(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best);

// A hierarchy of blocks of intervals, with bounds on the windows between two blocks.

/// Block k of rank r holds the 2^r intervals from k 2^r on, or the remaining ones.
class Blocks {
 public:
  explicit Blocks(const Curve& curve);

  /// The lowest rank whose block 0 holds everything.
  [[nodiscard]] std::size_t top() const { return bounds_.size() - 1; }
  [[nodiscard]] std::size_t count(std::size_t rank) const { return bounds_[rank].size(); }

  /// An upper bound of the criterion of all windows not longer than `longest` that begin in block i and end
  /// in block j >= i of the same rank.
  [[nodiscard]] double bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const;

  /// The first and the last sample of a block.
  [[nodiscard]] static std::size_t first(std::size_t rank, std::size_t block) { return block << rank; }
  [[nodiscard]] std::size_t last(std::size_t rank, std::size_t block) const {
    return std::min((block + 1) << rank, curve_->samples() - 1);
  }

 private:
  /// Within a block: the largest distances of the velocity below and above the straight line between its
  /// ends, and the highest level.
  struct Bounds {
    double below, above, level;
  };
  [[nodiscard]] double close_bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const;

  const Curve* curve_;
  std::vector<std::vector<Bounds>> bounds_;  // [rank][block]
};

}  // namespace dashpad::injury::hic_search

namespace dashpad::injury {

// Humps: pulses of one sign that rise to one peak and fall from it, as in most impacts. The best window of
// each length is where the pulse exceeds some level, so that one walk down from the peak replaces the search
// over all windows. Results are those of hic.cpp and clip.cpp up to rounding.

struct Hump {
  std::size_t peak = 0;
  double sign = 1;
};

/// Absent for a pulse with both signs, level stretches or several peaks. `pulse` has passed check().
std::optional<Hump> hump_of(const Pulse& pulse);

/// hic() of a hump; `curve` is its pulse times sign * scale.
Hic hic_of(const Hump& hump, const hic_search::Curve& curve, double scale, double longest_window);

/// contiguous_clip() and cumulative_clip() of a hump, which are equal.
Clip clip_of(const Hump& hump, const Pulse& pulse, double duration);

/// A power of two that brings `largest` (> 0) near to 1, so that no power of a level overflows.
double scale_for(double largest);

}  // namespace dashpad::injury
