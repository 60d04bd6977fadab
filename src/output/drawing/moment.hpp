#pragma once
/// What the drawing shows, in numbers: the pad at first contact and at greatest penetration. SI.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::output {

/// A layer of the pad; a pad of one foam has one.
struct DrawnLayer {
  std::string name;
  double thickness = 0;               ///< m
  double strain = 0;                  ///< on the axis at greatest penetration, 0 to 1
  std::optional<double> tested = {};  ///< strain up to which its foam was tested or fitted
  bool has_curves = false;            ///< of its tests, rather than numbers fitted to them
  bool struck_through = false;
};

struct DrawnMoments {
  std::vector<DrawnLayer> layers;    ///< from the struck face on
  double thickness = 0;              ///< of the pad, m
  double crater = 0;                 ///< penetration at first contact, left by earlier blows, m
  double penetration = 0;            ///< greatest, m, at most the thickness
  double deflection = 0;             ///< of the support then, m
  double body_motion = 0;            ///< of a free body behind the support then, m
  std::optional<double> time;        ///< of greatest penetration, s; absent without a history
  std::optional<double> half_width;  ///< of the pad's face, m; absent where it goes on to all sides
  bool struck_through = false;       ///< is_struck_through()
  bool is_so_far = false;            ///< the run ends there, before the impact has turned
  bool bottomed = false;             ///< nothing is left of it, and its support is rigid

  /// Of the pad on the axis, m.
  [[nodiscard]] double left() const { return thickness - penetration; }
  /// How far the back of the pad has gone, m.
  [[nodiscard]] double sink() const { return deflection + body_motion; }
};

DrawnMoments drawn_moments(const ImpactCase& impact, const Solution& solution);

}  // namespace dashpad::output
