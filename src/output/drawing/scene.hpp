#pragma once
/// The numbers and the layout that the parts of one drawing share.

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/model/nose/nose.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// Sizes of the drawing's texts, px: pages from 390 px on show them at 12 px and more.
inline constexpr double text_size = 15;
inline constexpr double small_text_size = 14;
inline constexpr double heading_size = 15;

/// Width of the viewBox, px.
inline constexpr double drawing_width = 736;
/// The room for dimensions beside a picture, px.
inline constexpr double beside_picture = 120;
/// Upper edge of both pictures, below their headings and what is written beside the arrow.
inline constexpr double picture_top = 70;

/// A placeholder for the name of the drawing in its ids; no readable text contains it.
inline constexpr std::string_view own_name = "\x01";

/// Sections of the round nose with the same outline in side view: their radius is half the width at a depth,
/// m. An ellipsoid is seen across its half length, a platen across its length, a cylinder along its axis.
Sections outline_of(const Nose& nose);
/// Whether it is narrower again behind its widest section, rather than going on along the motion.
bool is_ball(const Nose& nose);
/// Half the width in that view of a pad with this face, m2: it has the outline of the nose (theory.md, 1).
double half_width_of_face(const Nose& nose, double area);

/// A layer of the pad; a pad of one foam has one.
struct DrawnLayer {
  std::string name;
  double thickness = 0;               ///< m
  double strain = 0;                  ///< strain on the axis at greatest penetration, 0 to 1
  std::optional<double> tested = {};  ///< strain up to which its foam was tested or fitted
  bool has_curves = false;            ///< made of the curves of tests, rather than of numbers fitted to them
  bool struck_through = false;
};

/// The pad at first contact and at greatest penetration. SI.
struct DrawnMoments {
  std::vector<DrawnLayer> layers;    ///< beginning at the struck face
  double thickness = 0;              ///< thickness of the pad, m
  double crater = 0;                 ///< penetration at first contact, left by earlier blows, m
  double penetration = 0;            ///< greatest, m, at most the thickness
  double deflection = 0;             ///< deflection of the support at greatest penetration, m
  double body_motion = 0;            ///< displacement of a free body behind the support then, m
  std::optional<double> time;        ///< time of greatest penetration, s; absent without a history
  std::optional<double> half_width;  ///< half width of the pad's face, m; absent for an unbounded pad
  bool struck_through = false;       ///< is_struck_through()
  bool is_so_far = false;            ///< the run ends there, before the impact has turned
  bool bottomed = false;             ///< the pad is fully compressed on a rigid support

  /// The thickness that is left of the pad on the axis, m.
  [[nodiscard]] double left() const { return thickness - penetration; }
  /// The displacement of the back of the pad, m.
  [[nodiscard]] double sink() const { return deflection + body_motion; }
};

/// Heights of the symbols below the pad, from its back down, px. Only gap and travel are to scale.
struct SupportHeights {
  double plate = 0;   ///< height of a panel
  double gap = 0;     ///< to scale unless that is too small to be seen or too large for the picture
  double spring = 0;  ///< at rest; 0 where the support is rigid
  double base = 0;    ///< height of the ground or of a free body
};

/// The layout of the drawing, in px of its viewBox; y points down.
struct Layout {
  double scale = 0;           ///< px/m, the same across and along the motion
  double half_width = 0;      ///< half the width of each picture
  double left = 0;            ///< axis of the picture of first contact
  double right = 0;           ///< axis of that of greatest penetration
  double captions_width = 0;  ///< width of what is written below the left picture
  double left_end = 0;        ///< right end of the left picture with all texts beside and below it
  double right_begin = 0;     ///< left end of the right picture with the texts beside it
  double face = 0;            ///< y of the new pad's face at first contact
  double pad = 0;             ///< height of the new pad
  bool pad_is_cut = false;    ///< a stretch in the middle of the pad is left out
  double deflection = 0;      ///< deflection of the support
  double body_motion = 0;
  bool sink_is_cut = false;  ///< deflection and body motion are drawn shorter than they are
  SupportHeights support;
  double bottom = 0;  ///< lower edge of both pictures

  /// The drawn depth below the face of the new pad, px, for a depth in a pad of that thickness, m.
  [[nodiscard]] double below_face(double depth, double thickness) const;
  /// Half the width of the pad in m to px; more than the picture where it goes on.
  [[nodiscard]] double pad_half_width(const DrawnMoments& moments) const;
};

/// The picture of first contact or that of greatest penetration.
struct Picture {
  std::string name;        ///< "left": first contact; "right": greatest penetration
  double axis = 0;         ///< x, px
  double penetration = 0;  ///< m
  double deflection = 0;   ///< px
  double body_motion = 0;  ///< px

  /// The displacement of the back of the pad, px.
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

  Scene(const ImpactCase& impact_case, const Solution& solution, const UnitSystem& shown_units);

  /// y of the pad's back at first contact.
  [[nodiscard]] double back() const { return layout.face + layout.pad; }
  [[nodiscard]] double face(const Picture& picture) const { return layout.face + picture.sink(); }
  [[nodiscard]] double tip(const Picture& picture) const {
    return face(picture) + picture.penetration * layout.scale;
  }
  /// Half the width of the pad that is seen, px.
  [[nodiscard]] double pad_half_width() const;
  /// y of the front of a layer of the new pad below its face, px; of the number of layers: of the back.
  [[nodiscard]] double front_of_layer(std::size_t layer) const;
  /// An SI value as it is written, to three digits.
  [[nodiscard]] std::string shown(double value, const char* si_unit) const;
};

}  // namespace dashpad::output
