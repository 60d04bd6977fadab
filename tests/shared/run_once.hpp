#pragma once
/// One run of the solver at one resolution: no refinement, no extrapolation.

#include "impact/contacts.hpp"
#include "impact/march.hpp"

namespace dashpad::test {

struct Run {
  Figures figures;
  Track track;
};

inline Run run_once(const ImpactCase& impact, double resolution, const Options& options = {}) {
  Run run;
  Contacts().visit(impact, ColumnMath::vector, [&](auto& contact) {
    March march(impact, contact, options);
    run.figures = march.run(resolution, run.track);
  });
  return run;
}

}  // namespace dashpad::test
