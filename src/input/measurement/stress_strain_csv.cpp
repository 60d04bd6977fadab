#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "dashpad/quantities/quantity.hpp"
#include "input/measurement/csv_table.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t max_rows_of_a_test = 10'000;
constexpr double min_strain_of_a_test = 1e-9;

/// "stress" and "kPa" for "stress_kPa", "stress [kPa]" and "stress (kPa)".
HeaderText without_unit(const injury::MeasuredColumn& column) {
  const std::string& text = column.name;
  for (const auto& [open, close] : {std::pair('[', ']'), std::pair('(', ')')})
    if (const auto begin = text.find(open); begin != std::string::npos && text.ends_with(close))
      return {std::string(without_blanks(std::string_view(text).substr(0, begin))),
              std::string(without_blanks(std::string_view(text).substr(begin + 1, text.size() - begin - 2)))};
  if (!column.unit.empty()) return {split_header(text).name, column.unit};
  const auto mark = text.find_last_of("_ ");
  if (mark == std::string::npos) return {text, ""};
  return {text.substr(0, mark), text.substr(mark + 1)};
}

struct TestColumns {
  injury::MeasuredColumn strain, stress;
  std::optional<injury::MeasuredColumn> time;
};

/// Finds a column by its header, with or without unit.
std::optional<injury::MeasuredColumn> find_column(const std::vector<injury::MeasuredColumn>& all,
                                                  const std::string& wanted, const char* kind,
                                                  std::size_t line, MeasurementFaults& faults) {
  std::string names;
  std::vector<injury::MeasuredColumn> found;
  for (const injury::MeasuredColumn& column : all) {
    const HeaderText header = without_unit(column);
    names += (names.empty() ? "" : ", ") + column.name;
    const std::string whole = lower_case(wanted);
    const bool exact = lower_case(column.name) == whole;
    if (exact || lower_case(header.name) == whole) {
      found.push_back(column);
      found.back().unit = header.unit;
      if (exact) return found.back();
    }
  }
  if (found.size() == 1) return found.front();
  faults.add(line, wanted, "",
             found.empty() ? fmt::format("no such column for the {}; available: {}", kind, names)
                           : fmt::format("several columns may be the {}: {}", kind, names));
  return std::nullopt;
}

void settle_strain(injury::MeasuredColumn& column, const std::string& given, std::size_t line,
                   MeasurementFaults& faults) {
  const std::string unit = lower_case(given.empty() ? column.unit : given);
  const auto in_one = unit == "fraction" ? 1 : unit.empty() ? std::nullopt : units_in_strain_one(unit);
  if (!in_one)
    faults.add(line, column.name, "",
               "its unit is not stated: set strain_unit = \"fraction\" or strain_unit = \"percent\"");
  column.factor = 1 / in_one.value_or(1);
}

void settle_quantity(injury::MeasuredColumn& column, const std::string& given, const std::string& si_unit,
                     const char* key, std::size_t line, MeasurementFaults& faults) {
  const std::string unit = given.empty() ? column.unit : given;
  const auto [factor, rule] = read_si("1 " + unit, si_unit);
  const bool is_stated = !unit.empty() && rule.empty();
  if (!is_stated)
    faults.add(
        line, column.name, unit,
        fmt::format("its unit is not stated: put it into the header, such as {0}, or set {1} = \"{2}\"",
                    si_unit == "Pa" ? "stress_kPa" : "time_s", key, si_unit == "Pa" ? "kPa" : "s"));
  column.factor = is_stated ? factor : 1;
}

