#pragma once
/// A round rod that meets the pad end on; the end is a dome, the cap of a sphere.
///
///   a'(s) = 2 pi (R - s) up to s = R - sqrt(R^2 - r^2)                                (theory.md, Eq. 3)
///
/// R is the radius of the dome, r that of the rod. With equal radii it is the nose `sphere`.

#include <array>
#include <cmath>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Rod {
  double radius = 0;      ///< r, m, > 0
  double tip_radius = 0;  ///< R, m, >= r

  static constexpr const char* name = "rod";
  static const std::array<Parameter<Rod>, 2> parameters;

  [[nodiscard]] Sections sections() const {
    // R - root, written so that a flat dome causes no cancellation.
    const double root = std::sqrt((tip_radius - radius) * (tip_radius + radius));
    return {.tip = 0, .width = tip_radius, .taper = 1, .depth = radius * (radius / (tip_radius + root))};
  }
};

inline constexpr std::array<Parameter<Rod>, 2> Rod::parameters{{
    {"radius", "r", "m", &Rod::radius, positive, "radius of the rod"},
    {"tip_radius", "R", "m", &Rod::tip_radius, positive, "radius of the domed end"},
}};

}  // namespace dashpad
