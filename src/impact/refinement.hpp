#pragma once
/// Runs at halved resolution, compared: extrapolated figures and their error estimates.
///
/// The step is of second order, so two runs k-1 and k give (theory.md, Eq. 25)
///
///   x_k* = x_k + (x_k - x_(k-1)) / 3,     error of x_k*  <=  max(|x_k* - x_(k-1)*|, |x_k* - x_k| / 10)
///
/// The second bound keeps a chance agreement of two extrapolations from passing for accuracy.

#include <array>
#include <cstddef>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "impact/figures.hpp"

namespace dashpad {

class Refinement {
 public:
  static constexpr int most_runs = 9;

  Refinement(const Impactor& impactor, double tolerance);

  void add(const Figures& run);
  [[nodiscard]] int runs() const { return runs_; }
  /// Whether every error estimate and the energy residual are within the tolerance.
  [[nodiscard]] bool settled() const { return settled_; }
  /// The extrapolated figures.
  [[nodiscard]] const Figures& figures() const { return extrapolated_; }
  [[nodiscard]] const ErrorEstimates& errors() const { return errors_; }

 private:
  void judge(const Figures& run, const Figures& before);

  double speed_;
  double energy_;  ///< of the impact, J
  double tolerance_;
  int runs_ = 0;
  bool settled_ = false;
  Figures last_run_;
  Figures extrapolated_;
  ErrorEstimates errors_;
};

}  // namespace dashpad
