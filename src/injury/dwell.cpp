#include "dashpad/injury/metrics.hpp"

#include <algorithm>
#include <stdexcept>

#include "injury/pulse_line.hpp"

namespace dashpad::injury {
namespace {

Magnitude checked(const Pulse& pulse, double level) {
  check(pulse);
  if (!(level >= 0)) throw std::invalid_argument("dwell: the level must not be negative");
  return magnitude_of(pulse);
}

}  // namespace

double cumulative_dwell(const Pulse& pulse, double level) {
  double sum = 0;
  for_each_stretch(checked(pulse, level), level, Bound::exceeded,
                   [&](double begin, double end) { sum += end - begin; });
  return sum;
}

double longest_dwell(const Pulse& pulse, double level) {
  double longest = 0;
  for_each_stretch(checked(pulse, level), level, Bound::exceeded,
                   [&](double begin, double end) { longest = std::max(longest, end - begin); });
  return longest;
}

}  // namespace dashpad::injury
