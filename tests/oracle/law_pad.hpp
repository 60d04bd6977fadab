#pragma once
/// Laws 4 and 5 in the general oracle, where the support tells how fast the pad is pressed: rigid, damped or
/// with a panel. Columns at fixed depths follow the rate form of law_formulas.hpp.

#include <memory>

#include "oracle/pads.hpp"

namespace dashpad::oracle {

/// `deepest`: a penetration that is not exceeded, m.
std::unique_ptr<PadModel> law_pad(const NineParameter& law, Outline nose, double thickness, int fineness,
                                  double deepest);
std::unique_ptr<PadModel> law_pad(const TwentyOneParameter& law, Outline nose, double thickness, int fineness,
                                  double deepest);

}  // namespace dashpad::oracle
