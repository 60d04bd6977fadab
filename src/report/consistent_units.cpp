#include "dashpad/report/consistent_units.hpp"

#include "dashpad/units/quantity.hpp"
#include "io/named_system.hpp"

namespace dashpad {

const std::vector<ConsistentUnits>& consistent_systems() {
  static const std::vector<ConsistentUnits> systems{
      {.units = {.name = "kg-mm-ms",
                 .length = "mm",
                 .mass = "kg",
                 .time = "ms",
                 .speed = "mm/ms",
                 .force = "kN",
                 .stiffness = "kN/mm",
                 .pressure = "GPa",
                 .energy = "J"},
       .acceleration = "mm/ms2",
       .radioss_begin = "kg mm ms"},
      {.units = {.name = "kg-m-s",
                 .length = "m",
                 .mass = "kg",
                 .time = "s",
                 .speed = "m/s",
                 .force = "N",
                 .stiffness = "N/m",
                 .pressure = "Pa",
                 .energy = "J"},
       .acceleration = "m/s2",
       .radioss_begin = "kg m s"},
      {.units = {.name = "t-mm-s",
                 .length = "mm",
                 .mass = "t",
                 .time = "s",
                 .speed = "mm/s",
                 .force = "N",
                 .stiffness = "N/mm",
                 .pressure = "MPa",
                 .energy = "mJ"},
       .acceleration = "mm/s2",
       .radioss_begin = "Mg mm s"},
      {.units = {.name = "lbf-s2/in-in-s",
                 .length = "in",
                 .mass = "lbf.s2/in",
                 .time = "s",
                 .speed = "in/s",
                 .force = "lbf",
                 .stiffness = "lbf/in",
                 .pressure = "psi",
                 .energy = "in.lbf"},
       .acceleration = "in/s2",
       .radioss_begin = "175.126835246476 0.0254 1"},
  };
  return systems;
}

const ConsistentUnits& consistent_system(std::string_view name) {
  return named_system(consistent_systems(), name,
                      [](const ConsistentUnits& system) { return system.units.name; });
}

std::string unit_for(const ConsistentUnits& units, const std::string& si_unit) {
  return si_unit == "m/s2" ? units.acceleration : unit_for(units.units, si_unit);
}

double factor_for(const ConsistentUnits& units, const std::string& si_unit) {
  const std::string unit = unit_for(units, si_unit);
  return unit == si_unit ? 1 : from_si(1, si_unit, unit);
}

}  // namespace dashpad
