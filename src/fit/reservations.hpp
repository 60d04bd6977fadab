#pragma once
/// What a user of a fitted foam has to keep in mind.

#include <span>
#include <string>
#include <vector>

#include "dashpad/fit/report.hpp"

namespace dashpad::fit {

/// A sentence each; what the card said that the fit started from comes last, unless it is about an unknown.
std::vector<std::string> reservations_of(const Fit& fit, std::span<const double> values,
                                         const FitReport& report);

}  // namespace dashpad::fit
