#include "dashpad/model/pad/stress_scale.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

#include "dashpad/quantities/portable_math.hpp"

namespace dashpad {
namespace {

constexpr double freezing_K = 273.15;

/// The factor at a temperature, K: linear between the entries, constant beyond them.
double factor_at(const TemperatureTable& table, double temperature) {
  const auto next = std::ranges::upper_bound(table.temperature, temperature);
  if (next == table.temperature.begin()) return table.factor.front();
  if (next == table.temperature.end()) return table.factor.back();
  const auto i = static_cast<std::size_t>(next - table.temperature.begin());
  const double share =
      (temperature - table.temperature[i - 1]) / (table.temperature[i] - table.temperature[i - 1]);
  return table.factor[i - 1] + share * (table.factor[i] - table.factor[i - 1]);
}

template <class Form>
void scale_stresses(Form& form, double factor) {
  if constexpr (requires { Form::parameters; })
    for (const auto& parameter : Form::parameters)
      if (std::string_view(parameter.unit) == "Pa") parameter.set(form, factor * parameter.of(form));
}
void scale_stresses(TableCurve& table, double factor) {
  for (double& stress : table.stress) stress *= factor;
}
void scale_stresses(CurvesRateEffect& effect, double factor) {
  for (auto& [rate, curve] : effect.curves) scale_stresses(curve, factor);
}

}  // namespace

std::vector<Violation> violations(const PadCondition& condition, const Material& material) {
  std::vector<Violation> broken;
  const Parameter<PadCondition>& scale = PadCondition::parameters.front();
  if (const auto rule = broken_rule(condition.scale, scale.bounds, scale.unit))
    broken.push_back({scale.key, condition.scale, *rule});
  if (const auto& density = condition.density) {
    if (!material.density_exponent || !material.density)
      broken.push_back({"density", *density,
                        "the material has no data for other densities: its card has no density_exponent"});
    else if (!(*density >= *material.density / 10 && *density <= *material.density * 10))
      broken.push_back(
          {"density", *density,
           fmt::format("must be between 0.1 and 10 times the density of the material, {:.4g} kg/m3",
                       *material.density)});
  }
  if (const auto& temperature = condition.temperature) {
    if (material.temperature_table.temperature.empty())
      broken.push_back(
          {"temperature", *temperature,
           "the material has no data for other temperatures: its card has no temperature table"});
    else if (const auto rule = broken_rule(*temperature, PadCondition::parameters[2].bounds, "K"))
      broken.push_back({"temperature", *temperature, *rule});
  }
  return broken;
}

double stress_factor(const PadCondition& condition, const Material& material) {
  double factor = condition.scale;
  if (condition.density)
    factor *= portable::pow(*condition.density / *material.density, *material.density_exponent);
  if (condition.temperature) factor *= factor_at(material.temperature_table, *condition.temperature);
  return factor;
}

PadLaw scaled(const PadLaw& law, double factor) {
  PadLaw result = law;
  if (factor == 1) return result;
  std::visit(
      [factor]<class Law>(Law& held) {
        scale_stresses(held, factor);
        if constexpr (SharesSlip<Law>) {
          std::visit([factor](auto& form) { scale_stresses(form, factor); }, held.curves.base);
          std::visit([factor](auto& effect) { scale_stresses(effect, factor); }, held.curves.rate_effect);
          if constexpr (requires { held.unloading_curve; })
            if (held.unloading_curve) scale_stresses(*held.unloading_curve, factor);
        }
      },
      result);
  return result;
}

std::vector<Extrapolation> extrapolations(const PadCondition& condition, const Material& material) {
  if (!condition.temperature) return {};
  const std::vector<double>& tested = material.temperature_table.temperature;
  if (*condition.temperature >= tested.front() && *condition.temperature <= tested.back()) return {};
  return {{Beyond::other,
           fmt::format("the foam is at {:.4g} degC; it was tested from {:.4g} to {:.4g} "
                       "degC, and outside that range the factor for the nearest tested temperature is used",
                       *condition.temperature - freezing_K, tested.front() - freezing_K,
                       tested.back() - freezing_K)}};
}

}  // namespace dashpad
