#pragma once
/// How sure a minimum is, from the derivatives of the residuals there.
///
/// With J the derivatives and r the residuals over their deviations, the errors of the coordinates have the
/// covariance
///
///   scale H^-1 (sum over blocks of w_k J_k' J_k) H^-1,   H = J' J
///
/// w_k = n / n_eff is 1 for independent errors, and (1 + rho) / (1 - rho) for errors along a curve whose
/// neighbours are correlated by rho: the fit weighs them as if they were independent.

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "fit/problem.hpp"
#include "fit/solve.hpp"

namespace dashpad::fit {

/// Lag-1 correlation of residuals along a curve, and how many independent ones they are worth.
struct Autocorrelation {
  double rho = 0;
  double effective_points = 0;
};
Autocorrelation autocorrelation_of(std::span<const double> residuals);

struct Uncertainty {
  /// Of each coordinate; absent at a bound, and where a move across the bounds is within the noise.
  std::vector<std::optional<double>> error;
  std::vector<double> widening;    ///< of its variance, by correlated residuals
  std::vector<double> covariance;  ///< row by row; rows of coordinates at a bound are 0
  std::vector<std::pair<std::size_t, std::size_t>> strongly_correlated;
  std::vector<double> correlations;  ///< of these
  std::vector<std::vector<std::size_t>> flat_directions;
  std::vector<double> precision;        ///< of all coordinates, row by row: inverse of the covariance
  std::vector<double> gradient;         ///< of half the misfit over the scale
  std::vector<Autocorrelation> blocks;  ///< of the curve of each
};

/// At a minimum. `scale` multiplies variances. False where the derivatives cannot be evaluated.
bool find_uncertainty(const Problem& problem, const LeastSquares& residuals, std::span<const double> x,
                      double scale, Uncertainty& into);

bool is_at_bound(double x);

}  // namespace dashpad::fit
