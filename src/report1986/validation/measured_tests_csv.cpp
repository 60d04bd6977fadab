#include "report1986/validation/measured_tests_csv.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "dashpad/quantities/constants.hpp"
#include "input/disk.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/spelling.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double largest_whole = 9999;

std::vector<std::string> texts_of(const input::CsvRow& row) {
  std::vector<std::string> texts;
  for (const std::string_view field : row.fields) texts.emplace_back(input::without_blanks(field));
  return texts;
}

}  // namespace

std::string why_no_reading(const std::string& text, bool is_fraction, double& value) {
  const input::ReadNumber number = input::read_number(text);
  if (number.kind == input::NumberKind::empty) return "is missing";
  if (number.kind != input::NumberKind::number) return input::rule_for(number.kind);
  if (number.value <= 0) return "must be more than 0";
  if (is_fraction && number.value >= 1) return "must be less than 1";
  value = number.value;
  return "";
}

CsvTable::CsvTable(const std::filesystem::path& given, std::vector<std::string> wanted,
                   std::vector<input::Fault>& list)
    : file(given.string()), columns(std::move(wanted)), faults(list) {
  const auto text = input::read_text_file(given);
  if (!text) {
    for (input::Fault& unread : text.faults()) faults.push_back(std::move(unread));
    return;
  }
  input::CsvRows rows(input::without_mark(*text), ',');
  input::CsvRow row;
  if (!rows.next(row) || texts_of(row) != columns) {
    fault("must name these columns first: " + input::listing(columns), static_cast<int>(row.line));
    return;
  }
  while (rows.next(row)) {
    const int line = static_cast<int>(row.line);
    if (!row.fault.empty())
      fault(std::string(row.fault), line);
    else if (row.fields.size() != columns.size())
      fault(fmt::format("has {} fields; the columns are {}", row.fields.size(), columns.size()), line);
    else
      records.emplace_back(*this, line, texts_of(row));
  }
  if (records.empty()) fault("has no rows");
}

void CsvTable::fault(std::string rule, int line) { faults.push_back({file, line, "", "", std::move(rule)}); }

const std::string& CsvRecord::field(const std::string& column) const {
  const auto at = std::ranges::find(table_->columns, column) - table_->columns.begin();
  return fields_.at(static_cast<std::size_t>(at));
}

void CsvRecord::fault(const std::string& column, std::string rule) const {
  table_->faults.push_back({table_->file, line_, column, field(column), std::move(rule)});
}

std::string CsvRecord::text(const std::string& column) const {
  if (field(column).empty()) fault(column, "is missing");
  return field(column);
}

double CsvRecord::number(const std::string& column, bool is_fraction) const {
  double value = no_value;
  const std::string rule = why_no_reading(field(column), is_fraction, value);
  if (!rule.empty()) fault(column, rule);
  return value;
}

std::optional<double> CsvRecord::reading(const std::string& column, bool is_fraction) const {
  if (field(column).empty()) return std::nullopt;
  const double value = number(column, is_fraction);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

int CsvRecord::whole(const std::string& column) const {
  double value = 0;
  std::string rule = why_no_reading(field(column), false, value);
  if (rule.empty() && (value != std::floor(value) || value > largest_whole))
    rule = "must be a whole number from 1 to 9999";
  if (rule.empty()) return static_cast<int>(value);
  fault(column, rule);
  return 0;
}

std::optional<std::size_t> CsvRecord::choice(const std::string& column,
                                             const std::vector<std::string>& words) const {
  const auto found = std::ranges::find(words, field(column));
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  fault(column, "must be one of " + input::listing(words) + input::did_you_mean(field(column), words));
  return std::nullopt;
}

}  // namespace dashpad::report1986
