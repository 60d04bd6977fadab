#include "model/pad/layer/layer_law.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <type_traits>

#include "dashpad/quantities/constants.hpp"
#include "model/pad/foam/foam_curve.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "model/pad/foam/foam_stress.hpp"

namespace dashpad {
namespace {

const std::string must = "a layer needs a law whose stress rises with strain: ";

/// A largest strain from which the stress rises noticeably on the way back; nothing if there is none.
std::optional<double> strain_of_falling_return(const Foam& law) {
  if (!law.unloading_curve) return std::nullopt;
  constexpr int places = 40;
  constexpr double noticed = 0.02;
  const FoamStress stress(law);
  for (int i = 1; i <= places; ++i) {
    const double largest = last_strain_of(law.curves.base) * i / places;
    double most = 0;
    for (int k = 1; k <= places; ++k) {
      const double strain = largest * k / places;
      const double value = stress.response(strain_of(strain), largest - strain, 0).stress;
      most = std::max(most, value);
      if (most - value > noticed * stress.curve().at(strain_of(largest)).stress) return largest;
    }
  }
  return std::nullopt;
}

/// A rate at which the loading curve falls noticeably, 1/s; nothing if all curves rise.
std::optional<double> falling_rate(const FoamCurves& curves) {
  if (const std::vector<double> rates = softening_rates(curves); !rates.empty()) return rates.front();
  const auto* power = std::get_if<PowerRateEffect>(&curves.rate_effect);
  if (power == nullptr || power->exponent_slope >= 0) return std::nullopt;
  // If the rate effect falls with the strain, the curve of the highest rate is the first to fall.
  constexpr int places = 400;
  constexpr double noticed = 1e-3;
  const FoamStress stress(Foam{.curves = curves, .unloading_curve = {}});
  double most = 0;
  for (int i = 1; i <= places; ++i) {
    const Strain strain = strain_of(last_strain_of(curves.base) * i / places);
    const double value = stress.response(strain, 0, power->highest_rate).stress;
    if (value < most * (1 - noticed)) return power->highest_rate;
    most = std::max(most, value);
  }
  return std::nullopt;
}

std::vector<Violation> of_curves(const FoamCurves& curves) {
  if (const auto rate = falling_rate(curves))
    return {{"rate", *rate, must + fmt::format("the curve at {:.3g} per second falls", *rate)}};
  return {};
}

}  // namespace

std::optional<LayerLaw> layer_law(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law& held) -> std::optional<LayerLaw> {
        if constexpr (std::is_constructible_v<LayerLaw, Law>)
          return LayerLaw(held);
        else
          return std::nullopt;
      },
      law);
}

std::vector<Violation> violations_as_layer(const PadLaw& law) {
  if (std::holds_alternative<RigidFoam>(law))
    return {{"law", no_value,
             must + "the rigid-foam law is rigid on unloading, so its stress does not determine its strain"}};
  if (std::holds_alternative<NineParameter>(law) || std::holds_alternative<TwentyOneParameter>(law))
    return {{"law", no_value,
             must + "the stress of the " + name_of(law) +
                 " law jumps and falls where the strain rate changes sign"}};
  if (!layer_law(law))
    return {{"law", no_value,
             name_of(law) +
                 " is not available in layers; use elastic, linear-viscoelastic, foam or crushable-foam"}};
  if (const auto* crushable = std::get_if<CrushableFoam>(&law)) return of_curves(crushable->curves);
  if (const auto* foam = std::get_if<Foam>(&law)) {
    if (const auto largest = strain_of_falling_return(*foam))
      return {{"unloading", *largest,
               must + fmt::format("on unloading from a strain of {:.3g}, the stress rises before it falls",
                                  *largest)}};
    return of_curves(foam->curves);
  }
  return {};
}

}  // namespace dashpad
