#pragma once
/// The columns of numbers that the page plots.

#include <vector>

#include <nlohmann/json.hpp>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad::output {

/// The history, thinned to what a plot can show, and in it the energies (J).
nlohmann::ordered_json page_history(const ImpactCase& impact, const History& history);

/// The fields of the contact, each with the deviation of its force from that of the history.
nlohmann::ordered_json page_snapshots(const std::vector<ContactSnapshot>& snapshots);

/// Seven digits: more than a plot shows. Null if not finite.
nlohmann::ordered_json rounded(double value);

}  // namespace dashpad::output
