#pragma once
/// The secant stiffness of the support in the 1984 program.

#include <array>

#include "dashpad/spit1984/deck.hpp"
#include "spit1984/arithmetic.hpp"

namespace dashpad::spit1984 {

template <class Real>
class SupportSecant {
 public:
  /// `idle_segments`: as in the listing; otherwise mended.
  SupportSecant(const Deck& deck, bool idle_segments)
      : segments_(static_cast<std::size_t>(deck.support)), idle_(idle_segments) {
    if (segments_ == 1) {
      tangent_[0] = static_cast<Real>(deck.support_parameters[8]);
      return;
    }
    Real last_deflection(0), last_force(0);
    for (std::size_t j = 0; j < segments_; ++j) {
      deflection_[j] = static_cast<Real>(deck.support_parameters[2 * j]);
      const auto force = static_cast<Real>(deck.support_parameters[2 * j + 1]);
      tangent_[j] = (force - last_force) / (deflection_[j] - last_deflection);
      last_deflection = deflection_[j];
      last_force = force;
    }
  }

  /// STIF at the start.
  [[nodiscard]] Real initial() const { return tangent_[0]; }
  /// 221: K = K1 + sum of K(j) (1 - X(j)/XS) over the segments j with 1 - X(j)/XS > 1; in compression there
  /// are none. Mended: F(XS) / XS.
  [[nodiscard]] Real secant(Real deflection) const {
    if (segments_ == 1) return tangent_[0];
    if (!idle_) return curve_secant(deflection);
    const Real one(1);
    Real stiffness = tangent_[0];
    for (std::size_t j = 1; j < segments_; ++j) {
      const Real share = one - deflection_[j - 1] / deflection;
      if (share > one) stiffness = stiffness + tangent_[j] * share;
    }
    return stiffness;
  }

  /// SPAR(9) to SPAR(12).
  [[nodiscard]] std::array<double, 4> printed() const {
    std::array<double, 4> stiffness{};
    for (std::size_t j = 0; j < 4; ++j) stiffness[j] = to_double(tangent_[j]);
    return stiffness;
  }

 private:
  [[nodiscard]] Real curve_secant(Real deflection) const {
    if (deflection <= deflection_[0]) return tangent_[0];
    Real force = tangent_[0] * deflection_[0];
    std::size_t j = 1;
    for (; j < segments_ - 1 && deflection > deflection_[j]; ++j)
      force = force + tangent_[j] * (deflection_[j] - deflection_[j - 1]);
    return (force + tangent_[j] * (deflection - deflection_[j - 1])) / deflection;
  }

  std::size_t segments_;
  bool idle_;
  std::array<Real, 4> deflection_{};  ///< of the points
  std::array<Real, 4> tangent_{};
};

}  // namespace dashpad::spit1984
