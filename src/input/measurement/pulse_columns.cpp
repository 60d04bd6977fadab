// The columns of time and acceleration of a pulse: those that the user named, or that the header shows.

#include "input/measurement/csv_table.hpp"

#include <algorithm>
#include <iterator>

#include <fmt/format.h>

#include "input/spelling.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_namesakes = 5;
constexpr const char* or_interval = ", or give the time between samples with --interval";

using Columns = std::vector<injury::MeasuredColumn>;

std::string listing(const Columns& columns) {
  std::vector<std::string> all;
  for (const injury::MeasuredColumn& measured_column : columns)
    all.push_back(fmt::format("{} ({})", measured_column.name, measured_column.number));
  return short_listing(all);
}

/// The column that the user named, by its whole header or else by its name without unit; then ignoring case.
std::optional<injury::MeasuredColumn> named(const Columns& all, const std::string& wanted,
                                            const std::string& option, std::size_t line,
                                            MeasurementFaults& faults) {
  if (const auto number = parsed<std::size_t>(wanted)) {
    if (*number >= 1 && *number <= all.size()) return all[*number - 1];
    faults.add(line, "", "", fmt::format("{} {}: columns are numbered 1 to {}", option, wanted, all.size()));
    return std::nullopt;
  }
  const auto bare = [](const injury::MeasuredColumn& column) { return split_header(column.name).name; };
  const std::string whole = quoted_part(wanted, longest_column_name);  // columns are named likewise
  for (int attempt = 0; attempt < 4; ++attempt) {
    Columns found;
    for (const injury::MeasuredColumn& column : all) {
      const std::string name = attempt % 2 == 0 ? column.name : bare(column);
      if (attempt < 2 ? name == whole : lower_case(name) == lower_case(whole)) found.push_back(column);
    }
    if (found.size() == 1) return found.front();
    if (found.size() > 1) {
      faults.add(line, "", "",
                 fmt::format("{} {}: give the number of the column, since several have that name: {}", option,
                             wanted, listing(found)));
      return std::nullopt;
    }
  }
  faults.add(line, "", "", fmt::format("{} {}: no such column; available: {}", option, wanted, listing(all)));
  return std::nullopt;
}

/// With a sensitivity, the columns in volts if there are any.
Columns those_that_look_like(ColumnKind kind, const Columns& all,
                             const std::vector<Sensitivity>& sensitivity = {}) {
  Columns found;
  if (kind == ColumnKind::acceleration && !sensitivity.empty())
    std::ranges::copy_if(all, std::back_inserter(found),
                         [](const injury::MeasuredColumn& column) { return is_voltage(column.unit); });
  if (!found.empty()) return found;
  std::ranges::copy_if(all, std::back_inserter(found),
                       [&](const injury::MeasuredColumn& column) { return looks_like(kind, column); });
  return found;
}

/// A hint at columns with the expected name but an unsuitable unit.
std::string units_of_namesakes(ColumnKind kind, const Columns& all) {
  std::string text;
  std::size_t count = 0;
  for (const injury::MeasuredColumn& column : all) {
    const std::size_t before = text.size();
    if (kind == ColumnKind::acceleration && is_voltage(column.unit))
      text += fmt::format("; column {} is in {} and needs a sensitivity, such as --sensitivity \"10 mV/g\"",
                          column.number, column.unit);
    else if (!column.unit.empty() && !is_pulse_unit(ColumnKind::time, column.unit) &&
             !is_pulse_unit(ColumnKind::acceleration, column.unit) &&
             looks_like(kind, injury::MeasuredColumn{.name = split_header(column.name).name}))
      text += fmt::format("; the unit \"{}\" of column {} is not a unit of {}", column.unit, column.number,
                          kind == ColumnKind::time ? "time" : "acceleration");
    if (text.size() > before && ++count == max_namesakes) break;
  }
  return text;
}

