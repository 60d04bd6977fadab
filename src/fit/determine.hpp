#pragma once
/// The minimum of a fit with its uncertainty.

#include <vector>

#include "dashpad/fit/report.hpp"
#include "fit/problem.hpp"
#include "fit/profile.hpp"
#include "fit/session.hpp"
#include "fit/solve.hpp"
#include "fit/uncertainty.hpp"

namespace dashpad::fit {

struct Solved {
  Minimum minimum;
  Uncertainty uncertainty;
  std::vector<ProfileEnd> below, above;  ///< of each coordinate
};

/// From a minimum to the best one that profiles from there meet, with its profiles; report.converged says
/// whether it is one. Noise that nobody stated is put into the problem.
Solved determine(Problem& problem, const LeastSquares& residuals, Minimum minimum, Session& session,
                 FitReport& report);

}  // namespace dashpad::fit
