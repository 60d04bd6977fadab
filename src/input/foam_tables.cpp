#include "input/foam_tables.hpp"

#include <fmt/format.h>

#include <limits>

#include "dashpad/quantities/quantity.hpp"
#include "input/number_list.hpp"
#include "input/parameter_table.hpp"

namespace dashpad::input {
namespace {

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();

/// What a stress of 1 in the unit of a table is in Pa; NaN after a fault.
double stress_scale(TableReader& table) {
  const std::string unit = table.text("stress_unit");
  if (unit.empty()) return not_a_number;
  const auto [scale, rule] = read_si("1 " + unit, "Pa");
  if (rule.empty()) return scale;
  table.fault("stress_unit", rule);
  return not_a_number;
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
  bool sound = true;
  for (const TomlNode& node : curves->children) {
    const std::string key = table.full_key("curves") + node.key;
    if (node.kind != TomlNode::Kind::table) {
      table.faults().add(node, key, "must be a table with rate, strain and stress");
      sound = false;
      continue;
    }
    TableReader curve(node, key, table.faults());
    const double rate = curve.quantity("rate", "1/s");
    auto points = read_points(curve);
    curve.refuse_others();
    sound = sound && points;
    if (points) effect.curves.push_back({rate, *std::move(points)});
  }
  return sound ? std::optional<RateEffect>(effect) : std::nullopt;
}

std::optional<RateEffect> read_factors(TableReader& table) {
  auto rates = read_quantities(table, "rates", "1/s", most_rates);
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

}  // namespace

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

}  // namespace dashpad::input
