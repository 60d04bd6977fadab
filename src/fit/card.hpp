#pragma once
/// A fit as a material card.

#include <span>

#include "dashpad/fit/report.hpp"

namespace dashpad::fit {

/// The material with its origin: files, points, misfit, and what the data leave open as reservations.
Material card_of(const Fit& fit, std::span<const double> values, const FitReport& report);

}  // namespace dashpad::fit
