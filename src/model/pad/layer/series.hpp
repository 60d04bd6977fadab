#pragma once
/// A column of layers in series: one stress in all of them, and strains that add up to its shortening.
///
///   y = sum of L_i e_i,   stress_i(e_i) = stress for every layer                      (theory.md, Eq. 51)
///
/// The unknown of a step is the stress at its end. A layer's stress there rises with its strain, as steeply
/// as a jump where the layer turns, so e_i and y are single-valued, continuous, non-decreasing functions of
/// the stress (theory.md, Eq. 52): y has one root, on whatever branch each layer is.
///
/// Lengths in m, stress in Pa, compression positive.

#include <array>
#include <cstddef>
#include <vector>

#include "model/pad/foam/foam_curve.hpp"
#include "model/pad/layer/layer.hpp"
#include "model/pad/layer/step_solver.hpp"

namespace dashpad {

class LayerSeries {
 public:
  /// Data of a layer; its law must keep the rules of layer_law.hpp.
  struct Part {
    double thickness = 0;
    LayerLaw law;
    double factor = 1;  ///< factor of every stress

    friend bool operator==(const Part&, const Part&) = default;
  };
  explicit LayerSeries(const std::vector<Part>& parts);

  [[nodiscard]] std::size_t size() const { return layers_.size(); }
  [[nodiscard]] double thickness() const { return thickness_; }
  [[nodiscard]] double thickness(std::size_t layer) const { return thicknesses_[layer]; }
  [[nodiscard]] double memory_at_rest(std::size_t layer) const;
  [[nodiscard]] double memory_off_contact(std::size_t layer, double memory) const;

  /// Slow stress of the whole column over y / L: the weight of contact integrals; no result depends on it.
  [[nodiscard]] const FoamCurve& slow_curve() const { return slow_; }

  struct Solution {
    /// Pa; below 0 where the column is free of stress: the tension of a spring of its stiffness.
    double stress = 0;
    double flexibility = 0;  ///< dy/d(stress), m/Pa, >= 0
    std::array<Strain, max_layers> strain;
    PerLayer layer_flexibility{};
    std::size_t looks = 0;         ///< number of layer stresses computed
    std::size_t nested_looks = 0;  ///< those for a root within a root
  };
  /// `precision` is that of the layers' strains, as a share of their change over the step.
  [[nodiscard]] Solution solve(const Shortening& wanted, const LayerStates& now, const LayerStep& step,
                               const ColumnGuess& guess, double precision) const;

  /// The state of a layer at the end of a solved step.
  [[nodiscard]] LayerState after(std::size_t layer, double end, const LayerState& now,
                                 const LayerStep& step) const;
  /// d(stress)/dt at a held shortening, Pa/s: layers that relax more yield to the others (theory.md, Eq. 54).
  [[nodiscard]] double stress_rate_when_held(const LayerStates& state) const;

 private:
  [[nodiscard]] FoamCurve made_slow_curve() const;
  [[nodiscard]] double slow_stress(std::size_t layer, double strain) const;
  [[nodiscard]] double slow_strain(std::size_t layer, double stress) const;

  std::vector<Layer> layers_;
  std::vector<double> thicknesses_;
  double thickness_ = 0;
  FoamCurve slow_;
  double min_stress_ = 0;  ///< stress that counts as zero, Pa
};

}  // namespace dashpad
