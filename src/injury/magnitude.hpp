#pragma once
/// The magnitude |a| of a pulse as a line with corners, and the stretches of time that it spends above a
/// level.

#include <cmath>
#include <cstddef>
#include <vector>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

struct LinePoint {
  double time = 0;   ///< s
  double value = 0;  ///< |a|, m/s2
};

using Magnitude = std::vector<LinePoint>;

/// The samples, and a corner at zero wherever a changes its sign between two of them. Times do not decrease;
/// a zero may round onto the sample beside it.
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

/// When the piece between two corners passes a level that lies between their values.
inline double passing(const LinePoint& from, const LinePoint& to, double level) {
  return std::lerp(from.time, to.time, (level - from.value) / (to.value - from.value));
}

enum class Bound {
  reached,   ///< |a| >= level: a touch is a stretch without length
  exceeded,  ///< |a| > level: a touch from above divides a stretch
};

/// Calls visit(begin, end) for each stretch, in order of time. The lengths of all stretches need no sum over
/// their samples, so that rounding does not grow with the number of samples.
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

}  // namespace dashpad::injury
