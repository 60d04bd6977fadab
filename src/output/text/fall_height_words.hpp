#pragma once
/// Words for critical fall heights.

#include <string>

#include "dashpad/output/fall_height.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

/// The standard by which the drops, or the case, are judged.
const injury::Standard& standard_of(const FallHeightReport& report);

/// Metres, or feet where lengths are in inches.
ScaledUnit unit_of_heights(const UnitSystem& units);

/// "1.8 m": a height as it was set.
std::string height_text(double height, const UnitSystem& units);
/// "1.80 m": a height that was found, with three digits.
std::string height_result(double height, const UnitSystem& units);

/// "1.93 to 2.01 m", rounded outwards; "at least 1.93 m" where an end is 0 or infinite.
std::string height_range(double low, double high, const UnitSystem& units);

/// "centre, 23 °C"; "" if nothing tells the place from others.
std::string place_words(const fall_height::Place& place);

/// "1.97 m", "more than 2.3 m", "less than 1.2 m", "unknown"; without an end that the drops enclose.
std::string height_words(const fall_height::Crossing& crossing, const UnitSystem& units);

/// "1.93 to 2.01 m", "at least 1.9 m"; "" without one.
std::string interval_words(const fall_height::Crossing& crossing, const UnitSystem& units);

}  // namespace dashpad::output
