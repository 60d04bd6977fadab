#pragma once

#include <string>
#include <vector>

#include "dashpad/injury/pulse_report.hpp"

namespace dashpad::injury {

/// "1.2, 0, -0.3 g", of accelerations in m/s2; 0 for what is 0 up to rounding, compared with the peak.
std::string each_in_g(const std::vector<double>& accelerations, double peak);

/// "12 %": two digits, and all digits before the point.
std::string in_percent(double fraction);

/// "HIC15 is 4.4 % higher with it than without".
std::string change_of_hic15(const OffsetEffect& effect);

}  // namespace dashpad::injury
