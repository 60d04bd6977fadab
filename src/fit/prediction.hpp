#pragma once
/// How sure what is computed of an impact is, by the uncertainty of the unknowns.

#include <optional>
#include <span>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "fit/problem.hpp"
#include "fit/uncertainty.hpp"

namespace dashpad::fit {

/// Standard deviations of the figures of an impact at the minimum `x`: of each the root of the sum of squared
/// half differences between one standard deviation up and down each principal axis of the covariance. A
/// direction of which the data say nothing counts as even between the bounds. Absent where the figure is
/// missing there.
std::vector<std::optional<double>> prediction_deviations(const Fit& fit, const ImpactMeasurement& impact,
                                                         const Problem& problem, std::span<const double> x,
                                                         const Uncertainty& uncertainty);

}  // namespace dashpad::fit
