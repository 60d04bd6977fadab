#pragma once
/// A pad material as it stands in every JSON.

#include <optional>

#include "dashpad/model/pad/material.hpp"
#include "json/curves_json.hpp"
#include "model/parameter_values.hpp"

namespace dashpad::output {

inline Json fitted_json(const std::optional<FittedRange>& range) {
  if (!range) return nullptr;
  return {{"highest_strain", number(range->highest_strain)},
          {"lowest_rate_per_s", number(range->lowest_rate)},
          {"highest_rate_per_s", number(range->highest_rate)}};
}

inline Json material_json(const Material& of) {
  Json parameters = Json::object();
  for (const ParameterValue& parameter : parameter_values(of.law))
    parameters[parameter.key] = {
        {"value", number(parameter.value)}, {"unit", parameter.unit}, {"symbol", parameter.symbol}};
  Json json{{"material", of.name},    {"title", of.title},        {"source", of.source},
            {"law", name_of(of.law)}, {"parameters", parameters}, {"fitted", fitted_json(range_of(of))}};
  json["curves"] = curves_json(of.law);
  return json;
}

}  // namespace dashpad::output
