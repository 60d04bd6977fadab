#include "input/option_values.hpp"

#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/quantities/quantity.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

std::vector<Fault> refused(const std::string& option, const std::string& text, std::string rule) {
  return {{.file = option + " " + text, .key = "", .value = "", .rule = std::move(rule)}};
}

}  // namespace

std::string with_gravity(const std::string& text, const std::string& si_unit) {
  const bool is_in_g = si_unit == "m/s2" && text.size() > 1 && text.ends_with('g') &&
                       std::string_view("0123456789. ").find(text[text.size() - 2]) != std::string_view::npos;
  return is_in_g ? text.substr(0, text.size() - 1) + " gravity" : text;
}

Reading<double> read_option(const std::string& option, const std::string& text, const std::string& si_unit) {
  auto [value, rule] = read_si(with_gravity(text, si_unit), si_unit);
  if (si_unit == "m/s2") replace_all(rule, "gravity", "g");
  if (rule.empty()) rule = rule_of(measured_magnitudes(si_unit), value, si_unit);
  if (rule.empty()) return value;
  return refused(option, text, std::move(rule));
}

Reading<double> read_positive_option(const std::string& option, const std::string& text,
                                     const std::string& si_unit) {
  auto value = read_option(option, text, si_unit);
  if (!value || *value > 0) return value;
  return refused(option, text, "must be more than 0");
}

Reading<double> read_tolerance(const std::string& text) {
  constexpr Bounds bounds = Options::parameters[0].bounds;
  const auto value = dashpad::parsed<double>(text);
  if (value && bounds.contain(*value)) return *value;
  return refused("--tolerance", text,
                 fmt::format("must be a number from {} to {}, such as 1e-5", bounds.lowest, bounds.highest));
}

}  // namespace dashpad::input
