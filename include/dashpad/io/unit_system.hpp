#pragma once
/// The units in which results are shown to people.

#include <string>
#include <string_view>
#include <vector>

namespace dashpad {

/// A unit for each kind of quantity, as text that dashpad/units/quantity.hpp reads. Accelerations are in g
/// everywhere and strain rates in 1/s.
struct UnitSystem {
  std::string name;  ///< as on the command line
  std::string length;
  std::string mass;
  std::string time;
  std::string speed;
  std::string force;
  std::string stiffness;
  std::string pressure;
  std::string energy;
};

/// The systems on offer, the default first:
///   si                  mm, kg, ms, m/s, N, N/mm, kPa, J: SI with the prefixes that suit an impact
///   us                  in, lb, ms, mph, lbf, lbf/in, psi, in.lbf: the units of the 1986 report
///   engineering-metric  mm, kg, ms, km/h, kN, kN/mm, MPa, J: the units of crash laboratories
const std::vector<UnitSystem>& unit_systems();

/// The system of that name. Throws std::invalid_argument that names the systems on offer.
const UnitSystem& unit_system(std::string_view name);

/// SI without prefixes: m, kg, s, m/s, N, N/m, Pa, J. What files hold.
const UnitSystem& plain_si();

/// The units for a file that goes with a summary in `shown`: plain SI where people see SI.
const UnitSystem& units_of_files(const UnitSystem& shown);

/// The unit that a system has for an SI unit: "m/s" gives "mph". An SI unit that the system has no other
/// unit for ("1", "1/s") is returned as it is.
std::string unit_for(const UnitSystem& units, const std::string& si_unit);

/// An SI value in the unit that the system has for it.
double value_in(const UnitSystem& units, double value, const std::string& si_unit);

}  // namespace dashpad
