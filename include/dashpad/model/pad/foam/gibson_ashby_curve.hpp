#pragma once
/// A base curve after Gibson and Ashby: cell walls that bend and buckle, and the gas of closed cells.
///
///   s(e) = S (1 - exp(-E e / S)) + p0 e / (1 - e - R)
///
/// The first term rises with the modulus E to the plateau S (their elastic line and plateau, smoothed: an
/// assumption of ours); the second is the gas, compressed at constant temperature without lateral expansion.
/// L. J. Gibson, M. F. Ashby: Cellular Solids, 2nd ed., Cambridge 1997, section 5.3. Stress in Pa.

#include <array>

#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct GibsonAshbyCurve {
  double modulus = 0;           ///< E, Pa, > 0
  double plateau_stress = 0;    ///< S, Pa, > 0
  double gas_pressure = 0;      ///< p0, Pa, >= 0: 0.1013 MPa for closed cells, 0 for open ones
  double relative_density = 0;  ///< R, density of the foam divided by that of the solid, [0, 0.9]
  double highest_strain = 0;    ///< highest fitted strain, (0, 1 - R)

  static constexpr const char* name = "gibson-ashby";
  static const std::array<Parameter<GibsonAshbyCurve>, 5> parameters;

  [[nodiscard]] double stress(double e) const {
    return -plateau_stress * portable::expm1(-modulus * e / plateau_stress) +
           gas_pressure * e / (1 - e - relative_density);
  }
  friend bool operator==(const GibsonAshbyCurve&, const GibsonAshbyCurve&) = default;
};

inline constexpr std::array<Parameter<GibsonAshbyCurve>, 5> GibsonAshbyCurve::parameters{{
    {"modulus", "E", "Pa", &GibsonAshbyCurve::modulus, positive, "initial modulus due to the cell walls"},
    {"plateau_stress", "S", "Pa", &GibsonAshbyCurve::plateau_stress, positive, "plateau stress"},
    {"gas_pressure", "p0", "Pa", &GibsonAshbyCurve::gas_pressure, not_negative,
     "gas pressure in the closed cells"},
    {"relative_density", "R", "1", &GibsonAshbyCurve::relative_density, from_to(0, 0.9),
     "density of the foam divided by that of the solid"},
    {"highest_strain", "e_h", "1", &GibsonAshbyCurve::highest_strain, Bounds{.lowest = 0, .highest = 1},
     "strain up to which the curve was fitted"},
}};

}  // namespace dashpad
