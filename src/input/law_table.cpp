#include "input/case_tables.hpp"

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/quantity.hpp"

namespace dashpad::input {

namespace {

/// The factor from the stress unit of a table to Pa; NaN after a fault.
double stress_scale(TableReader& table) {
  const std::string unit = table.text("stress_unit");
  if (unit.empty()) return no_value;
  const auto [scale, rule] = read_si("1 " + unit, "Pa");
  if (rule.empty()) return scale;
  table.fault("stress_unit", rule);
  return no_value;
}

std::optional<TableCurve> read_points(TableReader& table) {
  const double scale = stress_scale(table);
  auto strain = read_numbers(table, "strain");
  auto stress = read_numbers(table, "stress", scale);
  if (!strain || !stress || !(scale > 0)) return std::nullopt;
  return TableCurve{*std::move(strain), *std::move(stress)};
}

std::optional<BaseCurve> read_base(TableReader& table) {
  const auto form = read_alternative<BaseCurve>(table, "form");
  if (!form) return std::nullopt;
  return std::visit(
      [&]<class Form>(const Form&) -> std::optional<BaseCurve> {
        if constexpr (std::is_same_v<Form, TableCurve>)
          return read_points(table);
        else
          return read_parameters<Form>(table);
      },
      *form);
}

std::optional<RateEffect> read_curves_of_rates(TableReader& table) {
  CurvesRateEffect effect;
  if (table.has("interpolation"))
    effect.linear = table.choice("interpolation", {"log-log", "linear"}) == "linear";
  const TomlNode* curves = table.array("curves");
  if (!curves) return std::nullopt;
  table.each_table(
      "curves", *curves,
      [&](TableReader& curve) {
        const double rate = curve.quantity("rate", "1/s");
        auto points = read_points(curve);
        curve.refuse_others();
        if (points) effect.curves.push_back({rate, *std::move(points)});
      },
      "must be a table with rate, strain and stress");
  const bool sound = effect.curves.size() == curves->children.size();
  return sound ? std::optional<RateEffect>(std::move(effect)) : std::nullopt;
}

std::optional<RateEffect> read_factors(TableReader& table) {
  auto rates = read_quantities(table, "rates", "1/s", max_rates);
  auto factors = read_numbers(table, "factors");
  if (!rates || !factors) return std::nullopt;
  return FactorRateEffect{*std::move(rates), *std::move(factors)};
}

std::optional<RateEffect> read_effect(TableReader& table) {
  const auto form = read_alternative<RateEffect>(table, "form");
  if (!form) return std::nullopt;
  std::optional<RateEffect> effect = std::visit(
      [&]<class Form>(const Form&) -> std::optional<RateEffect> {
        if constexpr (std::is_same_v<Form, PowerRateEffect>)
          return read_parameters<Form>(table);
        else if constexpr (std::is_same_v<Form, FactorRateEffect>)
          return read_factors(table);
        else if constexpr (std::is_same_v<Form, CurvesRateEffect>)
          return read_curves_of_rates(table);
        else
          return NoRateEffect{};
      },
      *form);
  table.refuse_others();
  return effect;
}

bool read_curves(TableReader& table, FoamCurves& into) {
  bool sound = false;
  if (auto curve = table.table("curve")) {
    into.slowest_rate = curve->quantity("rate", "1/s");
    if (auto base = read_base(*curve)) {
      into.base = *std::move(base);
      sound = true;
    }
    if (sound) curve->refuse_others();
  }
  if (auto rate = table.table("rate", Presence::optional)) {
    auto effect = read_effect(*rate);
    sound = sound && effect;
    if (effect) into.rate_effect = *std::move(effect);
  }
  return sound;
}

/// False if no curve is left to check. Numbers at fault are NaN.
bool read_foam_tables(TableReader& table, Foam& into) {
  bool sound = read_curves(table, into.curves);
  if (auto unloading = table.table("unloading", Presence::optional)) {
    into.unloading_curve = read_points(*unloading);
    unloading->refuse_others();
    sound = sound && into.unloading_curve;
  }
  return sound;
}

bool read_foam_tables(TableReader& table, CrushableFoam& into) { return read_curves(table, into.curves); }

/// Whether all numbers of a law are optional.
bool may_lack_parameters(const PadLaw& law) {
  return std::visit(
      []<class Law>(const Law&) {
        for (const auto& parameter : Law::parameters)
          if (!parameter.may_be_left_out()) return false;
        return true;
      },
      law);
}

}  // namespace

std::optional<PadLaw> read_law(TableReader& table) {
  auto law = read_alternative<PadLaw>(table, "law");
  auto parameters =
      table.table("parameters", law && may_lack_parameters(*law) ? Presence::optional : Presence::required);
  if (!law) return std::nullopt;
  // Marks these keys as known.
  for (const char* key : {"curve", "rate", "unloading"})
    if (has_curves(*law)) table.has(key);
  if (parameters) {
    law = with_parameters(*law, *parameters);
    parameters->refuse_others();
  } else if (!may_lack_parameters(*law)) {
    return std::nullopt;
  }
  const bool sound = std::visit(
      [&]<class Law>(Law& held) {
        if constexpr (SharesSlip<Law>)
          return read_foam_tables(table, held);
        else
          return true;
      },
      *law);
  return sound ? law : std::nullopt;
}

std::optional<FittedRange> read_fitted(TableReader& table) {
  auto fitted = table.table("fitted", Presence::optional);
  if (!fitted) return std::nullopt;
  const FittedRange range{.highest_strain = fitted->number("highest_strain"),
                          .lowest_rate = fitted->quantity("lowest_rate", "1/s"),
                          .highest_rate = fitted->quantity("highest_rate", "1/s")};
  fitted->refuse_others();
  return range;
}

}  // namespace dashpad::input
