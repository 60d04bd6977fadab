#pragma once
/// Random valid impacts over everything that a case may hold, in the ranges of practice.

#include <cstdint>

#include "dashpad/impact/impact_case.hpp"

namespace dashpad::test {

/// 0.2 to 20 kg at 0.5 to 12 m/s on 5 to 150 mm of a material card (one in three), a foam by curves,
/// crushable foam, slow foam or a law of the report, or on two or three layers (one in eight); below a nose
/// of any shape, on a support of any kind: rigid, linear, by a curve, with crushing, a damper, a panel's
/// mass, a gap, a preload, a free body. Some under gravity, below a sheet, on a block smaller than the nose,
/// or struck two to four times. The speed suits a strain of 0.1 to 1.1, so that some pads are hardly pressed
/// and some close. One seed, one case, on every platform.
ImpactCase case_of_practice(std::uint64_t seed);

}  // namespace dashpad::test
