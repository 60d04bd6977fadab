#pragma once
/// A pulse that is linear between its samples: |a| as a polyline, stretches above a level, accurate sums.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

#include "dashpad/impact/pulse.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"

namespace dashpad::injury {

struct LinePoint {
  double time = 0;   ///< s
  double value = 0;  ///< |a|, m/s2
};

using Magnitude = std::vector<LinePoint>;

/// The samples, with a corner at zero wherever a changes sign. Times do not decrease: a zero may round.
inline Magnitude magnitude_of(const Pulse& pulse) {
  Magnitude line;
  line.reserve(pulse.time.size() + pulse.time.size() / 8);
  for (std::size_t i = 0; i < pulse.time.size(); ++i) {
    const double a = pulse.acceleration[i];
    if (i > 0) {
      const double before = pulse.acceleration[i - 1];
      if ((before < 0 && a > 0) || (before > 0 && a < 0)) {
        const double share = std::abs(before) / (std::abs(before) + std::abs(a));
        line.push_back({std::lerp(pulse.time[i - 1], pulse.time[i], share), 0});
      }
    }
    line.push_back({pulse.time[i], std::abs(a)});
  }
  return line;
}

/// The time at which the piece between two corners passes a level between their values.
inline double passing(const LinePoint& from, const LinePoint& to, double level) {
  return std::lerp(from.time, to.time, (level - from.value) / (to.value - from.value));
}

enum class Bound {
  reached,   ///< |a| >= level: a touch is a stretch without length
  exceeded,  ///< |a| > level: a touch from above divides a stretch
};

/// Calls visit(begin, end) for each stretch, in order of time. A length is no sum over samples, so that
/// rounding does not grow with their number.
template <class Visit>
void for_each_stretch(const Magnitude& line, double level, Bound bound, Visit&& visit) {
  bool inside = false;
  double begin = 0;
  for (std::size_t i = 0; i < line.size(); ++i) {
    const bool now = bound == Bound::reached ? line[i].value >= level : line[i].value > level;
    if (now && !inside) begin = i == 0 ? line[i].time : passing(line[i - 1], line[i], level);
    if (!now && inside) visit(begin, passing(line[i - 1], line[i], level));
    inside = now;
  }
  if (inside) visit(begin, line.back().time);
}

/// The first sample with the largest magnitude.
inline std::size_t peak_sample(const Pulse& pulse) {
  std::size_t top = 0;
  for (std::size_t i = 1; i < pulse.time.size(); ++i)
    if (std::abs(pulse.acceleration[i]) > std::abs(pulse.acceleration[top])) top = i;
  return top;
}

/// The mean sampling interval, s.
inline double interval_of(const Pulse& pulse) {
  return (pulse.time.back() - pulse.time.front()) / static_cast<double>(pulse.time.size() - 1);
}

/// The duration minus the rounding of the times: a plateau from 3.5 to 6.5 ms lasts 3 ms, although the
/// difference of the two doubles is less than the double 0.003.
inline double attainable(const Pulse& pulse, double duration) {
  const double latest = std::max(std::abs(pulse.time.front()), std::abs(pulse.time.back()));
  return std::max(0.0, duration - 8 * std::numeric_limits<double>::epsilon() * latest);
}

/// A compensated sum of doubles.
class AccurateSum {
 public:
  void add(double x) {
    const double sum = high_ + x;
    const double kept = sum - high_;
    low_ += (high_ - (sum - kept)) + (x - kept);
    high_ = sum;
  }
  [[nodiscard]] double high() const { return high_; }
  [[nodiscard]] double low() const { return low_; }
  [[nodiscard]] double value() const { return high_ + low_; }

 private:
  double high_ = 0, low_ = 0;
};

// Errors of the time steps in the figures of a history, by the next coarser run and by its curvature.

inline bool has_coarser_run(const Solution& solution) { return solution.coarser.time.size() >= 2; }

/// A figure of a history, extrapolated by its value `coarser` with twice the step as a method of second order
/// allows (theory.md, Eq. 31); never beyond 0.
inline double extrapolated(double value, double coarser) {
  const double further = value + (value - coarser) / 3;
  return further * value > 0 ? further : value;
}

/// Relative error of an extrapolated figure, before which it was `value`: twice the extrapolation, since
/// events fall anywhere in a step.
inline double step_error(double value, double coarser) {
  return value == 0 ? std::abs(coarser) : 2.0 / 3 * std::abs(coarser / value - 1);
}

/// Relative error of a HIC(d) by that of its HIC36. The offset has none: the error of the samples shrinks
/// with it; that of the force does not.
inline double hic_d_error(double hic36_error, double value, double force_error) {
  const double of_force = hic_power * force_error;
  if (!std::isfinite(of_force)) return of_force;
  return (hic36_error - of_force) * (value - hic_d(0)) / value + of_force;
}

/// Relative error of the level of a clip due to the chords that cross it. A curve leaves a chord of length h
/// by at most h^2 |a''| / 8, with a'' by second differences at its ends. The level depends on few places,
/// whose errors in two runs may agree by chance.
double chord_error(const Pulse& pulse, const Clip& clip);

inline double step_error(const Pulse& pulse, const Clip& clip, const Clip& coarser) {
  return std::max(step_error(clip.level, coarser.level), chord_error(pulse, clip));
}

}  // namespace dashpad::injury
