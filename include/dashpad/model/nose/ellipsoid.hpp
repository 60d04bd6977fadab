#pragma once
/// An ellipsoid with one axis along the motion; beyond its widest section it continues as an elliptic
/// cylinder. With three equal semi-axes it is a sphere.
///
///   a(s) = pi (R1 R2 / b) (2 s - s^2 / b) up to s = b                                 (theory.md, Eq. 3)

#include <array>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Ellipsoid {
  double half_depth = 0;   ///< b, semi-axis along the motion, m, > 0
  double half_length = 0;  ///< R1, semi-axis across it, m, > 0
  double half_width = 0;   ///< R2, semi-axis across both, m, > 0

  static constexpr const char* name = "ellipsoid";
  static const std::array<Parameter<Ellipsoid>, 3> parameters;

  [[nodiscard]] Sections sections() const {
    // In this order equal semi-axes give the sphere's numbers to the last bit.
    return {.tip = 0,
            .width = half_length * (half_width / half_depth),
            .taper = (half_length / half_depth) * (half_width / half_depth),
            .depth = half_depth};
  }
};

inline constexpr std::array<Parameter<Ellipsoid>, 3> Ellipsoid::parameters{{
    {"half_depth", "b", "m", &Ellipsoid::half_depth, positive, "semi-axis in the direction of motion"},
    {"half_length", "R1", "m", &Ellipsoid::half_length, positive, "semi-axis perpendicular to the motion"},
    {"half_width", "R2", "m", &Ellipsoid::half_width, positive,
     "other semi-axis perpendicular to the motion"},
}};

}  // namespace dashpad
