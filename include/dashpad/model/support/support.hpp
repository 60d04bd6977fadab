#pragma once
/// The support of the pad: its curve of force over deflection, and its parts beside that curve.
///
///   F = Fs(Xs), piecewise linear through the origin and any number of points, increasing; beyond the last
///   point the last slope continues; below the origin the force is 0        (theory.md, Eq. 4; report, Eq. 6)
///
/// F and Xs are positive in compression; Xs of a rigid support is 0. Masses, losses, gap, preload: Backing.

#include <array>
#include <vector>

#include "dashpad/model/parameter.hpp"

namespace dashpad {

class Support {
 public:
  struct Point {
    double deflection = 0;  ///< m
    double force = 0;       ///< N
    friend bool operator==(const Point&, const Point&) = default;
  };

  /// A rigid support.
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
  /// Xs at a force, m; 0 for a rigid support and for forces <= 0.
  [[nodiscard]] double deflection(double force) const;
  /// dXs/dF at a force, m/N; 0 for a rigid support. At a corner that of the segment above.
  [[nodiscard]] double compliance(double force) const;
  /// Elastic energy at a force, J.
  [[nodiscard]] double energy(double force) const;
  /// The deflection at which Fs(Xs) + slope Xs = force, m; `slope` > 0, N/m. Not for a rigid support.
  [[nodiscard]] double balanced(double slope, double force) const;
  /// Forces at which the slope changes, N, increasing.
  [[nodiscard]] const std::vector<double>& corners() const { return corners_; }

 private:
  [[nodiscard]] std::size_t segment_of_force(double force) const;

  std::vector<Point> points_;
  std::vector<double> stiffness_;  ///< slope of each segment, N/m
  std::vector<double> energy_;     ///< energy at the lower end of each segment, J
  std::vector<double> corners_;
};

/// Parts of a support beside its curve Fs: losses, moving masses, gap and preload.
///
///   T = Fs(x) + c dx/dt     on the body behind or the ground                    (theory.md, Eq. 41)
///   m d2xp/dt2 = F - T,     Mb d2xb/dt2 = T,     x = xp - xb                     (theory.md, Eq. 42)
///
/// xp is the motion of the panel that carries the pad, xb that of a free body behind, Mb; F is the force of
/// the pad. All are positive in compression and start from rest at first contact; SI units. A part whose
/// number is 0 is absent; without any, the support is that of the report.
struct Backing {
  double unloading_stiffness = 0;  ///< k_u, slope of unloading of a support that crushes, N/m; 0: elastic
  double damping = 0;              ///< c, N s/m
  double loss_factor = 0;          ///< eta, alternative to c = eta sqrt(k (M + m)); k is the first slope
  double mass = 0;                 ///< m, mass of the panel, kg
  double body_mass = 0;            ///< Mb, mass of a free body behind, kg; 0: the ground
  double gap = 0;                  ///< gap between panel and support, m
  double preload = 0;              ///< force of the support on the panel against a stop, N
  double earlier_force = 0;        ///< largest earlier force of a support that crushes, N

  static const std::array<Parameter<Backing>, 8> parameters;

  friend bool operator==(const Backing&, const Backing&) = default;
};

inline constexpr std::array<Parameter<Backing>, 8> Backing::parameters{{
    {"unloading_stiffness", "k_u", "N/m", &Backing::unloading_stiffness, wide(1e-3, 1e15),
     "unloading stiffness of a support that crushes", LeftOut::zero},
    {"damping", "c", "N s/m", &Backing::damping, wide(1e-6, 1e12),
     "coefficient of a damper in parallel with the support", LeftOut::zero},
    {"loss_factor", "\\eta", "1", &Backing::loss_factor, from_to(0, 2),
     "loss factor of the support, modelled as a damper", LeftOut::zero},
    {"mass", "m", "kg", &Backing::mass, wide(1e-6, 1e6), "mass of the panel that carries the pad",
     LeftOut::none},
    {"body_mass", "M_b", "kg", &Backing::body_mass, wide(1e-6, 1e6), "mass of a free body behind the support",
     LeftOut::none},
    {"gap", "x_g", "m", &Backing::gap, wide(1e-5, 1e2), "gap between panel and support", LeftOut::zero},
    {"preload", "F_p", "N", &Backing::preload, wide(1e-6, 1e12), "preload of the support against a stop",
     LeftOut::zero},
    {"earlier_force", "F_e", "N", &Backing::earlier_force, wide(1e-6, 1e12),
     "largest previous force on a support that crushes", LeftOut::zero},
}};

}  // namespace dashpad
