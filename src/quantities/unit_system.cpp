#include "dashpad/quantities/unit_system.hpp"

#include <array>
#include <stdexcept>

#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/quantity.hpp"

namespace dashpad {
namespace {

constexpr std::size_t for_people = 3;

// clang-format off
const std::array<UnitSystem, 9>& table() {
  static const std::array<UnitSystem, 9> systems{{
      // name               length mass         time  speed    acceleration force stiffness pressure energy
      {"si",                "mm", "kg",        "ms", "m/s",   "m/s2",      "N",   "N/mm",   "kPa", "J"},
      {"us",                "in", "lb",        "ms", "mph",   "m/s2",      "lbf", "lbf/in", "psi", "in.lbf"},
      {"engineering-metric", "mm", "kg",       "ms", "km/h",  "m/s2",      "kN",  "kN/mm",  "MPa", "J"},
      {"kg-mm-ms",          "mm", "kg",        "ms", "mm/ms", "mm/ms2",    "kN",  "kN/mm",  "GPa", "J"},
      {"kg-m-s",            "m",  "kg",        "s",  "m/s",   "m/s2",      "N",   "N/m",    "Pa",  "J"},
      {"t-mm-s",            "mm", "t",         "s",  "mm/s",  "mm/s2",     "N",   "N/mm",   "MPa", "mJ"},
      {"g-mm-ms",           "mm", "g",         "ms", "mm/ms", "mm/ms2",    "N",   "N/mm",   "MPa", "mJ"},
      {"g-cm-us",           "cm", "g",         "us", "cm/us", "cm/us2",    "g.cm/us2", "g/us2", "Mbar", "g.cm2/us2"},
      {"lbf-s2/in-in-s",    "in", "lbf.s2/in", "s",  "in/s",  "in/s2",     "lbf", "lbf/in", "psi", "in.lbf"},
  }};
  return systems;
}
// clang-format on

const UnitSystem& named(std::span<const UnitSystem> systems, std::string_view name) {
  std::string names;
  for (const UnitSystem& system : systems) {
    if (system.name == name) return system;
    names += (names.empty() ? "" : ", ") + system.name;
  }
  throw std::invalid_argument("unit system \"" + std::string{name} + "\": must be one of " + names);
}

}  // namespace

std::span<const UnitSystem> unit_systems() { return std::span(table()).first(for_people); }
std::span<const UnitSystem> consistent_systems() { return std::span(table()).subspan(for_people); }

const UnitSystem& unit_system(std::string_view name) { return named(unit_systems(), name); }
const UnitSystem& consistent_system(std::string_view name) { return named(consistent_systems(), name); }
const UnitSystem& plain_si() {
  static const UnitSystem& units = consistent_system("kg-m-s");
  return units;
}

const UnitSystem& units_of_files(const UnitSystem& shown) { return shown.name == "si" ? plain_si() : shown; }

std::string unit_for(const UnitSystem& units, const std::string& si_unit) {
  if (si_unit == "m") return units.length;
  if (si_unit == "kg") return units.mass;
  if (si_unit == "s") return units.time;
  if (si_unit == "m/s") return units.speed;
  if (si_unit == "m/s2") return units.acceleration;
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

ScaledUnit scaled_unit(const std::string& si_unit, const UnitSystem& units) {
  if (si_unit == "m/s2") return {1 / standard_gravity, "g"};
  if (si_unit.empty()) return {1, "1"};
  return {value_in(units, 1, si_unit), unit_for(units, si_unit)};
}

std::string name_with_unit(const std::string& name, const std::string& unit) {
  if (unit.empty() || unit == "1") return name;
  if (unit.starts_with("1/")) return name + "_per_" + unit.substr(2);
  std::string text = name + "_";
  for (const char character : unit)
    text +=
        character == '/' ? "_per_" : std::string(1, character == '.' || character == ' ' ? '_' : character);
  return text;
}

}  // namespace dashpad
