#pragma once
/// Samples of a measured pulse: their plausibility, gaps, and times of clocks that began long ago.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/measured_pulse.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// Reports implausible samples: intervals or times beyond those of any test, or a peak that is no impact's. A
/// pulse of zeros is admitted. `line`: of the first sample, or 0.
void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults);

struct PulseGap {
  std::size_t after = 0;  ///< index of the sample before the gap
  double length = 0;      ///< s, from that sample to the next
};

struct PulseGaps {
  std::vector<PulseGap> all = {};
  double usual_step = 0;  ///< s, the median
};

/// Finds gaps: on an even grid, steps of more than 1.5 times the median; on any other, steps of more than 10
/// times the median and more than 3 times both neighbours. docs/pulses.md defines even grids. Fewer than
/// three steps have no gaps.
PulseGaps find_gaps(const std::vector<double>& times);

/// A decimal number as its whole part and its decimals, of the same sign. A double cannot hold
/// 1764068400.1234 s to better than 0.24 us; so times of such clocks are subtracted before they are rounded.
struct ExactTime {
  std::int64_t whole = 0;
  double part = 0;  ///< in (-1, 1)

  /// The difference to `first`, accurate to 1e-16 for near times.
  [[nodiscard]] double since(const ExactTime& first) const {
    return static_cast<double>(whole - first.whole) + (part - first.part);
  }
};

/// A number with a decimal point or comma, as in read_csv_number(); absent beyond 18 digits before the point.
std::optional<ExactTime> exact_time(std::string_view number);

/// Whether times count from the first sample: the clock's zero is further away than a thousand times
/// `length`, s, of the record.
bool counts_from_first(double first, double length);

/// The remark for such a record. `first` is as in the file, with its unit.
std::string remark_on_clock(const std::string& first);

}  // namespace dashpad::input
