#pragma once
/// What an accelerometer shows while nothing happens: its offset, and how to take it off.

#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/injury/measured_pulse.hpp"

namespace dashpad::injury {

/// What the sensor showed at rest, before a free fall: another level, by 1 g.
struct RestLevel {
  double end = 0;                 ///< s, of its last sample
  std::vector<double> mean = {};  ///< m/s2, of each direction
};

struct SensorOffset {
  double begin = 0, end = 0;           ///< s, of the first and the last sample that it is the mean of
  std::size_t samples = 0;             ///< their number
  std::vector<double> mean = {};       ///< m/s2, of each direction
  std::vector<double> scatter = {};    ///< m/s2, their standard deviation
  std::optional<RestLevel> rest = {};  ///< where it is the offset of a fall
};

/// Of the samples from `begin` to `end`, s, both included. Throws std::invalid_argument for fewer than two.
SensorOffset offset_between(const MeasuredPulse& measured, double begin, double end);

/// Of the quiet part before the impact, from the first sample on; absent where there is none. The impact
/// begins where the acceleration leaves five times its scatter (and 0.5 % of the largest deviation) for good
/// before it first reaches 10 % of the largest deviation. The quiet part ends earlier by a quarter of the
/// time from there to the peak, so that the slow beginning of a pulse is not in it; it has ten samples at
/// least and a scatter of 2 % of the peak at most. Deviations are those of all directions, root of the sum of
/// squares. Where the quiet part has two levels 1 g apart, to a tenth, rest and free fall, that of the fall
/// alone counts. Levels have ten samples at least, and differ by 1.5 times their scatter and five standard
/// errors; the later one is level, to a quarter of the step.
std::optional<SensorOffset> offset_before_impact(const MeasuredPulse& measured);

/// Without the samples before `begin`, s, and a remark that says so.
void leave_out_before(MeasuredPulse& measured, double begin);

/// With the mean taken off each direction; a resultant is that of the directions afterwards.
MeasuredPulse zeroed(MeasuredPulse measured, const SensorOffset& offset);

}  // namespace dashpad::injury
