#pragma once
/// A circular cone, pointed or cut off square; beyond its base its side continues as a cylinder.
///
///   a(s) = pi (r0 + s tan(alpha))^2 up to s = (R - r0) / tan(alpha)                   (theory.md, Eq. 3)

#include <array>
#include <numbers>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"
#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {

struct Cone {
  double radius = 0;      ///< R, m, > r0
  double half_angle = 0;  ///< alpha, rad, 0.01 to 1.56
  double tip_radius = 0;  ///< r0, m, >= 0

  static constexpr const char* name = "cone";
  static const std::array<Parameter<Cone>, 3> parameters;

  [[nodiscard]] Sections sections() const {
    const double slope = portable::tan(half_angle);
    return {.tip = std::numbers::pi * tip_radius * tip_radius,
            .width = tip_radius * slope,
            .taper = -slope * slope,
            .depth = (radius - tip_radius) / slope};
  }
};

inline constexpr std::array<Parameter<Cone>, 3> Cone::parameters{{
    {"radius", "R", "m", &Cone::radius, positive, "radius of the cone's base"},
    {"half_angle", "alpha", "rad", &Cone::half_angle, from_to(0.01, 1.56), "angle from the axis to the side"},
    {"tip_radius", "r0", "m", &Cone::tip_radius, not_negative, "radius of the flat tip; 0 for a point",
     LeftOut::as_default},
}};

}  // namespace dashpad
