#include "dashpad/impact/solver.hpp"

#include "dashpad/impact/solve.hpp"

namespace dashpad {

struct Solver::Memory {
  Solution solution;
};

Solver::Solver() : memory_(std::make_unique<Memory>()) {}
Solver::~Solver() = default;
Solver::Solver(Solver&&) noexcept = default;
Solver& Solver::operator=(Solver&&) noexcept = default;

const Solution& Solver::solve(const ImpactCase& impact, const Options& options) {
  memory_->solution = dashpad::solve(impact, options);
  return memory_->solution;
}

}  // namespace dashpad
