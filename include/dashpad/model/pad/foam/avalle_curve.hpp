#pragma once
/// The base curve of Avalle, Belingardi and Ibba: a plateau that saturates, and densification.
///
///   s(e) = A (1 - exp(-(E / A) e (1 - e)^m)) + B (e / (1 - e))^n
///
/// M. Avalle, G. Belingardi, A. Ibba: Mechanical models of cellular solids, International Journal of Impact
/// Engineering 34 (2007) 3-27. Stress in Pa, compression positive.

#include <array>

#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct AvalleCurve {
  double plateau_stress = 0;          ///< A, Pa, > 0
  double modulus = 0;                 ///< E, Pa, > 0
  double plateau_exponent = 0;        ///< m, [0, 20]
  double densification_stress = 0;    ///< B, Pa, >= 0
  double densification_exponent = 0;  ///< n, [0.5, 20]
  double highest_strain = 0;          ///< highest fitted strain, (0, 1)

  static constexpr const char* name = "avalle";
  static const std::array<Parameter<AvalleCurve>, 6> parameters;

  [[nodiscard]] double stress(double e) const {
    const double plateau = -plateau_stress * portable::expm1(-modulus / plateau_stress * e *
                                                             portable::pow(1 - e, plateau_exponent));
    return plateau + densification_stress * portable::pow(e / (1 - e), densification_exponent);
  }
  friend bool operator==(const AvalleCurve&, const AvalleCurve&) = default;
};

inline constexpr std::array<Parameter<AvalleCurve>, 6> AvalleCurve::parameters{{
    {"plateau_stress", "A", "Pa", &AvalleCurve::plateau_stress, positive, "plateau stress"},
    {"modulus", "E", "Pa", &AvalleCurve::modulus, positive, "initial modulus"},
    {"plateau_exponent", "m", "1", &AvalleCurve::plateau_exponent, from_to(0, 20),
     "exponent of (1 - strain) in the plateau term"},
    {"densification_stress", "B", "Pa", &AvalleCurve::densification_stress, not_negative,
     "densification stress at a strain of 0.5"},
    {"densification_exponent", "n", "1", &AvalleCurve::densification_exponent, from_to(0.5, 20),
     "exponent of the densification term"},
    {"highest_strain", "e_h", "1", &AvalleCurve::highest_strain, Bounds{.lowest = 0, .highest = 1},
     "strain up to which the curve was fitted"},
}};

}  // namespace dashpad
