#include "oracle/foam_formulas.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <variant>

namespace dashpad::oracle {

namespace {

constexpr std::size_t work_cells = 400;
constexpr std::size_t back_points = 20'000;
// Four points of Gauss on [0, 1].
constexpr std::array<double, 4> gauss_place{0.0694318442029737, 0.3300094782075719, 0.6699905217924281,
                                            0.9305681557970263};
constexpr std::array<double, 4> gauss_weight{0.1739274225687269, 0.3260725774312731, 0.3260725774312731,
                                             0.1739274225687269};

double power_of(double x, double n) { return std::exp(n * std::log(x)); }

double formula(const AvalleCurve& c, double e) {
  const double knee = 1 - std::exp(-(c.modulus / c.plateau_stress) * e * power_of(1 - e, c.plateau_exponent));
  return c.plateau_stress * knee + c.densification_stress * power_of(e / (1 - e), c.densification_exponent);
}
double formula(const PowerCurve& c, double e) {
  return c.modulus * power_of(e, c.contact_exponent) / power_of(1 - e, c.compaction_exponent);
}
double formula(const GibsonAshbyCurve& c, double e) {
  const double walls = c.plateau_stress * (1 - std::exp(-c.modulus / c.plateau_stress * e));
  return walls + c.gas_pressure * e / (1 - c.relative_density - e);
}
double formula(const HyperfoamCurve& c, double e) {
  const double stretch = 1 - e;
  const auto term = [&](double mu, double a) {
    if (std::fabs(a) < 1e-9) return -2 * mu * std::log(stretch) / stretch;
    return 2 * mu / a * (1 - power_of(stretch, a)) / stretch;
  };
  return term(c.first_modulus, c.first_exponent) + term(c.second_modulus, c.second_exponent);
}

}  // namespace

HermiteTable::HermiteTable(const TableCurve& points) : x_{0}, y_{0} {
  x_.insert(x_.end(), points.strain.begin(), points.strain.end());
  y_.insert(y_.end(), points.stress.begin(), points.stress.end());
  const std::size_t last = x_.size() - 1;
  const auto width = [&](std::size_t i) { return x_[i + 1] - x_[i]; };
  const auto secant = [&](std::size_t i) { return (y_[i + 1] - y_[i]) / width(i); };
  slope_.assign(last + 1, 0);
  slope_[0] = secant(0);
  slope_[last] = secant(last - 1);
  for (std::size_t i = 1; i < last; ++i) {
    if (secant(i) * secant(i - 1) <= 0) continue;
    const double of_left = (2 * width(i) + width(i - 1)) / (3 * (width(i) + width(i - 1)));
    slope_[i] = 1 / (of_left / secant(i - 1) + (1 - of_left) / secant(i));
  }
}

double HermiteTable::value(double x) const {
  if (x <= 0) return 0;
  if (x >= x_.back()) return y_.back() + slope_.back() * (x - x_.back());
  const auto i = static_cast<std::size_t>(std::upper_bound(x_.begin(), x_.end(), x) - x_.begin()) - 1;
  const double h = x_[i + 1] - x_[i], t = (x - x_[i]) / h;
  return y_[i] * (1 + 2 * t) * (1 - t) * (1 - t) + h * slope_[i] * t * (1 - t) * (1 - t) +
         y_[i + 1] * t * t * (3 - 2 * t) - h * slope_[i + 1] * t * t * (1 - t);
}

FoamFormulas::FoamFormulas(const Foam& law)
    : friction_(law.friction),
      recoil_(law.recoil),
      lag_(law.lag_strain / 20),
      u0_(law.curves.slowest_rate / 1000),
      factor_(law.unloading_factor),
      shape_(law.unloading_shape) {
  set_base(law.curves, law.continuation_exponent);
  set_rate_effect(law.curves);
  if (!law.unloading_curve) return;
  const HermiteTable back(*law.unloading_curve);
  for (std::size_t i = 0; i <= back_points; ++i) {
    const double root = double(i) / back_points;
    const double e = last_ * root * root;
    back_share_.push_back(work(e, 1 - e) / last_work_);
    const double loading = e > 0 ? base(e, 1 - e) : 1;
    back_value_.push_back(std::clamp((back.value(e) / loading + friction_) / (1 - friction_), 0.0, 1.0));
  }
  back_share_.front() = 0;
  back_value_.front() = back_value_[1];
}

FoamFormulas::FoamFormulas(const CrushableFoam& law)
    : lag_(law.lag_strain / 20), u0_(law.curves.slowest_rate / 1000), modulus_(law.unloading_modulus) {
  set_base(law.curves, law.continuation_exponent);
  set_rate_effect(law.curves);
}

void FoamFormulas::set_base(const FoamCurves& curves, double exponent) {
  exponent_ = exponent;
  if (const auto* table = std::get_if<TableCurve>(&curves.base)) {
    last_ = table->strain.back();
    tested_ = [curve = HermiteTable(*table)](double e) { return curve.value(e); };
    last_slope_ = HermiteTable(*table).last_slope();
  } else {
    std::visit(
        [&](const auto& form) {
          if constexpr (requires { form.highest_strain; }) {
            last_ = form.highest_strain;
            tested_ = [form](double e) { return e > 0 ? formula(form, e) : 0; };
            // Fourth order, to a few digits less than the number has.
            const double h = 1e-3 * std::min(last_, 1 - last_);
            const auto s = [&](double x) { return formula(form, last_ + x * h); };
            last_slope_ = (8 * (s(1) - s(-1)) - (s(2) - s(-2))) / (12 * h);
          }
        },
        curves.base);
  }
  last_stress_ = tested_(last_);
  last_slope_ = std::max(last_slope_, 0.1 * last_stress_ / last_);
  root_step_ = std::sqrt(last_) / work_cells;
  work_at_.assign(1, 0);
  for (std::size_t i = 0; i < work_cells; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < gauss_place.size(); ++k) {
      const double root = root_step_ * (double(i) + gauss_place[k]);
      sum += gauss_weight[k] * 2 * root * tested_(root * root);
    }
    work_at_.push_back(work_at_.back() + root_step_ * sum);
  }
  last_work_ = work_at_.back();
}

