#pragma once
/// The rows of one batch: what a thread or a rank computes.

#include <cstdint>
#include <vector>

#include "dashpad/impact/solver.hpp"
#include "dashpad/study/design.hpp"
#include "dashpad/study/store.hpp"
#include "dashpad/study/study.hpp"

namespace dashpad::study {

/// One worker's memory: a solver and a case, used again for every row.
class Worker {
 public:
  Worker(const Study& study, const Design& design);
  /// Rows batch * size to (batch + 1) * size - 1, as far as the design has them.
  std::vector<StoredRow> compute(std::uint64_t batch, std::uint64_t size);
  /// One row with its history.
  Solution replay(std::uint64_t row);

 private:
  const Study& study_;
  const Design& design_;
  Solver solver_;
  ImpactCase impact_;
  std::vector<double> factors_;
};

}  // namespace dashpad::study
