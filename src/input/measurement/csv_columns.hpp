#pragma once
/// The rows above the numbers of a table, and which columns they name.

#include <string>
#include <string_view>
#include <vector>

#include "dashpad/input/measurement/pulse_csv.hpp"
#include "input/measurement/measurement_text.hpp"

namespace dashpad::input {

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
  std::string_view text;
  char separator = ',';
  CsvHeader header;
};

/// Refuses what is no text, is empty, or has no row of two numbers. `content` must outlive table and faults.
CsvTable csv_table_in(std::string_view content, MeasurementFaults& faults);

struct CsvColumns {
  std::vector<injury::MeasuredColumn> all;           ///< units as in the header
  const CsvHeader::Row* names = nullptr;             ///< the row that names them
  injury::MeasuredColumn time;                       ///< units settled; number 0 where the interval is given
  std::vector<injury::MeasuredColumn> acceleration;  ///< units settled
};

/// All columns, with names and units of the row that says most about them, and of a row of units below it.
CsvColumns name_columns(const CsvHeader& header);

/// Chooses time and acceleration, settles their units, and adds to `remarks` what was not plain.
void choose_columns(CsvColumns& columns, const CsvHeader& header, const PulseCsvOptions& options,
                    MeasurementFaults& faults, std::vector<std::string>& remarks);

}  // namespace dashpad::input
