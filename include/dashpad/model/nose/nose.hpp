#pragma once
/// The closed set of noses. A nose is rigid and acts on the pad by its sections only.
///
/// A shape is a struct with its numbers, a parameter table, its name in case files, and sections(). A new
/// shape needs its own file, one entry in `Nose`, and what docs/extending.md lists.

#include <algorithm>
#include <string>
#include <variant>

#include "dashpad/model/nose/cone.hpp"
#include "dashpad/model/nose/cylinder.hpp"
#include "dashpad/model/nose/ellipsoid.hpp"
#include "dashpad/model/nose/flat_disc.hpp"
#include "dashpad/model/nose/platen.hpp"
#include "dashpad/model/nose/profile.hpp"
#include "dashpad/model/nose/rod.hpp"
#include "dashpad/model/nose/sphere.hpp"
#include "dashpad/quantities/constants.hpp"

namespace dashpad {

using Nose = std::variant<Sphere, FlatDisc, Cone, Ellipsoid, Rod, Platen, Cylinder, Profile>;

inline Sections sections_of(const Nose& nose) {
  return std::visit([](const auto& shape) { return shape.sections(); }, nose);
}

/// The shape's name in case files: `flat-disc`.
inline std::string name_of(const Nose& nose) {
  return std::visit([](const auto& shape) { return std::string(shape.name); }, nose);
}

/// The shape's name in a sentence: "flat disc".
inline std::string words_of(const Nose& nose) {
  std::string words = name_of(nose);
  std::ranges::replace(words, '-', ' ');
  return words;
}

/// Radius R of a sphere, m; NaN for any other shape. Standards need it: their headforms are spheres.
inline double sphere_radius(const Nose& nose) {
  const auto* sphere = std::get_if<Sphere>(&nose);
  return sphere == nullptr ? no_value : sphere->radius;
}

}  // namespace dashpad
