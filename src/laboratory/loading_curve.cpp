#include "laboratory/loading_curve.hpp"

#include <type_traits>
#include <utility>
#include <variant>

#include "dashpad/laboratory/column_test.hpp"

namespace dashpad::laboratory {

namespace {

std::vector<double> rates_of(const FoamCurves& curves) {
  std::vector<double> rates{curves.slowest_rate};
  std::visit(
      [&rates]<class Effect>(const Effect& effect) {
        if constexpr (std::is_same_v<Effect, PowerRateEffect>)
          rates.push_back(effect.highest_rate);
        else if constexpr (std::is_same_v<Effect, FactorRateEffect>)
          rates.insert(rates.end(), effect.rate.begin(), effect.rate.end());
        else if constexpr (std::is_same_v<Effect, CurvesRateEffect>)
          for (const CurvesRateEffect::AtRate& at : effect.curves) rates.push_back(at.rate);
      },
      curves.rate_effect);
  return rates;
}

}  // namespace

std::vector<double> tested_rates(const Material& material) {
  return std::visit(
      [&material]<class Law>(const Law& law) -> std::vector<double> {
        if constexpr (SharesSlip<Law>)
          return rates_of(law.curves);
        else if (material.fitted && material.fitted->lowest_rate > 0)
          return {material.fitted->lowest_rate, material.fitted->highest_rate};
        else
          return {material.fitted ? material.fitted->highest_rate : 1.0};
      },
      material.law);
}

LoadingCurve loading_curve(const Material& material, double rate, double strain, int steps) {
  const StrainHistory loading{{{.duration = strain / rate, .strain = 0, .rate = rate}}};
  ColumnTest column = drive(material.law, loading, steps);
  return {std::move(column.strain), std::move(column.stress)};
}

}  // namespace dashpad::laboratory
