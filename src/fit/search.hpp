#pragma once
/// From the starts to the best minimum.

#include <atomic>

#include "dashpad/fit/report.hpp"
#include "fit/problem.hpp"
#include "fit/session.hpp"
#include "fit/solve.hpp"

namespace dashpad::fit {

/// The problem as searches see it. They end soon once the session is stopped.
LeastSquares least_squares_of(const Problem& problem, const Session& session,
                              std::atomic<std::size_t>& evaluations);

/// The best of the starts that converged, or the best of all. The report gets how many came to it.
Minimum search(const Fit& fit, const Problem& problem, const LeastSquares& residuals, Session& session,
               FitReport& report);

}  // namespace dashpad::fit
