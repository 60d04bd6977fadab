#include "dashpad/io/unit_system.hpp"

#include "dashpad/units/quantity.hpp"
#include "io/named_system.hpp"

namespace dashpad {

const std::vector<UnitSystem>& unit_systems() {
  static const std::vector<UnitSystem> systems{
      {.name = "si",
       .length = "mm",
       .mass = "kg",
       .time = "ms",
       .speed = "m/s",
       .force = "N",
       .stiffness = "N/mm",
       .pressure = "kPa",
       .energy = "J"},
      {.name = "us",
       .length = "in",
       .mass = "lb",
       .time = "ms",
       .speed = "mph",
       .force = "lbf",
       .stiffness = "lbf/in",
       .pressure = "psi",
       .energy = "in.lbf"},
      {.name = "engineering-metric",
       .length = "mm",
       .mass = "kg",
       .time = "ms",
       .speed = "km/h",
       .force = "kN",
       .stiffness = "kN/mm",
       .pressure = "MPa",
       .energy = "J"},
  };
  return systems;
}

const UnitSystem& unit_system(std::string_view name) {
  return named_system(unit_systems(), name, [](const UnitSystem& system) { return system.name; });
}

const UnitSystem& plain_si() {
  static const UnitSystem units{.name = "plain-si",
                                .length = "m",
                                .mass = "kg",
                                .time = "s",
                                .speed = "m/s",
                                .force = "N",
                                .stiffness = "N/m",
                                .pressure = "Pa",
                                .energy = "J"};
  return units;
}

const UnitSystem& units_of_files(const UnitSystem& shown) { return shown.name == "si" ? plain_si() : shown; }

std::string unit_for(const UnitSystem& units, const std::string& si_unit) {
  if (si_unit == "m") return units.length;
  if (si_unit == "kg") return units.mass;
  if (si_unit == "s") return units.time;
  if (si_unit == "m/s") return units.speed;
  if (si_unit == "N") return units.force;
  if (si_unit == "N/m") return units.stiffness;
  if (si_unit == "Pa") return units.pressure;
  if (si_unit == "J") return units.energy;
  return si_unit;
}

double value_in(const UnitSystem& units, double value, const std::string& si_unit) {
  const std::string unit = unit_for(units, si_unit);
  return unit == si_unit ? value : from_si(value, si_unit, unit);
}

}  // namespace dashpad
