#pragma once
/// A sphere; deeper than its radius its side continues as a cylinder.
///
///   a'(s) = 2 pi (R - s) up to s = R                                (theory.md, Eq. 3; report, section 2.1)

#include <array>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Sphere {
  double radius = 0;  ///< R, m, > 0

  static constexpr const char* name = "sphere";
  static const std::array<Parameter<Sphere>, 1> parameters;

  [[nodiscard]] Sections sections() const { return {.tip = 0, .width = radius, .taper = 1, .depth = radius}; }
};

inline constexpr std::array<Parameter<Sphere>, 1> Sphere::parameters{{
    {"radius", "R", "m", &Sphere::radius, positive, "radius of the sphere"},
}};

}  // namespace dashpad
