#pragma once
/// The parts of a standard that its own text and that of an assessment share.

#include <array>
#include <string>

#include "dashpad/injury/standard.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad::output {

struct NamedValue {
  const char* name;
  const char* si_unit;
  const injury::StandardValue* value;
};

/// The values that a standard states for its impactor.
std::array<NamedValue, 3> values_of(const injury::Standard& standard);

/// "6.67 m/s (after a fall of 2.3 m)", or that it is the case's.
std::string value_text(const NamedValue& entry, const UnitSystem& units);

/// The name with the variants in force: "fmvss-218:hemispherical:small".
std::string full_name(const injury::Standard& standard);

}  // namespace dashpad::output
