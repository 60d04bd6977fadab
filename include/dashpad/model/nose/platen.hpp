#pragma once
/// A rectangular plate or side of a box, square to the pad: all of it meets the pad at once, with one strain.
///
///   a(s) = l b for s > 0                                                              (theory.md, Eq. 3)

#include <array>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Platen {
  double length = 0;  ///< l, m, > 0
  double width = 0;   ///< b, m, > 0

  static constexpr const char* name = "platen";
  static const std::array<Parameter<Platen>, 2> parameters;

  [[nodiscard]] Sections sections() const {
    return {.tip = length * width, .width = 0, .taper = 0, .depth = 0};
  }
};

inline constexpr std::array<Parameter<Platen>, 2> Platen::parameters{{
    {"length", "l", "m", &Platen::length, positive, "length of the plate"},
    {"width", "b", "m", &Platen::width, positive, "width of the plate"},
}};

}  // namespace dashpad
