#pragma once
/// Rows of a table in a text: separators, quotes, comments.

#include <deque>
#include <string>
#include <string_view>
#include <vector>

#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

/// One row. The views live until the next row is read.
struct CsvRow {
  std::size_t line = 0;  ///< of its beginning
  std::vector<std::string_view> fields;
  std::string_view fault;  ///< what is wrong with its quotes; empty if nothing is
  /// Fields up to the last one that is not empty.
  [[nodiscard]] std::size_t filled() const;
};

class CsvRows {
 public:
  CsvRows(std::string_view text, char separator) : lines_(text), separator_(separator) {}

  /// The next row with content. False at the end. Passes over comments (#), and over blank lines and lines of
  /// nothing but separators, which it counts.
  bool next(CsvRow& row);

  [[nodiscard]] const LineReader& lines() const { return lines_; }
  [[nodiscard]] std::size_t blank_lines() const { return blank_lines_; }
  /// The latest comment so far, without #; and its line.
  [[nodiscard]] std::string_view comment() const { return comment_; }
  [[nodiscard]] std::size_t comment_line() const { return comment_line_; }
  /// Comments from now on are those among the numbers.
  void begin_numbers() { numbers_ = true; }
  [[nodiscard]] std::size_t comments_among_numbers() const { return comments_among_numbers_; }
  [[nodiscard]] std::size_t first_comment_among_numbers() const { return first_comment_among_numbers_; }

 private:
  void split(std::string_view line, CsvRow& row);
  std::string_view quoted(std::string_view& line, std::size_t begin, CsvRow& row, std::size_t& after);

  LineReader lines_;
  char separator_;
  std::size_t blank_lines_ = 0, pending_blank_lines_ = 0;
  std::string_view comment_;
  std::size_t comment_line_ = 0;
  bool numbers_ = false;
  std::size_t comments_among_numbers_ = 0, first_comment_among_numbers_ = 0;
  std::deque<std::string> unquoted_;
};

/// ',' ';' tab, or ' ' for any number of blanks: what makes numbers of most rows at the beginning of `text`.
char find_separator(std::string_view text);

/// Whether the table has one column, of numbers with a decimal point or comma. Two numbers with a comma
/// between them are two columns where a row above them has two fields, or where the first one increases in at
/// least four rows of five, as a time does.
bool is_one_column(std::string_view text);

/// A number with a decimal point or, where no comma separates, with a decimal comma.
ReadNumber read_csv_number(std::string_view field, char separator);

}  // namespace dashpad::input
