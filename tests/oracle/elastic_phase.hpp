#pragma once
/// The elastic pad in the CVODE oracle: its force is a function of the penetration, so three unknowns do.

#include "oracle/impact_run.hpp"

namespace dashpad::oracle {

/// Whole impact on a pad of law 1, modulus in Pa.
void solve_elastic(ImpactRun& run, double modulus);

}  // namespace dashpad::oracle
