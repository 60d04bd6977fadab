#pragma once
/// Runs at halved resolution, compared: extrapolated figures and their error estimates.
///
/// The step is of second order, so two runs k-1 and k give (theory.md, Eq. 31)
///
///   x_k* = x_k + (x_k - x_(k-1)) / 3,     error estimate of x_k*:  max(|x_k* - x_(k-1)*|, |x_k* - x_k|)
///
/// with the first run's figures as they are for x_1*; two runs will do only for coarse tolerances, where they
/// agree to half of it. The second term, the last correction itself, keeps a chance agreement of two
/// extrapolations from passing for accuracy. That is held to the tolerance, and said three times as large.
/// It is an estimate, on the safe side where the order is 2, and no bound. A run that was given up, or came
/// to figures that are no numbers, changes nothing of what the runs before it agreed on.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "impact/figures.hpp"

namespace dashpad {

class Refinement {
 public:
  Refinement(const Impactor& impactor, double tolerance);

  /// Whether the run is the last of those whose figures are reported.
  bool add(const Figures& run);
  [[nodiscard]] int runs() const { return runs_; }
  /// Whether the error estimates and the energy residual are within the tolerance. Not held to it but to
  /// 1 %: the time of the peak force; and the absorbed share is held to ten times the tolerance, relative to
  /// itself.
  [[nodiscard]] bool is_met() const { return is_met_; }
  /// Whether no more runs are wanted: within half of a tolerance below 1e-3, or within all of it twice.
  [[nodiscard]] bool settled() const { return settled_; }
  /// Whether the figures come from two runs that ended alike.
  [[nodiscard]] bool runs_compared() const { return compared_; }
  /// The extrapolated figures.
  [[nodiscard]] const Figures& figures() const { return reported_; }
  [[nodiscard]] const ErrorEstimates& errors() const { return errors_; }

 private:
  void judge(const Figures& run, const Figures& before);

  double speed_;
  double energy_;  ///< of the impact, J
  double tolerance_;
  int runs_ = 0;
  bool settled_ = false;
  bool compared_ = false;
  bool has_sound_run_ = false;
  bool is_met_ = false;
  bool reloads_alike_ = false;  ///< the last two runs
  Figures last_run_;            ///< that was sound
  Figures extrapolated_;        ///< to it
  Figures reported_;
  ErrorEstimates errors_;
  double rebound_error_ = 0, bottomed_error_ = 0;  ///< of the last comparison alone
};

// The summary of an impact from the figures of its runs.

/// All but steps and wall time. `finest`: the history of the finest run; `tolerance` that was asked for.
Summary summarise(const ImpactCase& impact, const Refinement& refinement, const History& finest,
                  double tolerance);

}  // namespace dashpad
