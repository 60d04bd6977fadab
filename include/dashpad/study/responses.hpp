#pragma once
/// What a study keeps of each impact: figures of the summary and of the pulse, by name.

#include <limits>
#include <span>
#include <string>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad::study {

struct ResponseKind {
  const char* name;     ///< "peak_force", "hic15", ... as in results JSON
  const char* unit;     ///< SI
  const char* meaning;
  bool of_pulse;        ///< an injury figure: needs the history
};
const std::vector<ResponseKind>& response_kinds();

/// The outcome of a row.
struct Outcome {
  Status status = Status::not_run;
  bool extrapolated = false;
  bool bottomed = false;
  double error = 0;            ///< largest relative error estimate of the figures kept
  std::vector<double> values;  ///< NaN where the impact has none (no rebound speed without a release)
};

/// Fills `outcome.values`, one for each name.
void read_responses(const Solution& solution, std::span<const std::string> names, Outcome& outcome);

}  // namespace dashpad::study