double FoamFormulas::base(double strain, double complement) const {
  if (strain <= last_) return tested_(strain);
  const double q = 1 - last_;
  return last_stress_ + last_slope_ * q / exponent_ * (power_of(q / complement, exponent_) - 1);
}

double FoamFormulas::work(double strain, double complement) const {
  if (strain >= last_) {
    const double q = 1 - last_, n = exponent_;
    const double ratio = complement / q;
    const double integral =
        std::fabs(n - 1) < 1e-9 ? -q * std::log(ratio) : q * (power_of(ratio, 1 - n) - 1) / (n - 1);
    return last_work_ + last_stress_ * (strain - last_) + last_slope_ * q / n * (integral - (strain - last_));
  }
  if (strain <= 0) return 0;
  const double root = std::sqrt(strain);
  const auto cell = std::min(static_cast<std::size_t>(root / root_step_), work_cells - 1);
  const double from = root_step_ * double(cell);
  double sum = 0;
  for (std::size_t k = 0; k < gauss_place.size(); ++k) {
    const double r = from + (root - from) * gauss_place[k];
    sum += gauss_weight[k] * 2 * r * tested_(r * r);
  }
  return work_at_[cell] + (root - from) * sum;
}

void FoamFormulas::set_rate_effect(const FoamCurves& curves) {
  slowest_ = curves.slowest_rate;
  if (const auto* power = std::get_if<PowerRateEffect>(&curves.rate_effect)) {
    multiplier_ = [effect = *power, slowest = slowest_](double e, double r) {
      const double reached = std::fmin(r, effect.highest_rate) / slowest;
      return power_of(reached, std::fmax(effect.exponent + effect.exponent_slope * e, 0));
    };
  } else if (const auto* factors = std::get_if<FactorRateEffect>(&curves.rate_effect)) {
    multiplier_ = [effect = *factors, slowest = slowest_](double, double r) {
      double rate = slowest, factor = 1;
      for (std::size_t i = 0; i < effect.rate.size(); ++i) {
        if (r <= effect.rate[i])
          return factor *
                 power_of(effect.factor[i] / factor, std::log(r / rate) / std::log(effect.rate[i] / rate));
        rate = effect.rate[i], factor = effect.factor[i];
      }
      return factor;
    };
  } else if (const auto* tested = std::get_if<CurvesRateEffect>(&curves.rate_effect)) {
    std::vector<double> rates{slowest_};
    std::vector<HermiteTable> tables;
    for (const auto& [rate, curve] : tested->curves) rates.push_back(rate), tables.emplace_back(curve);
    multiplier_ = [this, rates, tables, linear = tested->linear](double e, double r) {
      double low = 1;
      for (std::size_t i = 0; i < tables.size(); ++i) {
        const double at = std::clamp(e, 1e-5 * last_, std::min(tables[i].last(), last_));
        const double high = std::fmax(tables[i].value(at) / tested_(at), low);
        if (r <= rates[i + 1]) {
          const double weight = linear ? (r - rates[i]) / (rates[i + 1] - rates[i])
                                       : std::log(r / rates[i]) / std::log(rates[i + 1] / rates[i]);
          return linear ? low + weight * (high - low) : low * power_of(high / low, weight);
        }
        low = high;
      }
      return low;
    };
  }
}

