#include "dashpad/input/measurement/tables.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "input/measurement/test_columns.hpp"
#include "quantities/magnitude_bounds.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {
namespace {

constexpr std::size_t max_rows = 10'000;
constexpr double min_strain = 1e-12;  // the largest of a history; rounding matters below

constexpr double noise_share = 0.01;  // of the largest strain: what is less below 0 is noise

/// The least and the largest number in the column of the strains.
std::pair<double, double> range_of_strains(const CsvTable& csv, const injury::MeasuredColumn& column) {
  std::pair<double, double> range{0, 0};
  CsvRows rows(csv.text, csv.separator);
  for (CsvRow row; rows.next(row);) {
    const ReadNumber read = read_csv_number(field_in(row, column));
    if (row.line < csv.header.first_line || read.kind != NumberKind::number) continue;
    range = {std::min(range.first, read.value), std::max(range.second, read.value)};
  }
  return range;
}

StrainTable read_rows(const CsvTable& csv, const TestColumns& columns, MeasurementFaults& faults) {
  StrainTable table;
  const auto [least, largest] = range_of_strains(csv, columns.strain);
  const double side = -least > largest ? -1 : 1;
  const double noise = noise_share * columns.strain.factor * std::max(-least, largest);
  std::size_t below = 0;
  std::optional<double> last_time;
  std::size_t rows = 0, repeated = 0;
  each_row(
      csv, faults,
      [&](const CsvRow& row) {
        const auto time = number_in(row, *columns.time, faults);
        auto strain = strain_in(row, columns, faults);
        if (!time || !strain) return;
        *strain *= side;
        if ((*strain < 0 && *strain > -noise) || (rows == 0 && *strain > 0 && *strain < noise)) {
          *strain = 0;
          ++below;
        }
        if (rows++ == max_rows)
          faults.refuse(row.line, "", "", fmt::format("has more than {} rows", max_rows));
        if (!table.time.empty() && *time == table.time.back() && *strain == table.strain.back()) {
          ++repeated;
          return;
        }
        // The first time will be subtracted from all others, so times are compared after that rounding.
        const double begin = table.time.empty() ? *time : table.time.front();
        if (!std::isfinite(*time - begin))
          add_fault(row, *columns.time, rule_for(NumberKind::out_of_range), faults);
        else if (last_time && !(*time - begin > *last_time - begin))
          add_fault(row, *columns.time,
                    *time > *last_time
                        ? "cannot be told apart from the previous time, since both are too far from the first"
                        : "must be later than the previous time",
                    faults);
        last_time = time;
        if (!(*strain >= 0 && *strain < 1))
          add_fault(row, columns.strain, "must be at least 0 and below 1 (100 %), with compression positive",
                    faults);
        else if (rows == 1 && *strain != 0)
          add_fault(row, columns.strain, "must be 0, since the history begins at first contact", faults);
        table.time.push_back(*time);
        table.strain.push_back(*strain);
      },
      &table.remarks);
  faults.throw_if_any();
  if (side < 0)
    table.remarks.push_back(columns.strain.name +
                            ": compression is negative in the file; its sign was reversed");
  if (below > 0)
    table.remarks.push_back(fmt::format("{} within the noise around 0 {} set to 0", plural(below, "strain"),
                                        below == 1 ? "was" : "were"));
  if (repeated > 0)
    table.remarks.push_back(fmt::format(
        "{} {} left out", repeated,
        repeated == 1 ? "row that repeats the previous one was" : "rows that repeat the previous one were"));
  return table;
}

/// Refuses a history that is too short or too long, or without strain.
void judge_history(const StrainTable& table, const TestColumns& columns, MeasurementFaults& faults) {
  if (table.time.size() < 2) faults.refuse(0, "", "", "has only one row; a history needs at least two");
  const double span = table.time.back() - table.time.front(), most = measured_magnitudes("s").most;
  if (!(span <= most))
    faults.refuse(0, columns.time->name, "",
                  fmt::format("spans {:.3g} s, but must not exceed {:g} s", span, most));
  if (const double largest = std::ranges::max(table.strain); !(largest > min_strain))
    faults.refuse(0, columns.strain.name, "", largest == 0 ? "is 0 throughout" : "is below 1e-12 throughout");
}

}  // namespace

Reading<StrainTable> read_strain_csv(const std::filesystem::path& file, const StressStrainColumns& wanted) {
  return reading_of([&]() -> StrainTable {
    MeasurementFaults faults(file.string());
    const std::string content = read_measurement(file);
    const CsvTable csv = csv_table_in(content, faults);
    const TestColumns columns = find_test_columns(csv.header, wanted, Beside::time, faults);
    require_no_numbers(csv.header, name_columns(csv.header).names, {*columns.time, columns.strain}, faults,
                       1);
    StrainTable table = read_rows(csv, columns, faults);
    judge_history(table, columns, faults);
    if (!csv.header.remark().empty()) table.remarks.push_back(csv.header.remark());
    if (const double begin = table.time.front(); begin != 0) {
      for (double& time : table.time) time -= begin;
      table.remarks.push_back(fmt::format(
          "the first time, {:g} s, was taken as first contact and subtracted from all times", begin));
    }
    return table;
  });
}

}  // namespace dashpad::input
