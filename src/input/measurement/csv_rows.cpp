#include "input/measurement/csv_table.hpp"

#include <algorithm>
#include <limits>

#include "input/measurement/clock_time.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t sample_rows = 400;
constexpr std::size_t longest_quoted_field = 10'000;  // a longer one is not closed

bool is_blank(char c) { return c == ' ' || c == '\t'; }

}  // namespace

std::string_view beginning_of(std::string_view text) {
  constexpr std::size_t sample_size = 1 << 20;
  const std::string_view sample = text.substr(0, sample_size);
  return sample.size() < text.size() ? sample.substr(0, sample.find_last_of("\r\n")) : text;
}

std::size_t CsvRow::filled() const {
  std::size_t count = fields.size();
  while (count > 0 && without_blanks(fields[count - 1]).empty()) --count;
  return count;
}

bool CsvRows::next(CsvRow& row) {
  std::string_view line;
  while (lines_.next(line)) {
    const std::string_view content = without_blanks(line);
    if (content.starts_with('#')) {
      comment_ = content.substr(content.find_first_not_of('#') == std::string_view::npos
                                    ? content.size()
                                    : content.find_first_not_of('#'));
      comment_line_ = lines_.number();
      if (numbers_ && comments_among_numbers_++ == 0) first_comment_among_numbers_ = comment_line_;
      continue;
    }
    row.line = lines_.number();
    row.fields.clear();
    row.fault = {};
    row.has_quotes = false;
    if (!content.empty()) split(line, row);
    if (row.filled() == 0 && row.fault.empty()) {
      ++pending_blank_lines_;
      continue;
    }
    if (numbers_) blank_lines_ += pending_blank_lines_;  // those in a header and at the end do not count
    pending_blank_lines_ = 0;
    return true;
  }
  return false;
}

/// The text of a quoted field that begins at `begin` and may extend over further lines, which are added to
/// `line`. `after` is the place after the closing quote.
std::string_view CsvRows::quoted(std::string_view& line, std::size_t begin, CsvRow& row, std::size_t& after) {
  std::string text;
  std::size_t i = begin + 1;
  while (true) {
    if (i >= line.size()) {
      std::string_view more;
      if (text.size() > longest_quoted_field || !lines_.next(more)) {
        row.fault = "has a quotation mark that is not closed";
        after = line.size();
        break;
      }
      text += '\n';
      line = {line.data(), static_cast<std::size_t>(more.data() + more.size() - line.data())};
      i = static_cast<std::size_t>(more.data() - line.data());
      continue;
    }
    if (line[i] != '"') {
      text += line[i++];
    } else if (i + 1 < line.size() && line[i + 1] == '"') {
      text += '"';
      i += 2;
    } else {
      after = i + 1;
      break;
    }
  }
  return unquoted_.emplace_back(std::move(text));
}

void CsvRows::split(std::string_view line, CsvRow& row) {
  if (!unquoted_.empty()) unquoted_.clear();
  const bool by_blanks = separator_ == ' ';
  const auto ends_field = [&](char c) { return by_blanks ? is_blank(c) : c == separator_; };
  std::size_t at = 0;
  while (true) {
    while (at < line.size() && is_blank(line[at]) && (by_blanks || line[at] != separator_)) ++at;
    if (by_blanks && at >= line.size()) return;
    if (at < line.size() && line[at] == '"') {
      row.has_quotes = true;
      row.fields.push_back(quoted(line, at, row, at));
      while (at < line.size() && is_blank(line[at]) && !ends_field(line[at])) ++at;
      if (at < line.size() && !ends_field(line[at]) && row.fault.empty())
        row.fault = "has text after a closing quotation mark";
      while (at < line.size() && !ends_field(line[at])) ++at;
    } else {
      const std::size_t begin = at;
      while (at < line.size() && !ends_field(line[at])) ++at;
      row.fields.push_back(line.substr(begin, at - begin));
    }
    if (at >= line.size()) return;
    ++at;
  }
}

