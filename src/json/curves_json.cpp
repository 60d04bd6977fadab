#include "json/curves_json.hpp"

#include <stdexcept>
#include <string>

#include "model/parameter_values.hpp"

namespace dashpad {
namespace {

/// Every key is there for every form; lists that a form does not have are empty.
template <class Form>
Json form_json(const Form& form) {
  Json numbers_of_form = Json::object();
  if constexpr (requires { Form::parameters; })
    for (const auto& parameter : Form::parameters)
      numbers_of_form[parameter.key] = number(parameter.of(form));
  return {{"form", Form::name}, {"parameters", numbers_of_form}};
}

Json points_json(const TableCurve& table) {
  return {{"strain", numbers(table.strain)}, {"stress_Pa", numbers(table.stress)}};
}
TableCurve points_of(const Json& json) {
  return {json.at("strain").get<std::vector<double>>(), json.at("stress_Pa").get<std::vector<double>>()};
}

Json base_json(const FoamCurves& curves) {
  Json json = std::visit([](const auto& form) { return form_json(form); }, curves.base);
  json["rate_per_s"] = number(curves.slowest_rate);
  const auto* table = std::get_if<TableCurve>(&curves.base);
  json.update(points_json(table ? *table : TableCurve{}));
  return json;
}

Json effect_json(const RateEffect& effect) {
  Json json = std::visit([](const auto& form) { return form_json(form); }, effect);
  const auto* factors = std::get_if<FactorRateEffect>(&effect);
  json["rates_per_s"] = numbers(factors ? factors->rate : std::vector<double>());
  json["factors"] = numbers(factors ? factors->factor : std::vector<double>());
  const auto* curves = std::get_if<CurvesRateEffect>(&effect);
  json["interpolation"] = curves && curves->linear ? "linear" : "log-log";
  json["curves"] = Json::array();
  if (curves)
    for (const auto& [rate, table] : curves->curves) {
      Json entry{{"rate_per_s", number(rate)}};
      entry.update(points_json(table));
      json["curves"].push_back(entry);
    }
  return json;
}

template <class Variant>
Variant form_of(const Json& json) {
  auto form = alternative_named<Variant>(json.at("form").get<std::string>());
  if (!form) throw std::runtime_error("no such curve form");
  const Json& values = json.at("parameters");
  std::visit(
      [&]<class Form>(Form& held) {
        if constexpr (requires { Form::parameters; })
          for (const auto& parameter : Form::parameters)
            parameter.set(held, values.at(parameter.key).template get<double>());
      },
      *form);
  return *std::move(form);
}

FoamCurves curves_of(const Json& json) {
  FoamCurves curves;
  const Json& base = json.at("curve");
  curves.slowest_rate = base.at("rate_per_s").get<double>();
  curves.base = form_of<BaseCurve>(base);
  if (auto* table = std::get_if<TableCurve>(&curves.base)) *table = points_of(base);
  const Json& rate = json.at("rate");
  curves.rate_effect = form_of<RateEffect>(rate);
  if (auto* factors = std::get_if<FactorRateEffect>(&curves.rate_effect))
    *factors = {rate.at("rates_per_s").get<std::vector<double>>(),
                rate.at("factors").get<std::vector<double>>()};
  if (auto* effect = std::get_if<CurvesRateEffect>(&curves.rate_effect)) {
    effect->linear = rate.at("interpolation") == "linear";
    for (const Json& entry : rate.at("curves"))
      effect->curves.push_back({entry.at("rate_per_s").get<double>(), points_of(entry)});
  }
  return curves;
}

}  // namespace

Json curves_json(const PadLaw& law) {
  const FoamCurves* const curves = foam_curves(law);
  if (curves == nullptr) return nullptr;
  const auto* const foam = std::get_if<Foam>(&law);
  return {{"curve", base_json(*curves)},
          {"rate", effect_json(curves->rate_effect)},
          {"unloading", foam ? made_of(foam->unloading_curve, points_json) : Json(nullptr)}};
}

void set_curves(PadLaw& law, const Json& json) {
  std::visit(
      [&]<class Law>(Law& held) {
        if constexpr (SharesSlip<Law>) {
          held.curves = curves_of(json);
          if constexpr (requires { held.unloading_curve; })
            if (!json.at("unloading").is_null()) held.unloading_curve = points_of(json["unloading"]);
        }
      },
      law);
}

}  // namespace dashpad
