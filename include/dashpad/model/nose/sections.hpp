#pragma once
/// A nose as the pad meets it: the area of its section over the depth behind its tip.
///
///   a(s) = a0 + 2 pi (w s - t s^2 / 2) for 0 < s <= d,   a(d) beyond          (theory.md, Eq. 3)
///
/// Columns of the pad do not act on each other, so that a nose enters the contact force by nothing else: the
/// columns that it meets between the depths s and s + ds have the area a'(s) ds. Areas in m2, lengths in m.

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dashpad {

struct Sections {
  double tip = 0;    ///< a0, m2: of the flat part that meets the pad first, >= 0
  double width = 0;  ///< w, m: the rate a'(0+) / (2 pi), >= 0
  double taper = 0;  ///< t: how fast that rate falls with the depth, < 0 for a cone; w - t d >= 0
  double depth = 0;  ///< d, m: from here on the section stays as it is, >= 0

  /// a'(s) / (2 pi), m; 0 beyond the depth d, where it may jump.
  [[nodiscard]] double rate(double s) const { return s <= depth ? std::max(width - taper * s, 0.0) : 0; }

  /// Projected area of the contact at the penetration y, a(y); at y = 0 that of the tip, which is all there.
  [[nodiscard]] double area(double y) const {
    const double c = std::clamp(y, 0.0, depth);
    return (y >= 0 ? tip : 0) + 2 * std::numbers::pi * c * (width - taper * c / 2);
  }
  /// Integral of a from 0 to y, m3.
  [[nodiscard]] double volume(double y) const {
    const double c = std::clamp(y, 0.0, depth);
    const double beyond = std::max(y - depth, 0.0);
    return tip * c + 2 * std::numbers::pi * c * c * (width / 2 - taper * c / 6) + area_beyond() * beyond;
  }
  /// Integral of volume() from 0 to y, m4.
  [[nodiscard]] double volume_integral(double y) const {
    const double c = std::clamp(y, 0.0, depth);
    const double beyond = std::max(y - depth, 0.0);
    return tip * c * c / 2 + 2 * std::numbers::pi * c * c * c * (width / 6 - taper * c / 24) +
           (volume(depth) + area_beyond() * beyond / 2) * beyond;
  }

  /// Radius of the circle that has the area of the section at a depth s >= 0, m.
  [[nodiscard]] double radius(double s) const {
    const double c = std::clamp(s, 0.0, depth);
    return std::sqrt(tip * std::numbers::inv_pi + c * (2 * width - taper * c));
  }
  /// The least depth at which that radius is reached; d for a radius that is not.
  [[nodiscard]] double depth_at(double radius) const {
    const double ring = radius * radius - tip * std::numbers::inv_pi;
    if (ring <= 0) return 0;
    const double root = width + std::sqrt(std::max(width * width - taper * ring, 0.0));
    return root > 0 ? std::min(ring / root, depth) : depth;
  }

  /// The nose on a pad whose face has that area, m2: what is wider meets no pad.
  [[nodiscard]] Sections limited_to(double face) const {
    if (face >= area_beyond()) return *this;
    if (face <= tip) return {.tip = face, .width = 0, .taper = 0, .depth = 0};
    return {.tip = tip,
            .width = width,
            .taper = taper,
            .depth = depth_at(std::sqrt(face * std::numbers::inv_pi))};
  }

  /// Area from the depth d on, m2.
  [[nodiscard]] double area_beyond() const {
    return tip + 2 * std::numbers::pi * depth * (width - taper * depth / 2);
  }
};

}  // namespace dashpad
