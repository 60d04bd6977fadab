#pragma once
/// Units as text: names with prefixes (unit_table.hpp), their products, quotients and whole powers.

#include <string>
#include <string_view>

namespace dashpad {

enum class UnitMatch {
  same_dimension,
  other_dimension,
  unknown,       ///< a name, or an order of signs, that is none
  holds_number,  ///< beside exponents and the 1 of "1/s": "3 mph"
  not_a_unit     ///< holds a sign that no unit has
};

struct UnitFactor {
  UnitMatch match = UnitMatch::unknown;
  double factor = 0;  ///< one `unit` in `si_unit`, where the dimensions are the same
};

/// The value of one `unit` in `si_unit`. A temperature scale with its own zero (degC) counts as another
/// dimension, as does a reciprocal (s as 1/s). "N s/m" is "(N s)/m". Beyond 100 characters: unknown.
UnitFactor unit_factor(std::string_view unit, std::string_view si_unit);

/// The text without blanks at its ends. Look-alike signs (the Greek letter mu, the no-break space, raised
/// digits, the degree sign) become those that unit_factor() knows, and "/s" becomes "1/s".
std::string tidy_unit(std::string_view text);

/// Advice for a name that means units of several sizes; "" for other names.
std::string_view advice_on_unit(std::string_view name);

}  // namespace dashpad
