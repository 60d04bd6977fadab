#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "input/measurement/pulse_rows.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

std::string without_value(std::string_view which, std::size_t rows) {
  return rows == 1 ? fmt::format("the {} row has no value and was left out", which)
                   : fmt::format("the {} {} rows have no value and were left out", which, rows);
}

/// What the header of a LabVIEW file says of a column.
LabViewHeader::Column stated_by(const CsvTable& table, const injury::MeasuredColumn& column) {
  const auto place = static_cast<std::size_t>(column.number - 1);
  return table.labview && place < table.labview->columns.size() ? table.labview->columns[place]
                                                                : LabViewHeader::Column{};
}

std::vector<std::string> remarks_on(const PulseFindings& findings, const CsvRows& rows, bool has_mark) {
  std::vector<std::string> remarks;
  if (has_mark) remarks.emplace_back("the byte order mark at the beginning was ignored");
  if (rows.lines().kinds_of_ends() > 1) remarks.emplace_back("the file has mixed line endings");
  if (rows.blank_lines() > 0)
    remarks.push_back(fmt::format("{} without content {} left out", plural(rows.blank_lines(), "line"),
                                  rows.blank_lines() == 1 ? "was" : "were"));
  if (findings.missing_before > 0) remarks.push_back(without_value("first", findings.missing_before));
  if (findings.missing_behind > 0) remarks.push_back(without_value("last", findings.missing_behind));
  if (findings.decimal_comma > 0) remarks.emplace_back("decimal commas were read as decimal points");
  if (findings.empty_columns > 0) remarks.emplace_back("empty columns at the end were left out");
  const auto left_out = [&](std::size_t count, std::string_view one, std::string_view several,
                            std::size_t first) {
    if (count > 0)
      remarks.push_back(fmt::format("{} {} left out ({} {})", count, count == 1 ? one : several,
                                    count == 1 ? "line" : "the first on line", first));
  };
  left_out(findings.repeated_samples, "sample that repeats the previous one was",
           "samples that repeat the previous one were", findings.first_repeated);
  left_out(rows.comments_among_numbers(), "line that begins with # among the numbers was",
           "lines that begin with # among the numbers were", rows.first_comment_among_numbers());
  return remarks;
}

/// Remarks on channels of a LabVIEW file whose number of samples is not the stated one. The channel has rows
/// without a value before and behind its samples, which may count.
void compare_number(const PulseRows& numbers, const CsvColumns& columns, const CsvTable& table,
                    std::vector<std::string>& remarks) {
  const PulseFindings& findings = numbers.findings;
  const std::size_t samples = numbers.pulse.time.size() + findings.repeated_samples + findings.missing_before;
  for (const injury::MeasuredColumn& column : columns.acceleration) {
    const auto stated = stated_by(table, column).samples;
    if (!stated || *stated == static_cast<double>(samples) ||
        *stated == static_cast<double>(samples + findings.missing_behind))
      continue;
    remarks.push_back(fmt::format("{}: the header states {} samples, but the file has {}", column.name,
                                  brief(*stated), samples));
  }
}

/// Chooses the columns, and the first time and interval that the header of a file without times states.
double choose(CsvColumns& columns, const CsvTable& table, PulseOptions& options, MeasurementFaults& faults,
              std::vector<std::string>& remarks) {
  const bool of_header =
      table.labview && !options.interval && table.labview->x_columns == LabViewHeader::XColumns::none;
  if (of_header) options.interval = 1;  // until the columns are known
  choose_columns(columns, table, options, faults, remarks);
  if (!of_header || columns.acceleration.empty()) return 0;
  const LabViewHeader::Column first = stated_by(table, columns.acceleration.front());
  for (const injury::MeasuredColumn& column : columns.acceleration)
    if (const auto own = stated_by(table, column); own.interval != first.interval || own.first != first.first)
      faults.add(table.labview->end, column.name, "",
                 "has different times from " + columns.acceleration.front().name);
  if (!first.interval || !(*first.interval > 0))
    faults.refuse(table.labview->end, columns.acceleration.front().name, "",
                  "has no times, and the header states no sampling interval (Delta_X); give --interval");
  options.interval = first.interval;
  remarks.push_back(
      fmt::format("the sampling interval, {} ms, was read from the header", brief(1e3 * *first.interval)));
  return first.first;
}

}  // namespace

