#pragma once
/// Least squares within bounds, the derivatives that go with it, and profile likelihood: how far a coordinate
/// can go until the misfit, the others refitted, has risen by a threshold.

#include <cstddef>
#include <functional>
#include <optional>
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
  /// Residuals take impacts, which are exact to some 1e-4: differences by several threads, and no search goes
  /// on below what that moves.
  bool takes_impacts = false;
  /// Coordinates that settle() puts where they are best unless they are held, at no cost: they are not
  /// searched for. Empty: none.
  std::vector<bool> settles = {};
  std::function<bool(std::span<double> x, const std::vector<bool>& held, std::span<double> residuals)>
      settle = {};
};

/// d residual / d x, a row a residual: central differences, at a bound one-sided ones of second order. False
/// where the residuals cannot be evaluated.
bool derivatives(const LeastSquares& problem, std::span<const double> x, std::span<double> into);

struct Minimum {
  bool converged = false;
  std::string why_not;
  std::vector<double> x;
  double misfit = 0;      ///< sum of squares
  bool is_sound = false;  ///< converged, or out of iterations with a misfit that is not below the least one
};

/// Relative change of the misfit at which a search has converged: for a comparison, and for the result; with
/// impacts, whose noise in it is up to 1e-4, not below that and a tenth of it.
inline constexpr double coarse = 1e-6, fine = 1e-10;
inline constexpr int most_iterations = 300;

/// From a start, by Levenberg-Marquardt within [0, 1]. Coordinates that are `held` (empty: none) stay.
Minimum minimise(const LeastSquares& problem, std::vector<double> start, double tolerance = fine,
                 const std::vector<bool>& held = {}, int iterations = most_iterations);

struct ProfileEnd {
  /// Absent where the misfit does not rise so far within the bounds, or within what makes a material.
  std::optional<double> x;
  bool is_rough = false;  ///< the refits ran out before it was as exact as asked for
  /// A better minimum, if one was met on the way.
  std::optional<Minimum> better;
};

struct ProfileRequest {
  std::size_t coordinate = 0;
  int side = 1;                        ///< 1 upwards, -1 downwards
  double threshold = 3.84;             ///< of the misfit
  double guess = 0.1;                  ///< of the distance
  std::vector<double> direction = {};  ///< of all coordinates, for a first guess of the others; 1 for its own
};

/// From a minimum, to half a per cent of the distance; with impacts, to two per cent. Some ten refits, each
/// with the others from where the curvature at the minimum expects them.
ProfileEnd profile(const LeastSquares& problem, const Minimum& minimum, const ProfileRequest& request);

}  // namespace dashpad::fit
