#pragma once
/// A nose by points: radius or area of its section over the depth behind its tip, as those of a headform.
/// Beyond the last point its side goes on along the motion.
///
///   between two points the radius, or else the area, is a straight line of the depth   (theory.md, Eq. 3)

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

  double scale = 1;  ///< by what depths and radii are multiplied, areas by its square; 0.001 to 1000
  Of of = Of::radius;
  std::vector<Point> points = {};  ///< 2 to most_points

  static constexpr const char* name = "profile";
  static constexpr std::size_t most_points = 10'000;
  static const std::array<Parameter<Profile>, 1> parameters;

  [[nodiscard]] Sections sections() const;

  /// Of a point as it stands after scaling, m or m2.
  [[nodiscard]] double scaled_size(const Point& point) const {
    return point.size * (of == Of::radius ? scale : scale * scale);
  }

  /// A rule that a point breaks, by its place in the list.
  struct Fault {
    std::size_t point = 0;
    std::string rule;
  };
  /// Of the points among themselves, one a point at most.
  [[nodiscard]] std::vector<Fault> faults() const;
};

inline constexpr std::array<Parameter<Profile>, 1> Profile::parameters{{
    {"scale", "k", "1", &Profile::scale, from_to(1e-3, 1e3),
     "by what the lengths of the profile are multiplied", LeftOut::as_default},
}};

}  // namespace dashpad