Reading<PulseFile> read_pulse_csv(const std::filesystem::path& file, const PulseOptions& given) {
  return reading_of([&]() -> PulseFile {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const bool two_are_named = !given.time.empty() || (!given.interval && !given.acceleration.empty());
    const CsvTable table = csv_table_in(content, faults,
                                        given.interval  ? Fewest::one
                                        : two_are_named ? Fewest::two
                                                        : Fewest::one_column);
    CsvColumns columns = name_columns(table.header, table.labview);
    if (table.has_one_column && !given.interval)
      faults.refuse(table.header.first_line, "", "",
                    "has one column of numbers and no times; if this column is the acceleration, give the "
                    "sampling interval, such as --interval \"0.1 ms\"");
    injury::MeasuredPulse result{.format = table.labview ? "LVM" : "CSV", .resultant = given.resultant};
    PulseOptions options = given;
    const double first = choose(columns, table, options, faults, result.remarks);
    faults.throw_if_any();
    if (!columns.times_of_day)
      require_no_numbers(table.header, columns.names, read_columns_of(columns), faults);

    PulseRows numbers(columns, table, options, faults);
    numbers.expect_rows(table);
    CsvRows rows(table.text, table.separator);
    CsvRow row;
    TextBehind text(table);
    std::size_t blank_lines = 0;
    while (rows.next(row)) {
      if (row.line < table.header.first_line || text.holds(row, faults)) continue;
      if (options.interval && row.line > table.header.first_line && rows.blank_lines() > blank_lines)
        faults.add(row.line - 1, "", "", "is blank; without times, a sample may be missing here");
      blank_lines = rows.blank_lines();
      rows.begin_numbers();
      numbers.add(row);
    }
    if (first != 0)
      for (double& time : numbers.pulse.time) time += first;
    numbers.judge_shared_times();
    numbers.judge_commas();
    result.counts_from = numbers.count_from_first();
    if (faults.none() && numbers.pulse.time.empty())
      faults.add(0, columns.acceleration.front().name, "", "has no values");
    else if (faults.none() && numbers.pulse.time.size() < 2)
      faults.add(0, "", "", "has only one sample; a pulse needs at least two");
    faults.throw_if_any();
    std::vector<std::string> missing;
    compare_number(numbers, columns, table, missing);
    std::vector<std::string> cut;
    numbers.keep_between(options.cut, cut);
    faults.throw_if_any();
    judge_pulse(numbers.pulse, table.header.first_line, faults);
    faults.throw_if_any();
    std::vector<std::string> bridged;
    if (!options.interval)
      judge_gaps(numbers.pulse.time, numbers.lines, columns.time.name, options.bridge_gaps, faults, bridged);
    faults.throw_if_any();

    for (std::string& remark : remarks_on(numbers.findings, rows, table.text.size() < content.size()))
      result.remarks.push_back(std::move(remark));
    if (!text.remark().empty()) result.remarks.push_back(text.remark());
    if (!result.counts_from.empty()) result.remarks.push_back(remark_on_clock(result.counts_from));
    for (std::vector<std::string>* more : {&missing, &cut, &bridged})
      std::ranges::move(*more, std::back_inserter(result.remarks));
    result.pulse = std::move(numbers.pulse);
    result.components = std::move(numbers.components);
    result.time = columns.time;
    result.acceleration = columns.acceleration;
    return {std::move(result), {{"the measurement", file}}};
  });
}

Reading<std::vector<injury::MeasuredColumn>> pulse_csv_columns(const std::filesystem::path& file) {
  return reading_of([&]() -> std::vector<injury::MeasuredColumn> {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable table = csv_table_in(content, faults, Fewest::one_column);
    return name_columns(table.header, table.labview).all;
  });
}

}  // namespace dashpad::input
