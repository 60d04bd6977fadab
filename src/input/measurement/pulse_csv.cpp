#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>

#include <fmt/format.h>

#include "input/measurement/csv_table.hpp"
#include "input/measurement/pulse_samples.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_gap_remarks = 20;

/// Observations while reading the numbers.
struct Findings {
  std::size_t repeated_samples = 0, first_repeated = 0;
  std::size_t empty_columns = 0;                     ///< rows with an empty last field
  std::size_t decimal_comma = 0, decimal_point = 0;  ///< the first line of each
};

/// The columns to be read, the time first.
std::vector<injury::MeasuredColumn> read_columns_of(const CsvColumns& columns) {
  std::vector<injury::MeasuredColumn> all = columns.acceleration;
  if (columns.time.number > 0) all.insert(all.begin(), columns.time);
  return all;
}

class NumberReader {
 public:
  NumberReader(const CsvColumns& columns, std::optional<double> interval, char separator,
               MeasurementFaults& faults)
      : separator_(separator),
        interval_(interval),
        width_(columns.all.size()),
        faults_(faults),
        columns_(read_columns_of(columns)) {
    if (columns.acceleration.size() > 1) components.resize(columns.acceleration.size());
  }

  void add(const CsvRow& row) {
    if (!row.fault.empty()) return faults_.add(row.line, "", "", std::string(row.fault));
    if (!fits(row)) return;
    std::array<double, 4> sample{};
    bool complete = true;
    if (interval_) sample[0] = *interval_ * static_cast<double>(pulse.time.size());
    const std::size_t values = interval_ ? 1 : 0;  // index of the first of the columns
    for (std::size_t i = 0; i < columns_.size(); ++i)
      complete = read(row, columns_[i], sample[values + i]) && complete;
    if (complete) append(sample, row);
  }

  /// Call after the last row. If the clock began long ago, makes times count from the first sample and
  /// returns the first time as in the file.
  std::string count_from_first() {
    if (since_first_.empty()) return "";
    const bool is_far = counts_from_first(pulse.time.front(), since_first_.back());
    if (!is_far && std::ranges::adjacent_find(pulse.time, std::greater_equal<>()) == pulse.time.end())
      return "";
    pulse.time = std::move(since_first_);
    return first_time_ + " " + columns_.front().unit;
  }

  Pulse pulse;
  std::vector<std::vector<double>> components;  ///< of a resultant
  std::vector<std::uint32_t> lines;             ///< of the samples
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

  bool read(const CsvRow& row, const injury::MeasuredColumn& column, double& value) {
    const std::optional<double> number = number_in(row, column, separator_, faults_);
    if (!number || !has_usual_decimal_sign(row, column)) return false;
    value = *number;
    const bool is_time = !interval_ && &column == &columns_.front();
    const double most = is_time ? latest_time_ : largest_acceleration_;
    if (std::abs(value) <= most) return true;
    add_fault(row, column,
              std::isfinite(value)
                  ? fmt::format("must be within {:g} {}: no sensor gives more", most, is_time ? "s" : "m/s2")
                  : rule_for(NumberKind::out_of_range),
              faults_);
    return false;
  }

  /// Whether the decimal sign is the usual one. A comma may also separate thousands, so commas and points
  /// together are ambiguous.
  bool has_usual_decimal_sign(const CsvRow& row, const injury::MeasuredColumn& column) {
    const std::string_view field = field_in(row, column);
    const bool comma = separator_ != ',' && field.find(',') != std::string_view::npos;
    if (!comma && (findings.decimal_point != 0 && findings.decimal_comma == 0)) return true;
    if (!comma && field.find('.') == std::string_view::npos) return true;
    std::size_t& first = comma ? findings.decimal_comma : findings.decimal_point;
    const std::size_t other = comma ? findings.decimal_point : findings.decimal_comma;
    if (first == 0) first = row.line;
    if (other == 0) return true;
    add_fault(row, column,
              fmt::format("has a decimal {}, but line {} has a {}", comma ? "comma" : "point", other,
                          comma ? "point" : "comma"),
              faults_);
    return false;
  }

