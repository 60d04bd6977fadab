// Documents for a terminal of 100 columns.

#include <algorithm>
#include <numeric>
#include <utility>

#include "output/layout.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t columns_of_terminal = 100, gap = 2;

std::string padded(const std::string& text, std::size_t width) {
  return text + std::string(width - std::min(width, width_of(text)), ' ');
}

/// `part` of each row at its widest, and a gap; 0 where no row has any.
template <class Part>
std::size_t column_of(const std::vector<ValueRow>& rows, Part&& part) {
  std::size_t width = 0;
  for (const ValueRow& row : rows) width = std::max(width, width_of(part(row)));
  return width == 0 ? 0 : width + gap;
}

/// The text in one line, with no-break spaces between numbers and their units.
std::string kept_whole(const std::string& text) { return quantities_whole(one_line(text)); }

std::string with_blanks(std::string text) {
  replace_all(text, "\u00a0", " ");
  return text;
}

std::string paragraph_of(const std::string& text) { return with_blanks(wrapped(kept_whole(text), 2)) + "\n"; }

std::string without_end(std::string line) { return line.erase(line.find_last_not_of(' ') + 1); }

std::vector<std::size_t> column_widths(const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths(rows.empty() ? 0 : rows.front().size());
  for (const auto& row : rows)
    for (std::size_t i = 0; i < widths.size(); ++i) widths[i] = std::max(widths[i], width_of(row[i]));
  return widths;
}

std::size_t longest_word(std::string_view text) {
  std::size_t longest = 0;
  for (std::size_t from = 0; from <= text.size();) {
    const std::size_t end = std::min(text.find(' ', from), text.size());
    longest = std::max(longest, width_of(text.substr(from, end - from)));
    from = end + 1;
  }
  return longest;
}

/// The least width of a column at which no words, quantities or row names are broken.
std::size_t narrowest(const Table& table, std::size_t column) {
  constexpr std::size_t longest_name = 35;
  const bool has_numbers = is_column_of_numbers(table, column);
  std::size_t width = longest_word(kept_whole(table.columns[column]));
  for (const auto& row : table.rows)
    width = std::max(width, has_numbers ? width_of(row[column]) : longest_word(kept_whole(row[column])));
  if (column == 0)
    for (const auto& row : table.rows) width = std::max(width, std::min(width_of(row[0]), longest_name));
  return width;
}

/// The widths of columns that fit together: the widest give way as far as they can.
std::vector<std::size_t> fitted_widths(const Table& table,
                                       const std::vector<std::vector<std::string>>& rows) {
  std::vector<std::size_t> widths = column_widths(rows), room(widths.size());
  for (std::size_t i = 0; i < widths.size(); ++i)
    room[i] = widths[i] - std::min(widths[i], narrowest(table, i));
  const auto taken = [&] { return std::accumulate(widths.begin(), widths.end(), gap * (widths.size() - 1)); };
  while (!widths.empty() && taken() > columns_of_terminal) {
    std::size_t widest = widths.size();
    for (std::size_t i = 0; i < widths.size(); ++i)
      if (room[i] > 0 && (widest == widths.size() || widths[i] > widths[widest])) widest = i;
    if (widest == widths.size()) break;
    --widths[widest];
    --room[widest];
  }
  return widths;
}

/// The words of a cell in lines of that width, as far as they allow.
std::vector<std::string> lines_of(const std::string& cell, std::size_t width) {
  std::vector<std::string> lines{""};
  std::string_view rest = cell;
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find(' '), rest.size());
    const std::string word(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (lines.back().empty())
      lines.back() = word;
    else if (width_of(lines.back()) + 1 + width_of(word) <= width)
      lines.back() += " " + word;
    else
      lines.push_back(word);
  }
  return lines;
}

/// Numbers stand one below the other, whether their unit is beside them or not.
void split_off_unit(ValueRow& row) {
  row.value = one_line(row.value);
  const std::size_t space = row.value.find(' ');
  if (!row.unit.empty() || space == std::string::npos || space != row.value.rfind(' ')) return;
  if (!is_number_or_none(row.value.substr(0, space))) return;
  row.unit = row.value.substr(space + 1);
  row.value.resize(space);
}

std::string text_of(const Section& section) {
  const bool is_headed = !section.rows.empty() && !section.rows.front().caption.empty();
  std::string text = section.heading.empty() || is_headed ? "" : one_line(section.heading) + ":\n";
  for (const RowGroup& group : section.rows)
    text += (&group == &section.rows.front() ? "" : "\n") +
            (group.caption.empty() ? "" : one_line(group.caption) + ":\n") + laid_out(group.rows);
  if (!section.rows.empty() && !section.paragraphs.empty()) text += "\n";
  for (const std::string& paragraph : section.paragraphs) text += paragraph_of(paragraph);
  bool is_first = section.rows.empty() && section.paragraphs.empty();
  for (const Table& table : section.tables) {
    if (!std::exchange(is_first, false)) text += "\n";
    if (!table.caption.empty() && table.caption != section.heading) text += paragraph_of(table.caption);
    text += plain_text(table);
  }
  return text;
}

}  // namespace

