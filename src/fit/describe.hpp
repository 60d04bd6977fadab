#pragma once
/// What a fit found, for people and programs.

#include "dashpad/fit/report.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"

namespace dashpad::fit {

/// What is said of the minimum, its uncertainty and the data, but for the time.
void describe(const Fit& fit, const Problem& problem, const Solved& solved, FitReport& report);

}  // namespace dashpad::fit
