#pragma once
/// Samples of a measured pulse: their plausibility and gaps.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/measurement/tables.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// Reports implausible samples: intervals or times beyond those of any test, or a peak that is no impact's. A
/// pulse of zeros is admitted. `line`: of the first sample, or 0.
void judge_pulse(const Pulse& pulse, std::size_t line, MeasurementFaults& faults);

/// The samples from `begin` to before `end`, by index.
struct KeptSamples {
  std::size_t begin = 0, end = 0;

  template <class Value>
  void keep(std::vector<Value>& of_samples) const {
    of_samples.erase(of_samples.begin() + static_cast<std::ptrdiff_t>(end), of_samples.end());
    of_samples.erase(of_samples.begin(), of_samples.begin() + static_cast<std::ptrdiff_t>(begin));
  }
};

/// Those between two times, inclusive; remarks on them. Fewer than two are a fault.
KeptSamples kept_samples(const std::vector<double>& times, const CutTimes& cut, MeasurementFaults& faults,
                         std::vector<std::string>& remarks);

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

/// Reports the gaps between the times, as faults or, if they are to be bridged, as remarks. `lines` of the
/// samples, or none. `name` of the times.
void judge_gaps(const std::vector<double>& times, const std::vector<std::uint32_t>& lines,
                const std::string& name, bool bridge, MeasurementFaults& faults,
                std::vector<std::string>& remarks);

}  // namespace dashpad::input
