// The rows above the numbers of a table, and the table in a text.

#include "input/measurement/csv_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/measurement/clock_time.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_header_rows = 1000;

/// The names in a row in which single blanks stand in names, and wider gaps between them.
std::vector<std::string> between_wide_gaps(const CsvRow& row) {
  std::vector<std::string> names;
  const char* end = nullptr;
  for (const std::string_view field : row.fields) {
    const std::string word = to_utf8(field);
    if (end != nullptr && field.data() == end + 1 && *end == ' ')
      names.back() += ' ' + word;
    else
      names.push_back(word);
    end = field.data() + field.size();
  }
  return names;
}

/// A universal file begins with a mark and the number of a data set, each in six columns; one column of
/// numbers goes on with numbers.
bool is_universal_file(std::string_view text) {
  constexpr std::string_view mark = "    -1";
  LineReader lines(text);
  std::string_view first, second, third;
  if (!lines.next(first) || !lines.next(second) || !lines.next(third)) return false;
  return first.starts_with(mark) && without_blanks(first) == "-1" && second.starts_with("  ") &&
         reads_as_number(second.substr(0, mark.size())) && !reads_as_number(third);
}

bool is_markup(std::string_view text) {
  const std::string begin = lower_case(without_blanks(text.substr(0, 100)));
  return begin.starts_with("<?xml") || begin.starts_with("<!doctype") || begin.starts_with("<html");
}

constexpr const char* rule_for_markup = "is XML or HTML, not a table; export the numbers as CSV or text";

}  // namespace

bool begins_numbers(const CsvRow& row, std::ptrdiff_t fewest) {
  const auto is_number_or_missing = [](std::string_view field) {
    return reads_as_number(field) || (!without_blanks(field).empty() && is_missing(without_blanks(field)));
  };
  return reads_as_number(row.fields.front()) &&
         std::ranges::count_if(row.fields, is_number_or_missing) >= fewest;
}

CsvHeader read_csv_header(std::string_view text, char separator, std::ptrdiff_t fewest, std::size_t skipped) {
  CsvHeader header;
  CsvRows rows(text, separator);
  CsvRow row;
  std::optional<CsvHeader> fallback;
  while (header.rows.size() < max_header_rows && rows.next(row)) {
    if (row.line <= skipped) continue;
    const auto begin_numbers = [&](CsvHeader& csv_header) {
      csv_header.first_line = row.line;
      csv_header.width = row.filled();
      csv_header.first_row.assign(row.fields.begin(), row.fields.end());
    };
    if (!fallback && std::ranges::count_if(row.fields, reads_as_number) >= fewest)
      begin_numbers(fallback.emplace(header));
    if (begins_numbers(row, fewest)) {
      begin_numbers(header);
      break;
    }
    CsvHeader::Row names{row.line, {}};
    for (std::size_t i = 0; i < row.filled(); ++i) {
      const std::string_view field = without_blanks(row.fields[i]);
      header.is_latin1 = header.is_latin1 || !is_utf8(field);
      names.fields.push_back(to_utf8(field));
    }
    if (separator == ' ' && row.fault.empty()) names.between_wide_gaps = between_wide_gaps(row);
    if (!names.fields.empty()) header.rows.push_back(std::move(names));
  }
  if (header.first_line == 0 && fallback) header = *fallback;
  return header;
}

bool CsvHeader::holds_time_of_day(const injury::MeasuredColumn& column) const {
  const auto place = static_cast<std::size_t>(column.number - 1);
  return place < first_row.size() && time_of_day(first_row[place]).has_value();
}

CsvTable csv_table_in(std::string_view content, MeasurementFaults& faults, Fewest fewest) {
  CsvTable table{.text = text_in(content, faults), .header = {}};
  if (without_blanks(table.text).empty()) faults.refuse(0, "", "", "is empty");
  if (is_universal_file(table.text))
    faults.refuse(1, "", "",
                  "is a universal file (UFF), which is not read; export its channel as a table (CSV) with a "
                  "row for each sample");
  if (is_markup(table.text)) faults.refuse(1, "", "", rule_for_markup);
  table.labview = labview_header(table.text, faults);
  if (table.labview) {
    table.separator = table.labview->separator;
    table.header = read_csv_header(table.text, table.separator, 1, table.labview->end);
    if (table.header.first_line == 0)
      faults.refuse(table.labview->end, "", "", "no numbers follow the header");
    return table;
  }
  table.has_one_column = fewest != Fewest::two && is_one_column(table.text);
  table.separator = table.has_one_column ? ';' : find_separator(table.text);
  table.header = find_header(table.text, table.separator, table.has_one_column ? 1 : 2);
  if (table.header.first_line == 0 && fewest == Fewest::one) {
    table.separator = find_separator(table.text, 1);
    table.header = find_header(table.text, table.separator, 1);
  }
  if (table.header.first_line == 0)
    faults.refuse(0, "", "",
                  without_blanks(table.text).starts_with('<') ? rule_for_markup
                                                              : "has no row with two or more numbers");
  refuse_several_tables(table, faults);
  return table;
}

}  // namespace dashpad::input
