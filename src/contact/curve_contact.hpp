#pragma once
/// The sphere on a pad without memory: contact force and work are closed forms of the penetration.
///
///   F(Y) = S0 a0(Y) + sum over k of (dE_k / L) a1(Y - e_k L)                     (theory.md, Eq. 16)
///   a0(y) = 2 pi int_0^min(y,R) (R - s) ds,   a1(y) = int_0^y a0,   a2(y) = int_0^y a1
///
/// Penetration in m, positive; force in N, compression positive.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "contact/contact.hpp"
#include "dashpad/pad/stress_curve.hpp"

namespace dashpad {

class CurveContact {
 public:
  CurveContact(const StressCurve& curve, bool recovers, double thickness, double radius)
      : curve_(curve), recovers_(recovers), thickness_(thickness), radius_(radius) {}

  /// Whether the pad follows its curve back on unloading; if not, it holds its deformation.
  [[nodiscard]] bool recovers() const { return recovers_; }
  [[nodiscard]] double lock_penetration() const { return thickness_; }
  [[nodiscard]] std::size_t stations() const { return 0; }
  [[nodiscard]] std::size_t updates() const { return 0; }

  void start(double, double) { penetration_ = 0; }

  /// The times do not matter: the law has no memory.
  [[nodiscard]] PadTrial trial(double advance, double from, double step) const {
    return {advance, from, step, force(penetration_ + advance)};
  }
  [[nodiscard]] double force_rate_when_held(const PadTrial&) const { return 0; }
  void accept(const PadTrial& trial) { penetration_ += trial.advance; }

  /// No more than its sign: tension is where the nose has left the pad.
  [[nodiscard]] double largest_stress(const PadTrial& trial) const { return penetration_ + trial.advance; }

  /// Contact radius, m.
  [[nodiscard]] double contact_radius() const {
    const double depth = std::clamp(penetration_, 0.0, radius_);
    return std::sqrt(depth * (2 * radius_ - depth));
  }

  [[nodiscard]] double force(double y) const {
    double sum = curve_.initial_stress * area(y);
    for (const auto& kink : curve_)
      sum += kink.slope_change / thickness_ * area_1(y - kink.strain * thickness_);
    return sum;
  }
  /// Work done on the pad from first contact, J.
  [[nodiscard]] double energy(double y) const {
    double sum = curve_.initial_stress * area_1(y);
    for (const auto& kink : curve_)
      sum += kink.slope_change / thickness_ * area_2(y - kink.strain * thickness_);
    return sum;
  }

 private:
  // The contact area's projection a0 and its repeated integrals; below the sphere's equator it stays pi R^2.
  [[nodiscard]] double area(double y) const {
    const double c = std::clamp(y, 0.0, radius_);
    return 2 * std::numbers::pi * c * (radius_ - c / 2);
  }
  [[nodiscard]] double area_1(double y) const {
    const double c = std::clamp(y, 0.0, radius_);
    const double beyond = std::max(y - radius_, 0.0);
    return 2 * std::numbers::pi * c * c * (radius_ / 2 - c / 6) + area(radius_) * beyond;
  }
  [[nodiscard]] double area_2(double y) const {
    const double c = std::clamp(y, 0.0, radius_);
    const double beyond = std::max(y - radius_, 0.0);
    return 2 * std::numbers::pi * c * c * c * (radius_ / 6 - c / 24) +
           (area_1(radius_) + area(radius_) * beyond / 2) * beyond;
  }

  StressCurve curve_;
  bool recovers_;
  double thickness_;
  double radius_;
  double penetration_ = 0;
};

}  // namespace dashpad
