#include "quantities/unit.hpp"

#include <array>
#include <cmath>
#include <cstdlib>
#include <optional>
#include <utility>

#include "quantities/text.hpp"
#include "quantities/unit_table.hpp"

namespace dashpad {
namespace {

constexpr std::size_t longest_unit = 100;
constexpr int largest_exponent = 1000;

using Pair = std::pair<std::string_view, std::string_view>;
/// Look-alikes: no-break space, Greek mu, dot operator, raised minus and digits, degree and ohm signs.
constexpr std::array lookalikes{Pair{"\u00a0", " "},    Pair{"\u03bc", "\u00b5"}, Pair{"\u22c5", "\u00b7"},
                                Pair{"\u207b", "-"},    Pair{"\u00b9", "1"},      Pair{"\u00b2", "2"},
                                Pair{"\u00b3", "3"},    Pair{"\u2074", "4"},      Pair{"\u2103", "degC"},
                                Pair{"\u2109", "degF"}, Pair{"\u00b0C", "degC"},  Pair{"\u00b0F", "degF"},
                                Pair{"\u00b0", "deg"},  Pair{"\u2126", "ohm"},    Pair{"\u03a9", "ohm"}};
constexpr std::string_view micro = "\u00b5", middle_dot = "\u00b7";

constexpr bool is_digit(char c) { return c >= '0' && c <= '9'; }
constexpr bool is_letter(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == '%';
}
constexpr bool is_sign(char c) { return c == '-' || c == '+'; }
constexpr bool is_blank(char c) { return c == ' ' || c == '\t'; }

/// Whether a digit or its sign may follow `before` as (part of) an exponent: "m2", "s-1", "s^-1", "m10".
constexpr bool can_take_exponent(char before) {
  return is_letter(before) || is_digit(before) || before == '^' || before == ')';
}

/// Finds anything but names, exponents and the signs / * . ^ ( ) between them: a number other than an
/// exponent or the 1 of "1/s", or another sign. None if the text may be a unit.
std::optional<UnitMatch> stranger_in(std::string_view text) {
  if (text.starts_with("1/") || text.starts_with("1 /")) text.remove_prefix(1);
  char before = ' ';
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    const char after = i + 1 < text.size() ? text[i + 1] : ' ';
    if (text.substr(i).starts_with(micro) || text.substr(i).starts_with(middle_dot)) {
      i += micro.size() - 1;
    } else if (is_digit(c)) {
      const bool signed_exponent = is_sign(before) && i >= 2 && can_take_exponent(text[i - 2]);
      if (!can_take_exponent(before) && !signed_exponent) return UnitMatch::holds_number;
    } else if (is_sign(c)) {
      if (!can_take_exponent(before) || !is_digit(after)) return UnitMatch::not_a_unit;
    } else if (!is_letter(c) && !is_blank(c) &&
               std::string_view("/*.^()").find(c) == std::string_view::npos) {
      return UnitMatch::not_a_unit;
    }
    before = text[i];
  }
  return std::nullopt;
}

/// number times ten to a power, in base units.
struct Unit {
  long double number = 1;
  int ten = 0;
  UnitDimension dimension = {};
  bool has_offset = false;
};

/// Not by std::pow, which for a long double is no more accurate than a double in some C libraries.
long double raised(long double base, int power) {
  long double result = 1;
  for (int i = 0; i < power; ++i) result *= base;
  return result;
}

/// `a` times `by` raised to a power. Nothing where an exponent grows beyond all use.
std::optional<Unit> product(const Unit& a, const Unit& by, int power) {
  const long double factor = raised(by.number, std::abs(power));
  Unit result{power < 0 ? a.number / factor : a.number * factor};
  bool is_sound = std::isfinite(result.number) && result.number > 0;
  const auto sum = [&](int left, int right) {
    const int exponent = left + right * power;  // both are at most largest_exponent, power at most 99
    is_sound = is_sound && std::abs(exponent) <= largest_exponent;
    return exponent;
  };
  result.ten = sum(a.ten, by.ten);
  for (int UnitDimension::*const each :
       {&UnitDimension::m, &UnitDimension::kg, &UnitDimension::s, &UnitDimension::K, &UnitDimension::A})
    result.dimension.*each = sum(a.dimension.*each, by.dimension.*each);
  return is_sound ? std::optional(result) : std::nullopt;
}

/// Whether a list with blanks between its words holds a word.
bool holds(std::string_view words, std::string_view word) {
  for (auto at = words.find(word); at != std::string_view::npos; at = words.find(word, at + 1)) {
    const auto end = at + word.size();
    if ((at == 0 || words[at - 1] == ' ') && (end == words.size() || words[end] == ' ')) return true;
  }
  return false;
}

const UnitRow* row_of(std::string_view name) {
  if (name.empty()) return nullptr;
  for (const UnitRow& row : unit_table::rows)
    if (holds(row.names, name)) return &row;
  return nullptr;
}

/// A name as it stands, or else the longest prefix after which a name that takes one is left.
std::optional<Unit> unit_called(std::string_view name) {
  if (const UnitRow* row = row_of(name)) return Unit{row->number, row->ten, row->dimension, row->has_offset};
  std::optional<Unit> found;
  std::size_t length = 0;
  for (const auto& [prefix, ten] : unit_table::prefixes) {
    if (prefix.size() < length || !name.starts_with(prefix)) continue;
    const UnitRow* row = row_of(name.substr(prefix.size()));
    if (row == nullptr || row->prefixes == Prefixes::no) continue;
    found = Unit{row->number, row->ten + ten, row->dimension, false};
    length = prefix.size();
  }
  return found;
}

/// A product of powers: names, brackets and the number 1, with the signs for times and over, or blanks.
class UnitReader {
 public:
  explicit UnitReader(std::string_view text) : rest_(text) {}

