#pragma once
/// The support of the pad: its force over its deflection, as long as that grows.
///
///   F = Fs(Xs), piecewise linear through the origin and any number of points, increasing; beyond the last
///   point the last slope goes on; below the origin the force is 0          (theory.md, Eq. 4; report, Eq. 6)
///
/// F and Xs are positive in compression. A rigid support deflects by nothing under any force. What it may
/// have beside this curve, mass and losses among it, is its Backing.

#include <vector>

namespace dashpad {

class Support {
 public:
  struct Point {
    double deflection = 0;  ///< m
    double force = 0;       ///< N
    friend bool operator==(const Point&, const Point&) = default;
  };

  /// Rigid.
  Support() = default;
  static Support rigid() { return {}; }
  /// `stiffness` in N/m, finite and > 0; std::invalid_argument otherwise.
  static Support linear(double stiffness);
  /// One point or more, both coordinates > 0, finite and strictly increasing; std::invalid_argument
  /// otherwise. The origin need not be given.
  static Support through(std::vector<Point> points);

  [[nodiscard]] bool is_rigid() const { return points_.empty(); }
  /// The points after the origin; a single one for a linear support.
  [[nodiscard]] const std::vector<Point>& points() const { return points_; }

  /// Fs(Xs), N. Not defined for a rigid support.
  [[nodiscard]] double force(double deflection) const;
  /// The inverse, m; 0 for a rigid support and for forces <= 0.
  [[nodiscard]] double deflection(double force) const;
  /// dXs/dF at a force, m/N; 0 for a rigid support. At a corner: that of the segment above.
  [[nodiscard]] double compliance(double force) const;
  /// Elastic energy at a force, J.
  [[nodiscard]] double energy(double force) const;
  /// The deflection at which Fs(Xs) + slope Xs = force, m; `slope` > 0, N/m. Not for a rigid support.
  [[nodiscard]] double balanced(double slope, double force) const;
  /// Forces at which the slope changes, increasing.
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }

 private:
  [[nodiscard]] std::size_t segment_of_force(double force) const;

  std::vector<Point> points_;
  std::vector<double> stiffness_;  ///< of each segment
  std::vector<double> energy_;     ///< at the lower end of each segment
  std::vector<double> corners_;
};

}  // namespace dashpad
