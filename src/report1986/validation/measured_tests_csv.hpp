#pragma once
/// A data file of the study: comma separated, with comments (#) and one line that names the columns.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::report1986 {

struct CsvTable;

/// A row of a table, which outlives it.
class CsvRecord {
 public:
  /// `fields`: one for each column, without blanks around them.
  CsvRecord(CsvTable& table, int line, std::vector<std::string> fields)
      : table_(&table), line_(line), fields_(std::move(fields)) {}

  /// What stands in a column; must not be empty.
  [[nodiscard]] std::string text(const std::string& column) const;
  /// A finite number above 0, of a fraction below 1. NaN after a fault.
  [[nodiscard]] double number(const std::string& column, bool is_fraction = false) const;
  /// The same; nothing where the field is empty or at fault.
  [[nodiscard]] std::optional<double> reading(const std::string& column, bool is_fraction) const;
  /// A whole number from 1 to 9999. 0 after a fault.
  [[nodiscard]] int whole(const std::string& column) const;
  /// One of the words. Their number in `words`; nothing after a fault.
  [[nodiscard]] std::optional<std::size_t> choice(const std::string& column,
                                                  const std::vector<std::string>& words) const;
  /// A fault, with the value of the column.
  void fault(const std::string& column, std::string rule) const;

 private:
  [[nodiscard]] const std::string& field(const std::string& column) const;

  CsvTable* table_;
  int line_;
  std::vector<std::string> fields_;
};

/// Keeps every fault instead of stopping at the first. A row with too few or too many fields is a fault and
/// is left out.
struct CsvTable {
  /// The file must name these columns, in this order. `faults` must outlive the table.
  CsvTable(const std::filesystem::path& file, std::vector<std::string> columns,
           std::vector<input::Fault>& faults);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  /// A fault of the whole file, unless a line is named.
  void fault(std::string rule, int line = 0);

  const std::string file;
  const std::vector<std::string> columns;
  std::vector<input::Fault>& faults;
  std::vector<CsvRecord> records;
};

/// Why a text is no finite number above 0 (below 1 for a fraction). Empty if it is one, which is then in
/// `value`.
std::string why_no_reading(const std::string& text, bool is_fraction, double& value);

}  // namespace dashpad::report1986