  /// The time of a row after the first sample, s, rounded after the subtraction.
  [[nodiscard]] double since_first(double time, const CsvRow& row) const {
    const std::optional<ExactTime> exact = exact_time(field_in(row, columns_.front()));
    return exact && first_ ? columns_.front().factor * exact->since(*first_) : time - pulse.time.front();
  }

  /// The time of this row after the previous one, s.
  double step_to(double time, const CsvRow& row) {
    if (pulse.time.size() == 1 && counts_from_first(pulse.time.front(), time - pulse.time.front()))
      since_first_ = {0};  // then the doubles are too coarse
    if (since_first_.empty()) return time - pulse.time.back();
    return since_first(time, row) - since_first_.back();
  }

  void append(const std::array<double, 4>& sample, const CsvRow& row) {
    const double time = sample[0];
    if (!interval_ && pulse.time.empty()) {
      first_time_ = field_in(row, columns_.front());
      first_ = exact_time(first_time_);
    } else if (!interval_) {
      const double step = step_to(time, row);
      if (step == 0 && sample == latest_) {
        if (findings.repeated_samples++ == 0) findings.first_repeated = row.line;
        return;
      }
      if (!(step > 0)) {
        return add_fault(row, columns_.front(),
                         step == 0 ? "repeats the time before, with another value; times must increase"
                                   : "is earlier than the time before; times must increase",
                         faults_);
      }
    }
    if (pulse.time.size() == max_samples)
      faults_.refuse(row.line, "", "", fmt::format("more than {} samples", max_samples));
    const double value = components.empty() ? sample[1] : std::hypot(sample[1], sample[2], sample[3]);
    if (!std::isfinite(value))
      return faults_.add(row.line, "", "", "the resultant is too large to compute with");
    latest_ = sample;
    if (!since_first_.empty()) since_first_.push_back(since_first(time, row));
    pulse.time.push_back(time);
    pulse.acceleration.push_back(value);
    lines.push_back(static_cast<std::uint32_t>(row.line));  // a file has fewer bytes than that
    for (std::size_t i = 0; i < components.size(); ++i) components[i].push_back(sample[i + 1]);
  }

  char separator_;
  std::optional<double> interval_;  ///< s, without a column of times
  std::size_t width_;
  double latest_time_ = measured_magnitudes("s").most;              ///< s
  double largest_acceleration_ = measured_magnitudes("m/s2").most;  ///< m/s2
  MeasurementFaults& faults_;
  std::vector<injury::MeasuredColumn> columns_;  ///< the time first, if it has a column
  std::array<double, 4> latest_{};
  std::string first_time_;  ///< as in the file
  std::optional<ExactTime> first_;
  std::vector<double> since_first_;  ///< s, of all samples, if the times may count from the first; else empty
};

std::vector<std::string> remarks_on(const Findings& findings, const CsvRows& rows, bool has_mark) {
  std::vector<std::string> remarks;
  if (has_mark) remarks.emplace_back("a byte order mark at the beginning was left out");
  if (rows.lines().kinds_of_ends() > 1) remarks.emplace_back("the file has mixed line endings");
  if (rows.blank_lines() > 0)
    remarks.push_back(plural(rows.blank_lines(), "line") + " without content left out");
  if (findings.decimal_comma > 0) remarks.emplace_back("decimal commas were read as points");
  if (findings.empty_columns > 0) remarks.emplace_back("empty columns at the end were left out");
  const auto left_out = [&](std::size_t count, std::string_view one, std::string_view several,
                            std::size_t first) {
    if (count > 0)
      remarks.push_back(fmt::format("{} {} left out, {}in line {}", count, count == 1 ? one : several,
                                    count == 1 ? "" : "the first ", first));
  };
  left_out(findings.repeated_samples, "sample that repeats the one before was",
           "samples that repeat the one before were", findings.first_repeated);
  left_out(rows.comments_among_numbers(), "line that begins with # among the numbers was",
           "lines that begin with # among the numbers were", rows.first_comment_among_numbers());
  return remarks;
}

