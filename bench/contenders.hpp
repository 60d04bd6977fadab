#pragma once
/// The solvers that compete, each with its settings.

#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "work_precision.hpp"

namespace dashpad::bench {

// CVODE twice: with the best of all settings for each error, which only hindsight knows, and with the columns
// that the oracle has by itself.
inline constexpr const char* tuned_cvode = "CVODE (best settings)";
inline constexpr const char* untuned_cvode = "CVODE (own columns)";

ImpactCase at_speed(ImpactCase impact, double share);

/// A Solver used again and again, solve() called anew, and single runs of the march, plain and extrapolated.
std::vector<Contender> dashpad_contenders(const ImpactCase& impact);

std::vector<Contender> cvode_contenders(const ImpactCase& impact, bool quick);

/// The program of 1984 in binary32, as printed and mended, at several time steps. Laws 2, 4 and 5.
std::vector<Contender> spit1984_contenders(const ImpactCase& impact);

/// CVODE with far finer settings than any that compete.
References reference_solutions(const ImpactCase& impact, bool quick);

/// bench/scipy_impact.py in a process of its own, judged and timed. Empty where Python has no SciPy.
std::vector<Measurement> scipy_measurements(const ImpactCase& impact, const References& references,
                                            bool quick);

}  // namespace dashpad::bench
