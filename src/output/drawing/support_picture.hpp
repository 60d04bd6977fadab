#pragma once
/// What the pad stands on, by symbols: panel, gap, springs, damper, ground or a free body.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "output/drawing/layout.hpp"

namespace dashpad::output {

/// One of the two pictures of the support.
struct SupportView {
  double axis = 0;        ///< x, px
  double back = 0;        ///< y of the pad's back at first contact, px
  double half_width = 0;  ///< of pad and picture, the smaller, px
  double ground_half_width = 0;
  double deflection = 0;   ///< px
  double body_motion = 0;  ///< px
  std::string mass;        ///< of a free body, as it is shown
};

std::string support_picture(const ImpactCase& impact, const SupportHeights& heights, const SupportView& view);

/// "a spring of 100 N/mm, which crushes, a panel of 1.2 kg": what stands there, in words.
std::string support_words(const ImpactCase& impact, const UnitSystem& units);

}  // namespace dashpad::output
