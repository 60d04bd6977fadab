#pragma once
/// Strain of a pad column, kept together with its distance from full compression.

#include <algorithm>
#include <cmath>

namespace dashpad {

/// Engineering strain, compression positive, in [0, 1).
/// `complement` is 1 - strain, computed by the caller without cancellation (from the gap L - Y, see
/// docs/theory.md, Eq. 5): near bottoming the difference of nearly equal numbers would lose it.
struct Strain {
  double value = 0;
  double complement = 1;
};

/// For callers far from bottoming.
constexpr Strain strain_of(double value) { return {value, 1 - value}; }

// The residual strain of the unloading factor that the 9- and the 21-parameter law share.
//
//   E(e, e*, D) = (e - e* D) / (e (1 - D)),   D = (tau* |de/dt|)^p           (theory.md, Eq. 16)
//
// e* is the largest strain that the column has seen. E (src/model/pad/formulas.hpp) is 1 at e = e* and 0 at
// the residual strain e* D.

/// The law means something only while tau* |de/dt| < 1; beyond it a column lets go at once, which is the
/// limit D -> 1. This is as near to it as is kept.
inline constexpr double largest_residual_ratio = 1 - 1e-6;

/// D, from a strain rate given by the logarithm of its magnitude (1/s).
inline double residual_ratio(double log_rate, double scale_time, double exponent) {
  return std::min(std::exp(exponent * (std::log(scale_time) + log_rate)), largest_residual_ratio);
}

}  // namespace dashpad
