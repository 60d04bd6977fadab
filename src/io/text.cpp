#include "io/text.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace dashpad {

namespace {

/// Five whole digits or more, but not so many that an exponent is easier to read.
bool is_long(double value) { return std::abs(value) >= 9999.95 && std::abs(value) < 1e9; }

}  // namespace

std::string significant(double value) {
  if (!std::isfinite(value)) return "none";
  if (value == 0) return "0";
  if (is_long(value)) return fmt::format("{:.0f}", value);
  return fmt::format("{:#.5g}", value);
}

std::string brief(double value) {
  if (!std::isfinite(value)) return "none";
  return is_long(value) ? fmt::format("{:.0f}", value) : fmt::format("{:.5g}", value);
}

std::string brief_quantity(double value, const std::string& si_unit, const UnitSystem& units) {
  const std::string unit = shown_unit(unit_for(units, si_unit));
  const std::string number = brief(value_in(units, value, si_unit));
  return unit.empty() ? number : number + " " + unit;
}

std::string percentage(double fraction) {
  if (!std::isfinite(fraction)) return "unknown";
  return fmt::format("{:.2g} %", 100 * fraction);
}

std::string shown_unit(const std::string& unit) {
  if (unit == "1") return "";
  std::string shown;
  for (const char character : unit) shown += character == '.' ? "·" : std::string(1, character);
  return shown;
}

std::string one_line(std::string_view text) {
  std::string line{text};
  std::ranges::replace_if(
      line, [](char character) { return static_cast<unsigned char>(character) < 0x20 || character == 0x7f; },
      ' ');
  return line;
}

}  // namespace dashpad
