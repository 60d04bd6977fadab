#pragma once
/// Two answers of the solver to the same impact: the fast path (columns by vectors, closed form of the
/// loading) and the plain one, or an answer and one to a fraction of its tolerance, which is as good as the
/// truth.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solve.hpp"

namespace dashpad::test {

/// A figure of both answers. Differences and estimates are relative to that of the reference; of a speed to
/// at least 1e-3 of the impact speed, as in ErrorEstimates.
struct ComparedFigure {
  const char* name = "";
  double value = 0;
  double reference = 0;
  double difference = 0;
  double estimates = 0;  ///< sum of the two

  [[nodiscard]] bool explained() const { return difference <= estimates; }
};

struct AnswerComparison {
  Status status = Status::not_run;
  Status reference_status = Status::not_run;
  /// Of impacts that both answers call trustworthy with the same status: peak force, peak penetration,
  /// rebound speed, end of contact, where there are such.
  std::vector<ComparedFigure> figures;
  bool same_figures = true;   ///< none is there in one answer only
  double wall_time = 0;       ///< s
  double reference_time = 0;  ///< s

  [[nodiscard]] bool compared() const { return !figures.empty(); }
  /// No figure differs by more than `allowed`.
  [[nodiscard]] bool alike(double allowed) const;
  /// One line.
  [[nodiscard]] std::string text() const;
};

AnswerComparison compare_answers(Solver& solver, const ImpactCase& impact, const Options& options,
                                 const Options& of_reference);

/// Work of one run is bounded, so that a few extreme cases do not take all the time.
inline constexpr std::size_t steps_of_comparison = 3000;

/// Each path may be in error by the tolerance: twice that is allowed.
inline AnswerComparison compare_paths(Solver& solver, const ImpactCase& impact, double tolerance) {
  return compare_answers(solver, impact, {.tolerance = tolerance, .max_steps = steps_of_comparison},
                         {.tolerance = tolerance, .max_steps = steps_of_comparison, .plain = true});
}

}  // namespace dashpad::test