/// The columns of one kind, as named by the user or by the header.
Columns chosen(const CsvColumns& columns, ColumnKind kind, const std::vector<std::string>& names,
               std::size_t most, const std::vector<Sensitivity>& sensitivity, MeasurementFaults& faults) {
  const std::string word = kind == ColumnKind::time ? "time" : "acceleration";
  const std::string option = "--" + word;
  const std::size_t line = columns.names != nullptr ? columns.names->line : 0;
  Columns found;
  if (!names.empty()) {
    for (const std::string& name : names)
      if (const auto column = named(columns.all, name, option, line, faults)) found.push_back(*column);
    return found;
  }
  found = those_that_look_like(kind, columns.all, sensitivity);
  if (found.empty())
    faults.add(line, "", "",
               fmt::format("no {} column was recognized; name it with {}{}; available: {}{}", word, option,
                           kind == ColumnKind::time ? or_interval : "", listing(columns.all),
                           units_of_namesakes(kind, columns.all)));
  if (found.size() > most) {
    faults.add(
        line, "", "",
        fmt::format("several columns could be the {}: {}; choose one with {}{}", word, listing(found), option,
                    kind == ColumnKind::acceleration ? ", or combine two or three with --resultant" : ""));
    found.clear();
  }
  return found;
}

void settle(injury::MeasuredColumn& column, ColumnKind kind, const std::string& given,
            const std::optional<Sensitivity>& sensitivity, std::size_t line, MeasurementFaults& faults,
            std::vector<std::string>& remarks) {
  const std::string unit_of_file = column.unit;
  const std::string option = kind == ColumnKind::time ? "--time-unit" : "--acceleration-unit";
  const std::string rule = settle_unit(column, kind, given, option, sensitivity);
  if (!rule.empty()) faults.add(line, column.name, "", rule);
  if (const auto remark = overruled_unit(column, unit_of_file); remark && rule.empty())
    remarks.push_back(*remark);
}

/// What the user named, or else what follows from the number of columns.
struct WantedColumns {
  std::vector<std::string> time = {}, acceleration = {};
};

/// Refuses a table of several columns of which none can be told.
[[noreturn]] void refuse_unknown(const CsvColumns& columns, const CsvTable& table,
                                 MeasurementFaults& faults) {
  if (columns.names == nullptr)
    faults.refuse(
        table.header.first_line, "", "",
        fmt::format("no header names the {} columns; choose two by their numbers and give their units, "
                    "such as --time 1 --time-unit ms --acceleration 2 --acceleration-unit g",
                    columns.all.size()));
  faults.refuse(
      columns.names->line, "", "",
      fmt::format("neither a time nor an acceleration column was recognized; name them with --time "
                  "and --acceleration{}; available: {}{}{}",
                  or_interval, listing(columns.all), units_of_namesakes(ColumnKind::time, columns.all),
                  units_of_namesakes(ColumnKind::acceleration, columns.all)));
}

/// Whether the first column is the X of a report of Abaqus, whose history outputs are over the time.
bool has_times_in_x(const CsvColumns& columns, const CsvTable& table) {
  return table.separator == ' ' && lower_case(columns.all.front().name) == "x" &&
         increases(table.text, table.separator, table.header.first_line, 0);
}

WantedColumns wanted_columns(const CsvColumns& columns, const CsvTable& table, const PulseOptions& options,
                             MeasurementFaults& faults, std::vector<std::string>& remarks) {
  WantedColumns wanted{.acceleration = options.acceleration};
  if (!options.time.empty()) wanted.time.push_back(options.time);
  if (options.interval && columns.all.size() == 1 && wanted.acceleration.empty()) wanted.acceleration = {"1"};
  if (options.interval || !wanted.time.empty() ||
      !those_that_look_like(ColumnKind::time, columns.all).empty())
    return wanted;
  const bool none_is_known =
      wanted.acceleration.empty() && those_that_look_like(ColumnKind::acceleration, columns.all).empty();
  if (none_is_known && columns.all.size() == 2) {
    wanted = {.time = {"1"}, .acceleration = {"2"}};
    remarks.emplace_back("the first of the two columns is used as the time, the second as the acceleration");
  } else if (has_times_in_x(columns, table)) {
    wanted.time = {"1"};
    remarks.emplace_back("column X is used as the time, as in reports of Abaqus");
  } else if (none_is_known && columns.all.size() > 2 &&
             those_that_look_like(ColumnKind::acceleration, columns.all, options.sensitivity).empty()) {
    refuse_unknown(columns, table, faults);
  }
  return wanted;
}

void settle_time(CsvColumns& columns, const CsvHeader& header, const PulseOptions& options, std::size_t line,
                 MeasurementFaults& faults, std::vector<std::string>& remarks) {
  columns.times_of_day = header.holds_time_of_day(columns.time);
  if (!columns.times_of_day)
    return settle(columns.time, ColumnKind::time, options.time_unit, {}, line, faults, remarks);
  columns.time.unit = "s";
  columns.time.unit_origin = "format";
  if (!options.time_unit.empty())
    faults.add(header.first_line, columns.time.name,
               header.first_row[static_cast<std::size_t>(columns.time.number - 1)],
               "is a time of day and takes no unit: leave out --time-unit");
}

