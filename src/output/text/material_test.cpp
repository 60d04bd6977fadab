// A material test for the terminal.

#include <algorithm>

#include <fmt/format.h>

#include "dashpad/output/material_test.hpp"
#include "dashpad/version.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/material_test_answer.hpp"
#include "output/text/material_test_words.hpp"
#include "output/text/table.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The words of a heading, one below the other.
std::vector<std::string> stacked(const std::string& heading) {
  std::vector<std::string> lines;
  for (std::size_t begin = 0; begin <= heading.size();) {
    const std::size_t end = std::min(heading.find(' ', begin), heading.size());
    const std::string word = heading.substr(begin, end - begin);
    // Short words do not need a line of their own.
    if (!lines.empty() && width_of(lines.back()) + width_of(word) < 10 && !word.starts_with('('))
      lines.back() += " " + word;
    else
      lines.push_back(word);
    begin = end + 1;
  }
  return lines;
}

using Line = std::vector<std::string>;

/// The headings as lines of the table, the last word just above the numbers.
std::vector<Line> heading_lines(const Table& table) {
  std::vector<std::vector<std::string>> columns;
  std::size_t height = 0;
  for (const std::string& column : table.columns) {
    columns.push_back(stacked(column));
    height = std::max(height, columns.back().size());
  }
  std::vector<Line> lines(height, Line(columns.size()));
  for (std::size_t i = 0; i < columns.size(); ++i)
    for (std::size_t j = 0; j < columns[i].size(); ++j)
      lines[height - columns[i].size() + j][i] = columns[i][j];
  return lines;
}

std::string laid_out(const Table& table) {
  std::vector<Line> lines = heading_lines(table);
  lines.insert(lines.end(), table.rows.begin(), table.rows.end());
  const std::vector<std::size_t> width = column_widths(lines);
  std::string text;
  for (const Line& line : lines) {
    std::string row;
    for (std::size_t i = 0; i < width.size(); ++i)
      row += "  " + std::string(width[i] - width_of(line[i]), ' ') + line[i];
    text += row + "\n";
  }
  return text;
}

}  // namespace

std::string material_test_text(const laboratory::MaterialTestReport& report, const UnitSystem& units) {
  std::string text = material_words(report.material) + "\n" + test_words(report.test, units) + "\n\n" +
                     material_test_answer(report, units) + ".\n";
  const std::vector<std::string> flags = flag_words(report);
  if (!flags.empty()) text += "\n";
  for (const std::string& flag : flags) text += flag + "\n";
  for (const Table& table : tables_of(report, units))
    text += fmt::format("\n{}\n{}", table.caption, laid_out(table));
  text += "\n";
  for (const std::string& note : notes_on(report)) text += note + "\n";
  const std::string& source = report.material.source;
  return text + fmt::format("Source of the material: {} (dashpad {})\n",
                            source.empty() ? "not stated" : one_line(source), version());
}

}  // namespace dashpad::output
