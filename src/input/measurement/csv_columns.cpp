// The columns that a header names, their units, and those that are chosen.

#include "input/measurement/csv_table.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "input/spelling.hpp"
#include "quantities/from_chars.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr std::size_t max_namesakes = 5;
constexpr std::size_t longest_name = 100;  // of a column, in messages and results

using Columns = std::vector<injury::MeasuredColumn>;

/// The unit in a field without a name: "ms", "[ms]", "(g)".
std::optional<std::string> lone_unit(const std::string& field) {
  const auto [name, unit] = split_header(field);
  if (name.empty() && !unit.empty()) return unit;
  return is_customary_unit(field) ? std::optional{field} : std::nullopt;
}

bool is_row_of_units(const CsvHeader::Row& row) {
  bool any = false;
  for (const std::string& field : row.fields) {
    const bool is_unit = lone_unit(field).has_value();
    any = any || is_unit;
    if (!is_unit && !field.empty() && field != "-" && field.size() > 12) return false;
    if (!is_unit && looks_like(ColumnKind::time, injury::MeasuredColumn{.name = field})) return false;
  }
  return any && (lone_unit(row.fields.front()).has_value() || row.fields.front().empty());
}

/// The number of columns in a row that look like a time or an acceleration.
int score(const CsvHeader::Row& row) {
  int known = 0;
  for (const std::string& field : row.fields) {
    const auto [name, unit] = split_header(field);
    const injury::MeasuredColumn column{.name = field, .unit = unit};
    known += looks_like(ColumnKind::time, column) || looks_like(ColumnKind::acceleration, column) ? 1 : 0;
  }
  return known;
}

const CsvHeader::Row* row_of_names(const CsvHeader& header) {
  const CsvHeader::Row* best = nullptr;
  int highest = 0;
  for (const CsvHeader::Row& row : header.rows) {
    if (row.fields.size() < std::min<std::size_t>(header.width, 2) || is_row_of_units(row)) continue;
    if (const int own = score(row); best == nullptr || own >= highest) {
      best = &row;
      highest = own;
    }
  }
  return best;
}

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
  const std::string whole = quoted_part(wanted, longest_name);  // columns are named likewise
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
               fmt::format("no {} column was recognized; name it with {}; available: {}{}", word, option,
                           listing(columns.all), units_of_namesakes(kind, columns.all)));
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

}  // namespace

void add_fault(const CsvRow& row, const injury::MeasuredColumn& column, std::string rule,
               MeasurementFaults& faults) {
  faults.add(row.line, column.name, field_in(row, column), std::move(rule));
}

std::optional<double> number_in(const CsvRow& row, const injury::MeasuredColumn& column,
                                MeasurementFaults& faults) {
  const ReadNumber read = read_csv_number(field_in(row, column));
  if (read.kind == NumberKind::number) return read.value * column.factor;
  add_fault(row, column, rule_for(read.kind), faults);
  return std::nullopt;
}

void require_no_numbers(const CsvHeader& header, const CsvHeader::Row* names,
                        const std::vector<injury::MeasuredColumn>& chosen, MeasurementFaults& faults,
                        std::size_t first) {
  for (const CsvHeader::Row& row : header.rows) {
    if (names != nullptr && row.line <= names->line) continue;
    const auto kind_of = [&](const injury::MeasuredColumn& column) {
      return read_csv_number(field_in(row, column)).kind;
    };
    const auto holds_number = [&](const auto& column) { return kind_of(column) == NumberKind::number; };
    if (std::none_of(chosen.begin() + static_cast<std::ptrdiff_t>(first), chosen.end(), holds_number))
      continue;
    for (const injury::MeasuredColumn& column : chosen)
      if (!holds_number(column))
        faults.add(row.line, column.name, field_in(row, column), rule_for(kind_of(column)));
  }
}

CsvColumns name_columns(const CsvHeader& header, const std::optional<LabViewHeader>& labview) {
  CsvColumns columns;
  columns.names = row_of_names(header);
  const std::size_t named_columns = columns.names != nullptr ? columns.names->fields.size() : 0;
  std::vector<const CsvHeader::Row*> unit_rows;
  for (const CsvHeader::Row& row : header.rows)
    if (is_row_of_units(row)) unit_rows.push_back(&row);
  // Names beyond the fields of the first row name nothing.
  const std::size_t count = std::max(header.width, std::min(named_columns, header.first_row.size()));
  for (std::size_t i = 0; i < count; ++i) {
    injury::MeasuredColumn column{.name = fmt::format("column {}", i + 1), .number = static_cast<int>(i + 1)};
    if (i < named_columns && !columns.names->fields[i].empty()) {
      column.unit = split_header(columns.names->fields[i]).unit;
      column.name = quoted_part(columns.names->fields[i], longest_name);
    }
    for (const CsvHeader::Row* row : unit_rows)
      if (column.unit.empty() && i < row->fields.size()) column.unit = lone_unit(row->fields[i]).value_or("");
    if (labview && i < labview->columns.size()) column.unit = labview->columns[i].unit;
    columns.all.push_back(std::move(column));
  }
  return columns;
}

