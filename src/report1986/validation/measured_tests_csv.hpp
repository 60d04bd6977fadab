#pragma once
/// A data file of the study: comma separated, with comments (#) and one line that names the columns.

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"

namespace dashpad::report1986 {

struct CsvRecord {
  int line = 0;
  std::vector<std::string> fields;  ///< one for each column, without blanks around them
};

/// Reads and keeps every fault instead of stopping at the first. A record with too few or too many fields is
/// a fault and is left out.
class CsvTable {
 public:
  /// The file must name these columns, in this order. `faults` must outlive the table.
  CsvTable(const std::filesystem::path& file, std::vector<std::string> columns,
           std::vector<input::Fault>& faults);

  [[nodiscard]] const std::vector<CsvRecord>& records() const { return records_; }

  /// What stands in a column; must not be empty.
  std::string text(const CsvRecord& record, const std::string& column);
  /// A finite number above 0, of a fraction below 1. NaN after a fault.
  double number(const CsvRecord& record, const std::string& column, bool is_fraction = false);
  /// The same; nothing where the field is empty or at fault.
  std::optional<double> reading(const CsvRecord& record, const std::string& column, bool is_fraction);
  /// A whole number from 1 to 9999. 0 after a fault.
  int whole(const CsvRecord& record, const std::string& column);
  /// One of the words. Their number in `words`; nothing after a fault.
  std::optional<std::size_t> choice(const CsvRecord& record, const std::string& column,
                                    const std::vector<std::string>& words);

  /// A fault of this file, with the value of the column if `record` is in it.
  void fault(const CsvRecord& record, const std::string& column, std::string rule);
  void fault(const std::string& rule);  ///< of the whole file

 private:
  void read(const std::string& text);
  [[nodiscard]] const std::string& field(const CsvRecord& record, const std::string& column) const;

  std::string file_;
  std::vector<std::string> columns_;
  std::vector<input::Fault>* faults_;
  std::vector<CsvRecord> records_;
};

/// Why a text is no finite number above 0 (below 1 for a fraction). Empty if it is one, which is then in
/// `value`.
std::string why_no_reading(const std::string& text, bool is_fraction, double& value);

}  // namespace dashpad::report1986
