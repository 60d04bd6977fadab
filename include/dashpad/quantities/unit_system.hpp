#pragma once
/// The table of unit systems: those for showing results, and those of finite-element decks.

#include <span>
#include <string>
#include <string_view>

namespace dashpad {

/// A unit for each kind of quantity, as quantity.hpp reads it. Strain rates are in 1/s everywhere.
struct UnitSystem {
  std::string name;  ///< name on the command line
  std::string length;
  std::string mass;
  std::string time;
  std::string speed;
  std::string acceleration;  ///< unit in decks; people are shown g
  std::string force;
  std::string stiffness;
  std::string pressure;
  std::string energy;
};

/// The systems for people, the default first:
///   si                  mm, kg, ms, m/s, N, N/mm, kPa, J: SI with the prefixes that suit an impact
///   us                  in, lb, ms, mph, lbf, lbf/in, psi, in.lbf: the units of the 1986 report
///   engineering-metric  mm, kg, ms, km/h, kN, kN/mm, MPa, J: the units of crash laboratories
std::span<const UnitSystem> unit_systems();

/// The systems for decks, the default first: force = mass * length / time^2, so that no equation needs a
/// factor. A deck does not say its units; whoever writes it keeps to one system.
///   kg-mm-ms         kN, GPa, J, mm/ms
///   kg-m-s           N, Pa, J, m/s
///   t-mm-s           N, MPa, mJ, mm/s
///   g-mm-ms          N, MPa, mJ, mm/ms
///   g-cm-us          Mbar, cm/us; the force is 10 MN
///   lbf-s2/in-in-s   lbf, psi, in.lbf, in/s; the mass is 175.127 kg
std::span<const UnitSystem> consistent_systems();

/// The system of that name for people or for decks. Throws std::invalid_argument that names those on offer.
const UnitSystem& unit_system(std::string_view name);
const UnitSystem& consistent_system(std::string_view name);

/// SI without prefixes, kg-m-s: what files hold.
const UnitSystem& plain_si();

/// The units for a file that goes with a summary in `shown`: plain SI where people see SI.
const UnitSystem& units_of_files(const UnitSystem& shown);

/// The unit of a system for an SI unit: "m/s" gives "mph". Others ("1", "1/s") are returned unchanged.
std::string unit_for(const UnitSystem& units, const std::string& si_unit);

/// An SI value in the unit that the system has for it.
double value_in(const UnitSystem& units, double value, const std::string& si_unit);

/// A unit, and what an SI value is multiplied with for it.
struct ScaledUnit {
  double scale = 1;
  std::string unit = {};  ///< "1" for a pure number
};
/// Accelerations in g, everything else as the system has it: for people, and for files (plain_si()).
ScaledUnit scaled_unit(const std::string& si_unit, const UnitSystem& units);

/// A name in a file with its unit: "force_lbf", "velocity_m_per_s", "peak_strain".
std::string name_with_unit(const std::string& name, const std::string& unit);

}  // namespace dashpad