/// Reports the gaps between the times, as faults or, if they are to be bridged, as remarks.
void judge_gaps(const NumberReader& numbers, const injury::MeasuredColumn& time, bool bridge,
                MeasurementFaults& faults, std::vector<std::string>& remarks) {
  const PulseGaps gaps = find_gaps(numbers.pulse.time);
  const auto words = [&](const PulseGap& gap) {
    return fmt::format("between lines {} and {} {:.6g} ms are missing", numbers.lines[gap.after],
                       numbers.lines[gap.after + 1], 1e3 * gap.length);
  };
  if (!bridge)
    for (const PulseGap& gap : gaps.all)
      faults.add(numbers.lines[gap.after + 1], time.name, "",
                 fmt::format("{}, where samples are {:.6g} ms apart; --bridge-gaps interpolates linearly",
                             words(gap), 1e3 * gaps.usual_step));
  for (std::size_t i = 0; i < std::min(gaps.all.size(), max_gap_remarks); ++i)
    remarks.push_back(words(gaps.all[i]) + "; interpolated linearly");
  if (gaps.all.size() > max_gap_remarks)
    remarks.push_back(fmt::format("{} more gaps between the times; interpolated linearly",
                                  gaps.all.size() - max_gap_remarks));
}

}  // namespace

Reading<PulseFile> read_pulse_csv(const std::filesystem::path& file, const PulseCsvOptions& options) {
  return reading_of([&]() -> PulseFile {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const bool two_are_named = !options.time.empty() || (!options.interval && !options.acceleration.empty());
    const CsvTable table = csv_table_in(content, faults, !two_are_named);
    CsvColumns columns = name_columns(table.header);
    if (table.has_one_column && !options.interval)
      faults.refuse(table.header.first_line, "", "",
                    "has one column of numbers and no times; if that is the acceleration, give the sample "
                    "interval, such as --interval \"0.1 ms\"");
    injury::MeasuredPulse result{.format = "CSV", .resultant = options.resultant};
    choose_columns(columns, table.header, options, faults, result.remarks);
    faults.throw_if_any();
    require_no_numbers(table.header, columns.names, read_columns_of(columns), table.separator, faults);

    NumberReader numbers(columns, options.interval, table.separator, faults);
    CsvRows rows(table.text, table.separator);
    CsvRow row;
    std::size_t blank_lines = 0;
    while (rows.next(row))
      if (row.line >= table.header.first_line) {
        if (options.interval && row.line > table.header.first_line && rows.blank_lines() > blank_lines)
          faults.add(row.line - 1, "", "", "has no content; without times a sample may be missing here");
        blank_lines = rows.blank_lines();
        rows.begin_numbers();
        numbers.add(row);
      }
    result.counts_from = numbers.count_from_first();
    const std::size_t count = numbers.pulse.time.size();
    if (faults.none() && count < 2) faults.add(0, "", "", "has one sample only; a pulse needs two");
    faults.throw_if_any();
    judge_pulse(numbers.pulse, table.header.first_line, faults);
    faults.throw_if_any();
    std::vector<std::string> bridged;
    if (!options.interval) judge_gaps(numbers, columns.time, options.bridge_gaps, faults, bridged);
    faults.throw_if_any();

    for (std::string& remark : remarks_on(numbers.findings, rows, table.text.size() < content.size()))
      result.remarks.push_back(std::move(remark));
    if (!result.counts_from.empty()) result.remarks.push_back(remark_on_clock(result.counts_from));
    for (std::string& remark : bridged) result.remarks.push_back(std::move(remark));
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
    return name_columns(csv_table_in(content, faults, true).header).all;
  });
}

}  // namespace dashpad::input
