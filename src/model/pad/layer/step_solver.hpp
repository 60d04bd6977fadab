#pragma once
/// Strains of all layers after a step, by the stress there (theory.md, Eq. 52). Each is the next guess.

#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include "model/pad/layer/layer.hpp"

namespace dashpad {

/// A number for each layer, from the struck face on.
using PerLayer = std::array<double, max_layers>;
using LayerStates = std::array<LayerState, max_layers>;

/// Shortening of a column, m.
struct Shortening {
  double y = 0;    ///< below 0 where the nose does not reach the column
  double gap = 0;  ///< L - y, without cancellation
};

/// Guess of the solution of a step.
struct ColumnGuess {
  double stress = 0;
  PerLayer strain{};
  PerLayer flexibility{};        ///< d(strain)/d(stress) of each layer, 1/Pa; 0: not known
  double total_flexibility = 0;  ///< dy/d(stress), m/Pa; 0: not known
};

class StepSolver {
 public:
  /// The arguments must outlive the solver. `share` is the precision of settle(), as a share of the change of
  /// each strain over the step.
  StepSolver(const std::vector<Layer>& layers, const std::vector<double>& thicknesses, const LayerStates& now,
             const LayerStep& step, double share)
      : layers_(layers), thicknesses_(thicknesses), now_(now), step_(step), share_(share) {}

  void begin(const ColumnGuess& guess);
  /// Solves for all layers at once, by secants from the guess on; false if they do not settle soon, or not
  /// above `min_stress`. Each evaluation gives stress and slope of every layer, and so the next guess: half
  /// as many evaluations as the fallback, a root within a root.
  bool settle(const Shortening& end, double min_stress, double& stress);
  /// y at a stress less that of `end`, m.
  double excess(double stress, const Shortening& end);

  [[nodiscard]] double last_excess() const { return excess_; }
  [[nodiscard]] double flexibility() const { return flexibility_; }  ///< dy/d(stress), m/Pa
  [[nodiscard]] const StrainOfStress& layer(std::size_t i) const { return last_[i]; }
  /// Number of layer stresses computed, and of those for a root within a root.
  [[nodiscard]] std::size_t looks() const { return looks_; }
  [[nodiscard]] std::size_t nested_looks() const { return nested_looks_; }

 private:
  double stress_of(std::size_t i, Strain strain) {
    ++looks_;
    return std::visit([&](const auto& layer) { return layer.stress(strain, now_[i], step_); }, layers_[i]);
  }
  void look(std::size_t i, double stress);

  const std::vector<Layer>& layers_;
  const std::vector<double>& thicknesses_;
  const LayerStates& now_;
  const LayerStep& step_;
  double share_;
  double last_stress_ = 0;
  std::array<StrainOfStress, max_layers> last_;
  PerLayer stride_{};
  PerLayer precision_{};
  double excess_ = 0;
  double flexibility_ = 0;
  std::size_t looks_ = 0;
  std::size_t nested_looks_ = 0;
};

}  // namespace dashpad
