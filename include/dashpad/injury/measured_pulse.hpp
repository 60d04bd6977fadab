#pragma once
/// A measured pulse with its provenance.

#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// A column of a table or a channel of a test, and its unit.
struct MeasuredColumn {
  std::string name = {};         ///< as in the file, UTF-8; "column 2" if the file has no name
  int number = 0;                ///< from 1
  std::string unit = {};         ///< as given or as in the file; empty if unknown
  std::string unit_origin = {};  ///< "given", "header", or "format" if the file format fixes it
  double factor = 1;             ///< one unit in SI
  std::string sensitivity = {};  ///< as given, "10 mV/g", if the unit is a voltage; else empty
};

struct MeasuredPulse {
  Pulse pulse = {};         ///< the resultant, if there is one
  std::string format = {};  ///< "CSV", "ISO-MME"
  MeasuredColumn time = {};
  /// The time of the first sample as in the file, "1764068400.1234 s", if the pulse counts from there because
  /// the clock began more than a thousand times the length of the record before; else empty.
  std::string counts_from = {};
  std::vector<MeasuredColumn> acceleration = {};  ///< one, or the two or three of a resultant
  bool resultant = false;
  /// The directions of a resultant, m/s2; empty without. They are filtered before they are combined, since
  /// the resultant of noise has a mean, which no filter removes.
  std::vector<std::vector<double>> components = {};
  std::vector<std::string> remarks = {};  ///< repairs and interpretations, a sentence each
};

/// sqrt(x^2 + y^2 + z^2) at each time.
std::vector<double> resultant_of(const std::vector<std::vector<double>>& components);

// Sensor offset: what an accelerometer shows while nothing happens.

/// The level that the sensor showed at rest, before a free fall; it differs by 1 g.
struct RestLevel {
  double end = 0;                 ///< s, of its last sample
  std::vector<double> mean = {};  ///< m/s2, of each direction
};

struct SensorOffset {
  double begin = 0, end = 0;           ///< s, first and last sample of the mean
  std::size_t samples = 0;             ///< their number
  std::vector<double> mean = {};       ///< m/s2, of each direction
  std::vector<double> scatter = {};    ///< m/s2, their standard deviation
  std::optional<RestLevel> rest = {};  ///< if this is the offset during a fall
};

/// The offset from `begin` to `end`, s, inclusive. Throws std::invalid_argument for fewer than two samples.
SensorOffset offset_between(const MeasuredPulse& measured, double begin, double end);

/// The offset of the quiet part before the impact, from the first sample on; if it shows a rest and a free
/// fall, only that of the fall. Absent if there is no quiet part, as docs/pulses.md defines it.
std::optional<SensorOffset> offset_before_impact(const MeasuredPulse& measured);

/// The offset between two times, s, or without them offset_before_impact(). Removes earlier samples at rest,
/// with a remark. Throws std::invalid_argument for fewer than two samples in the interval and, if
/// `is_required`, without a quiet part.
std::optional<SensorOffset> find_offset(MeasuredPulse& measured,
                                        const std::optional<std::pair<double, double>>& interval,
                                        bool is_required);

/// The pulse with the mean subtracted from each direction; a resultant is computed afterwards.
MeasuredPulse zeroed(MeasuredPulse measured, const SensorOffset& offset);

}  // namespace dashpad::injury
