#include "output/text/table.hpp"

#include <algorithm>

#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

using Row = std::vector<std::string>;

std::string markdown_row(const Row& row) {
  std::string line = "|";
  for (const std::string& cell : row) {
    line += ' ';
    for (const char character : one_line(cell))
      line += character == '|' ? std::string{"\\|"} : std::string{character};
    line += " |";
  }
  return line + "\n";
}

}  // namespace

std::string markdown(const Table& table) {
  std::string text = markdown_row(table.columns);
  text += "|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
  text += "\n";
  for (const Row& row : table.rows) text += markdown_row(row);
  return text;
}

std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  return widths;
}

std::string plain_text(const Table& table) {
  std::vector<Row> rows{table.columns};
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  const std::vector<std::size_t> widths = column_widths(rows);
  std::string text;
  for (const Row& row : rows) {
    std::string line;
    for (std::size_t i = 0; i < widths.size(); ++i)
      line += one_line(row[i]) + std::string(widths[i] - width_of(row[i]) + 2, ' ');
    line.erase(line.find_last_not_of(' ') + 1);
    text += line + "\n";
  }
  return text;
}

}  // namespace dashpad::output
