#pragma once
/// What the page shows, as JSON.

#include <string>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/blows.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// JSON in one line without a "<", so that no text of a user ends the element that holds it, or begins
/// another. Columns are in SI, to seven digits.
std::string page_data(const ImpactCase& impact, const Options& options, const Solution& solution,
                      const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots,
                      const std::vector<BlowResult>& blows = {});

}  // namespace dashpad::output
