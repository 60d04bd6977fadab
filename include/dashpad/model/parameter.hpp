#pragma once
/// What a law of a pad or the shape of a nose tells the rest of the program about its numbers: key, unit,
/// admissible range, meaning.

#include <limits>
#include <optional>
#include <string>
#include <string_view>

namespace dashpad {

/// Physically possible values of a parameter (not the range of a fit; see FittedRange).
struct Bounds {
  double lowest = -std::numeric_limits<double>::infinity();
  double highest = std::numeric_limits<double>::infinity();
  bool lowest_admitted = false;
  bool highest_admitted = false;

  /// False for NaN and for infinities as well.
  [[nodiscard]] constexpr bool contain(double value) const {
    constexpr double infinity = std::numeric_limits<double>::infinity();
    if (!(value > -infinity && value < infinity)) return false;
    return (value > lowest || (lowest_admitted && value == lowest)) &&
           (value < highest || (highest_admitted && value == highest));
  }
};

/// Greater than zero.
inline constexpr Bounds positive{.lowest = 0};
/// Zero or greater.
inline constexpr Bounds not_negative{.lowest = 0, .lowest_admitted = true};

/// One entry of a parameter table. The tables serve case files, checks, listings and tests alike.
template <class Owner>
struct Parameter {
  const char* key;     ///< name in case files and in results
  const char* symbol;  ///< symbol in theory.md
  const char* unit;    ///< SI unit as text, as "N s/m"; "1" for a pure number
  double Owner::*member;
  Bounds bounds;
  const char* meaning;
  /// Then it is what a default-made owner has.
  bool may_be_left_out = false;
};

/// A value that breaks a rule: which one, what it is (SI), and the rule in words.
struct Violation {
  std::string key;
  double value = 0;
  std::string rule;
};

/// The rule that a value breaks, if any: its bounds, or a magnitude that can be measured in any unit, beyond
/// which products overflow.
std::optional<std::string> broken_rule(double value, const Bounds& bounds, std::string_view unit);

}  // namespace dashpad
