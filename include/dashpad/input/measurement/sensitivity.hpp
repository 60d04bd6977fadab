#pragma once
/// What turns the volts of a logger into an acceleration.

#include <string>

namespace dashpad::input {

struct Sensitivity {
  std::string text = {};              ///< as written: "10 mV/g"
  double volts_per_acceleration = 0;  ///< V per m/s2, more than 0
};

/// "10 mV/g", "1.02 mV/(m/s2)": a voltage, and behind the slash the unit of acceleration that it stands for;
/// g is standard gravity. Throws UnitError.
Sensitivity sensitivity_of(const std::string& text);

}  // namespace dashpad::input
