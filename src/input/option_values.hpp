#pragma once
/// Values as options of the command state them; their faults name the option.

#include <string>

#include "dashpad/input/reading.hpp"

namespace dashpad::input {

/// The text of a quantity with its unit as the readers know it: in an acceleration, g is gravity and no gram.
std::string with_gravity(const std::string& text, const std::string& si_unit);

/// The value of an option in SI.
Reading<double> read_option(const std::string& option, const std::string& text, const std::string& si_unit);
/// A value that must be more than 0.
Reading<double> read_positive_option(const std::string& option, const std::string& text,
                                     const std::string& si_unit);

/// The relative error allowed, of --tolerance.
Reading<double> read_tolerance(const std::string& text);

}  // namespace dashpad::input
