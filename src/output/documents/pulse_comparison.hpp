#pragma once
/// The parts of a comparison of pulses that text, JSON and page share.

#include <string>
#include <vector>

#include "dashpad/output/pulse.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// "The case predicts a peak 12 % above that of the measured pulse, 8 % later; HIC15 is 31 % higher."
std::string comparison_answer(const PulseComparisonReport& report);

/// What to beware of in the case and in the pulse, a line each.
std::vector<std::string> comparison_reservations(const PulseComparisonReport& report,
                                                 const UnitSystem& units);

/// A figure a row: measured, computed, difference, its share of the measured, error of the computed.
Table comparison_table(const PulseComparisonReport& report, const UnitSystem& units);

/// How the figures are meant, a sentence each.
std::vector<std::string> comparison_notes(const PulseComparisonReport& report, const UnitSystem& units);

}  // namespace dashpad::output
