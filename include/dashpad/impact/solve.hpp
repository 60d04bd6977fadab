#pragma once
/// The impact solver.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Solves one impact (theory.md, section 4): the sphere's motion M d2X/dt2 = -F with the pad's force F(Y) in
/// equilibrium with the support, F = Fs(X - Y), at three or more resolutions until their differences say that
/// the tolerance is met. Never throws for a valid case: what goes wrong numerically is in the status.
/// Throws std::invalid_argument that names every broken rule for a case with violations() or for options out
/// of range.
Solution solve(const ImpactCase& impact, const Options& options = {});

}  // namespace dashpad
