#pragma once
/// The layers of a case as a contact takes them.

#include "dashpad/impact/impact_case.hpp"
#include "model/contact/layered_contact.hpp"
#include "model/pad/layer/layer_law.hpp"

namespace dashpad {

/// The layers must be sound.
inline LayeredContact::Parts layers_of(const Pad& pad) {
  LayeredContact::Parts parts;
  for (const PadLayer& layer : pad.layers)
    parts.push_back({layer.thickness, layer_law(layer.material.law).value(),
                     stress_factor(layer.condition, layer.material)});
  return parts;
}

}  // namespace dashpad
