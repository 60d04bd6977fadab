#pragma once
/// Windows of a pulse that is linear between its samples: how long they are and what velocity they gain.

#include <cmath>
#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/injury/metrics.hpp"
#include "injury/pulse_line.hpp"

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

// The windows that can be the best of all windows that begin in one interval and end in another, and the
// best of those that were offered. Why these windows suffice: docs/injury.md, HIC.

/// Two values that differ by less, relative, count as the same.
inline constexpr double rounding = 1e-13;

/// The best window so far, and of windows with the same value the earliest.
class Best {
 public:
  void offer(const Curve& curve, const Window& window);

  /// Whether no window that begins at `begin` (s) or later, and whose value is at most `bound`, is wanted.
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

/// Offers every window not longer than `longest` that begins in interval i, ends in interval j >= i and can
/// be the best of all.
void offer_candidates(const Curve& curve, std::size_t i, std::size_t j, double longest, Best& best);

// Blocks of intervals in a hierarchy, and what the windows between two blocks cannot exceed.

/// Block k of rank r holds the intervals from k 2^r on, 2^r of them or what is left.
class Blocks {
 public:
  explicit Blocks(const Curve& curve);

  /// The lowest rank whose block 0 holds everything.
  [[nodiscard]] std::size_t top() const { return bounds_.size() - 1; }
  [[nodiscard]] std::size_t count(std::size_t rank) const { return bounds_[rank].size(); }

  /// No window that begins in block i, ends in block j >= i of the same rank and is not longer than `longest`
  /// has a larger criterion.
  [[nodiscard]] double bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const;

  /// The first sample of a block, and the last.
  [[nodiscard]] static std::size_t first(std::size_t rank, std::size_t block) { return block << rank; }
  [[nodiscard]] std::size_t last(std::size_t rank, std::size_t block) const;

 private:
  /// Within a block: how far the velocity is below and above the straight line between its ends, and the
  /// highest level.
  struct Bounds {
    double below, above, level;
  };
  [[nodiscard]] double close_bound(std::size_t rank, std::size_t i, std::size_t j, double longest) const;

  const Curve* curve_;
  std::vector<std::vector<Bounds>> bounds_;  // [rank][block]
};

}  // namespace dashpad::injury::hic_search

namespace dashpad::injury {

// Pulses of one sign that rise to one peak and fall from it, as those of most impacts. For them the best
// window of each length is where the pulse is above some level, so that one walk down from the peak answers
// what a search over all windows does. Results are those of hic.cpp and clip.cpp up to rounding.

/// Where the peak of a hump is, and its sign, 1 or -1.
struct Hump {
  std::size_t peak = 0;
  double sign = 1;
};

/// Absent where the pulse is none: both signs, level stretches, or several peaks. `pulse` has passed check().
std::optional<Hump> hump_of(const Pulse& pulse);

/// hic() of a hump; `curve` is its pulse times sign * scale.
Hic hic_of(const Hump& hump, const hic_search::Curve& curve, double scale, double longest_window);

/// contiguous_clip() and cumulative_clip(), which are the same for a hump.
Clip clip_of(const Hump& hump, const Pulse& pulse, double duration);

/// A power of two that brings `largest` (> 0) near to 1, so that no power of a level overflows.
double scale_for(double largest);

}  // namespace dashpad::injury
