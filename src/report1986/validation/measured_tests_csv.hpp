#pragma once
/// Data files of the study: comma separated, with comments (#) and one line that names the columns.

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/input/fault.hpp"
#include "dashpad/quantities/constants.hpp"
#include "input/disk.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/spelling.hpp"

namespace dashpad::report1986 {

/// Why a text is no finite number above 0 (and below 1 for a fraction); if "", `value` is set.
inline std::string why_no_reading(const std::string& text, bool is_fraction, double& value) {
  const input::ReadNumber number = input::read_number(text);
  if (number.kind == input::NumberKind::empty) return "is missing";
  if (number.kind != input::NumberKind::number) return input::rule_for(number.kind);
  if (number.value <= 0) return "must be more than 0";
  if (is_fraction && number.value >= 1) return "must be less than 1";
  value = number.value;
  return "";
}

/// A data file, with the list that collects its faults.
struct CsvFile {
  const std::string name;
  const std::vector<std::string> columns;
  std::vector<input::Fault>& faults;

  /// Adds a fault of the whole file or of a line.
  void fault(std::string rule, int line = 0) { faults.push_back({name, line, "", "", std::move(rule)}); }
};

/// A row of a file, which must outlive it.
class CsvRecord {
 public:
  CsvRecord(CsvFile& file, int line, std::vector<std::string> fields)
      : file_(&file), line_(line), fields_(std::move(fields)) {}

  /// Adds a fault with the value of the column.
  void fault(const std::string& column, std::string rule) const {
    file_->faults.push_back({file_->name, line_, column, field(column), std::move(rule)});
  }
  /// The text of a column, which must not be empty.
  [[nodiscard]] std::string text(const std::string& column) const {
    if (field(column).empty()) fault(column, "is missing");
    return field(column);
  }
  /// A finite number above 0, and below 1 if a fraction. NaN after a fault.
  [[nodiscard]] double number(const std::string& column, bool is_fraction = false) const {
    double value = no_value;
    const std::string rule = why_no_reading(field(column), is_fraction, value);
    if (!rule.empty()) fault(column, rule);
    return value;
  }
  /// The same number; absent if the field is empty or at fault.
  [[nodiscard]] std::optional<double> reading(const std::string& column, bool is_fraction) const {
    if (field(column).empty()) return std::nullopt;
    const double value = number(column, is_fraction);
    return std::isnan(value) ? std::nullopt : std::optional(value);
  }
  /// A whole number from 1 to 9999; 0 after a fault.
  [[nodiscard]] int whole(const std::string& column) const {
    double value = 0;
    std::string rule = why_no_reading(field(column), false, value);
    if (rule.empty() && (value != std::floor(value) || value > 9999))
      rule = "must be a whole number from 1 to 9999";
    if (rule.empty()) return static_cast<int>(value);
    fault(column, rule);
    return 0;
  }
  /// The index of the field in `words`; absent after a fault.
  [[nodiscard]] std::optional<std::size_t> choice(const std::string& column,
                                                  const std::vector<std::string>& words) const {
    const auto found = std::ranges::find(words, field(column));
    if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
    fault(column, "must be one of " + input::listing(words) + input::did_you_mean(field(column), words));
    return std::nullopt;
  }

 private:
  [[nodiscard]] const std::string& field(const std::string& column) const {
    const auto at = std::ranges::find(file_->columns, column) - file_->columns.begin();
    return fields_.at(static_cast<std::size_t>(at));
  }

  CsvFile* file_;
  int line_;
  std::vector<std::string> fields_;
};

/// The rows of a file, which must name these columns in this order. A row with too few or too many fields is
/// a fault and is omitted.
struct CsvTable : CsvFile {
  CsvTable(const std::filesystem::path& given, std::vector<std::string> wanted,
           std::vector<input::Fault>& list)
      : CsvFile{given.string(), std::move(wanted), list} {
    const auto text = input::read_text_file(given);
    if (!text) {
      for (input::Fault& unread : text.faults()) faults.push_back(std::move(unread));
      return;
    }
    input::CsvRows rows(input::without_mark(*text), ',');
    input::CsvRow row;
    const auto trimmed = [&row] {
      std::vector<std::string> texts;
      for (const std::string_view field : row.fields) texts.emplace_back(input::without_blanks(field));
      return texts;
    };
    if (!rows.next(row) || trimmed() != columns) {
      fault("must name these columns, in this order: " + input::listing(columns), static_cast<int>(row.line));
      return;
    }
    while (rows.next(row)) {
      const int line = static_cast<int>(row.line);
      if (!row.fault.empty())
        fault(std::string(row.fault), line);
      else if (row.fields.size() != columns.size())
        fault(fmt::format("must have {} fields, not {}", columns.size(), row.fields.size()), line);
      else
        records.emplace_back(*this, line, trimmed());
    }
    if (records.empty()) fault("has no rows");
  }
  CsvTable(const CsvTable&) = delete;
  CsvTable& operator=(const CsvTable&) = delete;

  std::vector<CsvRecord> records;
};

}  // namespace dashpad::report1986
