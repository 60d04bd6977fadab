#include "spit1984/fortran_format.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

#include "quantities/from_chars.hpp"

namespace dashpad::spit1984 {

namespace {

/// The number 0.DIGITS times ten to the exponent.
struct Decimal {
  std::string digits;
  int exponent = 0;
};

/// All significant digits of a double; there are at most 767.
Decimal exact(double magnitude) {
  const std::string text = fmt::format("{:.766e}", magnitude);
  const std::size_t mark = text.find('e');
  return {text.substr(0, 1) + text.substr(2, mark - 2), std::atoi(text.c_str() + mark + 1) + 1};
}

/// Rounds ties away from zero: the first omitted digit decides.
Decimal rounded(Decimal number, std::size_t decimals) {
  const bool up = number.digits.at(decimals) >= '5';
  number.digits.resize(decimals);
  if (!up) return number;
  const std::size_t last = number.digits.find_last_not_of('9');
  if (last == std::string::npos) return {"1" + std::string(decimals - 1, '0'), number.exponent + 1};
  ++number.digits[last];
  std::fill(number.digits.begin() + static_cast<std::ptrdiff_t>(last) + 1, number.digits.end(), '0');
  return number;
}

std::string in_field(const std::string& text, int width) {
  const auto columns = static_cast<std::size_t>(width);
  return text.size() > columns ? std::string(columns, '*') : std::string(columns - text.size(), ' ') + text;
}

bool is_blank(char character) { return character == ' ' || character == '\t' || character == '\r'; }

bool is_sign(char character) { return character == '+' || character == '-'; }

bool is_exponent_letter(char character) {
  return std::string_view{"EeDd"}.find(character) != std::string_view::npos;
}

/// A Fortran number in C++ spelling, without a leading plus: "1.5D1" and "1.5+1" become "1.5e1" and "1.5e+1".
std::string in_our_spelling(std::string_view field) {
  std::string text;
  for (const char character : field) {
    if (is_exponent_letter(character)) {
      text += 'e';
      continue;
    }
    if (is_sign(character) && !text.empty() && text.back() != 'e') text += 'e';
    if (character != '+' || !text.empty()) text += character;
  }
  return text;
}

template <typename Number>
std::optional<Number> number_in(std::string_view field) {
  if (field.empty()) return Number{0};
  if (is_sign(field.front()) && field.size() > 1 && is_sign(field[1])) return std::nullopt;
  const std::string text = in_our_spelling(field);
  const std::size_t first = text.find_first_not_of('-');
  if (first == std::string::npos ||
      std::string_view{"0123456789."}.find(text[first]) == std::string_view::npos)
    return std::nullopt;  // from_chars would take "inf" and "nan"
  return parsed<Number>(text);
}

}  // namespace

std::string edit_e(double value, int width, int decimals) {
  const std::string sign = value < 0 ? "-" : "";
  if (std::isnan(value)) return in_field("NaN", width);
  if (std::isinf(value)) return in_field(sign + "Infinity", width);
  Decimal number{std::string(static_cast<std::size_t>(decimals), '0'), 0};
  if (value != 0) number = rounded(exact(std::abs(value)), static_cast<std::size_t>(decimals));
  const std::string exponent = std::abs(number.exponent) < 100 ? fmt::format("E{:+03}", number.exponent)
                                                               : fmt::format("{:+04}", number.exponent);
  const std::string text = "." + number.digits + exponent;
  const bool has_room = sign.size() + 1 + text.size() <= static_cast<std::size_t>(width);
  return in_field(sign + (has_room ? "0" : "") + text, width);
}

std::string edit_i(int value, int width) { return in_field(fmt::format("{}", value), width); }

PrintedRecords& PrintedRecords::text(std::string_view text) {
  record_ += text;
  return *this;
}

PrintedRecords& PrintedRecords::skip(int columns) {
  record_.append(static_cast<std::size_t>(columns), ' ');
  return *this;
}

PrintedRecords& PrintedRecords::end_record() {
  end_record_on_the_line();
  printed_ += '\n';
  return *this;
}

PrintedRecords& PrintedRecords::end_record_on_the_line() {
  if (!record_.empty()) {
    if (record_.front() == '1' && !printed_.empty()) printed_ += '\f';
    if (record_.front() == '0') printed_ += '\n';
    printed_.append(record_, 1);
  }
  record_.clear();
  return *this;
}

std::optional<int> TypedRecord::i() { return number_in<int>(free_field()); }

std::optional<double> TypedRecord::e(int width) {
  std::string field{rest_.substr(0, static_cast<std::size_t>(width))};
  rest_.remove_prefix(field.size());
  std::erase_if(field, is_blank);
  return number_in<double>(field);
}

std::optional<double> TypedRecord::f() { return number_in<double>(free_field()); }

/// Blanks on both sides of a comma belong to it: "1 , 2" has two fields, "1,,2" three.
std::string_view TypedRecord::free_field() {
  const auto skip_blanks = [this] {
    rest_.remove_prefix(
        static_cast<std::size_t>(std::find_if_not(rest_.begin(), rest_.end(), is_blank) - rest_.begin()));
  };
  skip_blanks();
  const auto end = std::find_if(rest_.begin(), rest_.end(),
                                [](char character) { return character == ',' || is_blank(character); });
  const std::string_view field = rest_.substr(0, static_cast<std::size_t>(end - rest_.begin()));
  rest_.remove_prefix(field.size());
  skip_blanks();
  if (rest_.starts_with(',')) rest_.remove_prefix(1);
  return field;
}

}  // namespace dashpad::spit1984
