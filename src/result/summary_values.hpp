#pragma once
/// The values of a summary by the quantities of the table of results, for text, page, JSON and studies.

#include <span>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/result/result_quantity.hpp"

namespace dashpad {

/// A value in SI with its estimated error, as in ErrorEstimates.
struct EstimatedValue {
  double value = no_value;     ///< of a moment its time; NaN if the impact has none
  double error = 0;            ///< 0 if the quantity has no estimate
  double velocity = no_value;  ///< velocity at a moment, m/s
};

struct SummaryQuantity {
  const ResultQuantity* quantity;
  EstimatedValue (*of)(const Summary&);
};

/// The quantities that a summary has, in the order of the table of results.
std::span<const SummaryQuantity> summary_quantities();

}  // namespace dashpad
