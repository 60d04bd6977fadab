#pragma once
/// Intervals of the figures of an impact by the uncertainties of foam and model (theory.md, section 6).
///
///   low = nominal - sum over ranges of (nominal - least) - 1.96 sqrt(sum of variances)              (Eq. 58)
///
/// and likewise the high end. A range (continuation, rate, way back) gives the least and the largest figure
/// over its ends, the nominal and, where these bend, a point between. A statistical source (scatter,
/// posterior, misfit, neighbours) gives 1.96 standard deviations, separately up and down.

#include <span>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::uncertainty {

/// Largest number of impacts solved for the ends of ranges and the axes of a posterior.
inline constexpr int max_impacts = 12;

/// Sets solution.summary.intervals of a solved impact. Further impacts are solved, on all cores, in two runs
/// each or to a tolerance of 1e-3, only for uncertain sources that the impact reaches. `dwell_levels` are
/// those of the wanted dwell times, m/s2. For an impact that was cut or bottomed out on a rigid support only
/// the sources are named; for one that was not run nothing is set.
///
/// Example:
/// \code
/// #include "dashpad/impact/solve.hpp"
/// dashpad::Solution solution = dashpad::solve(impact, options);
/// dashpad::uncertainty::add_intervals(impact, options, solution);
/// if (const auto& intervals = solution.summary.intervals)
///   if (const auto* const hic15 = intervals->find("hic15"))
///     std::printf("HIC15 %.0f (%.0f to %.0f)\n", hic15->nominal, hic15->low, hic15->high);
/// \endcode
void add_intervals(const ImpactCase& impact, const Options& options, Solution& solution,
                   std::span<const double> dwell_levels = {});

}  // namespace dashpad::uncertainty
