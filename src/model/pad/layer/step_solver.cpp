#include "model/pad/layer/step_solver.hpp"

#include <cmath>

namespace dashpad {
namespace {

double within_layer(double strain) { return std::clamp(strain, 0.0, 1 - SearchStrain::min_complement); }

/// Sum of L_i e_i less y, layer by layer; near full compression by the gaps, which keep their digits.
struct Excess {
  explicit Excess(const Shortening& end) : by_gap(end.gap < end.y), value(by_gap ? end.gap : -end.y) {}
  void add(double thickness, Strain strain) {
    value += by_gap ? -thickness * strain.complement : thickness * strain.value;
  }
  bool by_gap;
  double value;
};

}  // namespace

void StepSolver::begin(const ColumnGuess& guess) {
  last_stress_ = guess.stress;
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    last_[i] = {strain_of(within_layer(guess.strain[i])), guess.flexibility[i]};
    const double change = std::abs(guess.strain[i] - now_[i].strain);
    stride_[i] = std::max(change, 1e-6);
    precision_[i] = std::max(share_ * change, SearchStrain::precision);
  }
}

double StepSolver::excess(double stress, const Shortening& end) {
  flexibility_ = 0;
  Excess excess(end);
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    look(i, stress);
    excess.add(thicknesses_[i], last_[i].strain);
    flexibility_ += thicknesses_[i] * last_[i].flexibility;
  }
  last_stress_ = stress;
  return excess_ = excess.value;
}

void StepSolver::look(std::size_t i, double stress) {
  StrainOfStress& last = last_[i];
  const double change = (stress - last_stress_) * last.flexibility;
  const double x = change == 0 ? SearchStrain::of(last.strain)
                               : SearchStrain::of(strain_of(within_layer(last.strain.value + change)));
  const double slope = last.flexibility > 0 ? SearchStrain::slope(last.strain) / last.flexibility : 0;
  last = std::visit(
      [&](const auto& layer) {
        return strain_at(stress, std::min(x, SearchStrain::most()), slope, stride_[i], [&](Strain strain) {
          ++looks_, ++nested_looks_;
          return layer.stress(strain, now_[i], step_);
        });
      },
      layers_[i]);
}

bool StepSolver::settle(const Shortening& end, double min_stress, double& stress) {
  constexpr int most = 8;
  // A last step by the slope of a chord is wrong by step times chord times curvature, usually below 100.
  constexpr double inverse_of_curvature = 1e-2;
  PerLayer x{}, before{}, value{}, slope{}, chord{};
  for (std::size_t i = 0; i < layers_.size(); ++i) {
    if (!(last_[i].flexibility > 0)) return false;
    slope[i] = SearchStrain::slope(last_[i].strain) / last_[i].flexibility;
    x[i] = SearchStrain::of(last_[i].strain);
    chord[i] = 1;
  }
  for (int k = 0; k < most; ++k) {
    Excess excess(end);
    double weighted = 0;
    flexibility_ = 0;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const Strain strain = SearchStrain::strain(x[i]);
      const double now = stress_of(i, strain);
      // If the step is shorter than the precision, its slope is rounding: the guessed slope is kept.
      if (k > 0) {
        chord[i] = std::abs(x[i] - before[i]);
        if (chord[i] > SearchStrain::precision) slope[i] = (now - value[i]) / (x[i] - before[i]);
        if (!(slope[i] > 0)) return false;
      }
      value[i] = now;
      last_[i] = {strain, SearchStrain::slope(strain) / slope[i]};
      excess.add(thicknesses_[i], strain);
      weighted += thicknesses_[i] * last_[i].flexibility * now;
      flexibility_ += thicknesses_[i] * last_[i].flexibility;
    }
    stress = (weighted - excess.value) / flexibility_;
    if (!(stress > min_stress)) return false;
    bool settled = true;
    for (std::size_t i = 0; i < layers_.size(); ++i) {
      const double step = (stress - value[i]) / slope[i];
      settled = settled && std::abs(step) * std::min(chord[i] / inverse_of_curvature, 1.0) <= precision_[i];
      before[i] = x[i];
      x[i] += step;
      if (!(x[i] >= 0 && x[i] < SearchStrain::most())) return false;
    }
    if (!settled) continue;
    for (std::size_t i = 0; i < layers_.size(); ++i) last_[i].strain = SearchStrain::strain(x[i]);
    last_stress_ = stress;
    excess_ = 0;
    return true;
  }
  return false;
}

}  // namespace dashpad
