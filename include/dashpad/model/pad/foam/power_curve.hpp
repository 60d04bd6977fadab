#pragma once
/// A base curve with the shape A of law 4 (theory.md, Eq. 14).
///
///   s(e) = E e^m / (1 - e)^n
///
/// Stress in Pa, compression positive.

#include <array>

#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct PowerCurve {
  double modulus = 0;              ///< E, Pa, > 0
  double contact_exponent = 0;     ///< m, (0, 1.5]
  double compaction_exponent = 0;  ///< n, [0, 4]
  double highest_strain = 0;       ///< highest fitted strain, (0, 1)

  static constexpr const char* name = "power";
  static const std::array<Parameter<PowerCurve>, 4> parameters;

  [[nodiscard]] double stress(double e) const {
    return modulus * portable::pow(e, contact_exponent) * portable::pow(1 - e, -compaction_exponent);
  }
  friend bool operator==(const PowerCurve&, const PowerCurve&) = default;
};

inline constexpr std::array<Parameter<PowerCurve>, 4> PowerCurve::parameters{{
    {"modulus", "E", "Pa", &PowerCurve::modulus, positive, "stress scale"},
    {"contact_exponent", "m", "1", &PowerCurve::contact_exponent, above_to(0, 1.5), "exponent of the strain"},
    {"compaction_exponent", "n", "1", &PowerCurve::compaction_exponent, from_to(0, 4),
     "exponent of (1 - strain)"},
    {"highest_strain", "e_h", "1", &PowerCurve::highest_strain, Bounds{.lowest = 0, .highest = 1},
     "strain up to which the curve was fitted"},
}};

}  // namespace dashpad
