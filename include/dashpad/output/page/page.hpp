#pragma once
/// One impact as a page to look at in a browser: one HTML file, which asks nothing of any network.

#include <string>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/output/blows.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The HTML file: case, outcome, warnings, figures, plots, and the case to run again. `shown` are the units
/// at first; the reader may switch to the others. `snapshots` may be empty. `blows`: of a series,
/// whose last blow the solution is.
std::string page(const ImpactCase& impact, const Options& options, const Solution& solution,
                 const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots,
                 const std::vector<BlowResult>& blows = {});

}  // namespace dashpad::output
