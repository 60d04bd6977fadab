#include "dashpad/io/pulse_csv.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "io/pulse_csv_columns.hpp"
#include "io/pulse_csv_rows.hpp"

namespace dashpad {

namespace {

constexpr std::string_view byte_order_mark = "\xef\xbb\xbf";

/// What was met on the way through the numbers.
struct Findings {
  std::size_t repeated_samples = 0, first_repeated = 0;
  std::size_t empty_columns = 0;                     ///< rows with nothing behind their last separator
  std::size_t decimal_comma = 0, decimal_point = 0;  ///< the first line of each
};

std::string plural(std::size_t count, const std::string& word) {
  return fmt::format("{} {}{}", count, word, count == 1 ? "" : "s");
}

/// Reads the rows of numbers of a table.
class NumberReader {
 public:
  NumberReader(const CsvColumns& columns, char separator, MeasurementFaults& faults)
      : separator_(separator), width_(columns.all.size()), faults_(faults) {
    columns_.push_back(columns.time);
    columns_.insert(columns_.end(), columns.acceleration.begin(), columns.acceleration.end());
  }

  void add(const CsvRow& row) {
    if (!row.fault.empty()) {
      faults_.add(row.line, "", "", std::string(row.fault));
      return;
    }
    if (!fits(row)) return;
    std::array<double, 4> sample{};
    bool complete = true;
    for (std::size_t i = 0; i < columns_.size(); ++i)
      complete = read(row, columns_[i], sample[i]) && complete;
    if (complete) append(sample, row);
  }

  Pulse pulse;
  Findings findings;

 private:
  bool fits(const CsvRow& row) {
    if (row.fields.size() == width_) return true;
    if (row.fields.size() > width_ && row.filled() <= width_) {
      ++findings.empty_columns;
      return true;
    }
    faults_.add(row.line, "", "",
                fmt::format("has {} where {} are expected{}", plural(row.fields.size(), "field"), width_,
                            separator_ == ',' && row.fields.size() > width_
                                ? "; decimal commas need another separator, such as a semicolon"
                                : ""));
    return false;
  }

  bool read(const CsvRow& row, const MeasuredColumn& column, double& value) {
    const std::string_view field = row.fields[static_cast<std::size_t>(column.number - 1)];
    const ReadNumber number = read_csv_number(field, separator_);
    if (number.kind != NumberKind::number) {
      faults_.add(row.line, column.name, without_blanks(field), rule_for(number.kind));
      return false;
    }
    if (!has_usual_decimal_sign(row.line, column, field)) return false;
    value = number.value * column.factor;
    if (std::isfinite(value)) return true;
    faults_.add(row.line, column.name, without_blanks(field), rule_for(NumberKind::out_of_range));
    return false;
  }

  /// A comma may be a decimal sign or part thousands; together with points nobody knows.
  bool has_usual_decimal_sign(std::size_t line, const MeasuredColumn& column, std::string_view field) {
    const bool comma = separator_ != ',' && field.find(',') != std::string_view::npos;
    if (!comma && (findings.decimal_point != 0 && findings.decimal_comma == 0)) return true;
    if (!comma && field.find('.') == std::string_view::npos) return true;
    std::size_t& first = comma ? findings.decimal_comma : findings.decimal_point;
    const std::size_t other = comma ? findings.decimal_point : findings.decimal_comma;
    if (first == 0) first = line;
    if (other == 0) return true;
    faults_.add(line, column.name, without_blanks(field),
                fmt::format("has a decimal {}, but line {} has a {}", comma ? "comma" : "point", other,
                            comma ? "point" : "comma"));
    return false;
  }

  void append(const std::array<double, 4>& sample, const CsvRow& row) {
    const double time = sample[0];
    if (!pulse.time.empty() && !(time > pulse.time.back())) {
      if (sample == latest_) {
        if (findings.repeated_samples++ == 0) findings.first_repeated = row.line;
        return;
      }
      const MeasuredColumn& column = columns_.front();
      faults_.add(
          row.line, column.name, without_blanks(row.fields[static_cast<std::size_t>(column.number - 1)]),
          time == pulse.time.back() ? "repeats the time before, with another value; times must increase"
                                    : "is earlier than the time before; times must increase");
      return;
    }
    if (pulse.time.size() == most_samples)
      faults_.refuse(row.line, "", "", fmt::format("more than {} samples", most_samples));
    const double value = columns_.size() == 2 ? sample[1] : std::hypot(sample[1], sample[2], sample[3]);
    if (!std::isfinite(value)) {
      faults_.add(row.line, "", "", "the resultant is too large to compute with");
      return;
    }
    latest_ = sample;
    pulse.time.push_back(time);
    pulse.acceleration.push_back(value);
  }

