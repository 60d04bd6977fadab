#pragma once
/// Samples that are missing from a table, told by the times of the others.

#include <cstddef>
#include <vector>

namespace dashpad::input {

struct PulseGap {
  std::size_t after = 0;  ///< index of the sample before the gap
  double length = 0;      ///< s, from that sample to the next
};

struct PulseGaps {
  std::vector<PulseGap> all = {};
  double usual_step = 0;  ///< s, the median
};

/// On an even grid, steps of more than 1.5 times the median. A grid is even if all steps up to that length
/// are within a quarter of the median, and at most three of the rest, or a tenth of all, are longer: more
/// than that are times that were rounded, or two rates. On any other grid, steps of more than 10 times the
/// median and of more than 3 times both of their neighbours: the steps of a solver that adapts them grow to
/// 14 times their median, but one after the other. Fewer than three steps tell nothing.
PulseGaps find_gaps(const std::vector<double>& times);

}  // namespace dashpad::input
