#pragma once

#include <limits>

namespace dashpad {

/// Standard gravity, m/s2: for weights and for accelerations in g.
inline constexpr double standard_gravity = 9.80665;

inline constexpr double infinite = std::numeric_limits<double>::infinity();
/// The value of an absent number.
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace dashpad
