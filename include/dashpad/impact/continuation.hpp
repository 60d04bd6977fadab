#pragma once
/// What a result beyond the last tested strain of a foam hangs on.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Solves the impact twice more where its foam was strained beyond its curve: with the gentlest and with the
/// steepest continuation that the card admits (theory.md, Eq. 37). The peaks are left in the summary. Nothing
/// is done where the curve sufficed, or for a law without curves.
void explore_continuation(const ImpactCase& impact, const Options& options, Summary& summary);

}  // namespace dashpad
