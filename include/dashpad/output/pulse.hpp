#pragma once
/// A pulse and its figures: as text for people, as JSON and CSV for programs, as a picture.

#include <string>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// What to beware of and what was repaired, the figures, and what was done to the pulse.
Document pulse_document(const injury::PulseReport& report, const UnitSystem& units,
                        Pictures pictures = Pictures::left_out);

/// The same in SI, accelerations in g.
std::string pulse_json(const injury::PulseReport& report);

/// Time and acceleration of the pulse that the figures are of: "time_s,acceleration_g".
std::string pulse_csv(const injury::PulseReport& report, const UnitSystem& units);

/// The pulse, before and after the filter, with the windows of HIC15 and HIC36 and the level of the 3 ms
/// clip.
Plot pulse_plot(const injury::PulseReport& report, const UnitSystem& units);

}  // namespace dashpad::output