std::string plain_text(const Table& given) {
  Table table = given;
  for (std::string& title : table.columns) title = one_line(title);
  for (auto& row : table.rows)
    for (std::string& cell : row) cell = one_line(cell);
  std::vector<std::vector<std::string>> rows;
  if (std::ranges::any_of(table.columns, [](const std::string& title) { return !title.empty(); }))
    rows.push_back(table.columns);
  rows.insert(rows.end(), table.rows.begin(), table.rows.end());
  const std::vector<std::size_t> widths = fitted_widths(table, rows);
  std::vector<bool> is_on_the_right;
  for (std::size_t i = 0; i < widths.size(); ++i)
    is_on_the_right.push_back(i > 0 && is_column_of_numbers(table, i));
  std::string text;
  for (const auto& row : rows) {
    std::vector<std::vector<std::string>> cells;
    std::size_t lines = 0;
    for (std::size_t i = 0; i < widths.size(); ++i) {
      cells.push_back(lines_of(kept_whole(row[i]), widths[i]));
      lines = std::max(lines, cells.back().size());
    }
    for (std::size_t k = 0; k < lines; ++k) {
      std::string line;
      for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::string cell = k < cells[i].size() ? cells[i][k] : "";
        line += is_on_the_right[i]
                    ? std::string(widths[i] - width_of(cell), ' ') + cell + std::string(gap, ' ')
                    : padded(cell, widths[i] + gap);
      }
      text += without_end(std::move(line)) + "\n";
    }
  }
  return with_blanks(std::move(text));
}

std::string laid_out(const std::vector<ValueRow>& given) {
  constexpr std::size_t min_label = 21, max_label = 45, min_value = 9, max_value = 20, min_unit = 7,
                        of_error = 14, last_remark = 72, of_long_remark = 40;
  std::vector<ValueRow> rows = given;
  for (ValueRow& row : rows) split_off_unit(row);
  const std::size_t label =
      std::clamp(column_of(rows, [](const ValueRow& row) { return row.label; }), min_label, max_label);
  const std::size_t value = std::clamp(column_of(rows, [](const ValueRow& row) { return row.value; }),
                                       min_value + gap, max_value + gap) -
                            gap;
  const std::size_t unit =
      std::max(column_of(rows, [](const ValueRow& row) { return row.unit; }), min_unit + 1);
  const std::size_t interval = column_of(rows, [](const ValueRow& row) { return row.interval; });
  const std::size_t limit = column_of(rows, [](const ValueRow& row) { return row.limit; });
  const std::size_t error =
      std::ranges::any_of(rows, [](const ValueRow& row) { return row.error.has_value(); }) ? of_error : 0;
  const std::size_t remark = gap + label + value + 1 + unit + interval + error + limit;
  std::string text;
  for (const ValueRow& row : rows) {
    std::string line = "  " + padded(one_line(row.label), label);
    if (width_of(line) > label + gap) {  // a line of its own, so that the columns stay one below the other
      text += with_blanks(without_end(std::move(line))) + "\n";
      line = std::string(label + gap, ' ');
    }
    line += std::string(value - std::min(value, width_of(row.value)), ' ') + row.value + " ";
    line += padded(row.unit, unit) + padded(row.interval, interval);
    line += padded(row.error ? "± " + shown_error(*row.error) : "", error) + padded(row.limit, limit);
    const std::size_t indent = remark <= last_remark ? remark : of_long_remark;
    text += with_blanks(wrapped(without_end(line + kept_whole(row.remark)), indent)) + "\n";
  }
  return text;
}

std::string to_terminal(const Document& document, Detail detail) {
  std::string text;
  const auto add_lines = [&](const std::vector<std::string>& lines) {
    for (const std::string& line : lines)
      if (!line.empty()) text += paragraph_of(line);
  };
  add_lines({document.lead ? document.lead->answer : document.title});
  if (document.lead) add_lines(document.lead->subject);
  add_lines(document.summary);
  add_lines(document.warnings);
  const bool has_rows = std::ranges::any_of(document.sections, [&](const Section& section) {
    return is_seen(section, detail) && !section.rows.empty();
  });
  if (document.lead && !document.lead->figures.empty() && !has_rows)
    text += "\n" + laid_out(document.lead->figures);
  for (const Section& section : document.sections)
    if (is_seen(section, detail))
      if (const std::string part = text_of(section); !part.empty()) text += "\n" + part;
  return text;
}

}  // namespace dashpad::output
