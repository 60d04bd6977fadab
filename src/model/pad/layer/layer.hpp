#pragma once
/// A layer of any admitted law, and its strain as a function of the stress (theory.md, Eq. 52).

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <variant>

#include "dashpad/model/pad/elastic.hpp"
#include "dashpad/model/pad/linear_viscoelastic.hpp"
#include "dashpad/model/pad/strain.hpp"
#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/foam_stress.hpp"
#include "model/pad/layer/layer_law.hpp"
#include "model/root.hpp"

namespace dashpad {

/// State of one layer of a column.
///
/// Strains are engineering strains of the layer, compression positive; times in s.
struct LayerState {
  double strain = 0;   ///< present strain; below 0 where the nose does not reach the column
  double largest = 0;  ///< largest strain so far, >= 0
  double rate = 0;     ///< mean strain rate over the last step, 1/s
  double memory = 0;   ///< foams: exp(-|g| / c) with the sign of g (theory.md, Eq. 34); law 2: q, Pa
};

struct LayerStep {
  double time = 0;       ///< length of the step, > 0
  double last_time = 0;  ///< length of the step before; 0: there was none
};

/// Response of a layer to a strain that is held or changes suddenly (theory.md, Eq. 54).
struct LayerTangent {
  double relaxing = 0;   ///< rate of the stress while the strain is held, Pa/s
  double loading = 0;    ///< slope of the stress for a sudden strain, Pa, > 0
  double unloading = 0;  ///< the same for a falling strain
};

/// A layer of foam or crushable foam (theory.md, Eqs. 32 to 38): its stress at the end of a step as a
/// function of the strain there. The formulas are those of a pad of one foam, with a slip for each column.
///
/// Stress in Pa, compression positive.
class FoamLayer {
 public:
  static constexpr double memory_at_rest = 1;

  /// `factor` multiplies every stress.
  template <SharesSlip Law>
  FoamLayer(const Law& law, double factor) : stress_(law), factor_(factor) {}

  /// The stress at the end of a step. That of crushed foam continues below zero along its line of unloading,
  /// so that each stress belongs to one strain.
  [[nodiscard, gnu::flatten]] double stress(Strain end, const LayerState& now, const LayerStep& step) const {
    const double ahead = std::max(now.largest - end.value, 0.0);
    const double stress = stress_.response(end, ahead, slip_rate(end.value, now, step)).stress;
    if (stress > 0 || !stress_.stays_crushed()) return factor_ * stress;
    const Strain largest{end.value + ahead, end.complement - ahead};
    return factor_ * (stress_.curve().at(largest).stress - stress_.slope_back(largest) * ahead);
  }
  [[nodiscard]] LayerState after(double end, const LayerState& now, const LayerStep& step) const {
    const SlipScale::State slip = slip_after(end, now, step);
    return {.strain = end,
            .largest = std::max(now.largest, end),
            .rate = rate(end, now, step),
            .memory = slip.side * slip.z};
  }
  [[nodiscard]] LayerTangent tangent(const LayerState& state) const {
    const Strain at = strain_of(state.strain);
    const SlipScale& slip = stress_.slip();
    const double g = slip.strain_of(slip_of(state));
    const auto response = [&](double further) {
      const Strain strain{at.value + further, at.complement - further};
      return stress_.response(strain, std::max(state.largest - strain.value, 0.0),
                              slip.slip_rate(g + further));
    };
    // Small against the lag of the slip, large against rounding.
    const double change = 1e-5 * slip.strain;
    const FoamStress::Ratio here = response(0);
    return {factor_ * here.relaxing, factor_ * (response(change).stress - here.stress) / change,
            factor_ * (here.stress - response(-change).stress) / change};
  }
  /// The stress in the slowest test, Pa.
  [[nodiscard]] double slow_stress(Strain at) const { return factor_ * stress_.curve().at(at).stress; }
  /// Exponent n with which the stress grows as gap^-n near full compression.
  [[nodiscard]] double closing_exponent() const { return stress_.curve().continuation_exponent(); }
  /// A foam keeps its slip.
  [[nodiscard]] static double memory_off_contact(double memory) { return memory; }

 private:
  static SlipScale::State slip_of(const LayerState& state) {
    return {std::abs(state.memory), state.memory < 0 ? -1.0 : 1.0};
  }
  static double rate(double end, const LayerState& now, const LayerStep& step) {
    return (end - now.strain) / step.time;
  }
  [[nodiscard]] SlipScale::State slip_after(double end, const LayerState& now, const LayerStep& step) const {
    return stress_.slip().after_step(slip_of(now), rate(end, now, step), step.time, now.rate, step.last_time);
  }
  [[nodiscard]] double slip_rate(double end, const LayerState& now, const LayerStep& step) const {
    return stress_.slip().slip_rate(slip_after(end, now, step));
  }

