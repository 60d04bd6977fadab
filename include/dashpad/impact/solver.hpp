#pragma once
/// The impact solver for many impacts, one after the other: memory is taken once.

#include <functional>
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

  /// Called with each blow of a series in turn: the pad as that blow meets it, and what came of it.
  using BlowVisitor = std::function<void(const ImpactCase&, const Solution&)>;
  /// Solves the blows of a series, or the only one, as solve_blows() of dashpad/impact/blows.hpp.
  void solve_each_blow(const ImpactCase& impact, const Options& options, const BlowVisitor& visit);

 private:
  struct Memory;
  std::unique_ptr<Memory> memory_;
};

}  // namespace dashpad
