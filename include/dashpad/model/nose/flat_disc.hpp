#pragma once
/// The flat end of a round body, square to the pad: all of it meets the pad at once, with one strain.
///
///   a(s) = pi R^2 for s > 0                                                           (theory.md, Eq. 3)

#include <array>
#include <numbers>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct FlatDisc {
  double radius = 0;  ///< R, m, > 0

  static constexpr const char* name = "flat-disc";
  static const std::array<Parameter<FlatDisc>, 1> parameters;

  [[nodiscard]] Sections sections() const {
    return {.tip = std::numbers::pi * radius * radius, .width = 0, .taper = 0, .depth = 0};
  }
};

inline constexpr std::array<Parameter<FlatDisc>, 1> FlatDisc::parameters{{
    {"radius", "R", "m", &FlatDisc::radius, positive, "radius of the disc"},
}};

}  // namespace dashpad
