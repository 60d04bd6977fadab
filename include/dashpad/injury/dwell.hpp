#pragma once
/// For how long |a| is above a level. Exact for the pulse that is linear between its samples.

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

// Both throw std::invalid_argument for a pulse that check() refuses or a level that is negative. Above means
// above: a plateau at the level does not count, and a touch of the level from above divides a stretch.

/// All stretches above `level` (m/s2, >= 0) added, s: FMVSS 218's dwell time.
double cumulative_dwell(const Pulse& pulse, double level);

/// The longest of them, s.
double longest_dwell(const Pulse& pulse, double level);

}  // namespace dashpad::injury
