#include "model/pad/foam/foam_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <type_traits>

#include "model/pad/foam/foam_curve.hpp"
#include "model/pad/foam/monotone_curve.hpp"
#include "model/parameter_values.hpp"

namespace dashpad {
namespace {

using Violations = std::vector<Violation>;

/// Number of strains at which a curve is checked, evenly up to its last one.
constexpr int places = 400;
constexpr double highest_rate = 1e9;  // 1/s

std::string entry(const std::string& key, std::size_t i) { return fmt::format("{}[{}]", key, i + 1); }

/// Largest fall of the stress below an earlier maximum, as a share of that.
double softening_of(const std::vector<double>& stress) {
  double top = 0;
  double most = 0;
  for (const double s : stress) {
    top = std::max(top, s);
    most = std::max(most, 1 - s / top);
  }
  return most;
}

/// Checks the points of a table; true if they are sound.
bool check_points(const TableCurve& table, const std::string& key, Violations& broken) {
  const std::size_t before = broken.size();
  const std::string strains = key + ".strain";
  const std::string stresses = key + ".stress";
  if (table.strain.size() != table.stress.size())
    broken.push_back({stresses, double(table.stress.size()),
                      fmt::format("the number of entries, {}, must equal that of strain, {}",
                                  table.stress.size(), table.strain.size())});
  else if (table.strain.size() < TableCurve::fewest_points || table.strain.size() > TableCurve::max_points)
    broken.push_back({strains, double(table.strain.size()),
                      fmt::format("must have between {} and {} points besides the origin, which is implied",
                                  TableCurve::fewest_points, TableCurve::max_points)});
  double last = 0;
  for (std::size_t i = 0; i < table.strain.size(); ++i) {
    const double e = table.strain[i];
    if (!(e > 0 && e < 1))
      broken.push_back({entry(strains, i), e, "must be more than 0 and less than 1"});
    else if (e <= last)
      broken.push_back(
          {entry(strains, i), e, fmt::format("must be more than the previous strain, {:.6g}", last)});
    last = std::max(last, e);
  }
  for (std::size_t i = 0; i < table.stress.size(); ++i)
    if (const auto rule = broken_rule(table.stress[i], positive, "Pa"))
      broken.push_back({entry(stresses, i), table.stress[i], *rule});
  return broken.size() == before;
}

bool check_base(const TableCurve& table, Violations& broken) {
  if (!check_points(table, "curve", broken)) return false;
  const std::size_t before = broken.size();
  for (std::size_t i = 1; i < table.stress.size(); ++i)
    if (table.stress[i] < table.stress[i - 1])
      broken.push_back(
          {entry("curve.stress", i), table.stress[i],
           "must not be less than the previous stress: the curve of the slowest test must not fall"});
  return broken.size() == before;
}

template <class Form>
bool check_base(const Form& form, Violations& broken) {
  const std::size_t before = broken.size();
  check_bounds(form, "curve.", broken);
  if (broken.size() > before) return false;
  if constexpr (std::is_same_v<Form, GibsonAshbyCurve>)
    if (form.highest_strain >= 1 - form.relative_density) {
      broken.push_back({"curve.highest_strain", form.highest_strain,
                        "must be less than 1 - relative_density, at which no gas is left"});
      return false;
    }
  double stress = 0;
  for (int i = 1; i <= places; ++i) {
    const double e = form.highest_strain * i / places;
    const double next = form.stress(e);
    if (!(next > stress && std::isfinite(next))) {
      broken.push_back(
          {"curve.highest_strain", form.highest_strain,
           fmt::format("the curve must rise up to this strain, but does not at a strain of {:.3g}", e)});
      return false;
    }
    stress = next;
  }
  return true;
}

bool check_rate(double rate, double before, const std::string& key, Violations& broken) {
  if (!(rate > 0 && rate <= highest_rate))
    broken.push_back({key, rate, "must be more than 0 and at most 1e9 1/s"});
  else if (rate <= before)
    broken.push_back({key, rate, fmt::format("must be more than the previous rate, {:.6g} 1/s", before)});
  return rate > before && rate <= highest_rate;
}

/// Checks that a curve does not fall below that of the slower rate, as cubics and, if both are tables
/// (`slow_table`), also on the straight lines between their points: what lies between points is not measured.
void check_crossing(const TableCurve& fast_table, const MonotoneCurve& fast, double fast_rate,
                    const TableCurve* slow_table, const auto& slow, double slow_rate, double last,
                    const std::string& key, Violations& broken) {
  for (int i = 1; i <= places; ++i) {
    const double e = last * i / places;
    const double stress = fast.stress(e);
    if (stress >= (1 - max_crossing) * slow(e)) continue;
    if (slow_table && on_straight_lines(fast_table.strain, fast_table.stress, e) >=
                          (1 - max_crossing) * on_straight_lines(slow_table->strain, slow_table->stress, e))
      continue;
    broken.push_back({key, stress,
                      fmt::format("the curve at {:.4g} 1/s crosses the one at {:.4g} 1/s: at a strain of "
                                  "{:.3g}, its stress is {:.3g} times the stress at the lower rate",
                                  fast_rate, slow_rate, e, stress / slow(e))});
    return;
  }
}

void check_effect(const NoRateEffect&, const FoamCurves&, const FoamCurve*, Violations&) {}

void check_effect(const PowerRateEffect& effect, const FoamCurves& curves, const FoamCurve*,
                  Violations& broken) {
  check_bounds(effect, "rate.", broken);
  check_rate(effect.highest_rate, curves.slowest_rate, "rate.highest_rate", broken);
}

void check_effect(const FactorRateEffect& effect, const FoamCurves& curves, const FoamCurve*,
                  Violations& broken) {
  if (effect.rate.size() != effect.factor.size() || effect.rate.empty() || effect.rate.size() > max_rates)
    broken.push_back({"rate.factors", double(effect.factor.size()),
                      fmt::format("must have 1 to {} factors, one for each rate", max_rates)});
  double before = curves.slowest_rate;
  for (std::size_t i = 0; i < effect.rate.size(); ++i) {
    check_rate(effect.rate[i], before, entry("rate.rates", i), broken);
    before = std::max(before, effect.rate[i]);
  }
  double least = 1;
  for (std::size_t i = 0; i < effect.factor.size(); ++i) {
    if (!(effect.factor[i] >= least && effect.factor[i] <= 1e6))
      broken.push_back({entry("rate.factors", i), effect.factor[i],
                        fmt::format("must be at least {:.6g}{} and at most 1e6", least,
                                    i > 0 ? ", the previous factor," : "")});
    least = std::max(least, effect.factor[i]);
  }
}

void check_effect(const CurvesRateEffect& effect, const FoamCurves& curves, const FoamCurve* base,
                  Violations& broken) {
  if (effect.curves.empty() || effect.curves.size() > max_rates)
    broken.push_back({"rate.curves", double(effect.curves.size()),
                      fmt::format("must have between 1 and {} curves", max_rates)});
  double before = curves.slowest_rate;
  std::optional<MonotoneCurve> slower;
  const auto* slow_table = base ? std::get_if<TableCurve>(&curves.base) : nullptr;
  for (std::size_t i = 0; i < effect.curves.size(); ++i) {
    const auto& [rate, table] = effect.curves[i];
    const std::string key = entry("rate.curves", i);
    const bool in_order = check_rate(rate, before, key + ".rate", broken);
    if (!check_points(table, key, broken)) {
      slower.reset();
      continue;
    }
    if (const double fall = softening_of(table.stress); fall > max_softening)
      broken.push_back(
          {key + ".stress", fall,
           fmt::format("falls by {:.0f} % from an earlier peak; at most 10 % is allowed", 100 * fall)});
    const MonotoneCurve curve(table);
    if (in_order && (slower || base)) {
      const auto slow = [&](double e) { return slower ? slower->stress(e) : base->at(strain_of(e)).stress; };
      const double last = slower ? slower->last_strain() : base->last_strain();
      check_crossing(table, curve, rate, slow_table, slow, before, std::min(curve.last_strain(), last),
                     key + ".stress", broken);
    }
    slower = curve;
    slow_table = &table;
    before = std::max(before, rate);
  }
}

/// Checks all curves and returns the base curve, if it is sound.
std::optional<FoamCurve> check_curves(const FoamCurves& curves, double continuation_exponent,
                                      Violations& broken) {
  check_rate(curves.slowest_rate, 0, "curve.rate", broken);
  std::optional<FoamCurve> base;
  if (std::visit([&](const auto& form) { return check_base(form, broken); }, curves.base) &&
      continuation_exponents.contain(continuation_exponent))
    base.emplace(curves.base, continuation_exponent);
  std::visit([&](const auto& effect) { check_effect(effect, curves, base ? &*base : nullptr, broken); },
             curves.rate_effect);
  return base;
}

template <class Law>
void check_continuation(const Law& law, Violations& broken) {
  if (law.gentlest_continuation > law.continuation_exponent)
    broken.push_back(
        {"gentlest_continuation", law.gentlest_continuation, "must be at most continuation_exponent"});
  if (law.steepest_continuation < law.continuation_exponent)
    broken.push_back(
        {"steepest_continuation", law.steepest_continuation, "must be at least continuation_exponent"});
}

}  // namespace

double on_straight_lines(const std::vector<double>& strain, const std::vector<double>& stress, double at) {
  const auto i = static_cast<std::size_t>(std::ranges::lower_bound(strain, at) - strain.begin());
  if (i == strain.size()) return stress.back();
  const double e0 = i == 0 ? 0 : strain[i - 1], s0 = i == 0 ? 0 : stress[i - 1];
  return s0 + (stress[i] - s0) * (at - e0) / (strain[i] - e0);
}

void check_rules(const Foam& law, Violations& broken) {
  check_continuation(law, broken);
  const auto base = check_curves(law.curves, law.continuation_exponent, broken);
  if (!law.unloading_curve || !check_points(*law.unloading_curve, "unloading", broken) || !base) return;
  const TableCurve& back = *law.unloading_curve;
  for (std::size_t i = 0; i < back.strain.size(); ++i) {
    const double loading = base->at(strain_of(back.strain[i])).stress;
    if (back.strain[i] > base->last_strain() * (1 + 1e-9))
      broken.push_back(
          {entry("unloading.strain", i), back.strain[i],
           fmt::format("must be at most the last strain of the loading curve, {:.6g}", base->last_strain())});
    else if (back.stress[i] > loading * (1 + max_crossing))
      broken.push_back({entry("unloading.stress", i), back.stress[i],
                        fmt::format("must be at most the loading stress, {:.6g} Pa", loading)});
  }
}

void check_rules(const CrushableFoam& law, Violations& broken) {
  check_continuation(law, broken);
  const auto base = check_curves(law.curves, law.continuation_exponent, broken);
  if (!base || !positive.contain(law.unloading_modulus)) return;
  double steepest = 0;
  double before = 0;
  const double step = base->last_strain() / places;
  for (int i = 1; i <= places; ++i) {
    const double stress = base->at(strain_of(step * i)).stress;
    steepest = std::max(steepest, (stress - before) / step);
    before = stress;
  }
  if (law.unloading_modulus < steepest * (1 - 1e-6))
    broken.push_back({"unloading_modulus", law.unloading_modulus,
                      fmt::format("must be at least the steepest slope of the curve, {:.6g} Pa: a foam that "
                                  "unloads less steeply than it loads would create energy",
                                  steepest)});
}

std::vector<double> tested_rates(const FoamCurves& curves) {
  std::vector<double> rates{curves.slowest_rate};
  if (const auto* power = std::get_if<PowerRateEffect>(&curves.rate_effect))
    rates.push_back(power->highest_rate);
  if (const auto* factors = std::get_if<FactorRateEffect>(&curves.rate_effect))
    rates.insert(rates.end(), factors->rate.begin(), factors->rate.end());
  if (const auto* effect = std::get_if<CurvesRateEffect>(&curves.rate_effect))
    for (const CurvesRateEffect::AtRate& at : effect->curves) rates.push_back(at.rate);
  return rates;
}

std::vector<double> softening_rates(const FoamCurves& curves) {
  constexpr double noticed = 1e-3;
  std::vector<double> rates;
  if (const auto* effect = std::get_if<CurvesRateEffect>(&curves.rate_effect))
    for (const auto& [rate, table] : effect->curves)
      if (softening_of(table.stress) > noticed) rates.push_back(rate);
  return rates;
}

}  // namespace dashpad
