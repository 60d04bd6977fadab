#pragma once
/// The factor of a card's stresses in a case, from a plain scale, a density and a temperature.
///
///   factor = scale (density / density of the card)^exponent t(temperature)          (theory.md, Eq. 39)
///
/// Every stress of a law is multiplied, loading and unloading alike; strains, rates and times are unchanged.

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/model/pad/material.hpp"

namespace dashpad {

/// Condition of a pad beside its card.
struct PadCondition {
  double scale = 1;                   ///< [1e-3, 1e3]
  std::optional<double> density;      ///< kg/m3, > 0; needs a card with a density law
  std::optional<double> temperature;  ///< K, > 0; needs a card with a temperature table

  static const std::array<Parameter<PadCondition>, 3> parameters;

  friend bool operator==(const PadCondition&, const PadCondition&) = default;
};

/// The admissible densities and temperatures depend on the card, too (violations()).
inline constexpr std::array<Parameter<PadCondition>, 3> PadCondition::parameters{{
    {"scale", "", "1", &PadCondition::scale, from_to(1e-3, 1e3), "factor applied to the foam's stress",
     LeftOut::as_default},
    {"density", "", "kg/m3", &PadCondition::density, positive, "density of the foam", LeftOut::as_default},
    {"temperature", "", "K", &PadCondition::temperature, above_to(0, 2000), "temperature of the foam",
     LeftOut::as_default},
}};

/// Every rule that a condition breaks on this material; keys are those within the table: `density`.
std::vector<Violation> violations(const PadCondition& condition, const Material& material);

/// Factor of all stresses of the card (theory.md, Eq. 39). The condition must be sound.
double stress_factor(const PadCondition& condition, const Material& material);

/// The law with all its stresses times a factor.
PadLaw scaled(const PadLaw& law, double factor);

/// Reasons why a result under this condition is extrapolated.
std::vector<Extrapolation> extrapolations(const PadCondition& condition, const Material& material);

}  // namespace dashpad
