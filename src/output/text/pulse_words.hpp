#pragma once

#include <string>

#include "dashpad/injury/pulse_report.hpp"
#include "injury/pulse_words.hpp"

namespace dashpad::output {

/// "CFC1000, corner of SAE J211, ends mirrored".
std::string filter_words(const injury::PulseFilter& filter);

}  // namespace dashpad::output
