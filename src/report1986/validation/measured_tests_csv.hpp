#pragma once
/// Data files of the study: comma separated, with comments (#) and one line that names the columns.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::report1986 {

struct CsvTable;

/// A row of a table, which must outlive it.
class CsvRecord {
 public:
  /// `fields`: one per column, trimmed.
  CsvRecord(CsvTable& table, int line, std::vector<std::string> fields)
      : table_(&table), line_(line), fields_(std::move(fields)) {}

  /// The text of a column, which must not be empty.
  [[nodiscard]] std::string text(const std::string& column) const;
  /// A finite number above 0, and below 1 if a fraction. NaN after a fault.
  [[nodiscard]] double number(const std::string& column, bool is_fraction = false) const;
  /// The same number; absent if the field is empty or at fault.
  [[nodiscard]] std::optional<double> reading(const std::string& column, bool is_fraction) const;
  /// A whole number from 1 to 9999; 0 after a fault.
  [[nodiscard]] int whole(const std::string& column) const;
  /// The index of the field in `words`; absent after a fault.
  [[nodiscard]] std::optional<std::size_t> choice(const std::string& column,
                                                  const std::vector<std::string>& words) const;
  /// Adds a fault with the value of the column.
  void fault(const std::string& column, std::string rule) const;

 private:
  [[nodiscard]] const std::string& field(const std::string& column) const;

  CsvTable* table_;
  int line_;
  std::vector<std::string> fields_;
};

/// Collects all faults. A row with too few or too many fields is a fault and is omitted.
struct CsvTable {
  /// The file must name these columns, in this order. `faults` must outlive the table.
  CsvTable(const std::filesystem::path& file, std::vector<std::string> columns,
           std::vector<input::Fault>& faults);
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  /// Adds a fault of the whole file or of a line.
  void fault(std::string rule, int line = 0);

  const std::string file;
  const std::vector<std::string> columns;
  std::vector<input::Fault>& faults;
  std::vector<CsvRecord> records;
};

/// The reason why a text is no finite number above 0 (and below 1 for a fraction). Empty if it is one; then
/// `value` is set.
std::string why_no_reading(const std::string& text, bool is_fraction, double& value);

}  // namespace dashpad::report1986
