#pragma once
/// Strain of a pad column, kept together with its distance from full compression.

#include <algorithm>

#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

/// Engineering strain, compression positive, in [0, 1). `complement` is 1 - strain, which the caller computes
/// from the gap L - Y (theory.md, Eq. 5), since near bottoming the difference would lose its digits.
struct Strain {
  double value = 0;
  double complement = 1;
};

/// The strain of a value far from bottoming.
constexpr Strain strain_of(double value) { return {value, 1 - value}; }

// The residual strain of the unloading factor that the 9- and the 21-parameter law share.
//
//   E(e, e*, D) = (e - e* D) / (e (1 - D)),   D = (tau* |de/dt|)^p           (theory.md, Eq. 16)
//
// e* is the largest strain so far. E (src/model/pad/formulas.hpp) is 1 at e = e* and 0 at e* D.

/// Largest D. Eq. 16 holds while tau* |de/dt| < 1; beyond, a column loses its stress at once (D -> 1).
inline constexpr double largest_residual_ratio = 1 - 1e-6;

/// D at a strain rate given by the logarithm of its magnitude in 1/s; `scale_time`: tau*, s.
inline double residual_ratio(double log_rate, double scale_time, double exponent) {
  return std::min(portable::exp(exponent * (portable::log(scale_time) + log_rate)), largest_residual_ratio);
}

}  // namespace dashpad
