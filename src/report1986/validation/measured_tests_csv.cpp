#include "report1986/validation/measured_tests_csv.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "input/measurement/csv_rows.hpp"
#include "input/measurement/measurement_text.hpp"
#include "input/spelling.hpp"
#include "input/text_file.hpp"
#include "quantities/special_numbers.hpp"

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

CsvTable::CsvTable(const std::filesystem::path& file, std::vector<std::string> columns,
                   std::vector<input::Fault>& faults)
    : file_(file.string()), columns_(std::move(columns)), faults_(&faults) {
  try {
    read(input::read_text_file(file).value());
  } catch (const input::InputError& error) {
    faults.insert(faults.end(), error.faults().begin(), error.faults().end());
  }
}

void CsvTable::read(const std::string& text) {
  input::CsvRows rows(input::without_mark(text), ',');
  input::CsvRow row;
  if (!rows.next(row) || texts_of(row) != columns_)
    throw input::InputError({{file_, static_cast<int>(row.line), "", "",
                              "must name these columns first: " + input::listing(columns_)}});
  while (rows.next(row)) {
    const int line = static_cast<int>(row.line);
    if (!row.fault.empty())
      faults_->push_back({file_, line, "", "", std::string(row.fault)});
    else if (row.fields.size() != columns_.size())
      faults_->push_back({file_, line, "", "",
                          "has " + std::to_string(row.fields.size()) + " fields; the columns are " +
                              std::to_string(columns_.size())});
    else
      records_.push_back({line, texts_of(row)});
  }
  if (records_.empty()) fault("has no rows");
}

const std::string& CsvTable::field(const CsvRecord& record, const std::string& column) const {
  const auto at = std::ranges::find(columns_, column) - columns_.begin();
  return record.fields.at(static_cast<std::size_t>(at));
}

void CsvTable::fault(const CsvRecord& record, const std::string& column, std::string rule) {
  faults_->push_back({file_, record.line, column, field(record, column), std::move(rule)});
}

void CsvTable::fault(const std::string& rule) { faults_->push_back({file_, 0, "", "", rule}); }

std::string CsvTable::text(const CsvRecord& record, const std::string& column) {
  if (field(record, column).empty()) fault(record, column, "is missing");
  return field(record, column);
}

double CsvTable::number(const CsvRecord& record, const std::string& column, bool is_fraction) {
  double value = no_value;
  const std::string rule = why_no_reading(field(record, column), is_fraction, value);
  if (!rule.empty()) fault(record, column, rule);
  return value;
}

std::optional<double> CsvTable::reading(const CsvRecord& record, const std::string& column,
                                        bool is_fraction) {
  if (field(record, column).empty()) return std::nullopt;
  const double value = number(record, column, is_fraction);
  return std::isnan(value) ? std::nullopt : std::optional(value);
}

int CsvTable::whole(const CsvRecord& record, const std::string& column) {
  double value = 0;
  std::string rule = why_no_reading(field(record, column), false, value);
  if (rule.empty() && (value != std::floor(value) || value > largest_whole))
    rule = "must be a whole number from 1 to 9999";
  if (rule.empty()) return static_cast<int>(value);
  fault(record, column, rule);
  return 0;
}

std::optional<std::size_t> CsvTable::choice(const CsvRecord& record, const std::string& column,
                                            const std::vector<std::string>& words) {
  const auto found = std::ranges::find(words, field(record, column));
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  fault(record, column,
        "must be one of " + input::listing(words) + input::did_you_mean(field(record, column), words));
  return std::nullopt;
}

}  // namespace dashpad::report1986