  FoamStress stress_;
  double factor_ = 1;
};

/// A linear layer, elastic (law 1) or viscoelastic (law 2):
///
///   stress = E_inf e + q,   dq/dt = (E_0 - E_inf) de/dt - q / tau
///
/// These are Eqs. 8 and 11 with q = stress - E_inf e, exact at a constant rate; elastic: E_0 = E_inf.
///
/// Stress in Pa, compression positive.
class LinearLayer {
 public:
  static constexpr double memory_at_rest = 0;

  LinearLayer(const Elastic& law, double factor) : lasting_(factor * law.modulus) {}
  LinearLayer(const LinearViscoelastic& law, double factor)
      : lasting_(factor * law.asymptotic_modulus),
        relaxing_(factor * (law.initial_modulus - law.asymptotic_modulus)),
        time_(law.relaxation_time) {}

  [[nodiscard]] double stress(Strain end, const LayerState& now, const LayerStep& step) const {
    return lasting_ * end.value + branch_after(end.value, now, step);
  }
  [[nodiscard]] LayerState after(double end, const LayerState& now, const LayerStep& step) const {
    return {.strain = end,
            .largest = std::max(now.largest, end),
            .rate = (end - now.strain) / step.time,
            .memory = branch_after(end, now, step)};
  }
  [[nodiscard]] LayerTangent tangent(const LayerState& state) const {
    return {-state.memory / time_, lasting_ + relaxing_, lasting_ + relaxing_};
  }
  [[nodiscard]] double slow_stress(Strain at) const { return lasting_ * at.value; }
  /// A linear layer closes at a finite stress.
  [[nodiscard]] static double closing_exponent() { return 0; }
  /// A column that the nose has left starts anew.
  [[nodiscard]] static double memory_off_contact(double) { return memory_at_rest; }

 private:
  /// q at the end of a step, Pa. If the column is touched within the step, its strain begins below 0.
  [[nodiscard]] double branch_after(double end, const LayerState& now, const LayerStep& step) const {
    if (relaxing_ == 0) return 0;
    const double from = std::max(now.strain, 0.0);
    const double whole = end - now.strain;
    const double time = now.strain < 0 && whole > 0 ? step.time * (end - from) / whole : step.time;
    const double fall = -portable::expm1(-time / time_);
    const double rate = whole / step.time;
    return now.memory * (1 - fall) + relaxing_ * rate * time_ * fall;
  }

  double lasting_ = 0;   ///< E_inf
  double relaxing_ = 0;  ///< E_0 - E_inf
  double time_ = 1;      ///< tau, s
};

using Layer = std::variant<FoamLayer, LinearLayer>;

/// `factor` multiplies every stress.
inline Layer made_layer(const LayerLaw& law, double factor) {
  return std::visit(
      [&]<class Law>(const Law& held) -> Layer {
        if constexpr (SharesSlip<Law>)
          return FoamLayer(held, factor);
        else
          return LinearLayer(held, factor);
      },
      law);
}

/// The inverse of the stress of a layer.
struct StrainOfStress {
  Strain strain;
  double flexibility = 0;  ///< d(strain)/d(stress), 1/Pa
};

/// The variable x of root searches: the strain up to a half, then 1/2 - ln(2 (1 - e)) / 2, in which the
/// complement of a closing layer keeps its digits; smooth at a half.
struct SearchStrain {
  static constexpr double precision = 1e-13;
  /// Share of the thickness at which a layer counts as closed, below that at which a pad locks (Eq. 29).
  static constexpr double min_complement = 1e-10;

  static double most() { return of({1, min_complement}); }
  static double of(Strain e) { return e.value < 0.5 ? e.value : 0.5 - portable::log(2 * e.complement) / 2; }
  static Strain strain(double x) {
    if (x < 0.5) return strain_of(x);
    const double complement = portable::exp(1 - 2 * x) / 2;
    return {1 - complement, complement};
  }
  /// de/dx.
  static double slope(Strain e) { return e.value < 0.5 ? 1 : 2 * e.complement; }
};

/// The strain at which `stress_at(strain)` equals `stress`, Pa. The search starts at `x` with the slope
/// d(stress)/dx (0: not known) and a first stride.
template <class StressAt>
StrainOfStress strain_at(double stress, double x, double slope, double stride, StressAt&& stress_at) {
  const IncreasingRoot root =
      increasing_root([&](double at) { return stress_at(SearchStrain::strain(at)) - stress; },
                      {.guess = x,
                       .slope = slope,
                       .low = 0,
                       .high = SearchStrain::most(),
                       .stride = stride,
                       .precision = SearchStrain::precision});
  const Strain strain = SearchStrain::strain(root.x);
  return {strain, root.slope > 0 ? SearchStrain::slope(strain) / root.slope : 0};
}

}  // namespace dashpad
