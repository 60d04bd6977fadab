#pragma once
/// Units of finite-element decks: systems in which force = mass * length / time^2, so that no equation needs
/// a factor. A deck does not say its units; whoever writes it keeps to one system.

#include <string>
#include <string_view>
#include <vector>

#include "dashpad/io/unit_system.hpp"

namespace dashpad {

struct ConsistentUnits {
  UnitSystem units;
  std::string acceleration;
  std::string
      radioss_begin;  ///< mass, length and time as on the line of /BEGIN: codes, or numbers of SI units
};

/// The systems on offer, the default first:
///   kg-mm-ms         kN, GPa, J, mm/ms
///   kg-m-s           N, Pa, J, m/s
///   t-mm-s           N, MPa, mJ, mm/s
///   lbf-s2/in-in-s   lbf, psi, in.lbf, in/s; the mass is 175.127 kg
const std::vector<ConsistentUnits>& consistent_systems();

/// The system of that name. Throws std::invalid_argument that names the systems on offer.
const ConsistentUnits& consistent_system(std::string_view name);

/// The unit that a system has for an SI unit: "m/s2" gives "mm/ms2".
std::string unit_for(const ConsistentUnits& units, const std::string& si_unit);

/// How many of the system's units an SI unit is.
double factor_for(const ConsistentUnits& units, const std::string& si_unit);

}  // namespace dashpad
