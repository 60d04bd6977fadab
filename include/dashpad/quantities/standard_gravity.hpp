#pragma once

namespace dashpad {

/// Standard gravity, m/s2: for weights and for accelerations in g.
inline constexpr double standard_gravity = 9.80665;

}  // namespace dashpad
