#pragma once
/// One run of the solver at one resolution: no refinement, no extrapolation.

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "impact/figures.hpp"

namespace dashpad::test {

struct Run {
  Figures figures;
  Track track;
};

[[nodiscard]] Run run_once(const ImpactCase& impact, double resolution, const Options& options = {});

}  // namespace dashpad::test
