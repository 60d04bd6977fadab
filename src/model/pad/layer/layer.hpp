#pragma once
/// A layer of any admitted law, and its strain as a function of the stress (theory.md, Eq. 52).

#include <cmath>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "dashpad/model/pad/strain.hpp"
#include "model/increasing_root.hpp"
#include "model/pad/layer/foam_layer.hpp"
#include "model/pad/layer/layer_law.hpp"
#include "model/pad/layer/linear_layer.hpp"

namespace dashpad {

using Layer = std::variant<FoamLayer, LinearLayer>;

/// Every stress is multiplied by `factor`.
inline Layer made_layer(const LayerLaw& law, double factor) {
  return std::visit(
      [&]<class Law>(const Law& of) -> Layer {
        if constexpr (SharesSlip<Law>)
          return FoamLayer(of, factor);
        else
          return LinearLayer(of, factor);
      },
      law);
}

/// The inverse of the stress of a layer.
struct StrainOfStress {
  Strain strain;
  double flexibility = 0;  ///< d(strain)/d(stress), 1/Pa
};

/// Roots are sought over x = -ln(1 - e): the complement keeps its digits where a layer is nearly closed.
struct LogStrain {
  static constexpr double precision = 1e-13;
  /// A layer of which this share is left counts as closed, and carries any stress. Less than what the lock
  /// of a pad leaves (theory.md, Eq. 29).
  static constexpr double least_complement = 1e-10;

  static double most() { return -std::log(least_complement); }
  static double of(double strain) { return -std::log1p(-strain); }
  static double of(Strain strain) {
    return strain.complement < 0.5 ? -std::log(strain.complement) : of(strain.value);
  }
  static Strain strain(double x) {
    const double complement = std::exp(-x);
    return {complement > 0.5 ? -std::expm1(-x) : 1 - complement, complement};
  }
};

/// The strain at which `stress_at(strain)` is a stress, Pa, found from the guess `x` with the slope
/// d(stress)/dx there (0: not known) and a first stride.
template <class StressAt>
StrainOfStress strain_at(double stress, double x, double slope, double stride, StressAt&& stress_at) {
  const IncreasingRoot root =
      increasing_root([&](double at) { return stress_at(LogStrain::strain(at)) - stress; },
                      {.guess = x,
                       .slope = slope,
                       .low = 0,
                       .high = LogStrain::most(),
                       .stride = stride,
                       .precision = LogStrain::precision});
  const Strain strain = LogStrain::strain(root.x);
  return {strain, root.slope > 0 ? strain.complement / root.slope : 0};
}

}  // namespace dashpad
