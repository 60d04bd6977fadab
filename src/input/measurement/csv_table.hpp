#pragma once
/// Tables in a text: rows with separators, quotes and comments, the rows above the numbers, and which columns
/// these name.

#include <cstddef>
#include <deque>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/input/measurement/tables.hpp"
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

struct CsvHeader {
  struct Row {
    std::size_t line = 0;
    std::vector<std::string> fields;  ///< UTF-8, without blanks around them
  };
  std::vector<Row> rows;       ///< those before the first row of numbers
  bool from_comment = false;   ///< the only row is a comment
  bool is_latin1 = false;      ///< some text was not UTF-8
  std::size_t first_line = 0;  ///< of the numbers; 0 if there are none
  std::size_t width = 0;       ///< columns of the first row of numbers that are not empty
};

/// The rows up to the first one that begins with a number and holds `fewest` numbers; failing that, the first
/// one with so many.
CsvHeader read_csv_header(std::string_view text, char separator, int fewest = 2);

/// A table of numbers as it begins.
struct CsvTable {
  std::string_view text;        ///< without byte order mark
  bool has_one_column = false;  ///< which may be only where the caller says so
  char separator = ',';
  CsvHeader header;
};

/// Refuses what is no text, is empty, or has no row of two numbers, or of one. `content` must outlive table
/// and faults.
CsvTable csv_table_in(std::string_view content, MeasurementFaults& faults, bool may_have_one_column = false);

struct CsvColumns {
  std::vector<injury::MeasuredColumn> all;           ///< units as in the header
  const CsvHeader::Row* names = nullptr;             ///< the row that names them
  injury::MeasuredColumn time;                       ///< units settled; number 0 where the interval is given
  std::vector<injury::MeasuredColumn> acceleration;  ///< units settled
};

/// All columns, with names and units of the row that says most about them, and of a row of units below it.
CsvColumns name_columns(const CsvHeader& header);
/// The same; refuses a table in which no row names the columns, as `what` says: " and their units:
/// time_s,strain".
CsvColumns named_columns(const CsvHeader& header, const std::string& what, MeasurementFaults& faults);

/// The field of a column in a row, without blanks around it; empty where the row ends before.
std::string_view field_in(const CsvRow& row, const injury::MeasuredColumn& column);
/// Its number in SI; nothing, and a fault, where it holds none.
std::optional<double> number_in(const CsvRow& row, const injury::MeasuredColumn& column, char separator,
                                MeasurementFaults& faults);
/// Gives the rows of numbers to `take`, those with a fault in their quotes apart.
template <class Take>
void each_row(const CsvTable& table, MeasurementFaults& faults, Take&& take) {
  CsvRows rows(table.text, table.separator);
  for (CsvRow row; rows.next(row);) {
    if (row.line < table.header.first_line) continue;
    if (row.fault.empty())
      take(row);
    else
      faults.add(row.line, "", "", std::string(row.fault));
  }
}

/// Faults for a number in one of these columns, from `first` on, in a row below the names, but above the
/// numbers: a row that would be lost.
void require_no_numbers(const CsvHeader& header, const CsvHeader::Row* names,
                        const std::vector<injury::MeasuredColumn>& chosen, char separator,
                        MeasurementFaults& faults, std::size_t first = 0);

/// Chooses time and acceleration, settles their units, and adds to `remarks` what was not plain.
void choose_columns(CsvColumns& columns, const CsvHeader& header, const PulseCsvOptions& options,
                    MeasurementFaults& faults, std::vector<std::string>& remarks);

// The units of measured columns, and the ways in which headers name them.

enum class ColumnKind { time, acceleration };

/// One `unit` in SI. Of accelerations, g is standard gravity; the gram is no acceleration. Throws UnitError.
double pulse_unit_factor(ColumnKind kind, const std::string& unit);
bool is_pulse_unit(ColumnKind kind, const std::string& unit);
bool is_voltage(const std::string& unit);
/// Whether a header means a unit by this where it does not put it in brackets: "ms", "g", "m_per_s2".
bool is_customary_unit(std::string_view text);

/// A header in two: "Time [ms]", "Acc (g)", "t_ms", "Time / s", "Acc, g", "Acc g", "a_m_per_s2". The unit is
/// empty where there is none.
struct HeaderText {
  std::string name;
  std::string unit;
};
HeaderText split_header(std::string_view header);

/// How many of that unit a strain of 1 is: 1 without a unit, 100 in %. Nothing for a unit that is none of a
/// strain.
std::optional<double> units_in_strain_one(const std::string& unit);

/// Whether a column is of this kind: by its unit where it has one of time or acceleration, else by its name.
bool looks_like(ColumnKind kind, const injury::MeasuredColumn& column);

/// Fills in unit, origin and factor of a column whose `unit` is that of the header, or empty. Returns the
/// rule that is broken, or "". `option` is how to give the unit: "--time-unit". A column in volts is an
/// acceleration with a `sensitivity`, and only such a column has one.
std::string settle_unit(injury::MeasuredColumn& column, ColumnKind kind, const std::string& given,
                        const std::string& option, const std::optional<Sensitivity>& sensitivity = {});

std::string wrong_number_of_sensitivities(std::size_t given, std::size_t accelerations);
/// Of the acceleration at `place`, from 0: the only sensitivity is that of all.
std::optional<Sensitivity> sensitivity_at(const std::vector<Sensitivity>& given, std::size_t place);

/// A sentence for the user where a given unit overrules that of the file.
std::optional<std::string> overruled_unit(const injury::MeasuredColumn& column,
                                          const std::string& unit_of_file);

}  // namespace dashpad::input
