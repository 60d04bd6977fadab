#pragma once
/// Tables in a text: rows, headers, and the columns that the headers name.

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
  std::string_view fault;  ///< a fault in the quotes; empty if there is none
  bool has_quotes = false;
  /// The number of fields up to the last one that is not empty.
  [[nodiscard]] std::size_t filled() const;
};

class CsvRows {
 public:
  CsvRows(std::string_view text, char separator) : lines_(text), separator_(separator) {}

  /// Reads the next row with content; false at the end. Skips comments (#), and counts lines without content.
  bool next(CsvRow& row);

  [[nodiscard]] const LineReader& lines() const { return lines_; }
  [[nodiscard]] std::size_t blank_lines() const { return blank_lines_; }
  /// The latest comment without #, and its line.
  [[nodiscard]] std::string_view comment() const { return comment_; }
  [[nodiscard]] std::size_t comment_line() const { return comment_line_; }
  /// Later comments are counted as among the numbers.
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

/// The first MiB of a text, whole lines: enough for a header of thousands of columns and rows of numbers.
std::string_view beginning_of(std::string_view text);

/// The separator ',' ';' tab or ' ' (any number of blanks) that makes numbers of most rows at the beginning,
/// at least `fewest` of each.
char find_separator(std::string_view text, std::size_t fewest = 2);

/// The separator of the first row that is no comment: a semicolon, a tab, or else a comma.
char header_separator(std::string_view text);

/// Whether the table has one column, of numbers with decimal points or commas. Two numbers with a comma
/// between them are two columns if a row above has two fields, or if the first increases in at least four of
/// five rows, like a time.
bool is_one_column(std::string_view text);

/// A number with a decimal point or a decimal comma. Where commas separate, a field that holds one was
/// quoted.
ReadNumber read_csv_number(std::string_view field);
/// Whether a field is a number, finite or not, or a time of day.
bool reads_as_number(std::string_view field);

/// Whether a field says that there is no value: empty, NaN, N/A, an error of a spreadsheet.
bool is_missing(std::string_view field);

struct CsvHeader {
  struct Row {
    std::size_t line = 0;
    std::vector<std::string> fields;  ///< UTF-8, without blanks around them
    /// The same row of a table separated by blanks, split only where two or more of them follow each other.
    std::vector<std::string> between_wide_gaps = {};
    std::string keyword = {};  ///< what was taken off its beginning, as it names no column
    bool is_comment = false;
  };
  std::vector<Row> rows;               ///< those before the first row of numbers
  bool is_latin1 = false;              ///< some text is Latin-1
  std::size_t first_line = 0;          ///< of the numbers; 0 without any
  std::size_t width = 0;               ///< number of columns of the first row of numbers
  std::vector<std::string> first_row;  ///< the fields of that row, with empty ones at its end
  /// Line of rows of numbers above the rows here that were left out, if they might belong to the table; or 0.
  std::size_t numbers_above = 0;

  /// What was left out above; empty if nothing was.
  [[nodiscard]] std::string remark() const;
  [[nodiscard]] bool holds_time_of_day(const injury::MeasuredColumn& column) const;
};

/// The rows before the first one that begins with a number and holds at least `fewest` numbers; failing that,
/// before the first one with so many. Lines up to `skipped` are left out.
CsvHeader read_csv_header(std::string_view text, char separator, std::ptrdiff_t fewest = 2,
                          std::size_t skipped = 0);
/// Whether a row begins with a number and holds at least `fewest` numbers or signs of a missing one.
bool begins_numbers(const CsvRow& row, std::ptrdiff_t fewest);

/// The same, with each name of a column in a field of its own, as far as the names can be told: names with
/// units split at blanks, behind a keyword, one in a line, in comments, below rows of sizes.
CsvHeader find_header(std::string_view text, char separator, std::ptrdiff_t fewest);

/// What the header of a LabVIEW measurement file says.
struct LabViewHeader {
  /// Where the values of X are: nowhere, in the first column, in one before each channel.
  enum class XColumns { none, one, each };
  struct Column {
    std::string unit = {};
    double first = 0;                     ///< X0, s
    std::optional<double> interval = {};  ///< Delta_X, s, if X is the time
    std::optional<double> samples = {};   ///< how many there are to be
  };
  char separator = '\t';
  std::size_t end = 0;  ///< line of the last end of a header
  XColumns x_columns = XColumns::one;
  std::vector<Column> columns = {};
};

/// Absent for other text.
std::optional<LabViewHeader> labview_header(std::string_view text, MeasurementFaults& faults);

struct CsvTable {
  std::string_view text;        ///< without byte order mark
  bool has_one_column = false;  ///< only if the caller allows it
  char separator = ',';
  CsvHeader header;
  std::optional<LabViewHeader> labview = {};
};

/// How few numbers make a row of numbers.
enum class Fewest { two, one_column, one };

/// Refuses text that is binary, empty or without a row of two numbers; of one, if the table has one column
/// only or, with Fewest::one, no row has two. `content` outlives both.
CsvTable csv_table_in(std::string_view content, MeasurementFaults& faults, Fewest fewest = Fewest::two);

/// Rows of text behind the numbers, such as "EOF". Numbers below them belong to another table.
class TextBehind {
 public:
  explicit TextBehind(const CsvTable& table);

  /// Whether a row is such text. Refuses numbers below it.
  bool holds(const CsvRow& row, MeasurementFaults& faults);
  /// What was left out; empty if nothing was.
  [[nodiscard]] std::string remark() const;

 private:
  [[nodiscard]] bool is_text(const CsvRow& row) const;

