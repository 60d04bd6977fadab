#pragma once
/// Layers below a flat face, for the general oracle: springs, dashpots and foams in series, written anew from
/// theory.md, Eqs. 71 to 73.
///
///   sum L_i e_i(stress) = y,  stress_i(e_i) = stress
///
/// by secants, inside and outside, from the last strains on: on the way back there may be several. What is
/// remembered is the strain of each layer that has slipped.

#include <memory>

#include "oracle/pads.hpp"

namespace dashpad::oracle {

/// Throws std::invalid_argument for a nose with a side.
std::unique_ptr<PadModel> layer_pad(const Pad& pad, Outline nose, int fineness);

}  // namespace dashpad::oracle
