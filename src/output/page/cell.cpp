#include "output/page/cell.hpp"

#include <regex>

namespace dashpad::output {

namespace {

/// Also with a unit: one word.
bool is_number(const std::string& cell) {
  static const std::regex number(
      R"(^\s*(<|>|≤|≥|≈|~|±|\+|-|−)*\s*\.?[0-9][0-9.,]*([eE][+-]?[0-9]+)?\s*(%|±.*|[^\s0-9][^\s]*)?\s*$)");
  return cell.size() < 60 && std::regex_match(cell, number);
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
