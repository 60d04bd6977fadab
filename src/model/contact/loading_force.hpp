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
#include "model/pad/column_law.hpp"

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

  using Series = scalar::Series<double>;
  /// K as a series in the penetration from a given one on, m2, m and 1.
  [[nodiscard]] Series around(double penetration) const {
    if (penetration <= 0) return 0;
    Series sum = integral_from(0, penetration);
    if (penetration > nose_.depth) sum = sum - integral_from(nose_.depth, penetration);
    sum = 2 * std::numbers::pi * thickness_ * sum;
    return nose_.tip > 0 ? nose_.tip * shape_at(strain_at(penetration, 0)).shape + sum : sum;
  }
  /// Whether no edge of the nose meets the pad between two penetrations, m.
  [[nodiscard]] bool is_smooth_between(double a, double b) const {
    return (a > nose_.depth) == (b > nose_.depth);
  }

 private:
  [[nodiscard]] Strain strain_at(double penetration, double depth) const {
    return {(penetration - depth) / thickness_, ((thickness_ - penetration) + depth) / thickness_};
  }
  [[nodiscard]] scalar::Shape<Series> shape_at(Strain strain) const {
    const double growth = 1 / thickness_;
    return scalar::shape_at(
        power_, scalar::Strains<Series>{{strain.value, growth, 0}, {strain.complement, -growth, 0}});
  }
  /// Integral of A a' / (2 pi L) over the depths from `depth`, where it would go on with the same a', to the
  /// contact edge. Its slope follows from dw = A d(strain).
  [[nodiscard]] Series integral_from(double depth, double penetration) const {
    const Strain strain = strain_at(penetration, depth);
    const auto [shape, log_strain, log_complement] = shape_at(strain);
    const PowerShape::Value at{shape.value, 0, log_strain.value, log_complement.value};
    const PowerShape::Value moment{strain.value * shape.value, 0, at.log_strain, at.log_complement};
    const double measure = power_.measure(strain, at);
    const double width = nose_.width - nose_.taper * depth;
    return {(nose_.width - nose_.taper * penetration) * measure +
                nose_.taper * thickness_ * moment_.measure(strain, moment),
            width / thickness_ * shape.value - nose_.taper * measure,
            (width * shape.first - nose_.taper * shape.value) / (2 * thickness_)};
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
  [[nodiscard]] LoadingTrial trial(double shape_force, const NineParameter& law, double penetration,
                                   const NineParameter::RatePart& rate,
                                   const NineParameter::TimePart& time) const {
    LoadingTrial trial{{penetration, rate.modulus, time.decay}};
    trial.shape_force = shape_force;
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
