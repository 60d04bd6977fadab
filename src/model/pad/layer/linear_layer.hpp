#pragma once
/// A linear layer, elastic (law 1) or viscoelastic (law 2):
///
///   stress = E_inf e + q,   dq/dt = (E_0 - E_inf) de/dt - q / tau
///
/// which is Eqs. 8 and 11 of theory.md with q = stress - E_inf e, exact over a step of constant rate. An
/// elastic layer has E_0 = E_inf.
///
/// Stress in Pa, compression positive.

#include <algorithm>
#include <cmath>

#include "dashpad/model/pad/elastic.hpp"
#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/strain.hpp"
#include "model/pad/layer/layer_state.hpp"

namespace dashpad {

class LinearLayer {
 public:
  static constexpr double memory_at_rest = 0;

  LinearLayer(const Elastic& law, double factor) : lasting_(factor * law.modulus) {}
  LinearLayer(const LinearViscoelastic& law, double factor)
      : lasting_(factor * law.asymptotic_modulus),
        relaxing_(factor * (law.initial_modulus - law.asymptotic_modulus)),
        time_(law.relaxation_time) {}

  [[nodiscard]] double stress(Strain end, const LayerState& now, const LayerStep& step) const {
    return lasting_ * end.value + branch_after(end, now, step);
  }
  [[nodiscard]] LayerState after(Strain end, const LayerState& now, const LayerStep& step) const {
    return {.strain = end.value,
            .largest = std::max(now.largest, end.value),
            .rate = (end.value - now.strain) / step.time,
            .memory = branch_after(end, now, step)};
  }
  [[nodiscard]] LayerTangent tangent(Strain, const LayerState& state) const {
    return {-state.memory / time_, lasting_ + relaxing_, lasting_ + relaxing_};
  }
  [[nodiscard]] double slow_stress(Strain at) const { return lasting_ * at.value; }
  /// It closes under a finite stress.
  [[nodiscard]] static double closing_exponent() { return 0; }
  /// A column that the nose has left starts afresh.
  [[nodiscard]] static double memory_off_contact(double) { return memory_at_rest; }

 private:
  /// q at the end of a step. The column may be met within it: its strain begins below 0 then.
  [[nodiscard]] double branch_after(Strain end, const LayerState& now, const LayerStep& step) const {
    if (relaxing_ == 0) return 0;
    const double from = std::max(now.strain, 0.0);
    const double whole = end.value - now.strain;
    const double time = now.strain < 0 && whole > 0 ? step.time * (end.value - from) / whole : step.time;
    const double fall = -std::expm1(-time / time_);
    const double rate = whole / step.time;
    return now.memory * (1 - fall) + relaxing_ * rate * time_ * fall;
  }

  double lasting_ = 0;   ///< E_inf
  double relaxing_ = 0;  ///< E_0 - E_inf
  double time_ = 1;      ///< tau, s
};

}  // namespace dashpad
