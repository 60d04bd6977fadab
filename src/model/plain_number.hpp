#pragma once
/// Numbers in the sentences of the model and the solver.

#include <cstdlib>
#include <string>

#include <fmt/format.h>

namespace dashpad {

/// "1230", "0.0123": three digits, and no exponent from 0.0001 to below a million.
inline std::string plain_number(double value) {
  return fmt::format("{:g}", std::strtod(fmt::format("{:.2e}", value).c_str(), nullptr));
}

}  // namespace dashpad
