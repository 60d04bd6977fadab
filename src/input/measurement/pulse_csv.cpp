#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <utility>

#include <fmt/format.h>

#include "input/measurement/clock_time.hpp"
#include "input/measurement/csv_table.hpp"
#include "input/measurement/pulse_samples.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_deferred = 100'000;

/// Observations while reading the numbers.
struct Findings {
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
std::vector<injury::MeasuredColumn> read_columns_of(const CsvColumns& columns) {
  std::vector<injury::MeasuredColumn> all = columns.acceleration;
  if (columns.time.number > 0) all.insert(all.begin(), columns.time);
  return all;
}

/// Whether a field says that there is no value.
bool is_missing(std::string_view field) {
  if (field.size() > 7 || (!field.empty() && field.front() <= '9' && field.front() != '-')) return false;
  const std::string lower = lower_case(field);
  return lower.empty() || lower == "nan" || lower == "n/a" || lower == "na" || lower == "null" ||
         lower == "novalue" || lower == "-";
}

/// Whether the comma in a number may stand between thousands: "1,234", "-12,345".
bool may_have_comma_of_thousands(std::string_view number) {
  if (number.starts_with('-') || number.starts_with('+')) number.remove_prefix(1);
  const std::size_t comma = number.find(',');
  return comma >= 1 && comma <= 3 && number.size() == comma + 4 && number.front() != '0';
}

class NumberReader {
 public:
  NumberReader(const CsvColumns& columns, const CsvTable& table, const PulseOptions& options,
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
        "several samples share a time, {} with the previous one: the times are rounded, or "
        "one stands for a packet of samples",
        shared);
    if (length > 0)
      rule += fmt::format(
          "; if the samples are evenly spaced, give their interval: --interval \"{:.4g} ms\" ({:.4g} ms "
          "over {} steps)",
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
          "its comma may separate thousands or decimals, since other numbers of its column are whole: write "
          "decimal points, and no thousands separators");
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
  Findings findings;

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
                             : fmt::format(" (and {} more that follow)", findings.missing_behind - 1)));
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
      faults_.refuse(line, "", "", fmt::format("more than {} rows have faults", max_deferred));
    deferred_.emplace_back(sample, std::move(faults));
  }

  /// Rows have as many fields as the first one or as there are columns; more are empty.
  bool fits(const CsvRow& row) {
    if (row.fields.size() == width_) return true;
    if (row.fields.size() > width_ && row.filled() <= width_) {
      ++findings.empty_columns;
      return true;
    }
    if (row.fields.size() == fields_of_first_ || is_ragged_) return true;
    faults_.add(row.line, "", "",
                fmt::format("has {} where {} are expected{}", plural(row.fields.size(), "field"), width_,
                            separator_ == ',' && row.fields.size() > width_
                                ? "; decimal commas need another separator, such as a semicolon"
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
              std::isfinite(value)
                  ? fmt::format("must be within {:g} {}: no sensor gives more", most, is_time ? "s" : "m/s2")
                  : rule_for(NumberKind::out_of_range),
              faults_);
    return false;
  }

  bool read_time_of_day(const CsvRow& row, const injury::MeasuredColumn& column, double& value) {
    std::optional<ExactTime> time = time_of_day(field_in(row, column));
    if (!time) {
      add_fault(row, column, "must be a time of day, as in the first row of numbers", faults_);
      return false;
    }
    // Without a date, the clock begins anew at midnight, and one of minutes and seconds at the full hour.
    const std::int64_t round = std::ranges::count(field_in(row, column), ':') == 1 ? 3600 : 86400;  // s
    const bool has_date = time->whole >= 2 * 86400;
    time->whole += rounds_ * round;
    if (!has_date && !pulse.time.empty() && time->whole + round / 2 < time_of_day_.whole) {
      ++rounds_;
      time->whole += round;
    }
    time_of_day_ = *time;
    value = static_cast<double>(time->whole) + time->part;
    return true;
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
              fmt::format("has a decimal {}, but line {} has a {}", comma ? "comma" : "point", other,
                          comma ? "point" : "comma"),
              faults_);
    return false;
  }

  [[nodiscard]] std::optional<ExactTime> exact_time_of(const CsvRow& row) const {
    return times_of_day_ ? time_of_day_ : exact_time(field_in(row, columns_.front()));
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
      if (!(step > 0))
        return add_fault(row, columns_.front(), "is earlier than the previous time; times must increase",
                         faults_);
      smallest_packet_ = std::min(smallest_packet_, packet_);
      largest_packet_ = std::max(largest_packet_, packet_);
      packet_ = 1;
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
  ExactTime time_of_day_ = {};  ///< of the latest row
  std::int64_t rounds_ = 0;     ///< of the clock since the first row
  std::string missing_;         ///< what stands in place of the first missing value
  std::size_t packet_ = 1;      ///< number of the latest samples that share a time
  std::size_t smallest_packet_ = max_samples, largest_packet_ = 0;    ///< of those before
  std::vector<std::pair<std::size_t, std::vector<Fault>>> deferred_;  ///< of samples that may be cut off
  std::vector<double> since_first_;  ///< s, of all samples, if the times may count from the first; else empty
};

