#pragma once
/// A base curve of the Ogden-Hill (hyperfoam) kind without lateral expansion, of one or two terms.
///
///   s(e) = sum over i of 2 mu_i / (a_i (1 - e)) (1 - (1 - e)^a_i)
///
/// Nominal stress of uniaxial compression; Poisson's ratio 0. Stress in Pa, compression positive.

#include <array>

#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct HyperfoamCurve {
  double first_modulus = 0;    ///< mu_1, Pa, > 0
  double first_exponent = 0;   ///< a_1, [-50, 50]
  double second_modulus = 0;   ///< mu_2, Pa, >= 0
  double second_exponent = 0;  ///< a_2, [-50, 50]
  double highest_strain = 0;   ///< highest fitted strain, (0, 1)

  static constexpr const char* name = "hyperfoam";
  static const std::array<Parameter<HyperfoamCurve>, 5> parameters;

  [[nodiscard]] double stress(double e) const {
    const double log_stretch = portable::log1p(-e);
    const auto term = [&](double mu, double a) {
      // For a = 0 the term is its limit, the logarithm.
      return a == 0 ? -2 * mu * log_stretch / (1 - e)
                    : -2 * mu / (a * (1 - e)) * portable::expm1(a * log_stretch);
    };
    return term(first_modulus, first_exponent) + term(second_modulus, second_exponent);
  }
  friend bool operator==(const HyperfoamCurve&, const HyperfoamCurve&) = default;
};

inline constexpr Bounds hyperfoam_exponents = from_to(-50, 50);
inline constexpr std::array<Parameter<HyperfoamCurve>, 5> HyperfoamCurve::parameters{{
    {"first_modulus", "mu_1", "Pa", &HyperfoamCurve::first_modulus, positive, "modulus of the first term"},
    {"first_exponent", "a_1", "1", &HyperfoamCurve::first_exponent, hyperfoam_exponents, "its exponent"},
    {"second_modulus", "mu_2", "Pa", &HyperfoamCurve::second_modulus, not_negative,
     "modulus of the second term; 0 for none"},
    {"second_exponent", "a_2", "1", &HyperfoamCurve::second_exponent, hyperfoam_exponents, "its exponent"},
    {"highest_strain", "e_h", "1", &HyperfoamCurve::highest_strain, Bounds{.lowest = 0, .highest = 1},
     "strain up to which the curve was fitted"},
}};

}  // namespace dashpad
