#pragma once
/// Bounds for values that are read: what no foam, pad or sensor has is a typing error.

#include <string>
#include <string_view>

#include "dashpad/quantities/quantity.hpp"

namespace dashpad {

/// Magnitudes, SI. 0 is always admitted.
struct Magnitudes {
  double least = 0, most = 0;
  [[nodiscard]] bool admit(double value) const;
};

/// The bounds for values stated in a file or an option, in any dimension: those of the parameters of laws.
inline constexpr Magnitudes stated_magnitudes{1e-15, 1e15};

/// The bounds for measured values: the largest value of a sample, and the least peak, step or quantity on the
/// command line. They are wide, by a factor of a thousand or more beyond any test.
Magnitudes measured_magnitudes(std::string_view si_unit);

/// The rule that a value beyond the bounds breaks; "" within them.
std::string rule_of(const Magnitudes& bounds, double value, const std::string& si_unit);

/// read_si() of what is stated: a value beyond the bounds breaks a rule too.
SiValue read_stated(std::string_view text, const std::string& si_unit);

/// The same for those who pass the rule on as an exception: throws UnitError.
double stated_si(std::string_view text, const std::string& si_unit);

}  // namespace dashpad
