#pragma once
/// The dimensions that Dashpad meets: how people call them, and which units they use.

#include <array>
#include <span>
#include <string>
#include <string_view>

namespace dashpad {

struct Dimension {
  std::string_view si_unit;
  std::string_view name;                       ///< with its article: "a speed"
  std::array<std::string_view, 4> examples{};  ///< of units, the best known first; may end early
};

/// Every dimension with a name.
std::span<const Dimension> known_dimensions();

/// The one with this SI unit; without a name where there is none.
Dimension dimension_of(std::string_view si_unit);

}  // namespace dashpad
