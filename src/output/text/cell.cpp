#include "output/text/cell.hpp"

#include <string_view>

namespace dashpad::output {

namespace {

/// Takes `part` from the beginning of `text`, if it stands there.
bool take(std::string_view& text, std::string_view part) {
  if (!text.starts_with(part)) return false;
  text.remove_prefix(part.size());
  return true;
}

bool is_digit(char letter) { return letter >= '0' && letter <= '9'; }

/// Of the text that is left: as many of those letters as stand at its beginning.
std::string_view take_any_of(std::string_view& text, std::string_view letters) {
  const std::string_view taken = text.substr(0, text.find_first_not_of(letters));
  text.remove_prefix(taken.size());
  return taken;
}

void take_signs(std::string_view& text) {
  bool again = true;
  while (again) {
    again = !take_any_of(text, "<>~+- ").empty();
    for (const std::string_view sign : {"≤", "≥", "≈", "±", "−"}) again = take(text, sign) || again;
  }
}

/// Also with an exponent, a deviation or a unit: one word.
bool is_number(std::string_view text) {
  take_signs(text);
  take(text, ".");
  if (text.empty() || !is_digit(text.front())) return false;
  take_any_of(text, "0123456789.,");
  std::string_view exponent = text;
  if (take(exponent, "e") || take(exponent, "E")) {
    if (!take(exponent, "-")) take(exponent, "+");
    if (!take_any_of(exponent, "0123456789").empty()) text = exponent;
  }
  take_any_of(text, " ");
  if (text.starts_with("±")) return true;
  if (text.empty() || is_digit(text.front())) return text.empty();
  return text.find(' ') >= text.find_last_not_of(' ');
}

bool is_none(const std::string& cell) {
  return cell.empty() || cell == "-" || cell == "–" || cell == "none" || cell == "n/a";
}

}  // namespace

bool is_number_or_none(const std::string& cell) { return is_none(cell) || is_number(cell); }

bool is_column_of_numbers(const Table& table, std::size_t column) {
  bool has_number = false;
  for (const auto& row : table.rows) {
    if (column >= row.size()) continue;
    if (!is_number_or_none(row[column])) return false;
    has_number = has_number || is_number(row[column]);
  }
  return has_number;
}

}  // namespace dashpad::output
