#pragma once
/// A pulse that was read, and where it came from.

#include <vector>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/input_file.hpp"

namespace dashpad::input {

struct PulseFile {
  injury::MeasuredPulse measured;
  std::vector<InputFile> files;  ///< that it was read from: of a test, each of its parts
};

}  // namespace dashpad::input