/// Sets the units of the accelerations; reports those that are chosen twice.
void settle_accelerations(CsvColumns& columns, const PulseOptions& options, std::size_t line,
                          MeasurementFaults& faults, std::vector<std::string>& remarks) {
  const std::size_t count = columns.acceleration.size();
  if (options.sensitivity.size() > 1 && options.sensitivity.size() != count)
    faults.add(line, "", "", wrong_number_of_sensitivities(options.sensitivity.size(), count));
  for (std::size_t i = 0; i < count; ++i) {
    injury::MeasuredColumn& column = columns.acceleration[i];
    const auto is_same = [&](const injury::MeasuredColumn& other) { return other.number == column.number; };
    if (columns.time.number > 0 && is_same(columns.time))
      faults.add(line, column.name, "", "was chosen both as the time and as an acceleration");
    if (std::any_of(columns.acceleration.begin(), columns.acceleration.begin() + static_cast<long>(i),
                    is_same))
      faults.add(line, column.name, "", "is named twice");
    settle(column, ColumnKind::acceleration, options.acceleration_unit,
           sensitivity_at(options.sensitivity, i), line, faults, remarks);
  }
}

void tell_of_header(const CsvColumns& columns, const CsvHeader& header, std::vector<std::string>& remarks) {
  if (columns.names != nullptr && columns.names->is_comment)
    remarks.push_back(
        fmt::format("the column names were read from the comment on line {}", columns.names->line));
  if (columns.names != nullptr && !columns.names->keyword.empty())
    remarks.push_back(fmt::format("{}, at the beginning of line {}, names no column and was left out",
                                  quoted_part(columns.names->keyword, longest_column_name),
                                  columns.names->line));
  if (!header.remark().empty()) remarks.push_back(header.remark());
  if (header.is_latin1) remarks.emplace_back("the header is not UTF-8; it was read as Latin-1");
}

}  // namespace

void choose_columns(CsvColumns& columns, const CsvTable& table, const PulseOptions& options,
                    MeasurementFaults& faults, std::vector<std::string>& remarks) {
  const CsvHeader& header = table.header;
  const std::size_t line = columns.names != nullptr ? columns.names->line : 0;
  auto [time, acceleration] = wanted_columns(columns, table, options, faults, remarks);
  if (columns.names != nullptr && columns.names->fields.size() < header.width &&
      known_names(*columns.names) > 0)
    faults.add(
        line, "", "",
        fmt::format("names {}, but line {} has {} numbers; with decimal commas, use another separator, "
                    "such as a semicolon",
                    plural(columns.names->fields.size(), "column"), header.first_line, header.width));
  columns.acceleration = chosen(columns, ColumnKind::acceleration, acceleration, options.resultant ? 3 : 1,
                                options.sensitivity, faults);
  const bool has_own_times = table.labview && table.labview->x_columns == LabViewHeader::XColumns::each;
  if (has_own_times && time.empty() && columns.acceleration.size() == 1 &&
      columns.acceleration.front().number > 1)
    time = {std::to_string(columns.acceleration.front().number - 1)};
  if (has_own_times && options.resultant)
    faults.add(table.labview->end, "X_Columns", "Multi",
               "each channel has its own times, but a resultant needs the same times for all");
  const Columns times = options.interval ? Columns{} : chosen(columns, ColumnKind::time, time, 1, {}, faults);
  const std::size_t count = columns.acceleration.size();
  if (options.resultant ? count == 1 || count > 3 : count > 1)
    faults.add(line, "", "",
               options.resultant ? fmt::format("a resultant needs two or three columns, not {}", count)
                                 : "several acceleration columns were named; combine them with --resultant");
  if (!times.empty()) {
    columns.time = times.front();
    settle_time(columns, header, options, line, faults, remarks);
  } else if (options.interval) {
    columns.time = {.name = "samples", .unit = "s", .unit_origin = "given"};
    for (const injury::MeasuredColumn& unread : those_that_look_like(ColumnKind::time, columns.all))
      remarks.push_back(fmt::format("the times in column {}, {}, were not read because --interval was given",
                                    unread.number, unread.name));
  }
  settle_accelerations(columns, options, line, faults, remarks);
  tell_of_header(columns, header, remarks);
}

}  // namespace dashpad::input
