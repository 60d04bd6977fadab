#pragma once
/// What a summary says of each quantity of a result: read here, and nowhere else, by text, page, JSON and
/// studies.

#include <span>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad {

/// A value in SI and its error, estimated as ErrorEstimates has it; of a moment its time, and the velocity
/// then.
struct EstimatedValue {
  double value = no_value;     ///< NaN where the impact has none
  double error = 0;            ///< 0 where the quantity has no estimate
  double velocity = no_value;  ///< m/s
};

struct SummaryQuantity {
  const ResultQuantity* quantity;
  EstimatedValue (*of)(const Summary&);
};

/// In the order of the table of results.
std::span<const SummaryQuantity> summary_quantities();

}  // namespace dashpad
