#include "model/pad/foam/overstress.hpp"

#include <algorithm>
#include <type_traits>
#include <utility>

#include "dashpad/quantities/portable_math.hpp"
#include "model/pad/foam/foam_rules.hpp"
#include "model/pad/foam/monotone_curve.hpp"

namespace dashpad {

Overstress::Overstress(const FoamCurves& curves, const FoamCurve& base, double friction, double recoil,
                       double slip_rate)
    : friction_(friction), recoil_(recoil), slip_rate_(slip_rate), rates_(tested_rates(curves)) {
  std::visit(
      [&]<class Effect>(const Effect& effect) {
        if constexpr (std::is_same_v<Effect, PowerRateEffect>) {
          kind_ = Kind::power;
          exponent_ = effect.exponent;
          exponent_slope_ = effect.exponent_slope;
        } else if constexpr (std::is_same_v<Effect, FactorRateEffect>) {
          kind_ = Kind::tested;
          log_factors_.push_back(0);
          for (const double factor : effect.factor) log_factors_.push_back(portable::log(factor));
        } else if constexpr (std::is_same_v<Effect, CurvesRateEffect>) {
          kind_ = Kind::tested;
          linear_ = effect.linear;
          for (const auto& [rate, table] : effect.curves) {
            const MonotoneCurve curve(table);
            const double last = std::min(curve.last_strain(), base.last_strain());
            const auto ratio = [&](double root) {
              // Both curves start at 0; within the first cell their ratio is that at its end.
              const double e = std::clamp(root * root, base.cells().width * base.cells().width, last);
              const double m = curve.stress(e) / base.at(strain_of(e)).stress;
              return linear_ ? m : portable::log(m);
            };
            // Curves that touch must not cross between their points.
            const CellTable* slower = tables_.empty() ? nullptr : &tables_.back();
            CellTable table_of_rate;
            table_of_rate.fill(base.cells(), [&](double root) {
              const double least = slower ? slower->at(base.cells().place(std::abs(root))) : factor(0, {});
              return std::max(ratio(root), least);
            });
            tables_.push_back(std::move(table_of_rate));
          }
        }
      },
      curves.rate_effect);
  for (const double rate : rates_) log_rates_.push_back(portable::log(rate));
}

Overstress::AtRate Overstress::at(double slip_rate) const {
  AtRate result = rates_at(slip_rate);
  const bool without = result.share == 0;
  result.even = without || (kind_ == Kind::power ? exponent_slope_ == 0 : tables_.empty());
  if (without)
    result.at_all_strains = {result.friction, result.friction_rise};
  else if (result.even)
    result.at_all_strains = at_strain(result, 0, {});
  return result;
}

double Overstress::corner_below(double slip_rate) const {
  if (kind_ == Kind::none) return 0;
  constexpr double at_corner = 1e-6;
  const auto next = std::lower_bound(rates_.begin(), rates_.end(), slip_rate * (1 - at_corner));
  return next == rates_.begin() ? 0 : next[-1];
}

Overstress::AtRate Overstress::rates_at(double slip_rate) const {
  const double u = std::abs(slip_rate);
  AtRate result;
  result.friction = friction_ * slip_rate / (u + 2 * slip_rate_);
  result.friction_rise = friction_ * 2 * slip_rate_ * u / ((u + 2 * slip_rate_) * (u + 2 * slip_rate_));
  if (kind_ == Kind::none || u <= rates_.front()) return result;
  result.share = slip_rate > 0 ? 1 : -recoil_;
  if (kind_ == Kind::power) {
    result.log_rate = portable::log(std::min(u, rates_.back())) - log_rates_.front();
    result.weight_rise = u < rates_.back() ? 1 : 0;
    return result;
  }
  const auto next = std::upper_bound(rates_.begin(), rates_.end(), u);
  if (next == rates_.end()) {
    result.segment = rates_.size() - 2;
    result.weight = 1;
    return result;
  }
  result.segment = static_cast<std::size_t>(next - rates_.begin()) - 1;
  const double before = rates_[result.segment];
  if (linear_) {
    result.weight = (u - before) / (*next - before);
    result.weight_rise = u / (*next - before);
  } else {
    const double* log_rate = &log_rates_[result.segment];
    result.weight_rise = 1 / (log_rate[1] - log_rate[0]);
    result.weight = (portable::log(u) - log_rate[0]) * result.weight_rise;
  }
  return result;
}

Overstress::Value Overstress::at_strain(const AtRate& rate, double strain, CellPlace place) const {
  const auto [over, rise] = kind_ == Kind::power
                                ? scalar::over_by_power(exponent_, exponent_slope_, rate.log_rate, strain)
                                : scalar::over_between(linear_, factor(rate.segment, place),
                                                       factor(rate.segment + 1, place), rate.weight);
  return {rate.friction + rate.share * over,
          rate.friction_rise + std::abs(rate.share) * rate.weight_rise * rise};
}

}  // namespace dashpad
