#pragma once
/// A run of the 1984 program for other programs, in its own units and signs.

#include <string>

#include "dashpad/spit1984/run.hpp"

namespace dashpad::spit1984 {

/// The deck, how it was run and what came out, as JSON. Keys name the units; forces are negative in
/// compression, the rebound speed is negative. A number that is not finite is null.
std::string run_json(const Deck& deck, const Settings& settings, const Run& run);

/// The time history, every step of it, as CSV: time_ms, force_lbf, acceleration_g, speed_in_per_s, motion_in,
/// penetration_in. Numbers read back as the very same double; one that is not finite is an empty field.
std::string run_csv(const Run& run);

}  // namespace dashpad::spit1984