double FoamFormulas::multiplier(double strain, double rate) const {
  return !multiplier_ || rate <= slowest_ ? 1 : multiplier_(strain, rate);
}

double FoamFormulas::remaining(double share) const {
  if (share >= 1) return 1;
  if (back_share_.empty()) return 1 - (1 - factor_) * (1 - power_of(share, shape_));
  const auto next = std::upper_bound(back_share_.begin(), back_share_.end(), share);
  const auto i = static_cast<std::size_t>(next - back_share_.begin());
  if (i >= back_share_.size()) return back_value_.back();
  const double weight = (share - back_share_[i - 1]) / (back_share_[i] - back_share_[i - 1]);
  return back_value_[i - 1] + weight * (back_value_[i] - back_value_[i - 1]);
}

std::vector<double> FoamFormulas::corners() const {
  if (!modulus_ || *modulus_ <= last_slope_) return {last_};
  return {last_, 1 - (1 - last_) * power_of(last_slope_ / *modulus_, 1 / (exponent_ + 1))};
}

double FoamFormulas::slip_rate(double g) const {
  const double u = u0_ * (std::exp(std::fabs(g) / lag_) - 1);
  return g < 0 ? -u : u;
}

double FoamFormulas::stress(double strain, double complement, double ahead, double u) const {
  const double all = signed_stress(strain, complement, ahead, u);
  return modulus_ ? std::fmax(all, 0) : all;
}

double FoamFormulas::signed_stress(double strain, double complement, double ahead, double u) const {
  if (strain <= 0) return 0;
  const double s = base(strain, complement);
  const double over = multiplier(strain, std::fabs(u)) - 1;
  const double q = friction_ * u / (std::fabs(u) + 2 * u0_) + (u >= 0 ? over : -recoil_ * over);
  double lasting = (1 - friction_) * s;
  if (ahead > 0) {
    const double top = strain + ahead, top_complement = complement - ahead;
    if (modulus_) {
      const double steepest =
          top > last_ ? last_slope_ * power_of((1 - last_) / top_complement, exponent_ + 1) : 0;
      lasting = base(top, top_complement) - std::fmax(*modulus_, steepest) * ahead;
      if (lasting < 0) return q > 0 ? s * q : lasting;
    } else if (factor_ < 1 || !back_share_.empty()) {
      lasting *= remaining(work(strain, complement) / work(top, top_complement));
    }
  }
  return lasting + s * q;
}

}  // namespace dashpad::oracle
