// Documents as Markdown (CommonMark, with tables as GitHub has them).

#include <algorithm>
#include <string_view>

#include <fmt/format.h>

#include "output/layout.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Whatever it says, it is text.
std::string escaped(std::string_view text) {
  std::string safe;
  for (const char character : one_line(text)) {
    if (std::string_view("\\`*_<[|").find(character) != std::string_view::npos) safe += '\\';
    safe += character;
  }
  return safe;
}

/// The same at the beginning of a line, where it would be a heading, a quotation, a list or a rule.
std::string line_of(std::string_view text) {
  std::string safe = escaped(text);
  const std::size_t digits = safe.find_first_not_of("0123456789");
  if (!safe.empty() && std::string_view("#>+-=~").find(safe.front()) != std::string_view::npos)
    safe.insert(0, "\\");
  else if (digits != std::string::npos && digits > 0 &&
           (safe.substr(digits, 2) == ". " || safe.substr(digits, 2) == ") "))
    safe.insert(digits, "\\");
  return safe;
}

std::string row_of(const std::vector<std::string>& row) {
  std::string line = "|";
  for (const std::string& cell : row) line += " " + escaped(cell) + " |";
  return line + "\n";
}

/// A warning as a list item; the words in capitals at its front are bold.
std::string warning_line(const std::string& warning) {
  const std::string text = one_line(warning);
  const std::size_t end = capitals_in_front(text);
  return end == 0 ? "- " + escaped(text)
                  : fmt::format("- **{}**{}", escaped(text.substr(0, end)), escaped(text.substr(end)));
}

std::string code(const std::string& text) {
  std::string fence = "```";
  while (text.find(fence) != std::string::npos) fence += '`';
  return fence + "\n" + without_controls(text) + (text.ends_with('\n') ? "" : "\n") + fence + "\n";
}

std::string captioned(const Table& table) {
  return (table.caption.empty() ? "" : "**" + escaped(table.caption) + "**\n\n") + markdown(table) + "\n";
}

Table table_of(const std::vector<RangeBar>& ranges) {
  Table table{.columns = {"", "Value", "Interval", "From", "To"}};
  for (const RangeBar& each : ranges)
    table.rows.push_back({each.label, each.value, each.words, each.lowest, each.highest});
  return table;
}

std::string part_of(const Section& section) {
  std::string text;
  for (const std::string& paragraph : section.paragraphs) text += line_of(paragraph) + "\n\n";
  if (!section.ranges.empty()) text += captioned(table_of(section.ranges));
  for (const Table& table : tables_of(section)) text += captioned(table);
  if (!section.copy.empty()) text += code(section.copy) + "\n";
  if (text.empty()) return text;
  return (section.heading.empty() ? "" : "## " + escaped(section.heading) + "\n\n") + text;
}

}  // namespace

std::string markdown(const Table& table) {
  std::string text = row_of(table.columns) + "|";
  for (std::size_t i = 0; i < table.columns.size(); ++i) text += "---|";
  text += "\n";
  for (const auto& row : table.rows) text += row_of(row);
  return text;
}

std::string to_markdown(const Document& document) {
  std::string text = "# " + escaped(document.lead ? document.lead->answer : document.title) + "\n\n";
  if (document.lead)
    for (const std::string& line : document.lead->subject)
      if (!line.empty()) text += line_of(line) + "\n\n";
  for (const std::string& paragraph : document.summary) text += line_of(paragraph) + "\n\n";
  for (const std::string& warning : document.warnings) text += warning_line(warning) + "\n";
  if (!document.warnings.empty()) text += "\n";
  if (document.lead && !document.lead->figures.empty() &&
      std::ranges::all_of(document.sections, [](const Section& section) { return section.rows.empty(); }))
    text += captioned(table_of(RowGroup{"", document.lead->figures}));
  for (const Section& section : document.sections)
    if (section.seen != Seen::in_brief) text += part_of(section);
  return text.substr(0, text.find_last_not_of('\n') + 1) + "\n";
}

}  // namespace dashpad::output
