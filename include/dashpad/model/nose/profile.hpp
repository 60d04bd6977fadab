#pragma once
/// A nose given by points, such as a headform: radius or area of its section over the depth behind its tip.
/// Beyond the last point its side continues along the motion.
///
///   between two points the radius or the area is linear in the depth            (theory.md, Eq. 3)

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/parameter.hpp"

namespace dashpad {

struct Profile {
  enum class Of { radius, area };
  struct Point {
    double depth = 0;  ///< m; 0 first, then increasing
    double size = 0;   ///< radius, m, or area, m2; 0 or more at the tip, more behind it, not falling
    friend bool operator==(const Point&, const Point&) = default;
  };

  double scale = 1;  ///< factor of depths and radii, squared for areas; 0.001 to 1000
  Of of = Of::radius;
  std::vector<Point> points = {};  ///< 2 to max_points

  static constexpr const char* name = "profile";
  static constexpr std::size_t max_points = 10'000;
  static const std::array<Parameter<Profile>, 1> parameters;

  [[nodiscard]] Sections sections() const;

  /// Radius or area of a point after scaling, m or m2.
  [[nodiscard]] double scaled_size(const Point& point) const {
    return point.size * (of == Of::radius ? scale : scale * scale);
  }

  /// A rule that a point breaks.
  struct Fault {
    std::size_t point = 0;
    std::string rule;
  };
  /// Rules that the points break among themselves, at most one for each point.
  [[nodiscard]] std::vector<Fault> faults() const;
};

inline constexpr std::array<Parameter<Profile>, 1> Profile::parameters{{
    {"scale", "k", "1", &Profile::scale, from_to(1e-3, 1e3), "factor applied to the lengths of the profile",
     LeftOut::as_default},
}};

}  // namespace dashpad
