#pragma once
/// The fast path (columns by vectors, closed form of the loading) and the plain one on the same impact.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solver.hpp"

namespace dashpad::test {

/// A figure by both paths. Differences and estimates are relative to the plain figure; of a speed to at least
/// 1e-3 of the impact speed, as in ErrorEstimates.
struct PathFigure {
  const char* name = "";
  double fast = 0;
  double plain = 0;
  double difference = 0;
  double estimates = 0;  ///< sum of the two

  /// Each path may be in error by the tolerance.
  [[nodiscard]] bool alike(double tolerance) const { return difference <= 2 * tolerance; }
  [[nodiscard]] bool explained() const { return difference <= estimates; }
};

struct PathComparison {
  Status fast = Status::not_run;
  Status plain = Status::not_run;
  /// Of impacts that both paths call trustworthy with the same status: peak force, peak penetration, rebound
  /// speed, end of contact, where there are such.
  std::vector<PathFigure> figures;
  bool same_figures = true;  ///< none is there on one path only
  double fast_time = 0;      ///< s
  double plain_time = 0;     ///< s

  [[nodiscard]] bool compared() const { return !figures.empty(); }
  [[nodiscard]] bool alike(double tolerance) const;
  /// One line.
  [[nodiscard]] std::string text() const;
};

/// Work of one run is bounded by `most_steps`, so that a few extreme cases do not take all the time.
PathComparison compare_paths(Solver& solver, const ImpactCase& impact, double tolerance,
                             std::size_t most_steps = 3000);

}  // namespace dashpad::test
