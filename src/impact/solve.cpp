#include "dashpad/impact/solve.hpp"

#include "dashpad/impact/solver.hpp"

namespace dashpad {

Solution solve(const ImpactCase& impact, const Options& options) { return Solver().solve(impact, options); }

}  // namespace dashpad
