// The names of columns where they are not simply the row above the numbers: split at blanks, behind a sign or
// a keyword, one in a line, in comments, below the sizes of a specimen.

#include "input/measurement/csv_table.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace dashpad::input {

namespace {

constexpr std::size_t fewest_rows_of_table = 3;  // fewer rows of numbers above names are sizes
constexpr std::size_t max_rows_above = 100;      // among which sizes are looked for

/// Of a row of the file or of a header.
bool holds_number(const auto& row) { return std::ranges::any_of(row.fields, reads_as_number); }

bool are_names(const CsvHeader::Row& row, const CsvHeader& header) {
  return row.fields.size() == header.width && !holds_number(row);
}

bool has_row_of_names(const CsvHeader& header) {
  return std::ranges::any_of(header.rows, [&](const CsvHeader::Row& row) { return are_names(row, header); });
}

bool opens(std::string_view word) { return word.starts_with('(') || word.starts_with('['); }
bool closes(std::string_view word) { return word.ends_with(')') || word.ends_with(']'); }

bool has_open_bracket(std::string_view text) {
  return std::ranges::count_if(text, [](char c) { return c == '(' || c == '['; }) >
         std::ranges::count_if(text, [](char c) { return c == ')' || c == ']'; });
}

/// Words with the units behind them: "Time (ms)", "Acc (m / s2)", "Time / s".
std::vector<std::string> with_units(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  bool goes_on = false;  // the latest name
  for (const std::string& word : words) {
    const bool belongs = goes_on || word == "/" || (opens(word) && !names.empty() && !closes(names.back()));
    if (belongs && !names.empty())
      names.back() += ' ' + word;
    else
      names.push_back(word);
    goes_on = word == "/" || has_open_bracket(names.back());
  }
  return names;
}

/// Names of several words, each of which ends with its unit: "Head acc (g)".
std::vector<std::string> ended_by_units(const std::vector<std::string>& words) {
  std::vector<std::string> names;
  bool begins = true;
  for (const std::string& word : words) {
    if (begins)
      names.push_back(word);
    else
      names.back() += ' ' + word;
    begins = closes(word);
  }
  return names;
}

std::vector<std::string> parts_between(const std::string& line, char separator) {
  CsvRows rows(line, separator);
  std::vector<std::string> parts;
  if (CsvRow row; rows.next(row))
    for (std::size_t i = 0; i < row.filled(); ++i) parts.emplace_back(without_blanks(row.fields[i]));
  return parts;
}

bool looks_like_time(const std::string& name) {
  return looks_like(ColumnKind::time, {.name = name, .unit = split_header(name).unit});
}

/// A unit, with or without brackets.
bool is_unit_alone(const std::string& field) {
  const HeaderText parts = split_header(field);
  return is_known_unit(parts.name.empty() ? parts.unit : field);
}

bool has_unit(const std::string& name) {
  if (name.size() > longest_column_name) return false;  // a line of text
  const HeaderText parts = split_header(name);
  return !parts.name.empty() && is_known_unit(parts.unit);
}

/// Joins the words of a row that was split at blanks, so that there is one name for each column.
void join_words(CsvHeader::Row& row, std::size_t width) {
  using Names = std::vector<std::string>;
  const std::string line = fmt::format("{}", fmt::join(row.fields, " "));
  const Names names = with_units(row.fields);
  std::vector<Names> readings;
  for (const char separator : {';', ','})
    if (Names parts = parts_between(line, separator);
        std::ranges::any_of(parts, has_unit) && std::ranges::none_of(parts, reads_as_number))
      readings.push_back(std::move(parts));
  readings.insert(readings.end(), {names, ended_by_units(names), row.between_wide_gaps});
  const auto fitting =
      std::ranges::find_if(readings, [&](const Names& reading) { return reading.size() == width; });
  if (fitting != readings.end())
    row.fields = *fitting;
  else
    row.fields = row.fields.size() > width ? Names{line} : names;
}

void take_first_off(CsvHeader::Row& row) {
  row.keyword = std::move(row.fields.front());
  row.fields.erase(row.fields.begin());
}

/// Takes a sign at the beginning of a row off, and the keyword behind it if there is a name too many:
/// "% time, acc", ";Headers, time, Ax". Alone, % is a unit.
void take_sign_off(CsvHeader::Row& row, std::size_t width, std::size_t names) {
  constexpr std::string_view signs = "%;$!*/";
  std::string& first = row.fields.front();
  const auto begin = first.find_first_not_of(signs);
  if (begin == 0 || first.empty()) return;
  const bool is_sign_alone = begin == std::string::npos;
  const bool is_too_many = width >= 2 && names == width + 1;
  if (is_sign_alone && is_too_many)
    row.fields.erase(row.fields.begin());
  else if (is_too_many)
    take_first_off(row);
  else if (!is_sign_alone)
    first = std::string(without_blanks(std::string_view(first).substr(begin)));
}

/// Whether a row begins with a keyword: "SIGNAL","TIME","ACH1" or "UNITS","s","g" above two columns. Only
/// without it the column called a time increases, and units stand in all fields.
bool begins_with_keyword(const CsvHeader::Row& row, const CsvHeader& header, std::string_view text,
                         char separator) {
  if (header.width < 2 || row.fields.size() != header.width + 1) return false;
  const std::string& first = row.fields.front();
  if (first.empty() || looks_like_time(first) || is_unit_alone(first)) return false;
  if (first.ends_with(':') && !holds_number(row)) return true;
  const auto is_unit_or_none = [](const std::string& field) {
    return field.empty() || field == "-" || is_unit_alone(field);
  };
  if (std::all_of(row.fields.begin() + 1, row.fields.end(), is_unit_or_none)) return true;
  const auto time = std::ranges::find_if(row.fields, looks_like_time);
  if (time == row.fields.end()) return false;
  const auto column = static_cast<std::size_t>(time - row.fields.begin());
  return increases(text, separator, header.first_line, column - 1) &&
         !increases(text, separator, header.first_line, column);
}

void settle_rows(CsvHeader& header, std::string_view text, char separator) {
  const bool by_blanks = separator == ' ';
  for (CsvHeader::Row& row : header.rows) {
    take_sign_off(row, header.width, by_blanks ? with_units(row.fields).size() : row.fields.size());
    if (by_blanks)
      join_words(row, header.width);
    else if (begins_with_keyword(row, header, text, separator))
      take_first_off(row);
  }
}

/// The first line below sizes of a specimen or counts of points: rows of numbers, too few for a table, above
/// text and a table. 0 without.
std::size_t line_below_sizes(std::string_view text, char separator, std::ptrdiff_t fewest,
                             const CsvHeader& header) {
  const bool have_names = has_row_of_names(header);
  CsvRows rows(text, separator);
  CsvRow row;
  std::size_t run = 0, width = 0, count = 0;  // rows of numbers of one width
  std::size_t line = 0;                       // of the first row behind the numbers before
  bool has_names = false;                     // from that line on
  while (count < max_rows_above && rows.next(row)) {
    if (row.line < header.first_line) continue;
    ++count;
    if (!begins_numbers(row, fewest)) {
      if (run > 0 || line == 0) {
        line = row.line;
        has_names = false;
      }
      run = 0;
      has_names = has_names || (!holds_number(row) && (row.filled() >= 2 || !have_names));
      continue;
    }
    if (run > 0 && row.filled() != width) line = run = 0;
    width = row.filled();
    if (++run < fewest_rows_of_table) continue;
    return has_names && !(have_names && width == header.width) ? line : 0;
  }
  return 0;
}

/// Curve files name each column in a line of its own, such as "Time (ms)" and "Acceleration (g)"; lines above
/// and below are titles.
void take_names_one_a_line(CsvHeader& header) {
  if (header.width < 2) return;
  std::size_t run = 0;
  for (std::size_t i = 0; i < header.rows.size(); ++i) {
    const CsvHeader::Row& row = header.rows[i];
    if (are_names(row, header)) return;
    run = row.fields.size() == 1 && has_unit(row.fields.front()) ? run + 1 : 0;
    if (run < header.width) continue;
    CsvHeader::Row names{row.line, {}};
    for (std::size_t j = i + 1 - run; j <= i; ++j) names.fields.push_back(header.rows[j].fields.front());
    header.rows = {std::move(names)};
    return;
  }
}

/// "key= value" and "key: value" name no columns.
bool is_entry(const CsvHeader::Row& row) {
  return std::ranges::any_of(row.fields, [](const std::string& field) {
    return field.find('=') != std::string::npos || field.ends_with(':');
  });
}

/// Adds the comments above the numbers that have a name for each column, if no row has.
void add_names_of_comments(CsvHeader& header, std::string_view text, char separator) {
  if (has_row_of_names(header)) return;
  LineReader lines(text);
  for (std::string_view line; lines.next(line) && lines.number() < header.first_line;) {
    line = without_blanks(line);
    const auto begin = line.find_first_not_of('#');
    if (begin == 0 || begin == std::string_view::npos) continue;
    CsvRows words(line.substr(begin), separator);
    CsvRow row;
    if (!words.next(row) || !row.fault.empty()) continue;
    CsvHeader::Row names{.line = lines.number(), .fields = {}, .is_comment = true};
    for (std::size_t i = 0; i < row.filled(); ++i)
      names.fields.push_back(to_utf8(without_blanks(row.fields[i])));
    if (names.fields.size() == header.width + 1 && names.fields.front().ends_with(':'))
      names.fields.erase(names.fields.begin());
    if (separator == ' ') join_words(names, header.width);
    if (are_names(names, header) && !is_entry(names)) header.rows.push_back(std::move(names));
  }
  std::ranges::stable_sort(header.rows, {}, &CsvHeader::Row::line);
}

}  // namespace

std::string CsvHeader::remark() const {
  return numbers_above == 0
             ? ""
             : fmt::format("the numbers from line {} on, above the text, were left out", numbers_above);
}

CsvHeader find_header(std::string_view text, char separator, std::ptrdiff_t fewest) {
  CsvHeader header = read_csv_header(text, separator, fewest);
  if (header.first_line == 0) return header;
  settle_rows(header, text, separator);
  if (const std::size_t line = line_below_sizes(text, separator, fewest, header); line > 0) {
    const CsvHeader above = std::exchange(header, read_csv_header(text, separator, fewest, line - 1));
    if (above.width == header.width) header.numbers_above = above.first_line;
    settle_rows(header, text, separator);
  }
  take_names_one_a_line(header);
  add_names_of_comments(header, text, separator);
  return header;
}

}  // namespace dashpad::input
