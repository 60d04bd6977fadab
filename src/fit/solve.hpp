#pragma once
/// Least squares within bounds, and the derivatives that go with it.

#include <cstddef>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace dashpad::fit {

/// Residuals over coordinates in [0, 1]; false where they cannot be evaluated. Several threads call it.
struct LeastSquares {
  std::size_t unknowns = 0;
  std::size_t residuals = 0;
  double step = 1e-4;  ///< of a coordinate, for derivatives
  std::function<bool(std::span<const double> x, std::span<double> residuals)> evaluate;
};

/// d residual / d x, a row a residual: central differences, at a bound one-sided ones of second order. False
/// where the residuals cannot be evaluated.
bool derivatives(const LeastSquares& problem, std::span<const double> x, std::span<double> into);

struct Minimum {
  bool converged = false;
  std::string why_not;
  std::vector<double> x;
  double misfit = 0;  ///< sum of squares
};

/// Relative change of the misfit at which a search has converged: for a comparison, and for the result.
inline constexpr double coarse = 1e-6, fine = 1e-10;

/// From a start, by Levenberg-Marquardt within [0, 1]. Coordinates that are `held` (empty: none) stay.
Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance = fine,
                 const std::vector<bool>& held = {});

}  // namespace dashpad::fit
