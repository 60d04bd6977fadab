#pragma once
/// Gadd severity index: SI = integral of |a|^2.5 dt, a in g, t in s. Exact for the pulse that is linear
/// between its samples.

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// In g^2.5 s. Throws std::invalid_argument for a pulse that check() refuses.
double severity_index(const Pulse& pulse);

}  // namespace dashpad::injury
