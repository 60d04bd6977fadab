#pragma once
/// Peak, HIC and rebound of measured impacts beside the model's.

#include <span>
#include <vector>

#include "dashpad/fit/report.hpp"

namespace dashpad::fit {

/// Of an impact with these values of the unknowns, to the tolerance of its case.
std::vector<ImpactComparison> compared(const Fit& fit, const ImpactMeasurement& impact,
                                       std::span<const double> values);

}  // namespace dashpad::fit
