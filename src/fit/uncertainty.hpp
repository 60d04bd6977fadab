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
///
/// What follows from it for predictions, and draws from the Laplace approximation of a posterior.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "dashpad/fit/fit.hpp"
#include "fit/problem.hpp"
#include "fit/solve.hpp"

namespace dashpad::fit {

/// Eigenvalues of a symmetric matrix, rising, and their directions of length 1.
struct PrincipalAxes {
  std::vector<double> values;
  std::vector<double> directions;  ///< one after the other

  [[nodiscard]] std::span<const double> direction(std::size_t k) const {
    return {directions.data() + k * values.size(), values.size()};
  }
};

/// `matrix` holds `size` rows of `size` numbers.
[[nodiscard]] PrincipalAxes principal_axes(std::span<const double> matrix, std::size_t size);

/// Of a covariance of coordinates from 0 to 1, the standard deviation along an axis. A direction of which the
/// data say nothing counts as even between the bounds.
[[nodiscard]] double deviation_along(const PrincipalAxes& axes, std::size_t k);

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

/// Standard deviations of the figures of an impact at the minimum `x`: of each the root of the sum of squared
/// half differences between one standard deviation up and down each principal axis of the covariance. A
/// direction of which the data say nothing counts as even between the bounds. Absent where the figure is
/// missing there.
std::vector<std::optional<double>> prediction_deviations(const Fit& fit, const ImpactMeasurement& impact,
                                                         const Problem& problem, std::span<const double> x,
                                                         const Uncertainty& uncertainty);

/// Normal about a minimum in [0, 1]^n with this precision (row by row) and gradient there, cut off at the
/// bounds. Coordinates of which the data say nothing are even between their bounds. By hit and run along the
/// eigenvectors of the precision.
std::vector<std::vector<double>> laplace_sample(std::span<const double> minimum,
                                                std::span<const double> precision,
                                                std::span<const double> gradient, std::size_t count,
                                                std::uint64_t seed);

}  // namespace dashpad::fit
