#pragma once
/// Conversion between texts with units and SI, for input and output; the rest of the program is in SI.

#include <stdexcept>
#include <string>
#include <string_view>

namespace dashpad {

/// Text that is not a quantity of the wanted dimension. what() says the rule, in the user's words.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A value in SI, or the rule that a text breaks, in the user's words.
struct SiValue {
  double value = 0;  ///< 0 where a rule is broken
  std::string rule;  ///< "" where none is
};

/// The value of `text` ("20 mph", "7.96 psi", "1.05 kN/cm") in the SI unit `si_unit` ("m/s", "Pa", "N/m"; "1"
/// for a pure number). Any unit of that dimension is accepted; the pound (lb) is a mass, the pound-force
/// (lbf) a force, and g a gram. A rule is broken without a finite number and a known unit of the dimension.
SiValue read_si(std::string_view text, const std::string& si_unit);

/// The same for those who pass the rule on as an exception: throws UnitError.
double to_si(std::string_view text, const std::string& si_unit);

/// An SI value in another unit of its dimension ("m/s" to "mph"). Throws UnitError for a wrong unit.
double from_si(double value, const std::string& si_unit, const std::string& unit);

/// Examples of units for a dimension, for messages: "m/s" gives "m/s, km/h, mph, in/s".
std::string examples_of_units(const std::string& si_unit);

}  // namespace dashpad
