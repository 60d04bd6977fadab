#pragma once
/// Layers in the general oracle: columns (layer_column.hpp) of which the nose presses each as deep as it is
/// there.

#include <memory>

#include "oracle/pads.hpp"

namespace dashpad::oracle {

/// `deepest`: a penetration that is not exceeded, m.
std::unique_ptr<PadModel> layer_pad(const Pad& pad, Outline nose, int fineness, double deepest);

}  // namespace dashpad::oracle
