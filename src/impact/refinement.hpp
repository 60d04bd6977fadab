#pragma once
/// Comparison of runs at halved resolution: extrapolated figures and their error estimates.
///
/// The step is of second order, so two runs k-1 and k give (theory.md, Eq. 31)
///
///   x_k* = x_k + (x_k - x_(k-1)) / 3,     error estimate of x_k*:  max(|x_k* - x_(k-1)*|, |x_k* - x_k|)
///
/// where x_1* = x_1. The second term, the last correction itself, keeps a chance agreement of two
/// extrapolations from passing for accuracy. Of two runs a third of it is taken, since the first is compared
/// with its own error, plus the largest difference of their velocities and motions at any time, which no
/// chance makes small; they suffice for coarse tolerances, as do the last two of more runs for peaks. The
/// estimate is held to the tolerance, and reported three times as large. It is on the safe side where the
/// order is 2, and no bound. A run that was given up or has figures that are not finite changes nothing of
/// the earlier agreement.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/constants.hpp"
#include "impact/figures.hpp"

namespace dashpad {

class Refinement {
 public:
  Refinement(const ImpactCase& impact, double tolerance);

  /// Adds a run and returns whether it is the finest whose figures are reported. `apart` is the distance of
  /// the run from the one before (distance_between()); without it two runs never suffice.
  bool add(const Figures& run, double apart = infinite);
  [[nodiscard]] int runs() const { return runs_; }
  /// Whether the errors of the next run may depend on its distance from the last.
  [[nodiscard]] bool asks_for_distance() const { return runs_ == 1 || allows_two_; }
  /// Whether error estimates and energy residual are within the tolerance; the time of the peak force only to
  /// 1 %, the absorbed share to ten times the tolerance relative to itself.
  [[nodiscard]] bool is_met() const { return is_met_; }
  /// Whether no more runs are needed: within the tolerance, below 1e-3 within half of it or twice within it.
  [[nodiscard]] bool settled() const { return settled_; }
  /// Whether the figures come from two runs that ended alike.
  [[nodiscard]] bool runs_compared() const { return compared_; }
  /// The extrapolated figures.
  [[nodiscard]] const Figures& figures() const { return reported_; }
  [[nodiscard]] const ErrorEstimates& errors() const { return errors_; }

 private:
  void judge(const Figures& run, const Figures& before, double apart);

  double speed_;
  double energy_;             ///< impact energy, J
  bool has_corners_at_once_;  ///< of the support, where its speed jumps
  double tolerance_;
  bool allows_two_;  ///< whether the tolerance is one for which two runs may suffice
  int runs_ = 0;
  bool settled_ = false;
  bool compared_ = false;
  bool has_sound_run_ = false;
  bool is_met_ = false;
  bool reloads_alike_ = false;  ///< whether the last two runs reload alike
  Figures last_run_;            ///< last sound run
  Figures extrapolated_;        ///< extrapolated figures of the last sound run
  Figures reported_;
  ErrorEstimates errors_;
  double rebound_change_ = 0, bottomed_change_ = 0;  ///< by the last comparison alone
};

/// Largest difference of two runs at any time: of the velocities relative to the impact speed, or of the
/// motions relative to the largest. The fine one is a cubic in its steps, compared at the times of the
/// coarse.
double distance_between(const History& fine, const History& coarse, const Impactor& impactor);

// The summary of an impact from the figures of its runs.

/// The summary without steps and wall time. `finest` is the finest history, `tolerance` the one asked for.
Summary summarise(const ImpactCase& impact, const Refinement& refinement, const History& finest,
                  double tolerance);

}  // namespace dashpad
