#pragma once
/// The rows of a table of a pulse, one after the other, as samples.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "input/measurement/clock_time.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/pulse_samples.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

inline constexpr std::size_t max_deferred = 100'000;

/// Observations while reading the numbers.
struct PulseFindings {
  std::size_t repeated_samples = 0, first_repeated = 0;
  std::size_t shared_times = 0, first_shared = 0;  ///< samples with the time of the one before, first line
  std::size_t missing_before = 0, missing_behind = 0;  ///< rows without a value before and behind the samples
  std::size_t first_missing = 0;                       ///< line of the first one behind
  std::size_t empty_columns = 0;                       ///< rows with an empty last field
  std::size_t decimal_comma = 0, decimal_point = 0;    ///< the first line of each
  bool commas_may_be_of_thousands = true;              ///< every number with a comma is like 1,234
  std::array<bool, 4> has_commas = {}, has_whole_numbers = {};  ///< of each column; 0 is not counted
};

/// The columns to be read, the time first.
inline std::vector<injury::MeasuredColumn> read_columns_of(const CsvColumns& columns) {
  std::vector<injury::MeasuredColumn> all = columns.acceleration;
  if (columns.time.number > 0) all.insert(all.begin(), columns.time);
  return all;
}

/// Whether the comma in a number may stand between thousands: "1,234", "-12,345".
inline bool may_have_comma_of_thousands(std::string_view number) {
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  const std::size_t comma = number.find(',');
  return comma >= 1 && comma <= 3 && number.size() == comma + 4 && number.front() != '0';
}

/// Takes rows of a table and collects their samples, with what is noticed on the way.
class PulseRows {
 public:
  PulseRows(const CsvColumns& columns, const CsvTable& table, const PulseOptions& options,
            MeasurementFaults& faults)
      : separator_(table.separator),
        is_ragged_(table.labview.has_value()),
        interval_(options.interval),
        times_of_day_(columns.times_of_day),
        is_cut_(options.cut.from || options.cut.to),
        fields_of_first_(table.header.first_row.size()),
        width_(columns.all.size()),
        faults_(faults),
        columns_(read_columns_of(columns)) {
    if (columns.acceleration.size() > 1) components.resize(columns.acceleration.size());
  }

  /// Makes room for rows that are about as long as the first.
  void expect_rows(const CsvTable& table) {
    std::size_t length = table.header.first_row.size();  // of a row, with separators and line end
    for (const std::string& field : table.header.first_row) length += field.size();
    const std::size_t rows = std::min(table.text.size() / std::max<std::size_t>(length, 2), max_samples);
    pulse.time.reserve(rows);
    pulse.acceleration.reserve(rows);
    lines.reserve(rows);
  }

  void add(const CsvRow& row) {
    if (!row.fault.empty()) return faults_.add(row.line, "", "", std::string(row.fault));
    if (!fits(row)) return;
    if (!is_cut_ && is_without_values(row)) return;
    std::array<double, 4> sample{};
    const std::size_t times = interval_ ? 0 : 1;  // columns
    bool has_time = true, complete = true;
    if (interval_) sample[0] = *interval_ * static_cast<double>(findings.missing_before + pulse.time.size());
    if (!interval_) has_time = read(row, columns_.front(), sample[0]);
    const std::size_t faults = faults_.count();
    for (std::size_t i = times; i < columns_.size(); ++i)
      complete = read(row, columns_[i], sample[1 + i - times]) && complete;
    if (!has_time || (!complete && !is_cut_)) return;
    const std::size_t samples = pulse.time.size();
    if (!complete) sample[1] = sample[2] = sample[3] = 0;
    append(sample, row);
    if (!complete && pulse.time.size() > samples) defer(samples, faults_.split_off(faults), row.line);
  }

  /// Call after the last row. Keeps the samples between two times; faults in the others do not count.
  void keep_between(const CutTimes& cut, std::vector<std::string>& remarks) {
    if (!is_cut_) return;
    const KeptSamples kept = kept_samples(pulse.time, cut, faults_, remarks);
    for (auto& [sample, faults] : deferred_)
      if (sample >= kept.begin && sample < kept.end) faults_.add(std::move(faults));
    kept.keep(pulse.time);
    kept.keep(pulse.acceleration);
    kept.keep(lines);
    for (std::vector<double>& component : components) kept.keep(component);
  }

