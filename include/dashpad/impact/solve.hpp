#pragma once
/// The impact solver.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Solves one impact (theory.md, section 4): the motion of the impactor, M d2X/dt2 = M g - F, with the force
/// F of the pad in equilibrium with what carries it (theory.md, Eqs. 4, 41 and 42), at successively halved
/// resolutions (two at least) until the estimated errors are within the tolerance. Of repeated blows
/// (ImpactCase::blows) the solution is that of the last; solve_blows() of dashpad/impact/blows.hpp returns
/// them all. Never throws for a valid case: what goes wrong numerically is in the status. Throws
/// std::invalid_argument that names every broken rule for a case with violations() or for options out of
/// range.
Solution solve(const ImpactCase& impact, const Options& options = {});

}  // namespace dashpad
