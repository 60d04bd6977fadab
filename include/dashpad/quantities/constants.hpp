#pragma once

#include <limits>

namespace dashpad {

/// Standard gravity, m/s2: for weights and for accelerations in g.
inline constexpr double standard_gravity = 9.80665;

/// What stands for a number where there is none.
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace dashpad
