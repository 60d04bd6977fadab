#pragma once
/// A nose on a pad without memory: contact force and work are closed forms of the penetration.
///
///   F(Y) = S0 a(Y) + sum over k of (dE_k / L) a1(Y - e_k L)                      (theory.md, Eq. 18)
///
/// a is the area of the nose's section (theory.md, Eq. 3), a1 its integral from 0, a2 that of a1.
///
/// A foam that does not recover keeps the crater of an earlier blow, of the depth Yc (theory.md, Eq. 48): Y
/// is counted from the surface of the new pad, and first contact is at Y = Yc, where the pad carries F(Yc).
///
/// Penetration in m, positive; force in N, compression positive.

#include <cstddef>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/pad/stress_curve.hpp"
#include "model/contact/contact.hpp"

namespace dashpad {

class CurveContact {
 public:
  CurveContact(const StressCurve& curve, bool recovers, double thickness, const Sections& nose,
               double crater = 0)
      : curve_(curve), recovers_(recovers), thickness_(thickness), nose_(nose), crater_(crater) {
    if (crater > 0) work_before_ = integral(crater, 1);
  }

  /// Whether the pad follows its curve back on unloading; if not, it holds its deformation.
  [[nodiscard]] bool recovers() const { return recovers_; }
  [[nodiscard]] double lock_penetration() const { return thickness_ - crater_; }
  [[nodiscard]] double crater() const { return crater_; }
  [[nodiscard]] double joint() const { return 0; }
  [[nodiscard]] std::size_t stations() const { return 0; }
  [[nodiscard]] std::size_t updates() const { return 0; }

  void start(double, double) { penetration_ = crater_; }

  /// Force at which the foam begins to yield, N.
  [[nodiscard]] double first_force() const {
    return crater_ > 0 ? force(crater_) : curve_.initial_stress * nose_.tip;
  }

  /// The times have no effect, since the law has no memory.
  [[nodiscard]] PadTrial trial(double advance, double from, double step) const {
    return {advance, from, step, force(penetration_ + advance)};
  }
  [[nodiscard]] double force_rate_when_held(const PadTrial&) const { return 0; }
  void accept(const PadTrial& trial) { penetration_ += trial.advance; }

  /// A quantity with the sign of the stress: the penetration beyond the crater, m.
  [[nodiscard]] double largest_stress(const PadTrial& trial) const {
    return (penetration_ - crater_) + trial.advance;
  }

  /// Radius of the contact, m.
  [[nodiscard]] double contact_radius() const { return penetration_ >= 0 ? nose_.radius(penetration_) : 0; }

  /// Force at a penetration below the surface of the new pad, N.
  [[nodiscard]] double force(double y) const {
    double sum = curve_.initial_stress * nose_.area(y);
    for (const auto& kink : curve_)
      sum += kink.slope_change / thickness_ * nose_.volume(y - kink.strain * thickness_);
    return sum;
  }
  /// n-fold integral of the force of the new pad from 0 to y, n >= 1; for n = 1 the work, J.
  [[nodiscard]] double integral(double y, int n) const {
    double sum = curve_.initial_stress * nose_.integral(y, n);
    for (const auto& kink : curve_)
      sum += kink.slope_change / thickness_ * nose_.integral(y - kink.strain * thickness_, n + 1);
    return sum;
  }
  /// Work done on the pad since first contact, J, at a penetration since then, m.
  [[nodiscard]] double energy(double y) const { return integral(crater_ + y, 1) - work_before_; }

 private:
  StressCurve curve_;
  bool recovers_;
  double thickness_;
  Sections nose_;
  double crater_;           ///< m
  double work_before_ = 0;  ///< J
  double penetration_ = 0;  ///< below the surface of the new pad, m
};

}  // namespace dashpad