  std::optional<Unit> whole() {
    const auto unit = product_of_powers();
    return unit && rest_.empty() ? unit : std::nullopt;
  }

 private:
  std::optional<Unit> product_of_powers() {
    std::optional<Unit> result = power(Unit{}, 1);
    while (result && !at_end()) {
      const bool is_over = take("/") || take_word("per");
      if (!is_over && !take("*") && !take(".")) take(middle_dot);
      result = power(*result, is_over ? -1 : 1);
    }
    return result;
  }
  /// `before` times, or over, the next one, which is raised by what stands behind it.
  std::optional<Unit> power(const Unit& before, int direction) {
    skip_blanks();
    std::optional<Unit> unit;
    if (take("(")) {
      unit = product_of_powers();
      if (!unit || !take(")")) return std::nullopt;
    } else if (take("1")) {
      unit = Unit{};
    } else {
      unit = unit_called(take_name());
    }
    if (!unit) return std::nullopt;
    const std::optional<int> exponent = take_exponent();
    if (!exponent) return std::nullopt;
    // Alone, a temperature keeps its zero; in a product it is a difference.
    if (unit->has_offset && *exponent == 1 && direction == 1 && at_end() && is_first_) return unit;
    is_first_ = false;
    return product(before, *unit, direction * *exponent);
  }
  /// 1 where there is none.
  std::optional<int> take_exponent() {
    bool needs_digits = take("^");
    const bool is_negative = take("-");
    needs_digits = is_negative || take("+") || needs_digits;
    std::size_t digits = 0;
    while (digits < rest_.size() && is_digit(rest_[digits])) ++digits;
    if (digits == 0) return needs_digits ? std::nullopt : std::optional(1);
    if (digits > 2) return std::nullopt;
    const int exponent = std::atoi(std::string(rest_.substr(0, digits)).c_str());
    rest_.remove_prefix(digits);
    return is_negative ? -exponent : exponent;
  }
  std::string_view take_name() {
    std::size_t end = 0;
    for (;;) {
      if (end < rest_.size() && is_letter(rest_[end]))
        ++end;
      else if (rest_.substr(end).starts_with(micro))
        end += micro.size();
      else
        break;
    }
    const std::string_view name = rest_.substr(0, end);
    rest_.remove_prefix(end);
    return name;
  }
  bool take(std::string_view sign) {
    if (!rest_.starts_with(sign)) return false;
    rest_.remove_prefix(sign.size());
    return true;
  }
  bool take_word(std::string_view word) {
    if (!rest_.starts_with(word) || (rest_.size() > word.size() && is_letter(rest_[word.size()])))
      return false;
    return take(word);
  }
  void skip_blanks() {
    while (!rest_.empty() && is_blank(rest_.front())) rest_.remove_prefix(1);
  }
  bool at_end() {
    skip_blanks();
    return rest_.empty() || rest_.front() == ')';
  }

  std::string_view rest_;
  bool is_first_ = true;
};

}  // namespace

std::string tidy_unit(std::string_view text) {
  std::string tidy(text);
  for (const auto& [from, to] : lookalikes) replace_all(tidy, from, to);
  const auto first = tidy.find_first_not_of(" \t");
  if (first == std::string::npos) return {};
  tidy = tidy.substr(first, tidy.find_last_not_of(" \t") - first + 1);
  return tidy.starts_with('/') ? '1' + tidy : tidy;
}

UnitFactor unit_factor(std::string_view unit, std::string_view si_unit) {
  if (unit.size() > longest_unit) return {UnitMatch::unknown};
  if (const auto stranger = stranger_in(unit)) return {*stranger};
  const auto one = UnitReader(unit).whole(), si = UnitReader(si_unit).whole();
  if (!one || !si) return {UnitMatch::unknown};
  if (one->dimension != si->dimension || one->has_offset) return {UnitMatch::other_dimension};
  const int ten = one->ten - si->ten;
  const long double number = one->number / si->number, power = raised(10, std::abs(ten));
  return {UnitMatch::same_dimension, static_cast<double>(ten < 0 ? number / power : number * power)};
}

std::string_view advice_on_unit(std::string_view name) {
  for (const auto& [names, advice] : unit_table::ambiguous)
    if (!name.empty() && holds(names, name)) return advice;
  return {};
}

}  // namespace dashpad
