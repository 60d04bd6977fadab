#pragma once
/// A pulse that was read, where it came from, and what turned the volts of a logger into an acceleration.

#include <string>
#include <vector>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/reading.hpp"

namespace dashpad::input {

struct Sensitivity {
  std::string text = {};              ///< as written: "10 mV/g"
  double volts_per_acceleration = 0;  ///< V per m/s2, more than 0
};

/// "10 mV/g", "1.02 mV/(m/s2)": a voltage, and behind the slash the unit of acceleration that it stands for;
/// g is standard gravity. Throws UnitError.
Sensitivity sensitivity_of(const std::string& text);

struct PulseFile {
  injury::MeasuredPulse measured;
  std::vector<InputFile> files;  ///< that it was read from: of a test, each of its parts
};

}  // namespace dashpad::input
