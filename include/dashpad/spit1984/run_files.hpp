#pragma once
/// What is written of a run of the 1984 program, in its own units and signs: its printed report, JSON, CSV.

#include <string>

#include "dashpad/spit1984/run.hpp"

namespace dashpad::spit1984 {

/// The two devices that the listing writes to. The line printer (unit 21) printed Appendix C. Only the
/// terminal (unit 5) is told of iterations stopped at the precision limit and of ABENDs 903 and 904.
enum class Device { printer, terminal };

/// The report in the layout of the report's Appendix C: FORMAT statements 6000 and 601 to 613. Lines end in
/// '\n'. The first character of each Fortran record is carriage control and becomes what it did: '1' a form
/// feed, '0' an empty line before.
std::string listing(const Deck& deck, const Run& run, Device device);

/// The deck, how it was run and what came out, as JSON. Keys name the units; forces are negative in
/// compression, the rebound speed is negative. A number that is not finite is null.
std::string run_json(const Deck& deck, const Settings& settings, const Run& run);

/// The time history, every step of it, as CSV: time_ms, force_lbf, acceleration_g, speed_in_per_s, motion_in,
/// penetration_in. Numbers read back as the very same double; one that is not finite is an empty field.
std::string run_csv(const Run& run);

}  // namespace dashpad::spit1984