bool is_one_column(std::string_view text) {
  LineReader lines(beginning_of(text));
  std::string_view line;
  std::size_t numbers = 0, others = 0, names = 0, with_comma = 0, increasing = 0;
  double latest = -std::numeric_limits<double>::infinity();
  while (lines.next(line)) {
    line = without_blanks(line);
    if (line.empty() || line.starts_with('#')) continue;
    if (read_csv_number(line).kind != NumberKind::number) {
      if (numbers > 0)
        ++others;
      else
        names = static_cast<std::size_t>(std::ranges::count(line, ',')) + 1;
      continue;
    }
    ++numbers;
    const auto comma = line.find(',');
    if (comma == std::string_view::npos) continue;
    ++with_comma;
    const double first = read_number(line.substr(0, comma)).value;
    if (first > latest) ++increasing;
    latest = first;
  }
  const bool are_two =
      (names >= 2 && 2 * with_comma >= numbers) || (with_comma == numbers && 10 * increasing >= 8 * numbers);
  return numbers > others && !are_two;
}

bool increases(std::string_view text, char separator, std::size_t first_line, std::size_t column) {
  CsvRows rows(beginning_of(text), separator);
  double latest = -std::numeric_limits<double>::infinity();
  std::size_t count = 0;
  for (CsvRow row; count < sample_rows && rows.next(row);) {
    if (row.line < first_line || column >= row.fields.size()) continue;
    const ReadNumber number = read_csv_number(row.fields[column]);
    if (number.kind != NumberKind::number) break;
    if (!(number.value > latest)) return false;
    latest = number.value;
    ++count;
  }
  return count > 1;
}

char find_separator(std::string_view text, std::size_t fewest) {
  const std::string_view sample = beginning_of(text);
  char best = ',';
  std::size_t best_score = 0;
  for (const char separator : {'\t', ';', ',', ' '}) {
    CsvRows rows(sample, separator);
    CsvRow row;
    std::size_t of_numbers = 0, of_some = 0;  // rows
    for (std::size_t count = 0; count < sample_rows && rows.next(row); ++count) {
      const auto numbers = static_cast<std::size_t>(std::ranges::count_if(row.fields, reads_as_number));
      if (numbers < fewest) continue;
      const auto empty = static_cast<std::size_t>(std::ranges::count_if(
          row.fields, [](std::string_view field) { return without_blanks(field).empty(); }));
      const bool all = numbers + empty == row.fields.size();
      if (all && of_numbers == 0) of_some = 0;  // numbers in the header do not count
      ++(all ? of_numbers : of_some);
    }
    const std::size_t score = 10 * of_numbers + of_some;
    // Blanks also separate at tabs and between the words of a header, so one more row is not enough.
    if (score <= best_score + (separator == ' ' && best_score > 0 ? 1 : 0)) continue;
    best_score = score;
    best = separator;
  }
  return best;
}

char header_separator(std::string_view text) {
  LineReader lines(text);
  std::string_view line;
  while (lines.next(line) && (without_blanks(line).empty() || without_blanks(line).front() == '#')) {
  }
  for (const char separator : {';', '\t'})
    if (line.find(separator) != std::string_view::npos) return separator;
  return ',';
}

ReadNumber read_csv_number(std::string_view field) {
  const ReadNumber number = read_number(field);
  if (number.kind != NumberKind::text) return number;
  return field.find(',') == std::string_view::npos ? number : read_number(field, ',');
}

bool reads_as_number(std::string_view field) {
  const NumberKind kind = read_csv_number(field).kind;
  return (kind != NumberKind::text && kind != NumberKind::empty) || time_of_day(field).has_value();
}

bool is_missing(std::string_view field) {
  if (field.empty()) return true;
  if (field.size() > 7 || (field.front() <= '9' && field.front() != '-' && field.front() != '#'))
    return false;
  // The last ones are the errors of a spreadsheet.
  constexpr std::string_view words[]{"nan", "n/a",  "na",  "n.a.",    "null",   "none",    "novalue",
                                     "-",   "#n/a", "#nv", "#value!", "#wert!", "#div/0!", "#num!"};
  return std::ranges::count(words, lower_case(field)) > 0;
}

}  // namespace dashpad::input
