#pragma once
/// The samples of a measured pulse: what no sensor gives, samples that are missing, and times of a clock that
/// began long ago.

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

/// Faults where the samples are nearer to each other or further from time 0 than any test has them, or the
/// largest acceleration is no impact's. A pulse that is 0 throughout is admitted. `line`: of the first
/// sample; 0 where it has none.
void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults);

struct PulseGap {
  std::size_t after = 0;  ///< index of the sample before the gap
  double length = 0;      ///< s, from that sample to the next
};

struct PulseGaps {
  std::vector<PulseGap> all = {};
  double usual_step = 0;  ///< s, the median
};

/// On an even grid, steps of more than 1.5 times the median; on any other, steps of more than 10 times the
/// median and of more than 3 times both of their neighbours. docs/pulses.md says which grids are even. Fewer
/// than three steps tell nothing.
PulseGaps find_gaps(const std::vector<double>& times);

/// A time of a clock that began long ago: 1764068400.1234 s has no room for a sample of 0.1 ms in a double,
/// whose steps are 0.24 us there. So such times are subtracted before they are rounded.
///
/// A decimal number as its whole part and what is behind the point, of the same sign.
struct ExactTime {
  std::int64_t whole = 0;
  double part = 0;  ///< in (-1, 1)

  /// This less `first`, rounded once the common part is gone: to 1e-16 where both are near.
  [[nodiscard]] double since(const ExactTime& first) const {
    return static_cast<double>(whole - first.whole) + (part - first.part);
  }
};

/// Of a number with a decimal point or comma, as read_csv_number() takes it; absent for one with more than 18
/// digits before the point.
std::optional<ExactTime> exact_time(std::string_view number);

/// Whether a record of `length`, s, counts from its first sample: where its clock began more than a thousand
/// times as long ago, or will begin so much later.
bool counts_from_first(double first, double length);

/// What the user is told then. `first` is as in the file, with its unit.
std::string remark_on_clock(const std::string& first);

}  // namespace dashpad::input
