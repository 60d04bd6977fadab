#pragma once
/// Profile likelihood: how far a coordinate can go until the misfit, the others refitted, has risen by a
/// threshold.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "fit/solve.hpp"

namespace dashpad::fit {

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
