#pragma once
/// Quantities at the door: text with a unit to SI, and SI to a unit for people. Nothing else of the program
/// knows units.

#include <stdexcept>
#include <string>
#include <string_view>

namespace dashpad {

/// Text that is not a quantity of the wanted dimension. what() says the rule, in the user's words.
class UnitError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Value of `text` ("20 mph", "7.96 psi", "1.05 kN/cm") in the SI unit `si_unit` ("m/s", "Pa", "N/m"; "1" for
/// a pure number). Any unit of that dimension is accepted. Throws UnitError: no number, no unit (the message
/// names units that it could have), unknown unit, wrong dimension, not finite. The pound (lb)
/// is a mass, the pound-force (lbf) a force and g a gram.
double to_si(std::string_view text, const std::string& si_unit);

/// An SI value in another unit of its dimension ("m/s" to "mph"). Throws UnitError for a wrong unit.
double from_si(double value, const std::string& si_unit, const std::string& unit);

/// Examples of units for a dimension, for messages: "m/s" gives "m/s, km/h, mph, in/s".
std::string examples_of_units(const std::string& si_unit);

}  // namespace dashpad
