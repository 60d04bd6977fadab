#pragma once
/// A measured pulse beside the computed one: as text for people, as JSON for programs, as a picture and a
/// page.

#include <string>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// What was compared, and what came of it.
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

/// Both decelerations over time, which counts from first contact of the computed impact.
Plot pulse_comparison_plot(const PulseComparisonReport& report, const UnitSystem& units);

}  // namespace dashpad::output
