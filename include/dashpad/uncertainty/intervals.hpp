#pragma once
/// How sure the figures of an impact are, by what is not known of its foam and its model (theory.md, section
/// 6).
///
///   low  = nominal - sum over ranges of (nominal - least) - 1.96 sqrt(sum of variances),   high likewise
///   (Eq. 58)
///
/// A range (continuation, rate, way back) gives the least and the greatest figure over its ends, the nominal
/// and, where these bend, points between. A statistical source (scatter, posterior, misfit, neighbours)
/// gives 1.96 standard deviations, up and down apart.

#include <span>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::uncertainty {

/// Impacts that are solved for the ends of ranges and the axes of a posterior, at most.
inline constexpr int max_impacts = 12;

/// Sets solution.summary.intervals of a solved impact. Further impacts are solved, on all cores and to a
/// tolerance of 1e-3, only for sources that are open and that the impact reaches. `dwell_levels`: m/s2, of
/// the dwell times that are asked for. Of an impact that was not run, was cut or bottomed out on a rigid
/// support only the sources are named.
void add_intervals(const ImpactCase& impact, const Options& options, Solution& solution,
                   std::span<const double> dwell_levels = {});

}  // namespace dashpad::uncertainty
