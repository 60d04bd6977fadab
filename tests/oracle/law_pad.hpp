#pragma once
/// Laws 4 and 5 in the general oracle: columns that follow the rate form of law_formulas.hpp, at fixed shares
/// of the contact until the pad turns (law_loading.hpp) and at fixed depths from there on
/// (law_unloading.hpp).

#include <memory>

#include "oracle/pads.hpp"

namespace dashpad::oracle {

/// `deepest`: a penetration that is not exceeded, m.
std::unique_ptr<PadModel> law_pad(const NineParameter& law, Outline nose, double thickness, int fineness,
                                  double deepest);
std::unique_ptr<PadModel> law_pad(const TwentyOneParameter& law, Outline nose, double thickness, int fineness,
                                  double deepest);

}  // namespace dashpad::oracle
