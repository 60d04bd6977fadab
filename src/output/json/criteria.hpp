#pragma once
/// Limits and what became of them, as JSON.

#include <vector>

#include "dashpad/injury/standard.hpp"
#include "json/json_values.hpp"

namespace dashpad::output {

/// [{"metric": "hic15", "value": 743, "limit": 1000, "margin": 257, "verdict": "pass", ...}, ...].
Json criteria_json(const std::vector<injury::CriterionResult>& results);

}  // namespace dashpad::output
