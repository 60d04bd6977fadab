#pragma once
/// JSON that several results share, in the units of plain_si().

#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/interval.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/model/pad/material.hpp"
#include "json/json_values.hpp"

namespace dashpad::output {

Json flags_json(const std::vector<Flag>& flags);

/// The interval of a figure: `high` is null where there is no bound.
Json interval_json(const FigureInterval& interval);

/// The figures of a pulse: {"hic15": {"value": 1661.2, "begin_s": 5.8e-3, "end_s": 2.0e-2, "error": 1.6e-3},
/// "clip_3ms": {"value_g": ...}, ...}. Measured pulses have no errors.
Json injury_json(const injury::InjuryFigures& figures, bool with_errors);

/// The results of criteria: [{"metric": "hic15", "value": 743, "limit": 1000, "verdict": "pass", ...}, ...].
Json criteria_json(const std::vector<injury::CriterionResult>& results);

/// A pad material.
Json material_json(const Material& material);

}  // namespace dashpad::output