std::string without_value(std::string_view which, std::size_t rows) {
  return rows == 1 ? fmt::format("the {} row has no value and was left out", which)
                   : fmt::format("the {} {} rows have no value and were left out", which, rows);
}

std::vector<std::string> remarks_on(const Findings& findings, const CsvRows& rows, bool has_mark) {
  std::vector<std::string> remarks;
  if (has_mark) remarks.emplace_back("a byte order mark at the beginning was left out");
  if (rows.lines().kinds_of_ends() > 1) remarks.emplace_back("the file has mixed line endings");
  if (rows.blank_lines() > 0)
    remarks.push_back(plural(rows.blank_lines(), "line") + " without content left out");
  if (findings.missing_before > 0) remarks.push_back(without_value("first", findings.missing_before));
  if (findings.missing_behind > 0) remarks.push_back(without_value("last", findings.missing_behind));
  if (findings.decimal_comma > 0) remarks.emplace_back("decimal commas were read as points");
  if (findings.empty_columns > 0) remarks.emplace_back("empty columns at the end were left out");
  const auto left_out = [&](std::size_t count, std::string_view one, std::string_view several,
                            std::size_t first) {
    if (count > 0)
      remarks.push_back(fmt::format("{} {} left out, {}in line {}", count, count == 1 ? one : several,
                                    count == 1 ? "" : "the first ", first));
  };
  left_out(findings.repeated_samples, "sample that repeats the previous one was",
           "samples that repeat the previous one were", findings.first_repeated);
  left_out(rows.comments_among_numbers(), "line that begins with # among the numbers was",
           "lines that begin with # among the numbers were", rows.first_comment_among_numbers());
  return remarks;
}

/// Chooses the columns, and the first time and interval that the header of a file without times states.
double choose(CsvColumns& columns, const CsvTable& table, PulseOptions& options, MeasurementFaults& faults,
              std::vector<std::string>& remarks) {
  const bool of_header =
      table.labview && !options.interval && table.labview->x_columns == LabViewHeader::XColumns::none;
  if (of_header) options.interval = 1;  // until the columns are known
  choose_columns(columns, table, options, faults, remarks);
  if (!of_header || columns.acceleration.empty()) return 0;
  const auto stated = [&](const injury::MeasuredColumn& column) {
    const auto place = static_cast<std::size_t>(column.number - 1);
    return place < table.labview->columns.size() ? table.labview->columns[place] : LabViewHeader::Column{};
  };
  const LabViewHeader::Column first = stated(columns.acceleration.front());
  for (const injury::MeasuredColumn& column : columns.acceleration)
    if (const auto own = stated(column); own.interval != first.interval || own.first != first.first)
      faults.add(table.labview->end, column.name, "",
                 "has other times than " + columns.acceleration.front().name);
  if (!first.interval || !(*first.interval > 0))
    faults.refuse(table.labview->end, columns.acceleration.front().name, "",
                  "has no times, and the header no interval of times (Delta_X); --interval gives it");
  options.interval = first.interval;
  remarks.push_back(
      fmt::format("the sampling interval, {} ms, is that of the header", brief(1e3 * *first.interval)));
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
                    "has one column of numbers and no times; if that is the acceleration, give the sample "
                    "interval, such as --interval \"0.1 ms\"");
    injury::MeasuredPulse result{.format = table.labview ? "LVM" : "CSV", .resultant = given.resultant};
    PulseOptions options = given;
    const double first = choose(columns, table, options, faults, result.remarks);
    faults.throw_if_any();
    if (!columns.times_of_day)
      require_no_numbers(table.header, columns.names, read_columns_of(columns), faults);

    NumberReader numbers(columns, table, options, faults);
    numbers.expect_rows(table);
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
    if (first != 0)
      for (double& time : numbers.pulse.time) time += first;
    numbers.judge_shared_times();
    numbers.judge_commas();
    result.counts_from = numbers.count_from_first();
    if (faults.none() && numbers.pulse.time.size() < 2)
      faults.add(0, "", "", "has one sample only; a pulse needs two");
    faults.throw_if_any();
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
    if (!result.counts_from.empty()) result.remarks.push_back(remark_on_clock(result.counts_from));
    for (std::vector<std::string>* more : {&cut, &bridged})
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
