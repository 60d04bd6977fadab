#pragma once
/// A fit as a material card, and as a case.

#include <optional>
#include <span>
#include <vector>

#include "dashpad/fit/report.hpp"

namespace dashpad::fit {

/// Significant digits of what a card says was found: figures by it are those of the fit to 1e-4 and better.
inline constexpr int card_digits = 6;

/// The material with its origin: files, points, misfit, and what the data leave open as reservations. A scale
/// of the pad that was fitted is in all its stresses.
Material card_of(const Fit& fit, std::span<const double> values, const FitReport& report);

/// The case with what was found of it, but for its foam, which is that of the finished card; nothing where
/// only numbers of a card were sought.
std::optional<FittedCase> fitted_case_of(const Fit& fit, std::span<const double> values);

/// Whether a material comes from a card, or says itself where it was tested.
bool is_stated(const Material& material);

/// Largest strain rate of an impact with these values of the unknowns, 1/s.
double rate_of(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values);

}  // namespace dashpad::fit
