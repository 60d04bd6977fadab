#pragma once
/// A measured pulse, with all that is needed to say later where it came from.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// A column of a table or a channel of a test, and its unit.
struct MeasuredColumn {
  std::string name = {};         ///< as in the file, UTF-8; "column 2" where the file has no name
  int number = 0;                ///< from 1
  std::string unit = {};         ///< as given or as in the file; empty if nobody said
  std::string unit_origin = {};  ///< "given", "header"; "format" where the file format fixes it
  double factor = 1;             ///< one unit in SI
  std::string sensitivity = {};  ///< as given, "10 mV/g", where the unit is one of volts; else empty
};

struct MeasuredPulse {
  Pulse pulse = {};         ///< the resultant, if there is one
  std::string format = {};  ///< "CSV", "ISO-MME"
  MeasuredColumn time = {};
  /// The time of the first sample as in the file, "1764068400.1234 s", where the times of the pulse count
  /// from there, since its clock began more than a thousand times the length of the record ago; else empty.
  std::string counts_from = {};
  std::vector<MeasuredColumn> acceleration = {};  ///< one, or the two or three of a resultant
  bool resultant = false;
  /// The directions of a resultant, m/s2, at the times of the pulse; empty without. Filters are for these:
  /// the resultant of noise has a mean, which no filter takes away.
  std::vector<std::vector<double>> components = {};
  std::vector<std::string> remarks =
      {};  ///< repairs and readings that the user should know of, a sentence each
};

/// sqrt(x^2 + y^2 + z^2) at each time.
std::vector<double> resultant_of(const std::vector<std::vector<double>>& components);

// What an accelerometer shows while nothing happens: its offset, and how to take it off.

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

/// Of the quiet part before the impact, from the first sample on; where it shows a rest and a free fall, of
/// the fall alone. Absent where there is none. docs/pulses.md says what is quiet.
std::optional<SensorOffset> offset_before_impact(const MeasuredPulse& measured);

/// Without the samples before `begin`, s, and a remark that says so.
void leave_out_before(MeasuredPulse& measured, double begin);

/// With the mean taken off each direction; a resultant is that of the directions afterwards.
MeasuredPulse zeroed(MeasuredPulse measured, const SensorOffset& offset);

}  // namespace dashpad::injury
