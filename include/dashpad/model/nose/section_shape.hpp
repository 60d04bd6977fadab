#pragma once
/// The sections of a nose whose area over the depth is not one quadratic function: a cylinder on its side, a
/// profile by points.
///
/// Depths in m behind the tip, from 0 to the depth up to which the shape grows wider; areas in m2.

#include <vector>

namespace dashpad {

/// A stretch of depth over which the area of the section is a quadratic function of it.
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

  /// a(s), with that of a flat tip.
  [[nodiscard]] virtual double area(double s) const = 0;
  /// Integral of a from 0 to s, m3.
  [[nodiscard]] virtual double volume(double s) const = 0;
  /// Integral of volume() from 0 to s, m4.
  [[nodiscard]] virtual double volume_integral(double s) const = 0;
  /// a'(s) / (2 pi), m, for s > 0; where it jumps, that before the jump.
  [[nodiscard]] virtual double rate(double s) const = 0;
  /// The least depth at which an area between that of the tip and the widest is reached, m.
  [[nodiscard]] virtual double depth_at(double area) const = 0;

  /// Whether a' grows without bound towards the tip.
  [[nodiscard]] virtual bool is_steep_at_tip() const { return false; }
  /// Depths, increasing, at which a' jumps by much.
  [[nodiscard]] virtual const std::vector<double>& knots() const {
    static const std::vector<double> none;
    return none;
  }
  /// Quadratic pieces one behind the other from the tip to the widest section. Where the area is no such
  /// function itself they have its values at their ends and its volume, and a piece ends at exp(grading)
  /// times the depth at which it begins.
  [[nodiscard]] virtual std::vector<SectionPiece> pieces(double grading) const = 0;
};

}  // namespace dashpad
