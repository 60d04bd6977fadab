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

/// What one `unit` is worth in `si_unit`. A temperature with a zero of its own (degC) alone counts as another
/// dimension; so does a reciprocal (s as 1/s). Reads "N s/m" as "(N s)/m". Of more than 100 characters none
/// is known.
UnitFactor unit_factor(std::string_view unit, std::string_view si_unit);

/// Without blanks at the ends, with signs that look like another (the Greek letter mu, the hard space, raised
/// digits, the sign for a degree) in the form that unit_factor() knows, and "/s" as "1/s".
std::string tidy_unit(std::string_view text);

/// What to write in place of a name that means units of several sizes; "" of others.
std::string_view advice_on_unit(std::string_view name);

}  // namespace dashpad
