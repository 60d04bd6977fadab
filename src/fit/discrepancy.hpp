#pragma once
/// By what the law misses impacts that it was not fitted to: what a card says of that (theory.md, section 6).

#include <atomic>
#include <optional>
#include <span>
#include <vector>

#include "dashpad/fit/report.hpp"
#include "dashpad/model/pad/uncertainty.hpp"
#include "fit/problem.hpp"
#include "fit/session.hpp"

namespace dashpad::fit {

/// Each fitted impact as a fit to the others predicts it: the search goes on without it from the minimum `x`.
/// Of more than most_left_out impacts, several are left out together. Nothing of impacts without which there
/// is no fit.
std::vector<ImpactComparison> left_out(const Fit& fit, const Problem& problem, std::span<const double> x,
                                       int runs, Session& session, std::atomic<std::size_t>& evaluations);

inline constexpr std::size_t most_left_out = 8;

/// Standard deviations of what the law misses. `predicted`: of impacts that were not fitted; `fitted`: the
/// others, which count where nothing was predicted. Nothing without impacts.
///
///   s^2 = (n0 s0^2 + sum of squared shares) / (n0 + n),   times t(n0 + n) / t(infinity), both at 97.5 %
///
/// s0 is how sure a law of few numbers is at best, 2 % of stresses, and counts like n0 impacts.
std::optional<Misfit> misfit_of(std::span<const ImpactComparison> predicted,
                                std::span<const ImpactComparison> fitted);

}  // namespace dashpad::fit
