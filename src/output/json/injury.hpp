#pragma once
/// The figures of a pulse as JSON, of a computed one and of a measured one alike.

#include "dashpad/injury/figures.hpp"
#include "json/json_values.hpp"

namespace dashpad::output {

/// {"hic15": {"value": 1661.2, "begin_s": 5.8e-3, "end_s": 2.0e-2, "error": 1.6e-3}, "clip_3ms": {"value_g":
/// ...}, ...}. A measured pulse is taken as it is: without errors.
inline Json injury_json(const injury::InjuryFigures& figures, bool with_errors) {
  Json all = Json::object();
  for (const injury::InjuryValue& of : injury::injury_values(figures)) {
    const ScaledUnit unit = scaled_unit(of.quantity->si_unit, plain_si());
    Json& entry = all[of.quantity->key];
    entry[name_with_unit("value", unit.unit)] = number(unit.scale * of.value);
    if (of.time) entry["time_s"] = number(*of.time);
    if (of.begin) entry["begin_s"] = number(*of.begin);
    if (of.end) entry["end_s"] = number(*of.end);
    if (with_errors) entry["error"] = number(of.error);
  }
  return all;
}

}  // namespace dashpad::output
