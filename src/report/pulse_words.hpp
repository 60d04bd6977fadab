#pragma once

#include <string>

#include "dashpad/report/pulse_text.hpp"

namespace dashpad {

/// "CFC1000, corner of SAE J211, ends mirrored".
std::string filter_words(const PulseFilter& filter);

}  // namespace dashpad
