#pragma once
/// The values at which a verdict turns, as people and programs read them.

#include <string>

#include "dashpad/margin/margin.hpp"
#include "dashpad/output/document.hpp"
#include "dashpad/output/plot/plot.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// "Passes if the thickness of the pad is at least 29.4 mm (95 % interval 28.1 to 31 mm)": all solutions, or
/// how near the range comes to one.
std::string margin_answer(const margin::Answer& answer, const UnitSystem& units);

/// The answer, what decides it, what is uncertain, and figures over the range. `file` is the case file.
Document margin_document(const margin::Answer& answer, const std::string& file, const UnitSystem& units,
                         Pictures pictures = Pictures::left_out);

/// Each figure as a share of its limit over the range of the key; with draws also the share that passes.
Plot margin_plot(const margin::Answer& answer, const UnitSystem& units);

/// Everything, in SI and g; what is absent or not finite is null.
std::string margin_json(const margin::Answer& answer);

/// A row for each value of the key that was looked at: figures, share of the limit with its interval.
std::string margin_csv(const margin::Answer& answer);

}  // namespace dashpad::output
