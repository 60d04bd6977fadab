#pragma once
/// Output of pulses, alone or beside a computed one: documents, JSON, CSV and plots.

#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The document of a pulse: warnings and repairs, figures, and processing.
Document pulse_document(const injury::PulseReport& report, const UnitSystem& units,
                        Pictures pictures = Pictures::left_out);

/// Several pulses, two or more: a row each with mean and deviation, one over the other, then each by itself.
Document pulses_document(const std::vector<injury::PulseReport>& reports, const UnitSystem& units,
                         Pictures pictures = Pictures::left_out);

/// The figures in SI, accelerations in g; of several pulses an array.
std::string pulse_json(const injury::PulseReport& report);
std::string pulses_json(const std::vector<injury::PulseReport>& reports);

/// Time and acceleration of the pulse that the figures are of: "time_s,acceleration_g".
std::string pulse_csv(const injury::PulseReport& report, const UnitSystem& units);

/// The accelerations of several pulses over the time since the beginning of contact.
Plot pulses_plot(const std::vector<injury::PulseReport>& reports, const UnitSystem& units);

/// The pulse before and after the filter, with the windows of HIC15 and HIC36 and the level of the 3 ms clip.
Plot pulse_plot(const injury::PulseReport& report, const UnitSystem& units);

/// A measured pulse and the computed one: what was compared, and what came of it.
struct PulseComparisonReport {
  std::string case_file;
  const ImpactCase& impact;
  const Solution& solution;
  const injury::PulseReport& pulse;
  const injury::PulseComparison& comparison;
};

/// The answer in a sentence, what to beware of, the figures of both, and what they rest on.
Document pulse_comparison_document(const PulseComparisonReport& report, const UnitSystem& units,
                                   Pictures pictures = Pictures::left_out);

/// The same in SI, accelerations in g: schema/pulse-comparison.schema.json.
std::string pulse_comparison_json(const PulseComparisonReport& report);

/// Both decelerations over the time since first contact of the computed impact.
Plot pulse_comparison_plot(const PulseComparisonReport& report, const UnitSystem& units);

}  // namespace dashpad::output
