#pragma once
/// The parts of the documents of pulses that plots, JSON and each other share.

#include <string>
#include <vector>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/pulse.hpp"
#include "dashpad/output/text/table.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// "CFC1000, corner of SAE J211, ends mirrored".
std::string filter_words(const injury::PulseFilter& filter);

/// "Peak 151 g, HIC15 890"; beside a standard what its limits make of it.
std::string pulse_answer(const injury::PulseReport& report, const UnitSystem& units);
Tone pulse_tone(const injury::PulseReport& report);

/// "at 5.42 m/s, after a fall of 1.5 m".
std::string impact_words(const injury::MeasuredImpact& impact, const UnitSystem& units);

/// The flags and remarks of a pulse, a line each.
std::vector<std::string> reservations(const injury::PulseReport& report);

/// The origin and the processing of a pulse: pairs of a title and its text.
std::vector<std::vector<std::string>> pulse_basis(const injury::PulseReport& report, const UnitSystem& units);

/// "The case predicts a peak 12 % above that of the measured pulse, 8 % later; HIC15 is 31 % higher."
std::string comparison_answer(const PulseComparisonReport& report);

/// A figure a row: measured, computed, difference, its share of the measured, error of the computed.
Table comparison_table(const PulseComparisonReport& report, const UnitSystem& units);

/// Notes on how the figures are defined, a sentence each.
std::vector<std::string> comparison_notes(const PulseComparisonReport& report, const UnitSystem& units);

}  // namespace dashpad::output
