// Text behind the numbers of a table, and several tables in a file.

#include <algorithm>

#include <fmt/format.h>

#include "input/measurement/csv_table.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

/// A quick look at what most rows begin with.
bool begins_like_number(std::string_view field) {
  return !field.empty() && std::string_view("0123456789+-.").find(field.front()) != std::string_view::npos;
}

/// Whether a row of the header comes again, such as the names of a second table.
bool is_of_header(const CsvRow& row, const CsvHeader& header) {
  const std::size_t count = row.filled();
  return count >= 2 && std::ranges::any_of(header.rows, [&](const CsvHeader::Row& of_header) {
           return std::equal(row.fields.begin(), row.fields.begin() + static_cast<std::ptrdiff_t>(count),
                             of_header.fields.begin(), of_header.fields.end(),
                             [](std::string_view field, const std::string& name) {
                               return to_utf8(without_blanks(field)) == name;
                             });
         });
}

}  // namespace

TextBehind::TextBehind(const CsvTable& table)
    : table_(table),
      begin_with_numbers_(!table.header.first_row.empty() &&
                          reads_as_number(table.header.first_row.front())) {}

bool TextBehind::is_text(const CsvRow& row) const {
  const CsvHeader& header = table_.header;
  const std::size_t count = row.fields.size();
  const bool has_count = count == header.width || count == header.first_row.size();
  if (has_count && begins_like_number(row.fields.front())) return false;
  const std::string_view first = without_blanks(row.fields.front());
  const bool has_number = begin_with_numbers_ && !first.empty()
                              ? reads_as_number(first)
                              : std::ranges::any_of(row.fields, reads_as_number);
  if (has_number) return false;
  if (count_ > 0) return true;
  if (first.empty() || is_missing(first)) return false;
  const bool are_words = table_.separator == ' ' && std::ranges::none_of(row.fields, reads_as_number);
  return !has_count || row.filled() < 2 || are_words || is_of_header(row, header);
}

bool TextBehind::holds(const CsvRow& row, MeasurementFaults& faults) {
  if (!row.fault.empty() || table_.labview || table_.header.width < 2) return false;
  if (is_text(row)) {
    if (count_++ == 0) {
      first_line_ = row.line;
      first_ = to_utf8(without_blanks(row.fields.front()));
    }
    return true;
  }
  if (count_ > 0)
    faults.refuse(
        first_line_, first_, "",
        "is text among the numbers; if another table begins here, put it in a file of its own, else "
        "remove the text");
  return false;
}

std::string TextBehind::remark() const {
  if (count_ == 0) return "";
  return count_ == 1 ? fmt::format("the text on line {} behind the numbers was left out", first_line_)
                     : fmt::format("{} of text behind the numbers, from line {} on, were left out",
                                   plural(count_, "line"), first_line_);
}

void refuse_several_tables(const CsvTable& table, MeasurementFaults& faults) {
  TextBehind text(table);
  CsvRows rows(beginning_of(table.text), table.separator);
  for (CsvRow row; rows.next(row);)
    if (row.line >= table.header.first_line) text.holds(row, faults);
}

}  // namespace dashpad::input