  /// Call after the last row. Reports times that several samples share.
  void judge_shared_times() {
    if (findings.shared_times == 0) return;
    const std::size_t shared = findings.shared_times + findings.repeated_samples;
    const double length = since_first_.empty() ? pulse.time.back() - pulse.time.front() : since_first_.back();
    const bool are_packets = smallest_packet_ == largest_packet_;
    const std::size_t steps = pulse.time.size() + shared - (are_packets ? packet_ : 1);
    std::string rule = fmt::format(
        "{} the same time as the previous one: either the times are rounded, or each time applies "
        "to a packet of samples",
        shared == 1 ? "1 sample has" : fmt::format("{} samples have", shared));
    if (length > 0)
      rule += fmt::format(
          "; if the samples are evenly spaced, give their interval with --interval \"{:.4g} ms\" "
          "({:.4g} ms over {} steps)",
          1e3 * length / static_cast<double>(steps), 1e3 * length, steps);
    faults_.add(findings.first_shared, columns_.front().name, "", rule);
  }

  /// Call after the last row. Reports commas that may be those of thousands.
  void judge_commas() {
    bool has_both = false;
    for (std::size_t i = 0; i < findings.has_commas.size(); ++i)
      has_both = has_both || (findings.has_commas[i] && findings.has_whole_numbers[i]);
    if (has_both && findings.commas_may_be_of_thousands)
      faults_.add(
          findings.decimal_comma, "", "",
          "the comma here may separate thousands or decimals, since other numbers in the column are whole; "
          "write decimal points and no thousands separators");
  }

  /// Call after the last row. If the clock began long ago, makes times count from the first sample and
  /// returns the first time as in the file.
  std::string count_from_first() {
    if (since_first_.empty()) return "";
    const bool is_far = counts_from_first(pulse.time.front(), since_first_.back());
    if (!is_far && std::ranges::adjacent_find(pulse.time, std::greater_equal<>()) == pulse.time.end())
      return "";
    pulse.time = std::move(since_first_);
    return times_of_day_ ? first_time_ : first_time_ + " " + columns_.front().unit;
  }

  Pulse pulse;
  std::vector<std::vector<double>> components;  ///< of a resultant
  std::vector<std::uint32_t> lines;             ///< of the samples
  PulseFindings findings;

 private:
  /// Counts rows without a value: before the first sample, behind the last one, or a gap between two.
  bool is_without_values(const CsvRow& row) {
    const auto is_missing_in = [&](const injury::MeasuredColumn& column) {
      return is_missing(field_in(row, column));
    };
    const auto values = columns_.begin() + (interval_ ? 0 : 1);
    if (!is_missing_in(*values) || !std::all_of(values, columns_.end(), is_missing_in)) {
      if (findings.missing_behind > 0)
        faults_.add(findings.first_missing, values->name, missing_,
                    rule_for(read_csv_number(missing_).kind) +
                        (findings.missing_behind == 1
                             ? ""
                             : fmt::format(" ({} rows in succession)", findings.missing_behind)));
      findings.missing_behind = 0;
      return false;
    }
    if (pulse.time.empty()) {
      ++findings.missing_before;
    } else if (findings.missing_behind++ == 0) {
      findings.first_missing = row.line;
      missing_ = field_in(row, *values);
    }
    return true;
  }

  void defer(std::size_t sample, std::vector<Fault> faults, std::size_t line) {
    if (deferred_.size() == max_deferred)
      faults_.refuse(line, "", "", fmt::format("more than {} rows have errors", max_deferred));
    deferred_.emplace_back(sample, std::move(faults));
  }

  /// Rows have as many fields as the first one or as there are columns; more are empty.
  bool fits(const CsvRow& row) {
    if (row.fields.size() == width_) return has_fitted_ = true;
    if (row.fields.size() > width_ && row.filled() <= width_) {
      ++findings.empty_columns;
      return has_fitted_ = true;
    }
    if (row.fields.size() == fields_of_first_ || is_ragged_) return has_fitted_ = true;
    // Said once of rows in succession, as of earlier times.
    if (!std::exchange(has_fitted_, false)) return false;
    faults_.add(row.line, "", "",
                fmt::format("has {} where {} are expected{}", plural(row.fields.size(), "field"), width_,
                            separator_ == ',' && row.fields.size() > width_
                                ? "; with decimal commas, use another separator, such as a semicolon"
                                : ""));
    return false;
  }

  bool read(const CsvRow& row, const injury::MeasuredColumn& column, double& value) {
    const bool is_time = !interval_ && &column == &columns_.front();
    if (is_time && times_of_day_) return read_time_of_day(row, column, value);
    const std::optional<double> number = number_in(row, column, faults_);
    if (!number || !has_usual_decimal_sign(row, column)) return false;
    value = *number;
    const double most = is_time ? latest_time_ : largest_acceleration_;
    if (std::abs(value) <= most) return true;
    add_fault(row, column,
              std::isfinite(value) ? fmt::format("must be within ±{:g} {}; no sensor records more", most,
                                                 is_time ? "s" : "m/s2")
                                   : rule_for(NumberKind::out_of_range),
              faults_);
    return false;
  }

