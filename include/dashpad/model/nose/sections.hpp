#pragma once
/// A nose as the pad meets it: the area of its section over the depth behind its tip.
///
///   a(s) = a0 + 2 pi (w s - t s^2 / 2) for 0 < s <= d,   a(d) beyond          (theory.md, Eq. 3)
///
/// A SectionShape may replace this function up to d. Since columns of the pad do not act on each other,
/// nothing else of a nose enters the contact force: the columns that it meets between the depths s and s + ds
/// have the area a'(s) ds. Areas in m2, lengths in m.

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <vector>

namespace dashpad {

// Noses whose area is not one quadratic function of the depth: a cylinder on its side, a profile by points.
//
// Depths are counted from the tip, m, up to the widest section; areas in m2.

/// A range of depths, m, over which the area of the section is a quadratic function of the depth.
struct SectionPiece {
  double from = 0;
  double to = 0;
  double width = 0;  ///< a'(s) / (2 pi) = width - taper s, m; at least 0
  double taper = 0;

  [[nodiscard]] double rate(double s) const {
    const double value = width - taper * s;
    return value > 0 ? value : 0;
  }
};

class SectionShape {
 public:
  virtual ~SectionShape() = default;

  /// a(s), m2, including the area of a flat tip.
  [[nodiscard]] virtual double area(double s) const = 0;
  /// Integral of a from 0 to s, m3.
  [[nodiscard]] virtual double volume(double s) const = 0;
  /// Integral of volume() from 0 to s, m4.
  [[nodiscard]] virtual double volume_integral(double s) const = 0;
  /// a'(s) / (2 pi), m, for s > 0; at a jump the value before it.
  [[nodiscard]] virtual double rate(double s) const = 0;
  /// The smallest depth at which the section has `area`, m, which lies between those of the tip and the end.
  [[nodiscard]] virtual double depth_at(double area) const = 0;

  /// Whether a' grows without bound towards the tip.
  [[nodiscard]] virtual bool is_steep_at_tip() const { return false; }
  /// Depths at which a' jumps considerably, m, increasing.
  [[nodiscard]] virtual const std::vector<double>& knots() const {
    static const std::vector<double> none;
    return none;
  }
  /// Consecutive quadratic pieces from the tip to the widest section. Where the area is no quadratic function
  /// itself, they match its values at their ends and its volume, and each piece ends at exp(grading) times
  /// the depth at which it begins.
  [[nodiscard]] virtual std::vector<SectionPiece> pieces(double grading) const = 0;
};

struct Sections {
  double tip = 0;    ///< a0, area of the flat tip that meets the pad first, m2, >= 0
  double width = 0;  ///< w = a'(0+) / (2 pi), m, >= 0
  double taper = 0;  ///< t, fall of a' / (2 pi) with the depth, < 0 for a cone; w - t d >= 0
  double depth = 0;  ///< d, depth from which on the section is constant, m, >= 0
  /// Replaces w and t if set; at least as deep as d.
  std::shared_ptr<const SectionShape> shape = {};

  /// a'(s) / (2 pi), m; 0 beyond the depth d, where it may jump.
  [[nodiscard]] double rate(double s) const {
    if (shape) [[unlikely]]
      return s <= depth ? shape->rate(s) : 0;
    return s <= depth ? std::max(width - taper * s, 0.0) : 0;
  }
  /// Weights a' / (2 pi) at both ends of a range of depths up to d, m; of a shape the mean over the range.
  struct Weights {
    double inner = 0;  ///< at the end closer to the tip
    double outer = 0;
  };
  [[nodiscard]] Weights weights(double from, double to) const {
    if (!shape) [[likely]]
      return {rate(from), rate(to)};
    const double rise = shape->area(to) - shape->area(from);
    const double mean = to > from ? rise / (2 * std::numbers::pi * (to - from)) : shape->rate(to);
    return {std::max(mean, 0.0), std::max(mean, 0.0)};
  }

  /// Projected area a(y) of the contact at the penetration y, m2; at y = 0 that of the tip.
  [[nodiscard]] double area(double y) const {
    const double c = std::clamp(y, 0.0, depth);
    if (shape) [[unlikely]]
      return y >= 0 ? shape->area(c) : 0;
    return (y >= 0 ? tip : 0) + 2 * std::numbers::pi * c * (width - taper * c / 2);
  }
  /// Integral of a from 0 to y, m3.
  [[nodiscard]] double volume(double y) const {
    const double c = std::clamp(y, 0.0, depth);
    const double beyond = std::max(y - depth, 0.0);
    if (shape) [[unlikely]]
      return shape->volume(c) + shape->area(depth) * beyond;
    return tip * c + 2 * std::numbers::pi * c * c * (width / 2 - taper * c / 6) + area_beyond() * beyond;
  }
  /// n-fold integral of a from 0 to y, m^(2+n), n >= 1; of a shape n <= 2.
  [[nodiscard]] double integral(double y, int n) const {
    if (!(y > 0)) return 0;
    const double beyond = std::max(y - depth, 0.0);
    if (shape) [[unlikely]]
      return n == 1 ? volume(y)
                    : shape->volume_integral(std::min(y, depth)) +
                          (shape->volume(depth) + shape->area(depth) * beyond / 2) * beyond;
    double sum = integral_within(std::min(y, depth), n);
    // Beyond d the integral is a polynomial: its Taylor series about d, with the area as highest derivative.
    double power = 1;
    for (int k = 1; beyond > 0 && k <= n; ++k)
      sum += (power *= beyond / k) * (k == n ? area_beyond() : integral_within(depth, n - k));
    return sum;
  }

  /// Radius of the circle that has the area of the section at a depth s >= 0, m.
  [[nodiscard]] double radius(double s) const {
    if (shape) [[unlikely]]
      return std::sqrt(area(s) * std::numbers::inv_pi);
    const double c = std::clamp(s, 0.0, depth);
    return std::sqrt(tip * std::numbers::inv_pi + c * (2 * width - taper * c));
  }
  /// The smallest depth at which radius() has that value, m; d if it never does.
  [[nodiscard]] double depth_at(double radius) const {
    const double ring = radius * radius - tip * std::numbers::inv_pi;
    if (ring <= 0) return 0;
    if (shape) [[unlikely]] {
      const double area = std::numbers::pi * radius * radius;
      return area < shape->area(depth) ? shape->depth_at(area) : depth;
    }
    const double root = width + std::sqrt(std::max(width * width - taper * ring, 0.0));
    return root > 0 ? std::min(ring / root, depth) : depth;
  }

  /// The nose on a pad with a face of that area, m2: wider parts of it meet no pad.
  [[nodiscard]] Sections limited_to(double face) const {
    if (face >= area_beyond()) return *this;
    if (face <= tip) return {.tip = face, .width = 0, .taper = 0, .depth = 0};
    return {.tip = tip,
            .width = width,
            .taper = taper,
            .depth = depth_at(std::sqrt(face * std::numbers::inv_pi)),
            .shape = shape};
  }

  /// Area from the depth d on, m2.
  [[nodiscard]] double area_beyond() const {
    if (shape) [[unlikely]]
      return shape->area(depth);
    return tip + 2 * std::numbers::pi * depth * (width - taper * depth / 2);
  }

 private:
  [[nodiscard]] double integral_within(double y, int n) const {
    double power = 1;
    for (int k = 1; k <= n; ++k) power *= y / k;
    const double rise = y / (n + 1), bend = rise * y / (n + 2);
    return power * (tip + 2 * std::numbers::pi * (width * rise - taper * bend));
  }
};

}  // namespace dashpad
