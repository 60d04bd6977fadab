#pragma once
/// By what the stresses of a card are multiplied in a case: a plain scale, another density, another
/// temperature.
///
///   factor = scale (density / density of the card)^exponent t(temperature)          (theory.md, Eq. 39)
///
/// Every stress of a law is multiplied, loading and unloading alike; strains, rates and times stay.

#include <optional>
#include <string>
#include <vector>

#include "dashpad/model/pad/material.hpp"

namespace dashpad {

/// What a case says of its pad beside the card.
struct PadCondition {
  double scale = 1;                   ///< [1e-3, 1e3]
  std::optional<double> density;      ///< kg/m3, > 0; needs a card with a density law
  std::optional<double> temperature;  ///< K, > 0; needs a card with a temperature table

  friend bool operator==(const PadCondition&, const PadCondition&) = default;
};

/// Every rule that a condition breaks on this material; keys are those of cases, without `pad.`: `density`.
std::vector<Violation> violations(const PadCondition& condition, const Material& material);

/// The condition must be sound.
double stress_factor(const PadCondition& condition, const Material& material);

/// The law with all its stresses times a factor.
PadLaw scaled(const PadLaw& law, double factor);

/// Why a result under this condition is extrapolated, a reason each.
std::vector<Extrapolation> extrapolations(const PadCondition& condition, const Material& material);

}  // namespace dashpad
