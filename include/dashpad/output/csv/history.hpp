#pragma once
/// The impact over time for other programs.

#include <string>

#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// CSV text: a header row, then a row a time step. Columns: time, force, acceleration (in g), velocity,
/// motion, penetration, support_deflection, contact_radius, axis_strain; the header adds the unit:
/// "time_s", "velocity_m_per_s". Signs are those of History. Numbers read back as the very same double (in
/// plain SI as the solver's own, but for g); one that is not finite is an empty field. RFC 4180 but for the
/// line ends, which are '\n'.
std::string history_csv(const History& history, const UnitSystem& units);

}  // namespace dashpad::output
