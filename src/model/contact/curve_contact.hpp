#pragma once
/// A nose on a pad without memory: contact force and work are closed forms of the penetration.
///
///   F(Y) = S0 a(Y) + sum over k of (dE_k / L) a1(Y - e_k L)                      (theory.md, Eq. 18)
///
/// a is the area of the nose's section (theory.md, Eq. 3), a1 its integral from 0, a2 that of a1.
///
/// Penetration in m, positive; force in N, compression positive.

#include <cstddef>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/pad/stress_curve.hpp"
#include "model/contact/contact.hpp"

namespace dashpad {

class CurveContact {
 public:
  CurveContact(const StressCurve& curve, bool recovers, double thickness, const Sections& nose)
      : curve_(curve), recovers_(recovers), thickness_(thickness), nose_(nose) {}

  /// Whether the pad follows its curve back on unloading; if not, it holds its deformation.
  [[nodiscard]] bool recovers() const { return recovers_; }
  [[nodiscard]] double lock_penetration() const { return thickness_; }
  [[nodiscard]] std::size_t stations() const { return 0; }
  [[nodiscard]] std::size_t updates() const { return 0; }

  void start(double, double) { penetration_ = 0; }

  /// Force at which the uncrushed foam begins to yield, N.
  [[nodiscard]] double first_force() const { return curve_.initial_stress * nose_.tip; }

  /// The times do not matter: the law has no memory.
  [[nodiscard]] PadTrial trial(double advance, double from, double step) const {
    return {advance, from, step, force(penetration_ + advance)};
  }
  [[nodiscard]] double force_rate_when_held(const PadTrial&) const { return 0; }
  void accept(const PadTrial& trial) { penetration_ += trial.advance; }

  /// No more than its sign: tension is where the nose has left the pad.
  [[nodiscard]] double largest_stress(const PadTrial& trial) const { return penetration_ + trial.advance; }

  /// Contact radius, m.
  [[nodiscard]] double contact_radius() const { return penetration_ >= 0 ? nose_.radius(penetration_) : 0; }

  [[nodiscard]] double force(double y) const {
    double sum = curve_.initial_stress * nose_.area(y);
    for (const auto& kink : curve_)
      sum += kink.slope_change / thickness_ * nose_.volume(y - kink.strain * thickness_);
    return sum;
  }
  /// Work done on the pad from first contact, J.
  [[nodiscard]] double energy(double y) const {
    double sum = curve_.initial_stress * nose_.volume(y);
    for (const auto& kink : curve_)
      sum += kink.slope_change / thickness_ * nose_.volume_integral(y - kink.strain * thickness_);
    return sum;
  }

 private:
  StressCurve curve_;
  bool recovers_;
  double thickness_;
  Sections nose_;
  double penetration_ = 0;
};

}  // namespace dashpad