TestColumns columns_of_test(const CsvHeader& header, const StressStrainColumns& wanted,
                            MeasurementFaults& faults) {
  const CsvColumns named = named_columns(header, ": strain,stress_kPa", faults);
  const std::size_t line = named.names->line;
  TestColumns columns;
  if (const auto strain = find_column(named.all, wanted.strain, "strain", line, faults)) {
    columns.strain = *strain;
    settle_strain(columns.strain, wanted.strain_unit, line, faults);
  }
  if (const auto stress = find_column(named.all, wanted.stress, "stress", line, faults)) {
    columns.stress = *stress;
    settle_quantity(columns.stress, wanted.stress_unit, "Pa", "stress_unit", line, faults);
  }
  if (!wanted.time.empty()) columns.time = find_column(named.all, wanted.time, "time", line, faults);
  if (columns.time) settle_quantity(*columns.time, wanted.time_unit, "s", "time_unit", line, faults);
  faults.throw_if_any();
  return columns;
}

StressStrainTable read_test_rows(const CsvTable& csv, const TestColumns& columns, MeasurementFaults& faults) {
  StressStrainTable table;
  std::optional<double> last_time;
  each_row(csv, faults, [&](const CsvRow& row) {
    if (table.strain.size() == max_rows_of_a_test)
      faults.refuse(row.line, "", "", fmt::format("more than {} rows: thin them", max_rows_of_a_test));
    const auto value = [&](const injury::MeasuredColumn& column, const char* si_unit) {
      auto number = number_in(row, column, csv.separator, faults);
      const double most = measured_magnitudes(si_unit).most;
      if (!number || std::abs(*number) <= most) return number;
      add_fault(row, column,
                fmt::format("must be within {:g} {}: no test of a foam gives more", most, si_unit), faults);
      return std::optional<double>();
    };
    const auto strain = value(columns.strain, "1"), stress = value(columns.stress, "Pa");
    if (columns.time) {
      const auto time = value(*columns.time, "s");
      if (!time) return;
      if (last_time && !(*time > *last_time))
        return add_fault(row, *columns.time, "must be later than the time before", faults);
      last_time = time;
    }
    if (!strain || !stress) return;
    if (*strain >= 1)
      return add_fault(row, columns.strain,
                       columns.strain.factor == 1
                           ? "a strain is below 1: is it in per cent? Then set strain_unit = \"percent\""
                           : "a strain is below 100 %",
                       faults);
    if (columns.time) table.time.push_back(*last_time);
    table.strain.push_back(*strain);
    table.stress.push_back(*stress);
  });
  faults.throw_if_any();
  return table;
}

/// Refuses a test without compression or stress.
void judge_test(const StressStrainTable& table, const TestColumns& columns, MeasurementFaults& faults) {
  if (table.strain.size() < 2) faults.refuse(0, "", "", "has fewer than two rows");
  const auto [least, largest] = std::ranges::minmax(table.strain);
  if (!(largest > 0) || -least > largest)
    faults.refuse(0, columns.strain.name, "",
                  "is negative: compression is positive here, for strain and stress alike");
  if (!(largest > min_strain_of_a_test))
    faults.refuse(0, columns.strain.name, "",
                  fmt::format("is nowhere above {:g}: nothing was compressed", min_strain_of_a_test));
  const double min_stress = measured_magnitudes("Pa").least, max_stress = std::ranges::max(table.stress);
  if (max_stress > 0 && max_stress < min_stress)
    faults.refuse(0, columns.stress.name, "",
                  fmt::format("is nowhere above {:g} Pa: no test of a foam gives less", min_stress));
  if (!(max_stress > 0))
    faults.refuse(0, columns.stress.name, "", "is nowhere above 0: compression is positive here");
}

}  // namespace

Reading<StressStrainTable> read_stress_strain_csv(const std::filesystem::path& file,
                                                  const StressStrainColumns& wanted) {
  return reading_of([&]() -> StressStrainTable {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable csv = csv_table_in(content, faults);
    const TestColumns columns = columns_of_test(csv.header, wanted, faults);
    StressStrainTable table = read_test_rows(csv, columns, faults);
    judge_test(table, columns, faults);
    return table;
  });
}

}  // namespace dashpad::input
