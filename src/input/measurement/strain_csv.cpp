#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "input/measurement/csv_table.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t max_rows = 10'000;
constexpr double min_strain = 1e-12;  // the largest of a history; rounding matters below

/// A column called strain, whose unit needs no brackets: "strain %", "strain_percent".
std::optional<injury::MeasuredColumn> as_strain(injury::MeasuredColumn column) {
  std::string name = lower_case(split_header(column.name).name);
  for (const std::string_view unit : {" %", "_%", "_percent", " percent"})
    if (column.unit.empty() && name.ends_with(unit)) {
      name.erase(name.size() - unit.size());
      column.unit = "%";
    }
  if (name != "strain") return std::nullopt;
  return column;
}

struct StrainColumns {
  injury::MeasuredColumn time, strain;
};

/// Finds the columns. Faults if the header is ambiguous or lacks a unit.
StrainColumns choose(const CsvHeader& header, MeasurementFaults& faults) {
  const CsvColumns named = named_columns(header, " and their units: time_s,strain", faults);
  const std::size_t line = named.names->line;
  std::vector<injury::MeasuredColumn> times, strains;
  for (const injury::MeasuredColumn& column : named.all) {
    if (const auto strain = as_strain(column))
      strains.push_back(*strain);
    else if (looks_like(ColumnKind::time, column))
      times.push_back(column);
  }
  if (times.size() != 1)
    faults.add(line, "", "",
               fmt::format("one column of times is needed, such as time_s or \"time [ms]\"; there are {}",
                           times.size()));
  if (strains.size() != 1)
    faults.add(
        line, "", "",
        fmt::format("one column called strain is needed, such as strain or \"strain [%]\"; there are {}",
                    strains.size()));
  StrainColumns chosen;
  if (times.size() == 1) {
    chosen.time = times.front();
    const std::string rule = settle_unit(chosen.time, ColumnKind::time, "", "the header");
    if (!rule.empty())
      faults.add(line, chosen.time.name, "",
                 "the time needs a unit in the header, such as time_s or time [ms]");
  }
  if (strains.size() == 1) {
    chosen.strain = strains.front();
    const auto in_one = units_in_strain_one(chosen.strain.unit);
    if (!in_one) faults.add(line, chosen.strain.name, "", "a strain is a pure number, or in %");
    chosen.strain.factor = 1 / in_one.value_or(1);
  }
  faults.throw_if_any();
  return chosen;
}

StrainTable read_rows(const CsvTable& csv, const StrainColumns& columns, MeasurementFaults& faults) {
  StrainTable table;
  std::optional<double> last_time;
  std::size_t rows = 0, repeated = 0;
  each_row(csv, faults, [&](const CsvRow& row) {
    const auto time = number_in(row, columns.time, csv.separator, faults);
    const auto strain = number_in(row, columns.strain, csv.separator, faults);
    if (!time || !strain) return;
    if (rows++ == max_rows) faults.refuse(row.line, "", "", fmt::format("more than {} rows", max_rows));
    if (!table.time.empty() && *time == table.time.back() && *strain == table.strain.back()) {
      ++repeated;
      return;
    }
    // The first time will be subtracted from all others, so times are compared after that rounding.
    const double begin = table.time.empty() ? *time : table.time.front();
    if (!std::isfinite(*time - begin))
      add_fault(row, columns.time, rule_for(NumberKind::out_of_range), faults);
    else if (last_time && !(*time - begin > *last_time - begin))
      add_fault(row, columns.time,
                *time > *last_time ? "rounds to the previous time, so long after the first"
                                   : "must be later than the previous time",
                faults);
    last_time = time;
    if (!(*strain >= 0 && *strain < 1))
      add_fault(row, columns.strain, "a strain is at least 0 and below 1 (100 %), positive in compression",
                faults);
    else if (rows == 1 && *strain != 0)
      add_fault(row, columns.strain, "the history begins at first contact, with strain 0", faults);
    table.time.push_back(*time);
    table.strain.push_back(*strain);
  });
  faults.throw_if_any();
  if (repeated > 0)
    table.remarks.push_back(
        fmt::format("{} {} before {} left out", repeated,
                    repeated == 1 ? "row that repeats the one" : "rows that repeat the one",
                    repeated == 1 ? "was" : "were"));
  return table;
}

/// Refuses a history that is too short or too long, or without strain.
void judge_history(const StrainTable& table, const StrainColumns& columns, MeasurementFaults& faults) {
  if (table.time.size() < 2) faults.refuse(0, "", "", "has one row only; a history needs two");
  const double span = table.time.back() - table.time.front(), most = measured_magnitudes("s").most;
  if (!(span <= most))
    faults.refuse(0, columns.time.name, "", fmt::format("lasts {:.3g} s; must be within {:g} s", span, most));
  if (const double largest = std::ranges::max(table.strain); !(largest > min_strain))
    faults.refuse(0, columns.strain.name, "", largest == 0 ? "is 0 throughout" : "is below 1e-12 throughout");
}

}  // namespace

Reading<StrainTable> read_strain_csv(const std::filesystem::path& file) {
  return reading_of([&]() -> StrainTable {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable csv = csv_table_in(content, faults);
    const StrainColumns columns = choose(csv.header, faults);
    require_no_numbers(csv.header, name_columns(csv.header).names, {columns.time, columns.strain},
                       csv.separator, faults, 1);
    StrainTable table = read_rows(csv, columns, faults);
    judge_history(table, columns, faults);
    if (const double begin = table.time.front(); begin != 0) {
      for (double& time : table.time) time -= begin;
      table.remarks.push_back(
          fmt::format("the first time, {:g} s, is first contact; it was subtracted from all times", begin));
    }
    return table;
  });
}

}  // namespace dashpad::input