  const CsvTable& table_;
  bool begin_with_numbers_;  ///< the rows of the table
  std::size_t count_ = 0, first_line_ = 0;
  std::string first_;
};

/// Refuses a text with several tables, as far as its beginning shows it.
void refuse_several_tables(const CsvTable& table, MeasurementFaults& faults);

/// The longest name of a column in messages and results.
inline constexpr std::size_t longest_column_name = 100;

struct CsvColumns {
  std::vector<injury::MeasuredColumn> all;           ///< units as in the header
  const CsvHeader::Row* names = nullptr;             ///< the row that names them
  injury::MeasuredColumn time;                       ///< with its unit; number 0 if the interval is given
  bool times_of_day = false;                         ///< as in time_of_day()
  std::vector<injury::MeasuredColumn> acceleration;  ///< with their units
};

/// All columns, named by the most telling row, with units from it, from a row of units below or from
/// `labview`.
CsvColumns name_columns(const CsvHeader& header, const std::optional<LabViewHeader>& labview = {});
/// The same columns. Refuses a table without a row of names; `what` continues the message: " and their units:
/// time_s,strain".
CsvColumns named_columns(const CsvHeader& header, const std::string& what, MeasurementFaults& faults);

/// The number of names in a row that look like those of a time or an acceleration.
int known_names(const CsvHeader::Row& row);

/// The trimmed field of a column in a row; empty beyond the end of the row.
template <class Row>
std::string_view field_in(const Row& row, const injury::MeasuredColumn& column) {
  const auto place = static_cast<std::size_t>(column.number - 1);
  return place < row.fields.size() ? without_blanks(row.fields[place]) : std::string_view();
}
/// Adds a fault of a field.
void add_fault(const CsvRow& row, const injury::MeasuredColumn& column, std::string rule,
               MeasurementFaults& faults);
/// The number of a field in SI; absent after a fault.
std::optional<double> number_in(const CsvRow& row, const injury::MeasuredColumn& column,
                                MeasurementFaults& faults);
/// Calls `take` with each row of numbers. Rows with a fault in their quotes are reported. Text behind the
/// numbers is left out with a remark; without `remarks` it is a row like others.
template <class Take>
void each_row(const CsvTable& table, MeasurementFaults& faults, Take&& take,
              std::vector<std::string>* remarks = nullptr) {
  TextBehind text(table);
  CsvRows rows(table.text, table.separator);
  for (CsvRow row; rows.next(row);) {
    if (row.line < table.header.first_line || (remarks != nullptr && text.holds(row, faults))) continue;
    if (row.fault.empty())
      take(row);
    else
      faults.add(row.line, "", "", std::string(row.fault));
  }
  if (remarks != nullptr && !text.remark().empty()) remarks->push_back(text.remark());
}

/// Whether the numbers of a column, from 0, increase in the first rows from a line on.
bool increases(std::string_view text, char separator, std::size_t first_line, std::size_t column);

/// Reports rows between names and numbers that hold a number in one of these columns, from `first` on.
/// Without names, a count of points alone in its row and what stands above a title are no such rows.
void require_no_numbers(const CsvHeader& header, const CsvHeader::Row* names,
                        const std::vector<injury::MeasuredColumn>& chosen, MeasurementFaults& faults,
                        std::size_t first = 0);

/// Chooses the columns of time and acceleration with their units; remarks on choices that were not obvious.
void choose_columns(CsvColumns& columns, const CsvTable& table, const PulseOptions& options,
                    MeasurementFaults& faults, std::vector<std::string>& remarks);

// Units of measured columns, and their notation in headers.

enum class ColumnKind { time, acceleration };

/// One `unit` in SI. As an acceleration, g is standard gravity. Throws UnitError.
double pulse_unit_factor(ColumnKind kind, const std::string& unit);
bool is_pulse_unit(ColumnKind kind, const std::string& unit);
bool is_voltage(const std::string& unit);
/// Whether a text is a unit, of whatever quantity.
bool is_known_unit(const std::string& text);
/// Whether a header may have this unit without brackets: "ms", "g", "m_per_s2".
bool is_customary_unit(std::string_view text);

/// Splits headers such as "Time [ms]", "Acc (g)", "t_ms", "Time / s", "Acc, g", "Acc g", "a_m_per_s2". The
/// unit may be empty.
struct HeaderText {
  std::string name;
  std::string unit;
};
HeaderText split_header(std::string_view header);

/// How many of a unit make a strain of 1: 1 without a unit, 100 for %. Absent for other units.
std::optional<double> units_in_strain_one(const std::string& unit);

/// Whether a column is of this kind, by its unit or, unless that is one of time or acceleration, by its name.
bool looks_like(ColumnKind kind, const injury::MeasuredColumn& column);

/// Sets unit, origin and factor of a column whose `unit` is that of the header, or empty. Returns a broken
/// rule, or "". `option` is how to give the unit: "--time-unit". A column in volts needs a `sensitivity`, and
/// only such a column has one.
std::string settle_unit(injury::MeasuredColumn& column, ColumnKind kind, const std::string& given,
                        const std::string& option, const std::optional<Sensitivity>& sensitivity = {});

std::string wrong_number_of_sensitivities(std::size_t given, std::size_t accelerations);
/// The sensitivity of the acceleration number `place`, from 0; a single one applies to all.
std::optional<Sensitivity> sensitivity_at(const std::vector<Sensitivity>& given, std::size_t place);

/// A remark if a given unit overrules that of the file.
std::optional<std::string> overruled_unit(const injury::MeasuredColumn& column,
                                          const std::string& unit_of_file);

}  // namespace dashpad::input
