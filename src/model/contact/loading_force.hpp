#pragma once
/// The contact force of the 9-parameter law while the pad is only loaded: a closed form, without columns.
///
///   K(Y) = a0 A(Y / L) + int A((Y - s) / L) a'(s) ds, over s in [0, min(Y, d)]       (theory.md, Eq. 21)
///   F1 = B K(Y1) + (F0 - B K(Y0)) exp(-dt / tau)                                    (theory.md, Eq. 22)
///
/// All columns relax alike, so their integral obeys the law of one column with K in place of A.

#include <numbers>
#include <vector>

#include "dashpad/model/nose/sections.hpp"
#include "dashpad/model/pad/nine_parameter.hpp"

namespace dashpad {

/// K(Y): since a'(s) / (2 pi) = w - t s = (w - t Y) + t L e, integrals of A and e A in the form of Eq. 19.
class ContactShape {
 public:
  ContactShape(PowerExponents exponents, double thickness, const Sections& nose) {
    set(exponents, thickness, nose);
  }
  void set(PowerExponents exponents, double thickness, const Sections& nose) {
    thickness_ = thickness;
    nose_ = nose;
    if (exponents != power_.exponents()) {
      power_ = PowerShape(exponents);
      moment_ = PowerShape({exponents.m + 1, exponents.n});
    }
  }
  [[nodiscard]] const PowerShape& power() const { return power_; }

  /// K at a penetration, m2.
  [[nodiscard]] double at(double penetration) const {
    if (penetration <= 0) return 0;
    const Strain axis{penetration / thickness_, (thickness_ - penetration) / thickness_};
    double sum = integral_up_to(axis, penetration);
    if (penetration > nose_.depth)
      sum -= integral_up_to(
          {(penetration - nose_.depth) / thickness_, ((thickness_ - penetration) + nose_.depth) / thickness_},
          penetration);
    return (nose_.tip > 0 ? nose_.tip * power_.at(axis).shape : 0) + 2 * std::numbers::pi * thickness_ * sum;
  }

 private:
  /// Integral over the strains from 0 to `strain`.
  [[nodiscard]] double integral_up_to(Strain strain, double penetration) const {
    const PowerShape::Value at = power_.at(strain);
    return (nose_.width - nose_.taper * penetration) * at.measure +
           nose_.taper * thickness_ *
               moment_.measure(strain, {strain.value * at.shape, 0, at.log_strain, at.log_complement});
  }

  double thickness_ = 0;
  Sections nose_;
  PowerShape power_;
  PowerShape moment_{{2, 0}};
};

/// A step of the loading, as needed to lay columns later.
struct LoadingStep {
  double penetration = 0;  ///< penetration at its end, m
  double modulus = 0;      ///< B, Pa
  double decay = 1;        ///< exp(-dt / tau)
};

/// A trial step of the loading.
struct LoadingTrial {
  LoadingStep step;
  double force = 0;                 ///< N
  double shape_force = 0;           ///< K, m2
  double force_rate_when_held = 0;  ///< N/s
};

class LoadingForce {
 public:
  LoadingForce() { steps_.reserve(100'000); }

  void start() {
    steps_.clear();
    force_ = shape_force_ = 0;
  }
  [[nodiscard]] LoadingTrial trial(const ContactShape& shape, const NineParameter& law, double penetration,
                                   const NineParameter::RatePart& rate,
                                   const NineParameter::TimePart& time) const {
    LoadingTrial trial{{penetration, rate.modulus, time.decay}};
    trial.shape_force = shape.at(penetration);
    trial.force = rate.modulus * trial.shape_force + (force_ - rate.modulus * shape_force_) * time.decay;
    trial.force_rate_when_held =
        (law.asymptotic_modulus * trial.shape_force - trial.force) / law.relaxation_time;
    return trial;
  }
  void accept(const LoadingTrial& trial) {
    steps_.push_back(trial.step);
    force_ = trial.force;
    shape_force_ = trial.shape_force;
  }
  [[nodiscard]] double force() const { return force_; }
  [[nodiscard]] const std::vector<LoadingStep>& steps() const { return steps_; }

 private:
  std::vector<LoadingStep> steps_;
  double force_ = 0;
  double shape_force_ = 0;  ///< K
};

}  // namespace dashpad
