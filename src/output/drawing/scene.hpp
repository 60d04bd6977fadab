#pragma once
/// All that the parts of one drawing share.

#include <algorithm>
#include <string>

#include "dashpad/quantities/unit_system.hpp"
#include "output/drawing/layout.hpp"
#include "output/drawing/moment.hpp"
#include "output/drawing/nose_outline.hpp"

namespace dashpad::output {

/// One of the two pictures.
struct Picture {
  std::string name;        ///< "left": first contact; "right": greatest penetration
  double axis = 0;         ///< x, px
  double penetration = 0;  ///< m
  double deflection = 0;   ///< px
  double body_motion = 0;  ///< px

  /// How far the back of the pad has gone, px.
  [[nodiscard]] double sink() const { return deflection + body_motion; }
};

struct Scene {
  const ImpactCase& impact;
  const Summary& summary;
  const UnitSystem& units;
  Sections outline;
  DrawnMoments moments;
  Layout layout;
  Picture left, right;

  Scene(const ImpactCase& of, const Solution& solution, const UnitSystem& shown)
      : impact(of),
        summary(solution.summary),
        units(shown),
        outline(outline_of(of.impactor.nose)),
        moments(drawn_moments(of, solution)),
        layout(layout_of(of, moments)),
        left{.name = "left", .axis = layout.left, .penetration = moments.crater},
        right{.name = "right",
              .axis = layout.right,
              .penetration = moments.penetration,
              .deflection = layout.deflection,
              .body_motion = layout.body_motion} {}

  /// y of the pad's back at first contact.
  [[nodiscard]] double back() const { return layout.face + layout.pad; }
  [[nodiscard]] double face(const Picture& picture) const { return layout.face + picture.sink(); }
  [[nodiscard]] double tip(const Picture& picture) const {
    return face(picture) + picture.penetration * layout.scale;
  }
  /// Half the width of the pad that is seen, px.
  [[nodiscard]] double pad_half_width() const {
    return std::min(layout.pad_half_width(moments), layout.half_width);
  }
  /// y of the front of a layer of the new pad below its face, px; of the number of layers: of the back.
  [[nodiscard]] double front_of_layer(std::size_t layer) const {
    double depth = 0;
    for (std::size_t i = 0; i < layer; ++i) depth += moments.layers[i].thickness;
    return layout.below_face(depth, moments.thickness);
  }
};

}  // namespace dashpad::output