CsvColumns named_columns(const CsvHeader& header, const std::string& what, MeasurementFaults& faults) {
  CsvColumns columns = name_columns(header);
  if (columns.names == nullptr)
    faults.refuse(header.first_line, "", "", "needs a header line that names the columns" + what);
  return columns;
}

void choose_columns(CsvColumns& columns, const CsvTable& table, const PulseOptions& options,
                    MeasurementFaults& faults, std::vector<std::string>& remarks) {
  const CsvHeader& header = table.header;
  const std::size_t line = columns.names != nullptr ? columns.names->line : 0;
  const bool any_known = !those_that_look_like(ColumnKind::time, columns.all).empty() ||
                         !those_that_look_like(ColumnKind::acceleration, columns.all).empty();
  std::vector<std::string> time;
  std::vector<std::string> acceleration = options.acceleration;
  if (!options.time.empty()) time.push_back(options.time);
  if (options.interval && columns.all.size() == 1 && acceleration.empty()) acceleration = {"1"};
  if (!options.interval && columns.all.size() == 2 && time.empty() && acceleration.empty() && !any_known) {
    time = {"1"};
    acceleration = {"2"};
    remarks.emplace_back("the first of the two columns is used as the time, the second as the acceleration");
  }
  if (columns.names != nullptr && columns.names->fields.size() < header.width && score(*columns.names) > 0)
    faults.add(
        line, "", "",
        fmt::format("names {}, but line {} has {} numbers; with decimal commas, use another separator, "
                    "such as a semicolon",
                    plural(columns.names->fields.size(), "column"), header.first_line, header.width));
  columns.acceleration = chosen(columns, ColumnKind::acceleration, acceleration, options.resultant ? 3 : 1,
                                options.sensitivity, faults);
  if (table.labview && table.labview->x_columns == LabViewHeader::XColumns::each && time.empty() &&
      columns.acceleration.size() == 1 && columns.acceleration.front().number > 1)
    time = {std::to_string(columns.acceleration.front().number - 1)};
  if (table.labview && table.labview->x_columns == LabViewHeader::XColumns::each && options.resultant)
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
    columns.times_of_day = header.holds_time_of_day(columns.time);
    if (!columns.times_of_day) {
      settle(columns.time, ColumnKind::time, options.time_unit, {}, line, faults, remarks);
    } else {
      columns.time.unit = "s";
      columns.time.unit_origin = "format";
      if (!options.time_unit.empty())
        faults.add(header.first_line, columns.time.name,
                   header.first_row[static_cast<std::size_t>(columns.time.number - 1)],
                   "is a time of day and takes no unit: leave out --time-unit");
    }
  } else if (options.interval) {
    columns.time = {.name = "samples", .unit = "s", .unit_origin = "given"};
    for (const injury::MeasuredColumn& unread : those_that_look_like(ColumnKind::time, columns.all))
      remarks.push_back(fmt::format("the times in column {}, {}, were not read because --interval was given",
                                    unread.number, unread.name));
  }
  if (options.sensitivity.size() > 1 && options.sensitivity.size() != count)
    faults.add(line, "", "", wrong_number_of_sensitivities(options.sensitivity.size(), count));
  for (std::size_t i = 0; i < count; ++i) {
    injury::MeasuredColumn& column = columns.acceleration[i];
    const auto is_same = [&](const injury::MeasuredColumn& other) { return other.number == column.number; };
    if (!times.empty() && is_same(columns.time))
      faults.add(line, column.name, "", "was chosen both as the time and as an acceleration");
    if (std::any_of(columns.acceleration.begin(), columns.acceleration.begin() + static_cast<long>(i),
                    is_same))
      faults.add(line, column.name, "", "is named twice");
    settle(column, ColumnKind::acceleration, options.acceleration_unit,
           sensitivity_at(options.sensitivity, i), line, faults, remarks);
  }
  if (header.from_comment)
    remarks.push_back(fmt::format("the column names were read from the comment on line {}", line));
  if (header.is_latin1) remarks.emplace_back("the header is not UTF-8; it was read as Latin-1");
}

}  // namespace dashpad::input