  bool read_time_of_day(const CsvRow& row, const injury::MeasuredColumn& column, double& value) {
    if (clock_.read(field_in(row, column))) {
      value = static_cast<double>(clock_.time().whole) + clock_.time().part;
      return true;
    }
    add_fault(row, column, "must be a time of day, as in the first row of numbers", faults_);
    return false;
  }

  /// Whether the decimal sign is the usual one. A comma may also separate thousands, so commas and points
  /// together are ambiguous.
  bool has_usual_decimal_sign(const CsvRow& row, const injury::MeasuredColumn& column) {
    const std::string_view field = field_in(row, column);
    const bool comma = (separator_ != ',' || row.has_quotes) && field.find(',') != std::string_view::npos;
    const auto place = static_cast<std::size_t>(&column - columns_.data());
    if (comma) {
      findings.has_commas[place] = true;
      findings.commas_may_be_of_thousands &= may_have_comma_of_thousands(field);
    }
    if (!comma && (findings.decimal_point != 0 && findings.decimal_comma == 0)) return true;
    if (!comma && field.find('.') == std::string_view::npos) {
      if (field != "0") findings.has_whole_numbers[place] = true;
      return true;
    }
    std::size_t& first = comma ? findings.decimal_comma : findings.decimal_point;
    const std::size_t other = comma ? findings.decimal_point : findings.decimal_comma;
    if (first == 0) first = row.line;
    if (other == 0) return true;
    add_fault(row, column,
              fmt::format("has a decimal {}, but line {} has a decimal {}", comma ? "comma" : "point", other,
                          comma ? "point" : "comma"),
              faults_);
    return false;
  }

  [[nodiscard]] std::optional<ExactTime> exact_time_of(const CsvRow& row) const {
    return times_of_day_ ? clock_.time() : exact_time(field_in(row, columns_.front()));
  }

  /// The time of a row after the first sample, s, rounded after the subtraction.
  [[nodiscard]] double since_first(double time, const CsvRow& row) const {
    const std::optional<ExactTime> exact = exact_time_of(row);
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
      first_ = exact_time_of(row);
    } else if (!interval_) {
      const double step = step_to(time, row);
      if (step == 0) {
        const bool is_repeated = sample == latest_;
        latest_ = sample;
        std::size_t& count = is_repeated ? findings.repeated_samples : findings.shared_times;
        if (count++ == 0) (is_repeated ? findings.first_repeated : findings.first_shared) = row.line;
        ++packet_;
        return;
      }
      // Said once of rows in succession: they may be another table.
      if (std::exchange(is_earlier_, !(step > 0)) && is_earlier_) return;
      if (is_earlier_)
        return add_fault(row, columns_.front(), "is earlier than the previous time; times must increase",
                         faults_);
      smallest_packet_ = std::min(smallest_packet_, packet_);
      largest_packet_ = std::max(largest_packet_, packet_);
      packet_ = 1;
    }
    if (pulse.time.size() == max_samples)
      faults_.refuse(row.line, "", "", fmt::format("there are more than {} samples", max_samples));
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
  bool is_ragged_;                  ///< a row may have a comment behind its numbers
  std::optional<double> interval_;  ///< s, without a column of times
  bool times_of_day_;
  bool is_cut_;
  std::size_t fields_of_first_;  ///< of the first row of numbers
  std::size_t width_;
  double latest_time_ = measured_magnitudes("s").most;              ///< s
  double largest_acceleration_ = measured_magnitudes("m/s2").most;  ///< m/s2
  MeasurementFaults& faults_;
  std::vector<injury::MeasuredColumn> columns_;  ///< the time first, if it has a column
  std::array<double, 4> latest_{};
  std::string first_time_;  ///< as in the file
  std::optional<ExactTime> first_;
  RunningClock clock_;
  std::string missing_;      ///< what stands in place of the first missing value
  bool has_fitted_ = true;   ///< the latest row, into the columns
  bool is_earlier_ = false;  ///< the latest row, than the latest sample
  std::size_t packet_ = 1;   ///< number of the latest samples that share a time
  std::size_t smallest_packet_ = max_samples, largest_packet_ = 0;    ///< of those before
  std::vector<std::pair<std::size_t, std::vector<Fault>>> deferred_;  ///< of samples that may be cut off
  std::vector<double> since_first_;  ///< s, of all samples, if the times may count from the first; else empty
};

}  // namespace dashpad::input
