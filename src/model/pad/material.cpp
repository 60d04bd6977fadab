#include "dashpad/model/pad/material.hpp"

#include <string_view>

#include <fmt/format.h>

#include "model/pad/foam/foam_curve.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "quantities/text.hpp"

namespace dashpad {
namespace {

void check_fit(const FittedRange& fitted, std::vector<Violation>& broken) {
  constexpr double highest_rate = 1e9;  // 1/s
  if (!(fitted.highest_strain > 0 && fitted.highest_strain <= 1))
    broken.push_back({"fitted.highest_strain", fitted.highest_strain, "must be more than 0 and at most 1"});
  if (!(fitted.lowest_rate >= 0 && fitted.lowest_rate <= highest_rate))
    broken.push_back({"fitted.lowest_rate", fitted.lowest_rate, "must be at least 0 and at most 1e9 1/s"});
  if (!(fitted.highest_rate > 0 && fitted.highest_rate <= highest_rate))
    broken.push_back({"fitted.highest_rate", fitted.highest_rate, "must be more than 0 and at most 1e9 1/s"});
  else if (fitted.highest_rate <= fitted.lowest_rate)
    broken.push_back({"fitted.highest_rate", fitted.highest_rate, "must be more than lowest_rate"});
}

void check_conditions(const Material& material, std::vector<Violation>& broken) {
  if (const auto& exponent = material.density_exponent) {
    if (!(*exponent >= 0 && *exponent <= 5))
      broken.push_back({"density_exponent", *exponent, "must be from 0 to 5"});
    if (!material.density)
      broken.push_back({"density_exponent", *exponent, "the density of the material must be given as well"});
  }
  const auto& [temperature, factor] = material.temperature_table;
  if (temperature.size() != factor.size())
    broken.push_back({"temperature.factors", double(factor.size()),
                      fmt::format("must have one factor for each temperature, not {} for {}", factor.size(),
                                  temperature.size())});
  for (std::size_t i = 0; i < temperature.size(); ++i)
    if (!(temperature[i] > (i > 0 ? temperature[i - 1] : 0) && temperature[i] <= highest_temperature))
      broken.push_back({fmt::format("temperature.temperatures[{}]", i + 1), temperature[i],
                        fmt::format("must be above the previous temperature, above 0 K and at most {:g} K",
                                    highest_temperature)});
  for (std::size_t i = 0; i < factor.size(); ++i)
    if (!(factor[i] >= 1e-3 && factor[i] <= 1e3))
      broken.push_back(
          {fmt::format("temperature.factors[{}]", i + 1), factor[i], "must be from 0.001 to 1000"});
}

void check_range(const char* key, const std::optional<ValueRange>& range, std::optional<double> nominal,
                 const Bounds& bounds, std::vector<Violation>& broken) {
  if (!range) return;
  const std::string full = fmt::format("uncertainty.{}", key);
  if (!bounds.contain(range->low) || !bounds.contain(range->high))
    broken.push_back(
        {full, range->low, fmt::format("must be from {:g} to {:g}", bounds.lowest, bounds.highest)});
  else if (!(range->low <= range->high))
    broken.push_back({full, range->low, "must be two numbers, the lower first"});
  else if (nominal && !(*nominal >= range->low && *nominal <= range->high))
    broken.push_back({full, *nominal, fmt::format("the range must include the card's value of {}", key)});
}

/// Checks a range against value and bounds of the law's parameter of that name, which must exist.
void check_parameter_range(const Material& material, const char* key, const std::optional<ValueRange>& range,
                           std::vector<Violation>& broken) {
  if (!range) return;
  const bool is_known = std::visit(
      [&]<class Law>(const Law& law) {
        for (const Parameter<Law>& parameter : Law::parameters)
          if (std::string_view(parameter.key) == key) {
            check_range(key, range, parameter.of(law), parameter.bounds, broken);
            return true;
          }
        return false;
      },
      material.law);
  if (!is_known)
    broken.push_back({fmt::format("uncertainty.{}", key), range->low, "the law has no such parameter"});
}

void check_uncertainty(const Material& material, std::vector<Violation>& broken) {
  constexpr Bounds shares = from_to(0, 1);
  const Uncertainty& of = material.uncertainty;
  check_parameter_range(material, "recoil", of.recoil, broken);
  check_parameter_range(material, "unloading_factor", of.unloading_factor, broken);
  check_parameter_range(material, "lag_strain", of.lag_strain, broken);
  check_range("rate_exponent", of.rate_exponent, {}, shares, broken);
  const auto check_share = [&](const char* key, double value) {
    if (!shares.contain(value))
      broken.push_back({fmt::format("uncertainty.{}", key), value, "must be a fraction, from 0 to 1"});
  };
  if (of.scatter) check_share("scatter", *of.scatter);
  if (const auto& misfit = of.misfit) {
    check_share("misfit.peak_acceleration", misfit->peak_acceleration);
    check_share("misfit.hic", misfit->hic);
    check_share("misfit.rebound_speed", misfit->rebound_speed);
    check_share("misfit.penetration", misfit->penetration);
    if (const auto& nose = misfit->nose_over_pad; nose && !positive.contain(*nose))
      broken.push_back({"uncertainty.misfit.nose_over_pad", *nose, "must be more than 0"});
    if (misfit->impacts < 1)
      broken.push_back(
          {"uncertainty.misfit.impacts", double(misfit->impacts), "must be a whole number, 1 or more"});
  }
  const PosteriorAxes& axes = of.posterior;
  if (axes.minus.size() != axes.plus.size() || axes.minus.size() > max_posterior_axes ||
      axes.keys.size() > max_posterior_keys)
    broken.push_back({"uncertainty.posterior.plus", double(axes.plus.size()),
                      fmt::format("must have as many rows as \"minus\", at most {}", max_posterior_axes)});
  for (const auto* rows : {&axes.minus, &axes.plus})
    for (const std::vector<double>& row : *rows)
      if (row.size() != axes.keys.size())
        broken.push_back(
            {rows == &axes.minus ? "uncertainty.posterior.minus" : "uncertainty.posterior.plus",
             double(row.size()),
             fmt::format("each row must have {} numbers, one for each entry of \"keys\"", axes.keys.size())});
}

}  // namespace

bool is_of_parameters(std::string_view key) {
  return !key.starts_with("curve.") && !key.starts_with("rate.") && !key.starts_with("unloading.");
}

FittedRange tested_range(const FoamCurves& curves) {
  return {.highest_strain = last_strain_of(curves.base),
          .lowest_rate = curves.slowest_rate,
          .highest_rate = tested_rates(curves).back()};
}

std::string name_of(Beyond beyond) {
  constexpr const char* names[]{"EXTRAPOLATED STRAIN", "EXTRAPOLATED RATE", "EXTRAPOLATED"};
  return names[static_cast<std::size_t>(beyond)];
}

std::optional<FittedRange> range_of(const Material& material) {
  if (material.fitted) return material.fitted;
  if (const FoamCurves* const curves = foam_curves(material.law)) return tested_range(*curves);
  return std::nullopt;
}

std::vector<Violation> violations(const Material& material) {
  std::vector<Violation> broken = violations(material.law);
  for (Violation& violation : broken)
    if (is_of_parameters(violation.key)) violation.key = "parameters." + violation.key;
  const std::vector<Violation> others = violations_beside_law(material);
  broken.insert(broken.end(), others.begin(), others.end());
  return broken;
}

std::vector<Violation> violations_beside_law(const Material& material) {
  std::vector<Violation> broken;
  if (material.fitted) check_fit(*material.fitted, broken);
  check_conditions(material, broken);
  check_uncertainty(material, broken);
  return broken;
}

namespace {

/// "from 0.01 to 100", "at 0.01"
std::string rates_of(const FittedRange& range) {
  return range.highest_rate > range.lowest_rate
             ? fmt::format("from {} to {}", plain_number(range.lowest_rate), plain_number(range.highest_rate))
             : "at " + plain_number(range.lowest_rate);
}

}  // namespace

std::vector<Extrapolation> extrapolations(const Material& material, double largest_strain,
                                          double largest_rate) {
  std::vector<Extrapolation> reasons;
  if (const auto fitted = range_of(material)) {
    const bool by_curves = has_curves(material.law);
    if (largest_strain > fitted->highest_strain)
      reasons.push_back({Beyond::strain,
                         fmt::format("the strain reaches {:.3f}; the {} up to {:.3g}{}", largest_strain,
                                     by_curves ? "foam was tested" : "law was fitted", fitted->highest_strain,
                                     by_curves ? ", and its curve is extrapolated beyond that" : "")});
    if (largest_rate > fitted->highest_rate || largest_rate < fitted->lowest_rate)
      reasons.push_back(
          {Beyond::rate, by_curves
                             ? fmt::format("the strain rate reaches {} per second; the foam was tested {}, "
                                           "and beyond that the stress at the nearest tested rate is used",
                                           plain_number(largest_rate), rates_of(*fitted))
                             : fmt::format("the strain rate reaches {} per second; the law was fitted {}",
                                           plain_number(largest_rate), rates_of(*fitted))});
  }
  std::visit(
      [&](const auto& law) {
        if constexpr (requires { law.residual_strain_time; })
          if (law.residual_strain_time * largest_rate >= 1)
            reasons.push_back(
                {Beyond::rate,
                 fmt::format("the strain rate reaches {} per second; the law's residual strain is defined "
                             "only below {} per second",
                             plain_number(largest_rate), plain_number(1 / law.residual_strain_time))});
      },
      material.law);
  return reasons;
}

}  // namespace dashpad
