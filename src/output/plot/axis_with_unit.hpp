#pragma once
/// The axis of a quantity: "Force (kN)", with the unit that a system has for it.

#include <string>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

inline Axis axis_with_unit(const char* meaning, const char* si_unit, const UnitSystem& units) {
  Axis axis;
  axis.si_unit = si_unit;
  axis.per_si = value_in(units, 1, si_unit);
  axis.label = fmt::format("{} ({})", meaning, shown_as(si_unit, units).unit);
  return axis;
}

/// The axis of a quantity of the table of results.
inline Axis axis_of(const char* key, const UnitSystem& units) {
  const ResultQuantity& of = result_quantity(key);
  return axis_with_unit(of.title, of.si_unit, units);
}

/// SI values in the unit of that axis.
inline std::vector<double> values_in(const UnitSystem& units, std::vector<double> values,
                                     const std::string& si_unit) {
  const double factor = value_in(units, 1, si_unit);
  for (double& value : values) value *= factor;
  return values;
}

}  // namespace dashpad::output
