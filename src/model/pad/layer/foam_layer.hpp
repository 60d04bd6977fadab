#pragma once
/// A layer of foam or crushable foam (theory.md, Eqs. 32 to 38): its stress at the end of a step, by the
/// strain there. The formulas are those of a pad of one foam; here each column has a slip of its own.
///
/// Stress in Pa, compression positive.

#include <algorithm>
#include <cmath>

#include "model/pad/foam/foam_stress.hpp"
#include "model/pad/layer/layer_state.hpp"

namespace dashpad {

class FoamLayer {
 public:
  static constexpr double memory_at_rest = 1;

  /// Every stress is multiplied by `factor`.
  template <SharesSlip Law>
  FoamLayer(const Law& law, double factor) : stress_(law), factor_(factor) {}

  /// Of a crushed foam that has come back free of stress, below zero: its line goes on, so that no stress has
  /// two strains.
  [[nodiscard]] double stress(Strain end, const LayerState& now, const LayerStep& step) const {
    const double ahead = std::max(now.largest - end.value, 0.0);
    const double stress = stress_.response(end, ahead, slip_rate(end, now, step)).stress;
    if (stress > 0 || !stress_.stays_crushed()) return factor_ * stress;
    const Strain largest{end.value + ahead, end.complement - ahead};
    return factor_ * (stress_.curve().at(largest).stress - stress_.slope_back(largest) * ahead);
  }
  [[nodiscard]] LayerState after(Strain end, const LayerState& now, const LayerStep& step) const {
    const SlipScale::State slip = slip_after(end, now, step);
    return {.strain = end.value,
            .largest = std::max(now.largest, end.value),
            .rate = rate(end, now, step),
            .memory = slip.side * slip.z};
  }
  [[nodiscard]] LayerTangent tangent(Strain at, const LayerState& state) const {
    const SlipScale& slip = stress_.slip();
    const double g = slip.strain_of(slip_of(state));
    const auto response = [&](double further) {
      const Strain strain{at.value + further, at.complement - further};
      return stress_.response(strain, std::max(state.largest - strain.value, 0.0),
                              slip.slip_rate(g + further));
    };
    // Small against the strain over which the slip follows, large against rounding.
    const double change = 1e-5 * slip.strain;
    const FoamStress::Ratio here = response(0);
    return {factor_ * here.relaxing, factor_ * (response(change).stress - here.stress) / change,
            factor_ * (here.stress - response(-change).stress) / change};
  }
  /// Of the slowest test, Pa.
  [[nodiscard]] double slow_stress(Strain at) const { return factor_ * stress_.curve().at(at).stress; }
  /// With which power of the gap that is left the stress grows at last.
  [[nodiscard]] double closing_exponent() const { return stress_.curve().continuation_exponent(); }
  /// A foam keeps its slip.
  [[nodiscard]] static double memory_off_contact(double memory) { return memory; }

 private:
  static SlipScale::State slip_of(const LayerState& state) {
    return {std::abs(state.memory), state.memory < 0 ? -1.0 : 1.0};
  }
  static double rate(Strain end, const LayerState& now, const LayerStep& step) {
    return (end.value - now.strain) / step.time;
  }
  [[nodiscard]] SlipScale::State slip_after(Strain end, const LayerState& now, const LayerStep& step) const {
    return stress_.slip().after_step(slip_of(now), rate(end, now, step), step.time, now.rate, step.last_time);
  }
  [[nodiscard]] double slip_rate(Strain end, const LayerState& now, const LayerStep& step) const {
    return stress_.slip().slip_rate(slip_after(end, now, step));
  }

  FoamStress stress_;
  double factor_ = 1;
};

}  // namespace dashpad
