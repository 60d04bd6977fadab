// The rows above the numbers of a table, and its separator.

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

}  // namespace

CsvHeader read_csv_header(std::string_view text, char separator, int fewest, std::size_t skipped) {
  CsvHeader header;
  CsvRows rows(text, separator);
  CsvRow row;
  std::optional<CsvHeader> fallback;
  std::string_view comment;
  while (header.rows.size() < max_header_rows && rows.next(row)) {
    if (row.line <= skipped) continue;
    const auto numbers = std::ranges::count_if(row.fields, reads_as_number);
    const auto begin_numbers = [&](CsvHeader& csv_header) {
      csv_header.first_line = row.line;
      csv_header.width = row.filled();
      csv_header.first_row.assign(row.fields.begin(), row.fields.end());
    };
    if (numbers >= fewest && !fallback) {
      begin_numbers(fallback.emplace(header));
      comment = rows.comment();
    }
    const auto without_value = [](std::string_view field) {
      return !without_blanks(field).empty() && !reads_as_number(field) && is_missing(without_blanks(field));
    };
    if (reads_as_number(row.fields.front()) &&
        numbers + std::ranges::count_if(row.fields, without_value) >= fewest) {
      begin_numbers(header);
      comment = rows.comment();
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
  for (CsvHeader::Row& names : header.rows) {
    if (separator != ' ' || names.fields.size() <= header.width) continue;
    const bool has_wide_gaps = names.between_wide_gaps.size() == header.width;
    names.fields = has_wide_gaps ? names.between_wide_gaps
                                 : std::vector{fmt::format("{}", fmt::join(names.fields, " "))};
  }
  if (header.first_line != 0 && header.rows.empty() && !comment.empty()) {
    CsvRows words(comment, separator);
    if (words.next(row) && row.filled() == header.width && row.fault.empty()) {
      CsvHeader::Row names{rows.comment_line(), {}};
      for (const std::string_view field : row.fields) names.fields.push_back(to_utf8(without_blanks(field)));
      header.rows.push_back(std::move(names));
      header.from_comment = true;
    }
  }
  return header;
}

bool CsvHeader::holds_time_of_day(const injury::MeasuredColumn& column) const {
  const auto place = static_cast<std::size_t>(column.number - 1);
  return place < first_row.size() && time_of_day(first_row[place]).has_value();
}

CsvTable csv_table_in(std::string_view content, MeasurementFaults& faults, Fewest fewest) {
  CsvTable table{.text = text_in(content, faults), .header = {}};
  if (without_blanks(table.text).empty()) faults.refuse(0, "", "", "is empty");
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
  table.header = read_csv_header(table.text, table.separator, table.has_one_column ? 1 : 2);
  if (table.header.first_line == 0 && fewest == Fewest::one) {
    table.separator = find_separator(table.text, 1);
    table.header = read_csv_header(table.text, table.separator, 1);
  }
  if (table.header.first_line == 0) faults.refuse(0, "", "", "has no row with two or more numbers");
  return table;
}

}  // namespace dashpad::input
