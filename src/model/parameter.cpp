#include "dashpad/model/parameter.hpp"

#include <fmt/format.h>

#include <cmath>

namespace dashpad {
namespace {

/// Beyond any measurable magnitude in any unit; keeps products of parameters from overflowing.
constexpr double largest_magnitude = 1e15;

bool is_out_of_scale(double value) {
  const double magnitude = std::abs(value);
  return magnitude > largest_magnitude || (magnitude > 0 && magnitude < 1 / largest_magnitude);
}

}  // namespace

std::string rule_of(const Bounds& bounds, std::string_view unit) {
  const std::string suffix = unit == "1" ? "" : fmt::format(" {}", unit);
  if (*bounds.words != '\0') return fmt::format("must be {}", bounds.words);
  if (bounds.is_wide)
    return fmt::format("must be more than 0 (between {0} {2} and {1} {2})", bounds.lowest, bounds.highest,
                       unit);
  std::string rule = "must be a finite number";
  if (std::isfinite(bounds.lowest))
    rule = fmt::format("must be {}{}{}", bounds.lowest_admitted ? "at least " : "more than ", bounds.lowest,
                       suffix);
  if (std::isfinite(bounds.highest))
    rule += fmt::format(" and {}{}{}", bounds.highest_admitted ? "at most " : "less than ", bounds.highest,
                        suffix);
  return rule;
}

std::optional<std::string> broken_rule(double value, const Bounds& bounds, std::string_view unit) {
  if (!bounds.contain(value)) return rule_of(bounds, unit);
  if (is_out_of_scale(value))
    return fmt::format("must have a magnitude between {} and {} in {}", 1 / largest_magnitude,
                       largest_magnitude, unit);
  return std::nullopt;
}

}  // namespace dashpad
