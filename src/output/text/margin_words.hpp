#pragma once
/// Words for where a verdict turns.

#include <string>

#include "dashpad/margin/margin.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// A value of the key, with its unit: "29.4 mm".
std::string key_text(const margin::Answer& answer, double value, const UnitSystem& units);
/// A turn with its interval: "29.4 mm (95 % interval 28.1 to 31 mm)", "29.4 mm (95 % interval: above 28.1
/// mm)".
std::string turn_text(const margin::Answer& answer, const margin::Turn& turn, const UnitSystem& units);
/// "HIC15", "HIC15 of en-1177" if several standards limit it.
std::string limit_title(const margin::Answer& answer, std::size_t limit);
/// "at most 1000", "80 g".
std::string limit_text(const margin::Limit& limit, const UnitSystem& units);
/// A figure as it is shown; "bottomed out" or "none" without one.
std::string figure_text(const margin::Limit& limit, double figure, const UnitSystem& units);
/// The figure over its limit that has this excess.
double share_of_limit(const margin::Limit& limit, double excess);

}  // namespace dashpad::output
