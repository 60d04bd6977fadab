#include "input/material_deck/deck_cards.hpp"

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "quantities/from_chars.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t longest_number = 100;

/// A number as written: digits with a point, and an exponent.
struct WrittenNumber {
  std::string mantissa;
  int exponent = 0;
};

bool is_digit(char c) { return c >= '0' && c <= '9'; }

std::optional<int> read_exponent(std::string_view text) {
  if (text.starts_with('+')) text.remove_prefix(1);
  const auto value = parsed<int>(text);
  return value && *value >= -9999 && *value <= 9999 ? value : std::nullopt;
}

/// Absent if the text is no number.
std::optional<WrittenNumber> taken_apart(std::string_view text) {
  WrittenNumber number;
  std::size_t i = 0;
  if (text[0] == '+' || text[0] == '-') {
    if (text[0] == '-') number.mantissa = "-";
    ++i;
  }
  bool has_digit = false, has_point = false;
  for (; i < text.size() && (is_digit(text[i]) || (text[i] == '.' && !has_point)); ++i) {
    has_digit = has_digit || is_digit(text[i]);
    has_point = has_point || text[i] == '.';
    number.mantissa += text[i];
  }
  if (!has_digit) return std::nullopt;
  if (i == text.size()) return number;
  if (std::string_view("eEdD").find(text[i]) != std::string_view::npos) ++i;
  const auto exponent = read_exponent(text.substr(i));
  if (!exponent) return std::nullopt;
  number.exponent = *exponent;
  return number;
}

/// Significant digits; the first has the weight 10^exponent.
struct Digits {
  bool negative = false;
  std::string digits;
  int exponent = 0;
};

Digits digits_of(double value, int precision) {
  std::array<char, 64> buffer{};
  const auto end = precision < 0 ? std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                 std::chars_format::scientific)
                                 : std::to_chars(buffer.data(), buffer.data() + buffer.size(), value,
                                                 std::chars_format::scientific, precision);
  const std::string_view text(buffer.data(), static_cast<std::size_t>(end.ptr - buffer.data()));
  const auto mark = text.find('e');
  Digits result;
  for (const char c : text.substr(0, mark)) {
    if (c == '-') result.negative = true;
    if (is_digit(c)) result.digits += c;
  }
  while (result.digits.size() > 1 && result.digits.ends_with('0')) result.digits.pop_back();
  result.exponent = read_exponent(text.substr(mark + 1)).value_or(0);
  return result;
}

std::string in_fixed_notation(const Digits& number, bool with_zero) {
  const auto& [negative, digits, exponent] = number;
  const std::string sign = negative ? "-" : "";
  if (exponent < 0)
    return sign + (with_zero ? "0." : ".") + std::string(static_cast<std::size_t>(-exponent - 1), '0') +
           digits;
  const auto whole = static_cast<std::size_t>(exponent) + 1;
  if (digits.size() <= whole) return sign + digits + std::string(whole - digits.size(), '0') + ".0";
  return sign + digits.substr(0, whole) + "." + digits.substr(whole);
}

std::string in_scientific_notation(const Digits& number) {
  return fmt::format("{}{}.{}e{}", number.negative ? "-" : "", number.digits.substr(0, 1),
                     number.digits.size() > 1 ? number.digits.substr(1) : "0", number.exponent);
}

/// Empty if no notation is short enough. Leaves one column blank if possible.
std::string fitting(const Digits& number, std::size_t width) {
  const bool is_handy = number.exponent > -6 && number.exponent < 16;
  for (const std::size_t room : {width - 1, width})
    for (const int notation : {0, 1, 2}) {
      if (notation != 1 && !is_handy) continue;
      const std::string text =
          notation == 1 ? in_scientific_notation(number) : in_fixed_notation(number, notation == 0);
      if (text.size() <= room) return text;
    }
  return "";
}

/// The number whose product with `factor` is exactly `value`, if there is one.
double divided(double value, double factor) {
  const double quotient = value / factor;
  double below = quotient, above = quotient;
  for (int i = 0; i < 3; ++i) {
    if (below * factor == value) return below;
    if (above * factor == value) return above;
    below = std::nextafter(below, 0.0);
    above = std::nextafter(above, 2 * quotient);
  }
  return quotient;
}

}  // namespace

DeckUnit deck_unit(const std::string& unit, const std::string& si_unit) {
  DeckUnit result{to_si("1 " + unit, si_unit), std::nullopt};
  const double power = std::round(std::log10(result.factor));
  if (std::abs(result.factor / std::pow(10, power) - 1) < 1e-12)
    result.power_of_ten = static_cast<int>(power);
  return result;
}

DeckUnits::DeckUnits(const UnitSystem& system)
    : stress(deck_unit(system.pressure, "Pa")),
      density(deck_unit("(" + system.mass + ")/" + system.length + "3", "kg/m3")),
      rate(deck_unit("1/" + system.time, "1/s")),
      time(deck_unit(system.time, "s")) {}

const DeckUnit& DeckUnits::of(Content content) const {
  switch (content) {
    case Content::stress: return stress;
    case Content::density: return density;
    case Content::rate: return rate;
    case Content::time: return time;
    case Content::number:
    case Content::whole: break;
  }
  return none;
}

ReadNumber read_deck_number(std::string_view text, const DeckUnit& unit) {
  text = without_blanks(text);
  if (text.empty()) return {};
  if (text.size() > longest_number) return {NumberKind::text};
  const std::string word = lower_case(text.substr(text[0] == '+' || text[0] == '-' ? 1 : 0));
  if (word.starts_with("nan") || word.starts_with("inf")) return {NumberKind::not_finite};
  auto number = taken_apart(text);
  if (!number) return {NumberKind::text};
  number->exponent += unit.power_of_ten.value_or(0);
  const std::string shifted = fmt::format("{}e{}", number->mantissa, number->exponent);
  double value = 0;
  const auto [end, error] = from_chars(shifted.data(), shifted.data() + shifted.size(), value);
  if (error == std::errc::result_out_of_range) return {NumberKind::out_of_range};
  if (error != std::errc{} || end != shifted.data() + shifted.size()) return {NumberKind::text};
  if (!unit.power_of_ten) value *= unit.factor;
  return {std::isfinite(value) ? NumberKind::number : NumberKind::out_of_range, value};
}

std::string deck_number(double value, const DeckUnit& unit, std::size_t width) {
  if (value == 0) return "0.0";
  if (!unit.power_of_ten) value = divided(value, unit.factor);
  std::string text;
  for (int precision = -1; text.empty() && precision != 0; precision = precision < 0 ? 16 : precision - 1) {
    Digits digits = digits_of(value, precision);
    digits.exponent -= unit.power_of_ten.value_or(0);
    text = fitting(digits, width);
  }
  return text;
}

}  // namespace dashpad::input
