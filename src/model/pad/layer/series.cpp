#include "model/pad/layer/series.hpp"

#include <algorithm>
#include <cmath>

#include "model/root.hpp"

namespace dashpad {
LayerSeries::LayerSeries(const std::vector<Part>& parts) {
  for (const Part& part : parts) {
    layers_.push_back(made_layer(part.law, part.factor));
    thicknesses_.push_back(part.thickness);
    thickness_ += part.thickness;
  }
  slow_ = made_slow_curve();
  min_stress_ = 1e-9 * slow_.at(strain_of(0.1)).stress;
}

double LayerSeries::memory_at_rest(std::size_t layer) const {
  return std::visit([](const auto& given) { return given.memory_at_rest; }, layers_[layer]);
}
double LayerSeries::memory_off_contact(std::size_t layer, double memory) const {
  return std::visit([&](const auto& given) { return given.memory_off_contact(memory); }, layers_[layer]);
}

LayerState LayerSeries::after(std::size_t layer, double end, const LayerState& now,
                              const LayerStep& step) const {
  return std::visit([&](const auto& given) { return given.after(end, now, step); }, layers_[layer]);
}

LayerSeries::Solution LayerSeries::solve(const Shortening& wanted, const LayerStates& now,
                                         const LayerStep& step, const ColumnGuess& guess,
                                         double precision) const {
  Solution found;
  if (wanted.y <= 0) {
    found.strain.fill({wanted.y / thickness_, wanted.gap / thickness_});
    return found;
  }
  // A trial may go beyond full compression.
  const double min_gap = 2 * SearchStrain::min_complement * thickness_;
  const Shortening end = wanted.gap > min_gap ? wanted : Shortening{thickness_ - min_gap, min_gap};
  StepSolver at(layers_, thicknesses_, now, step, precision);
  at.begin(guess);
  const double first = std::max(guess.stress, min_stress_);
  const double scale = std::max(first, slow_.at({end.y / thickness_, end.gap / thickness_}).stress);
  // A column without stress is likely to remain so.
  double stress = min_stress_;
  bool is_free = guess.stress <= min_stress_ && at.excess(stress, end) > 0;
  if (!is_free) {
    at.begin(guess);
    if (!at.settle(end, min_stress_, stress)) {
      at.begin(guess);
      stress = increasing_root([&](double value) { return at.excess(value, end); },
                               {.guess = first,
                                .slope = guess.total_flexibility,
                                .low = min_stress_,
                                .high = 1e200,
                                .stride = scale / 4,
                                .precision = 1e-12 * scale})
                   .x;
      is_free = stress == min_stress_ && at.last_excess() > 0;
    }
  }
  const double excess = at.last_excess();
  found.looks = at.looks();
  found.nested_looks = at.nested_looks();
  found.flexibility = at.flexibility();
  found.stress = is_free ? -excess / std::max(found.flexibility, 1e-300) : stress;
  for (std::size_t i = 0; i < size(); ++i) {
    const StrainOfStress& layer = at.layer(i);
    found.layer_flexibility[i] = layer.flexibility;
    if (is_free) {
      // The column is free of stress: its layers share the remaining shortening in proportion (Eq. 53).
      const double share = end.y / (end.y + excess);
      found.strain[i] = {layer.strain.value * share, 1 - layer.strain.value * share};
    } else {
      // The layers share the excess of the last evaluation by their flexibility.
      const double change =
          excess * (found.flexibility > 0 ? layer.flexibility / found.flexibility : 1 / thickness_);
      found.strain[i] = {layer.strain.value - change, layer.strain.complement + change};
    }
  }
  return found;
}

double LayerSeries::stress_rate_when_held(const LayerStates& state) const {
  std::array<LayerTangent, max_layers> tangent;
  for (std::size_t i = 0; i < size(); ++i)
    tangent[i] = std::visit([&](const auto& layer) { return layer.tangent(state[i]); }, layers_[i]);
  // The rate r of the stress solves sum L_i (r - relaxing_i) / slope_i = 0 with the slope of the side to
  // which each layer moves. It is piecewise linear, rising and convex in r, so Newton's method descends to
  // the root and ends once no layer changes its side.
  double rate = 0;
  for (std::size_t k = 0; k <= size() + 1; ++k) {
    double relaxing = 0;
    double flexibility = 0;
    for (std::size_t i = 0; i < size(); ++i) {
      const double slope = rate >= tangent[i].relaxing ? tangent[i].loading : tangent[i].unloading;
      const double soft = thicknesses_[i] / std::max(slope, 1e-300);
      relaxing += soft * tangent[i].relaxing;
      flexibility += soft;
    }
    const double next = relaxing / flexibility;
    if (next == rate) break;
    rate = next;
  }
  return rate;
}

FoamCurve LayerSeries::made_slow_curve() const {
  constexpr int points = 96;
  constexpr double last = 0.9;
  // The layer with the largest exponent is the last to close; the others have a vanishing share of the gap.
  double exponent = 0;
  for (const Layer& layer : layers_)
    exponent =
        std::max(exponent, std::visit([](const auto& given) { return given.closing_exponent(); }, layer));
  TableCurve table;
  double stress = 0;
  for (int k = 1; k <= points; ++k) {
    const double share = double(k) / points;
    const double strain = last * share * share;
    const IncreasingRoot root = increasing_root(
        [&](double at) {
          double sum = -strain * thickness_;
          for (std::size_t i = 0; i < size(); ++i) sum += thicknesses_[i] * slow_strain(i, at);
          return sum;
        },
        {.guess = k == 1 ? slow_stress(0, strain)
                         : stress * share * share * points * points / ((k - 1.0) * (k - 1.0)),
         .low = stress,
         .high = 1e200,
         .stride = std::max(stress, slow_stress(0, strain)) / 4,
         .precision = 1e-9 * std::max(stress, slow_stress(0, strain))});
    stress = std::max(root.x, stress * (1 + 1e-9));
    table.strain.push_back(strain);
    table.stress.push_back(stress);
  }
  return FoamCurve(table, exponent > 0 ? exponent : 1);
}

double LayerSeries::slow_stress(std::size_t layer, double strain) const {
  return std::visit([&](const auto& given) { return given.slow_stress(strain_of(strain)); }, layers_[layer]);
}
double LayerSeries::slow_strain(std::size_t layer, double stress) const {
  return std::visit(
      [&](const auto& given) {
        return strain_at(stress, 0.1, 0, 0.1, [&](Strain strain) { return given.slow_stress(strain); })
            .strain.value;
      },
      layers_[layer]);
}

}  // namespace dashpad
