#pragma once
/// The laws that a layer of a pad may have: those whose stress rises with the strain at every rate, so that a
/// stress tells the strain of each layer (theory.md, Eq. 52).

#include <cstddef>
#include <optional>
#include <variant>
#include <vector>

#include "dashpad/model/pad/law.hpp"

namespace dashpad {

inline constexpr std::size_t most_layers = 8;

using LayerLaw = std::variant<Elastic, LinearViscoelastic, Foam, CrushableFoam>;

/// Nothing for a law that layers do not admit.
std::optional<LayerLaw> layer_law(const PadLaw& law);

/// The rule that a sound law breaks as a layer, at most one: its key is `law`, or that of a curve that falls.
std::vector<Violation> violations_as_layer(const PadLaw& law);

}  // namespace dashpad
