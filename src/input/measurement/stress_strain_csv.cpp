#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "input/measurement/test_columns.hpp"
#include "input/measurement/test_names.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t max_rows_of_test = 10'000;
constexpr double min_strain_of_a_test = 1e-9;

StressStrainTable read_test_rows(const CsvTable& csv, const TestColumns& columns, MeasurementFaults& faults) {
  StressStrainTable table;
  std::optional<double> last_time;
  bool has_too_large = false;  // told once: the unit is the cause
  each_row(
      csv, faults,
      [&](const CsvRow& row) {
        if (row.line < columns.first_line) return;
        if (table.strain.size() == max_rows_of_test)
          faults.refuse(row.line, "", "",
                        fmt::format("has more than {} rows; thin them out", max_rows_of_test));
        const auto within = [&](std::optional<double> number, const injury::MeasuredColumn& column,
                                const char* si_unit) {
          const double most = measured_magnitudes(si_unit).most;
          if (!number || std::abs(*number) <= most) return number;
          add_fault(row, column,
                    fmt::format("must be within ±{:g} {}; no foam test gives more", most, si_unit), faults);
          return std::optional<double>();
        };
        const auto value = [&](const injury::MeasuredColumn& column, const char* si_unit) {
          return within(number_in(row, column, faults), column, si_unit);
        };
        const auto strain = within(strain_in(row, columns, faults), columns.strain, "1"),
                   stress = value(columns.stresses.front().of, "Pa");
        if (columns.time) {
          const auto time = value(*columns.time, "s");
          if (!time) return;
          if (last_time && !(*time > *last_time))
            return add_fault(row, *columns.time, "must be later than the previous time", faults);
          last_time = time;
        }
        if (!strain || !stress) return;
        if (std::abs(*strain) >= 1) {
          if (!std::exchange(has_too_large, true))
            add_fault(row, columns.strain, too_large_strain(columns), faults);
          return;
        }
        if (columns.time) table.time.push_back(*last_time);
        table.strain.push_back(*strain);
        table.stress.push_back(*stress);
      },
      &table.remarks);
  faults.throw_if_any();
  return table;
}

/// Turns compression positive; refuses a test without compression or stress.
void judge_test(StressStrainTable& table, const TestColumns& columns, MeasurementFaults& faults) {
  if (table.strain.size() < 2) faults.refuse(0, "", "", "has fewer than two rows");
  const injury::MeasuredColumn& of_stress = columns.stresses.front().of;
  make_compression_positive(table.strain, columns.strain.name, table.remarks);
  make_compression_positive(table.stress, of_stress.name, table.remarks);
  if (table.time.empty() && std::ranges::is_sorted(table.strain, std::ranges::greater())) {
    std::ranges::reverse(table.strain);
    std::ranges::reverse(table.stress);
    table.remarks.push_back(columns.strain.name +
                            ": the strains decrease from row to row, so the rows were read in reverse order");
  }
  if (!(std::ranges::max(table.strain) > min_strain_of_a_test))
    faults.refuse(0, columns.strain.name, "",
                  fmt::format("is nowhere above {:g}: nothing was compressed", min_strain_of_a_test));
  const double min_stress = measured_magnitudes("Pa").least, max_stress = std::ranges::max(table.stress);
  if (max_stress > 0 && max_stress < min_stress)
    faults.refuse(0, of_stress.name, "",
                  fmt::format("is nowhere above {:g} Pa; no foam test gives so little", min_stress));
  if (!(max_stress > 0)) faults.refuse(0, of_stress.name, "", "is 0 throughout");
}

}  // namespace

Reading<TestHeader> read_test_header(const std::filesystem::path& file, const StressStrainColumns& wanted) {
  return reading_of([&]() -> TestHeader {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable csv = csv_table_in(content, faults);
    TestHeader header;
    for (const StressColumn& stress :
         find_test_columns(csv.header, wanted, Beside::stresses, faults).stresses)
      header.stresses.push_back({stress.of.name, stress.rate});
    std::size_t line = 0;
    std::vector<TestColumn> columns = named_test_columns(csv.header, line);
    std::erase_if(columns, [](const TestColumn& column) { return column.kind != TestKind::time; });
    if (columns.size() == 1) header.time = columns.front().of.name;
    return header;
  });
}

Reading<StressStrainTable> read_stress_strain_csv(const std::filesystem::path& file,
                                                  const StressStrainColumns& wanted) {
  return reading_of([&]() -> StressStrainTable {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable csv = csv_table_in(content, faults);
    TestColumns columns = find_test_columns(csv.header, wanted, Beside::one_stress, faults);
    std::vector<std::string> remarks;
    settle_beginning(csv, columns, remarks);
    StressStrainTable table = read_test_rows(csv, columns, faults);
    table.remarks.insert(table.remarks.begin(), remarks.begin(), remarks.end());
    judge_test(table, columns, faults);
    return table;
  });
}

}  // namespace dashpad::input
