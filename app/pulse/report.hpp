#pragma once
/// What `dashpad pulse` and `dashpad compare --pulse` do with a measured pulse before they show it.

#include <functional>
#include <string>
#include <vector>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/input/input_file.hpp"
#include "pulse/request.hpp"

namespace dashpad::app {

/// The pulse of the request, read, zeroed, resampled and filtered as asked for, with its figures and flags.
/// `judge` sees the files that it was read from, and may add to `wrong`. Throws Refused with all that is
/// wrong then.
injury::PulseReport pulse_report(
    const PulseRequest& request, std::vector<std::string> wrong,
    const std::function<void(const std::vector<input::InputFile>&, std::vector<std::string>&)>& judge);

}  // namespace dashpad::app
