#pragma once
/// Standard gravity by its usual letter.

#include "dashpad/quantities/constants.hpp"

namespace dashpad {

inline constexpr double g = standard_gravity;

}  // namespace dashpad
