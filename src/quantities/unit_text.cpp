#include "quantities/unit_text.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace dashpad {
namespace {

using Pair = std::pair<std::string_view, std::string_view>;
/// Hard space, Greek mu for the micro sign, dot operator for the middle dot, raised minus and digits.
constexpr std::array<Pair, 7> lookalikes{Pair{"\u00a0", " "}, {"\u03bc", "\u00b5"}, {"\u22c5", "\u00b7"},
                                         {"\u207b", "-"},     {"\u00b9", "1"},      {"\u00b2", "2"},
                                         {"\u00b3", "3"}};
constexpr std::array<std::string_view, 2> other_signs{"\u00b5", "\u00b7"};

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%';
}
constexpr bool is_sign(char c) { return c == '-' || c == '+'; }

/// Whether a digit or its sign may follow `before` as (part of) an exponent: "m2", "s-1", "s^-1", "m10".
constexpr bool can_take_exponent(char before) {
  return is_letter(before) || is_digit(before) || before == '^' || before == ')';
}

}  // namespace

std::string tidy_unit(std::string_view text) {
  std::string tidy(text);
  for (const auto& [from, to] : lookalikes)
    for (auto at = tidy.find(from); at != std::string::npos; at = tidy.find(from, at + to.size()))
      tidy.replace(at, from.size(), to);
  const auto first = tidy.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  tidy = tidy.substr(first, tidy.find_last_not_of(" \t") - first + 1);
  return tidy.starts_with('/') ? '1' + tidy : tidy;
}

UnitText kind_of_unit_text(std::string_view text) {
  if (text.starts_with("1/") || text.starts_with("1 /")) text.remove_prefix(1);
  char before = ' ';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const char after = i + 1 < text.size() ? text[i + 1] : ' ';
    const auto stands_here = [&](std::string_view sign) { return text.substr(i).starts_with(sign); };
    const auto other = std::ranges::find_if(other_signs, stands_here);
    if (other != other_signs.end()) {
      i += other->size() - 1;
    } else if (is_digit(c)) {
      const bool signed_exponent = is_sign(before) && i >= 2 && can_take_exponent(text[i - 2]);
      if (!can_take_exponent(before) && !signed_exponent) return UnitText::holds_number;
    } else if (is_sign(c)) {
      if (!can_take_exponent(before) || !is_digit(after)) return UnitText::not_a_unit;
    } else if (!is_letter(c) && std::string_view(" \t/*.^()").find(c) == std::string_view::npos) {
      return UnitText::not_a_unit;
    }
    before = text[i];
  }
  return UnitText::plain;
}

}  // namespace dashpad
