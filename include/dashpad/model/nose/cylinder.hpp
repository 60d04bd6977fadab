#pragma once
/// A cylinder on its side, such as a pole, a rim or a knee: its axis is parallel to the pad, its ends are
/// flat. Deeper than its radius it continues as a box of the same width.
///
///   a(s) = 2 l sqrt(2 R s - s^2) up to s = R                                          (theory.md, Eq. 3)

#include <array>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Cylinder {
  double radius = 0;  ///< R, m, > 0
  double length = 0;  ///< l, length along its axis, m, > 0

  static constexpr const char* name = "cylinder";
  static const std::array<Parameter<Cylinder>, 2> parameters;

  [[nodiscard]] Sections sections() const;
};

inline constexpr std::array<Parameter<Cylinder>, 2> Cylinder::parameters{{
    {"radius", "R", "m", &Cylinder::radius, positive, "radius of the cylinder"},
    {"length", "l", "m", &Cylinder::length, positive, "length of the cylinder along its axis"},
}};

}  // namespace dashpad
