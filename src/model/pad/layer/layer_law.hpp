#pragma once
/// The laws that a layer may have: their stress rises with the strain and determines it (theory.md, Eq. 52).

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {

inline constexpr std::size_t max_layers = 8;

using LayerLaw = std::variant<Elastic, LinearViscoelastic, Foam, CrushableFoam>;

/// The law as one of a layer; nothing if layers do not admit it.
std::optional<LayerLaw> layer_law(const PadLaw& law);

/// The rule that a sound law breaks as a layer, at most one; its key is `law`, `rate` or `unloading`.
std::vector<Violation> violations_as_layer(const PadLaw& law);

}  // namespace dashpad
