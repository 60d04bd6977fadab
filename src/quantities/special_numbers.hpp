#pragma once
/// What stands for a number where there is none.

#include <limits>

namespace dashpad {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double no_value = std::numeric_limits<double>::quiet_NaN();

}  // namespace dashpad
