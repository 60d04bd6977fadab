#pragma once
/// Where axes end, and the marks on them: at 1, 2 and 5 times powers of ten.

#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/output/plot/plot.hpp"
#include "output/plot/rows.hpp"

namespace dashpad::output {

struct Tick {
  double value = 0;
  std::string label;  ///< empty: a minor tick of a logarithmic axis
};

/// An axis with both its ends.
struct AxisRange {
  double low = 0;
  double high = 1;
  bool logarithmic = false;

  /// Share of the axis: 0 at its low end, 1 at its high one.
  [[nodiscard]] double share(double value) const;
};

/// From the limits of the axis or, where it has none, from the next mark beyond what it has to include, or
/// half way to it.
/// `most`: about how many labels there is room for.
AxisRange range_of(const Axis& axis, const Span& included, std::size_t most);

/// The nearest of 1, 2 and 5 times powers of ten below a positive number, or above it.
double round_number(double value, bool above);

/// From low to high, within the range.
std::vector<Tick> ticks_of(const AxisRange& range, std::size_t most);

}  // namespace dashpad::output
