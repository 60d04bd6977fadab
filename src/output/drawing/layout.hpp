#pragma once
/// Where things of the drawing lie, in px of its viewBox; y points down.

#include "dashpad/impact/impact_case.hpp"
#include "output/drawing/moment.hpp"

namespace dashpad::output {

/// Width of the viewBox.
inline constexpr double drawing_width = 736;
/// Of dimensions beside a picture.
inline constexpr double beside_picture = 120;
/// Upper edge of both pictures, below their headings and what is written beside the arrow.
inline constexpr double picture_top = 70;

/// What stands below the pad, from its back down; heights of symbols but for gap and travel.
struct SupportHeights {
  double plate = 0;   ///< of a panel
  double gap = 0;     ///< to scale, unless it is too small to be seen or too large for the picture
  double spring = 0;  ///< at rest; 0 where the support is rigid
  double base = 0;    ///< of the ground or of a free body
};

struct Layout {
  double scale = 0;           ///< px/m, the same across and along the motion
  double half_width = 0;      ///< of either picture
  double left = 0;            ///< axis of the picture of first contact
  double right = 0;           ///< axis of that of greatest penetration
  double captions_width = 0;  ///< width of what is written below the left picture
  double left_end = 0;        ///< where the left picture and all that is written beside and below it end
  double right_begin = 0;     ///< where the right picture and what is written beside it begin
  double face = 0;            ///< y of the new pad's face at first contact
  double pad = 0;             ///< height of the new pad
  bool pad_is_cut = false;    ///< a stretch in the middle of the pad is left out
  double deflection = 0;      ///< of the support
  double body_motion = 0;
  bool sink_is_cut = false;  ///< those two are drawn shorter than they are
  SupportHeights support;
  double bottom = 0;  ///< of both pictures

  [[nodiscard]] double sink() const { return deflection + body_motion; }
  /// How far below the new pad's face a depth in the pad is drawn, of `thickness`; both depths in m.
  [[nodiscard]] double below_face(double depth, double thickness) const;
  /// Half the width of the pad in m to px; more than the picture where it goes on.
  [[nodiscard]] double pad_half_width(const DrawnMoments& moments) const;
};

Layout layout_of(const ImpactCase& impact, const DrawnMoments& moments);

}  // namespace dashpad::output
