#pragma once
/// The pad under the nose: columns shaded by strain, layers by their hatching.

#include <string>

#include "dashpad/model/nose/sections.hpp"
#include "output/drawing/layout.hpp"
#include "output/drawing/moment.hpp"

namespace dashpad::output {

/// One of the two pictures of the pad.
struct PadView {
  std::string name;        ///< of its ids: "left", "right"
  double axis = 0;         ///< x, px
  double face = 0;         ///< y of the new pad's face, px
  double penetration = 0;  ///< m
};

/// What the nose, drawn over it, leaves to be seen. Of a pad of layers only the axis is computed: away from
/// it each layer's strain is taken to fall as the shortening of the whole column, which keeps their sum.
std::string pad_picture(const DrawnMoments& moments, const Layout& layout, const Sections& outline,
                        const PadView& view);

/// The `<pattern>`s by which layers are told apart; none for a pad of one foam.
std::string hatchings(const DrawnMoments& moments);

}  // namespace dashpad::output
