#pragma once
/// What physics allows a result to be, for intervals: plain data beside the table of results.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad {

/// The largest value that a figure can have.
enum class Most {
  unbounded,
  one,
  pad_thickness,
  impact_speed,
  height_of_impact_speed,  ///< that to which the impact speed would throw the impactor up
};

struct PossibleRange {
  const char* key;
  double least = 0;
  Most most = Most::unbounded;
};

/// The range of a quantity of a result. One without a row of its own is at least 0 unless it is signed.
PossibleRange possible_range(const ResultQuantity& quantity);

/// The largest possible value in a case, SI; infinite without a bound.
double max_in(const ImpactCase& impact, Most most);

}  // namespace dashpad