  char separator_;
  std::size_t width_;
  MeasurementFaults& faults_;
  std::vector<MeasuredColumn> columns_;  ///< the time first
  std::array<double, 4> latest_{};
};

/// A number in a chosen column, in a row below the names: a sample that would be lost.
void require_no_numbers(const CsvHeader& header, const CsvColumns& columns, char separator,
                        MeasurementFaults& faults) {
  for (const CsvHeader::Row& row : header.rows) {
    if (&row <= columns.names && columns.names != nullptr) continue;
    std::vector<MeasuredColumn> chosen = columns.acceleration;
    chosen.insert(chosen.begin(), columns.time);
    const auto field_of = [&](const MeasuredColumn& column) {
      const auto at = static_cast<std::size_t>(column.number - 1);
      return at < row.fields.size() ? std::string_view(row.fields[at]) : std::string_view();
    };
    const auto holds_number = [&](const MeasuredColumn& column) {
      return read_csv_number(field_of(column), separator).kind == NumberKind::number;
    };
    if (std::ranges::none_of(chosen, holds_number)) continue;
    for (const MeasuredColumn& column : chosen)
      if (!holds_number(column))
        faults.add(row.line, column.name, field_of(column),
                   rule_for(read_csv_number(field_of(column), separator).kind));
  }
}

struct Table {
  std::string content;
  std::string_view text;  ///< without byte order mark
  bool has_mark = false;
  char separator = ',';
  CsvHeader header;
  CsvColumns columns;
};

void read_table(const std::filesystem::path& file, MeasurementFaults& faults, Table& table) {
  table.content = read_measurement(file);
  if (const auto problem = why_not_text(table.content)) faults.refuse(problem->line, "", "", problem->rule);
  table.text = table.content;
  table.has_mark = table.text.starts_with(byte_order_mark);
  if (table.has_mark) table.text.remove_prefix(byte_order_mark.size());
  if (without_blanks(table.text).empty()) faults.refuse(0, "", "", "is empty");
  table.separator = find_separator(table.text);
  table.header = read_csv_header(table.text, table.separator);
  if (table.header.first_line == 0) faults.refuse(0, "", "", "has no row of two numbers or more");
  table.columns = name_columns(table.header);
}

std::vector<std::string> remarks_on(const Findings& findings, const CsvRows& rows, bool has_mark) {
  std::vector<std::string> remarks;
  if (has_mark) remarks.emplace_back("a byte order mark at the beginning was left out");
  if (rows.lines().kinds_of_ends() > 1) remarks.emplace_back("the lines end in different ways");
  if (rows.blank_lines() > 0)
    remarks.push_back(fmt::format("{} left out", plural(rows.blank_lines(), "line") + " without content"));
  if (findings.decimal_comma > 0) remarks.emplace_back("decimal commas were read as points");
  if (findings.empty_columns > 0) remarks.emplace_back("empty columns at the end were left out");
  if (findings.repeated_samples > 0)
    remarks.push_back(fmt::format("{} that repeat the one before were left out, the first in line {}",
                                  plural(findings.repeated_samples, "sample"), findings.first_repeated));
  return remarks;
}

}  // namespace

MeasuredPulse read_pulse_csv(const std::filesystem::path& file, const PulseCsvOptions& options) {
  MeasurementFaults faults(file.string());
  Table table;
  read_table(file, faults, table);
  MeasuredPulse result{.format = "CSV", .resultant = options.resultant};
  choose_columns(table.columns, table.header, options, faults, result.remarks);
  faults.throw_if_any();
  require_no_numbers(table.header, table.columns, table.separator, faults);

  NumberReader numbers(table.columns, table.separator, faults);
  CsvRows rows(table.text, table.separator);
  CsvRow row;
  while (rows.next(row))
    if (row.line >= table.header.first_line) numbers.add(row);
  const std::size_t count = numbers.pulse.time.size();
  if (faults.none() && count < 2) faults.add(0, "", "", "has one sample only; a pulse needs two");
  faults.throw_if_any();

  for (std::string& remark : remarks_on(numbers.findings, rows, table.has_mark))
    result.remarks.push_back(std::move(remark));
  result.pulse = std::move(numbers.pulse);
  result.time = table.columns.time;
  result.acceleration = table.columns.acceleration;
  return result;
}

std::vector<MeasuredColumn> pulse_csv_columns(const std::filesystem::path& file) {
  MeasurementFaults faults(file.string());
  Table table;
  read_table(file, faults, table);
  return table.columns.all;
}

}  // namespace dashpad
