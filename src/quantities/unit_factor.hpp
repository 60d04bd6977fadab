#pragma once
/// Units as text, by UDUNITS-2 with corrections.

#include <string>

namespace dashpad {

enum class UnitMatch { same_dimension, other_dimension, unknown };

struct UnitFactor {
  UnitMatch match = UnitMatch::unknown;
  double factor = 0;  ///< one `unit` in `si_unit`, where the dimensions are the same
};

/// What one `unit` is worth in `si_unit`. Scales that do not go through zero (degC, decibels) and reciprocals
/// (s as 1/s) count as another dimension. Thread-safe. Throws UnitDatabaseError.
UnitFactor unit_factor(const std::string& unit, const std::string& si_unit);

}  // namespace dashpad
