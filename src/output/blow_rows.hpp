#pragma once
/// A series of blows in words and figures before it is laid out: for terminal and page.

#include <string>
#include <vector>

#include "dashpad/output/document.hpp"
#include "dashpad/output/impact.hpp"
#include "dashpad/output/text/table.hpp"

namespace dashpad::output {

/// How the peaks grow from the first blow to the last; why they do not where the pad recovers.
std::string growth_text(const ImpactCase& impact, const std::vector<BlowResult>& blows);

/// A row a blow.
Table blow_table(const ImpactCase& impact, const std::vector<BlowResult>& blows, const UnitSystem& units,
                 Detail detail);

/// The flags of blows before the last that the last does not have, and which blows have them: a line each.
std::vector<std::string> reservations(const std::vector<BlowResult>& blows);

}  // namespace dashpad::output
