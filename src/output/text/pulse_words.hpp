#pragma once

#include <string>
#include <vector>

#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "injury/pulse_words.hpp"
#include "output/result_rows.hpp"

namespace dashpad::output {

/// "CFC1000, corner of SAE J211, ends mirrored".
std::string filter_words(const injury::PulseFilter& filter);

/// The figures of a pulse, and what else it was asked for.
std::vector<ResultRow> report_rows(const injury::PulseReport& report, const UnitSystem& units, Detail detail);

/// "peak acceleration ± 2.3 % (sampling 0.4 %, filter 1.1 %, calibration 2 %); ..., k = 2", and what is not
/// in it. With Detail::main of peak and HIC15 alone.
std::string uncertainty_words(const injury::MeasurementUncertainty& of, Detail detail);

/// What the figures leave in doubt: flags and remarks, a line each.
std::vector<std::string> reservations(const injury::PulseReport& report);

/// Where the pulse comes from and what was done to it, indented lines.
std::string pulse_source(const injury::PulseReport& report, const UnitSystem& units);
/// The same in one sentence, for a page.
std::string pulse_source_sentence(const injury::PulseReport& report, const UnitSystem& units);

}  // namespace dashpad::output
