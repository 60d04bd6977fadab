#include "dashpad/quantities/quantity.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "quantities/from_chars.hpp"
#include "quantities/unit.hpp"

namespace dashpad {
namespace {

/// A dimension that Dashpad meets: how people call it, and which units they use.
struct Dimension {
  std::string_view si_unit;
  std::string_view name;                       ///< name with its article: "a speed"
  std::array<std::string_view, 4> examples{};  ///< units, the best known first; may end early
};

constexpr Dimension dimensions[] = {
    {"m", "a length", {"m", "mm", "in", "ft"}},
    {"m/s", "a speed", {"m/s", "km/h", "mph", "in/s"}},
    {"m/s2", "an acceleration", {"m/s2", "ft/s2", "gravity"}},
    {"s", "a time", {"s", "ms"}},
    {"1/s", "a rate", {"1/s", "1/ms"}},
    {"kg", "a mass", {"kg", "g", "lb"}},
    {"N", "a force", {"N", "kN", "lbf", "kgf"}},
    {"N/m", "a stiffness", {"N/m", "N/mm", "kN/m", "lbf/in"}},
    {"N s/m", "a damping coefficient", {"N s/m", "kN s/m", "lbf s/in"}},
    {"Pa", "a stress", {"Pa", "kPa", "MPa", "psi"}},
    {"J", "an energy", {"J", "kJ", "ft lbf", "in lbf"}},
    {"N s", "an impulse", {"N s", "lbf s"}},
    {"kg/m3", "a density", {"kg/m3", "g/cm3", "lb/ft3"}},
    {"kg/m2", "a mass per unit area", {"kg/m2", "g/m2", "lb/ft2"}},
    {"V", "a voltage", {"V", "mV"}},
    {"m2", "an area", {"m2", "mm2", "in2"}},
    {"m3", "a volume", {"m3", "cm3", "in3"}},
    {"rad", "an angle", {"deg", "rad"}},
    {"K", "a temperature", {"degC", "degF", "K"}},
    {"1", "a pure number", {}},
};

/// The one with this SI unit; without a name where there is none.
Dimension dimension_of(std::string_view si_unit) {
  const auto* found = std::ranges::find(dimensions, si_unit, &Dimension::si_unit);
  return found != std::end(dimensions) ? *found : Dimension{si_unit, "", {si_unit}};
}

constexpr std::size_t longest_text = 100;

struct NumberAndUnit {
  double number = 0;
  std::string number_text;
  std::string unit;
  std::string rule = {};  ///< rule that the text breaks; "" if none
};

NumberAndUnit breaks(std::string rule) { return {0, "", "", std::move(rule)}; }

/// "a speed", or "a value in m4" for a dimension without a name.
std::string name_of(const Dimension& dimension) {
  return dimension.name.empty() ? fmt::format("a value in {}", dimension.si_unit)
                                : std::string(dimension.name);
}

/// `"20 m/s", "20 mph"`: the examples behind a number.
std::string quoted_examples(const Dimension& dimension, std::string_view number) {
  std::string list;
  for (const auto example : dimension.examples)
    if (!example.empty()) list += fmt::format("{}\"{} {}\"", list.empty() ? "" : ", ", number, example);
  return list.empty() ? fmt::format("\"{}\"", number) : list;
}

NumberAndUnit split(std::string_view text, const Dimension& wanted) {
  if (text.size() > longest_text)
    return breaks(fmt::format("is longer than {} characters; a number and a unit are needed", longest_text));
  if (std::ranges::any_of(text, [](char c) { return static_cast<unsigned char>(c) < ' ' && c != '\t'; }))
    return breaks("contains a control character");
  const std::string tidy = tidy_unit(text);
  const char* first = tidy.data() + (tidy.starts_with('+') && !tidy.starts_with("+-") ? 1 : 0);
  const char* last = tidy.data() + tidy.size();
  NumberAndUnit result;
  const auto [end, error] = from_chars(first, last, result.number);
  if (error == std::errc::invalid_argument)
    return breaks(
        fmt::format("{} must start with a number, as in {}", name_of(wanted), quoted_examples(wanted, "20")));
  if (end != last && *end == ',')
    return breaks("write the number with a decimal point and without commas, as in 1.5 or 1500");
  if (error == std::errc::result_out_of_range)
    return breaks("the number is too large or too small to compute with");
  if (!std::isfinite(result.number)) return breaks("must be a finite number");
  result.number_text = std::string(first, end);
  result.unit = tidy_unit({end, static_cast<std::size_t>(last - end)});
  return result;
}

/// "; did you mean mph?" where a unit of the wanted dimension differs in capitals only.
std::string other_capitals(const std::string& unit, const Dimension& wanted) {
  const auto lower = [](std::string_view word) {
    std::string result(word);
    for (char& c : result)
      if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
    return result;
  };
  for (const auto example : wanted.examples)
    if (!example.empty() && lower(example) == lower(unit)) return fmt::format("; did you mean {}?", example);
  return {};
}

std::string wrong_dimension(const std::string& unit, const Dimension& wanted) {
  const auto fits = [](const std::string& text, std::string_view si_unit) {
    return unit_factor(text, si_unit).match == UnitMatch::same_dimension;
  };
  std::string rule = name_of(wanted) + " is needed";
  if (!wanted.examples[0].empty())
    rule += fmt::format(" ({})", examples_of_units(std::string(wanted.si_unit)));
  // An angle counts as a pure number, and a pure number as an angle.
  for (const Dimension& dimension : dimensions)
    if (dimension.si_unit != "rad" && fits(unit, dimension.si_unit))
      rule += fmt::format(", but \"{}\" denotes {}", unit, dimension.name);
  if (fits(fmt::format("({}) m/s2", unit), wanted.si_unit))
    rule += "; lb and kg are units of mass, and lbf, kgf and N are units of force";
  return rule + other_capitals(unit, wanted);
}

std::string unknown_unit(const std::string& unit, const Dimension& wanted) {
  if (const std::string_view advice = advice_on_unit(unit); !advice.empty())
    return fmt::format("\"{}\" is ambiguous: {}", unit, advice);
  return fmt::format("unknown unit \"{}\"; use {}{}", unit, examples_of_units(std::string(wanted.si_unit)),
                     other_capitals(unit, wanted));
}

/// The value of 1 unit in SI.
SiValue factor_of(const std::string& unit, const Dimension& wanted) {
  const std::string si_unit(wanted.si_unit);
  const auto [match, factor] = unit_factor(unit, si_unit);
  switch (match) {
    case UnitMatch::same_dimension: break;
    case UnitMatch::other_dimension: return {0, wrong_dimension(unit, wanted)};
    case UnitMatch::holds_number:
      return {0, fmt::format("one number and one unit are needed, but \"{}\" contains another number", unit)};
    case UnitMatch::not_a_unit:
      return {0, fmt::format("\"{}\" is not a unit; use {}", unit, examples_of_units(si_unit))};
    case UnitMatch::unknown: return {0, unknown_unit(unit, wanted)};
  }
  return {factor, ""};
}

}  // namespace

std::string examples_of_units(const std::string& si_unit) {
  std::string list;
  for (const auto example : dimension_of(si_unit).examples)
    if (!example.empty()) list += fmt::format("{}{}", list.empty() ? "" : ", ", example);
  return list.empty() ? "no unit" : list;
}

SiValue read_si(std::string_view text, const std::string& si_unit) {
  const Dimension wanted = dimension_of(si_unit);
  const auto [number, number_text, unit, rule] = split(text, wanted);
  if (!rule.empty()) return {0, rule};
  if (unit.empty() && si_unit == "1") return {number, ""};
  if (unit.empty())
    return {0,
            fmt::format("{} needs a unit, as in {}", name_of(wanted), quoted_examples(wanted, number_text))};
  // The only units with an offset, and only where a temperature itself is asked for.
  const bool celsius = si_unit == "K" && (unit == "degC" || unit == "celsius");
  const bool fahrenheit = si_unit == "K" && (unit == "degF" || unit == "fahrenheit");
  if (celsius) return {number + 273.15, ""};
  if (fahrenheit) return {(number + 459.67) / 1.8, ""};
  SiValue value = factor_of(unit, wanted);
  if (value.rule.empty()) value.value *= number;
  if (!std::isfinite(value.value)) return {0, "the number is too large to compute with"};
  return value;
}

double to_si(std::string_view text, const std::string& si_unit) {
  SiValue read = read_si(text, si_unit);
  if (!read.rule.empty()) throw UnitError(read.rule);
  return read.value;
}

double from_si(double value, const std::string& si_unit, const std::string& unit) {
  if (unit == si_unit) return value;
  const SiValue factor = factor_of(tidy_unit(unit), dimension_of(si_unit));
  if (!factor.rule.empty()) throw UnitError(factor.rule);
  return value / factor.value;
}

}  // namespace dashpad
