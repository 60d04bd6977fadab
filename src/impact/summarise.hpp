#pragma once
/// The summary of an impact from the figures of its runs.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "impact/refinement.hpp"

namespace dashpad {

/// All but steps and wall time. `finest`: the history of the finest run; `tolerance` that was asked for.
Summary summarise(const ImpactCase& impact, const Refinement& refinement, const History& finest,
                  double tolerance);

}  // namespace dashpad
