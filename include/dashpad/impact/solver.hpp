#pragma once
/// The impact solver for many impacts, one after the other: memory is taken once.

#include <memory>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Not for several threads at once: one each.
class Solver {
 public:
  Solver();
  ~Solver();
  Solver(Solver&&) noexcept;
  Solver& operator=(Solver&&) noexcept;

  /// As solve() of dashpad/impact/solve.hpp; the solution stays valid until the next call.
  const Solution& solve(const ImpactCase& impact, const Options& options = {});

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace dashpad
