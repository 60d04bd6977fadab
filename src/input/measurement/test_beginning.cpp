// The beginning of a compression test: displacements and forces that are not 0 there.

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "input/measurement/test_columns.hpp"
#include "quantities/text.hpp"

namespace dashpad::input {

namespace {

constexpr double noise_of_test = 0.01;     // of the whole travel or the largest force
constexpr double far_from_zero = 0.1;      // of the whole travel
constexpr double preload = 0.1;            // of the largest force, at most
constexpr std::size_t min_level_rows = 5;  // rows
constexpr double level_travel = 0.01;      // of the whole travel, at least
constexpr double noise_of_level = 0.002;   // of the largest force
constexpr double min_level = 0.005;        // of the largest force
constexpr double max_level = 0.05;         // of the largest force; more may be a plateau of the foam
constexpr double levelness = 0.2;          // of the level

/// Strains or displacements and stresses or forces of the rows that have both, as in the file.
struct RawTest {
  std::vector<double> place, force;
  double travel = 0, most = 0;  ///< the largest change of the place since the first row; the largest force
};

RawTest raw_test(const CsvTable& csv, const TestColumns& columns) {
  RawTest test;
  CsvRows rows(csv.text, csv.separator);
  for (CsvRow row; rows.next(row);) {
    if (row.line < csv.header.first_line) continue;
    const ReadNumber place = read_csv_number(field_in(row, columns.strain));
    const ReadNumber force = read_csv_number(field_in(row, columns.stresses.front().of));
    if (place.kind != NumberKind::number || force.kind != NumberKind::number) continue;
    test.place.push_back(place.value);
    test.force.push_back(force.value);
    test.travel = std::max(test.travel, std::abs(place.value - test.place.front()));
    test.most = std::max(test.most, std::abs(force.value));
  }
  return test;
}

std::string as_in_file(double value, const injury::MeasuredColumn& column) {
  return with_unit(brief(value), column.unit);
}

/// A displacement that begins far from 0: from there it counts if there is no force.
void settle_zero(const RawTest& test, TestColumns& columns, std::vector<std::string>& remarks) {
  const double first = test.place.front(), force = std::abs(test.force.front());
  if (!columns.is_displacement || std::abs(first) <= noise_of_test * test.travel) return;
  const injury::MeasuredColumn& column = columns.strain;
  if (force <= noise_of_test * test.most) {
    columns.zero = first;
    remarks.push_back(fmt::format("{}: begins at {} without force and was counted from there", column.name,
                                  as_in_file(first, column)));
  } else if (std::abs(first) > far_from_zero * test.travel && force <= preload * test.most) {
    remarks.push_back(fmt::format(
        "{}: begins at {} with {:.2g} % of the largest force and was counted from 0; if the specimen is "
        "uncompressed there, subtract {} from the displacements",
        column.name, as_in_file(first, column), 100 * force / test.most, as_in_file(first, column)));
  }
}

struct Level {
  std::size_t rows = 0;  ///< 0: there are too few for a level
  double force = 0;
};

/// The level of the force in the first rows.
Level level_at_beginning(const RawTest& test) {
  Level level{1, test.force.front()};
  for (; level.rows < test.force.size(); ++level.rows) {
    const double change = test.force[level.rows] - level.force;
    if (std::abs(change) > std::max(levelness * std::abs(level.force), noise_of_level * test.most)) break;
    level.force += change / static_cast<double>(level.rows + 1);
  }
  const double moved = std::abs(test.place[level.rows - 1] - test.place.front());
  if (level.rows >= min_level_rows && moved >= level_travel * test.travel) return level;
  return {0, test.force.front()};
}

/// Remarks on a force that is not 0 where the test begins: it was not zeroed, or there is a preload.
void tell_of_force(const RawTest& test, const TestColumns& columns, std::vector<std::string>& remarks) {
  if (std::abs(test.place.front() - columns.zero) > noise_of_test * test.travel) return;
  const auto [rows, level] = level_at_beginning(test);
  const double share = std::abs(level) / test.most;
  const bool is_level = rows > 0 && share >= min_level;
  if (!is_level && (share <= noise_of_test || test.place.front() != columns.zero)) return;
  if (share > max_level) return;
  const injury::MeasuredColumn& column = columns.stresses.front().of;
  remarks.push_back(
      fmt::format("{}: {} {}, {:.2g} % of the largest value; if it was not zeroed, subtract {} from all "
                  "values, which was "
                  "not done",
                  column.name, is_level ? fmt::format("in the first {} rows it stays at", rows) : "begins at",
                  as_in_file(level, column), 100 * share, as_in_file(level, column)));
}

}  // namespace

void settle_beginning(const CsvTable& csv, TestColumns& columns, std::vector<std::string>& remarks) {
  if (!csv.header.remark().empty()) remarks.push_back(csv.header.remark());
  if (columns.stresses.empty()) return;
  const RawTest test = raw_test(csv, columns);
  if (test.place.empty() || !(test.most > 0)) return;
  settle_zero(test, columns, remarks);
  tell_of_force(test, columns, remarks);
}

}  // namespace dashpad::input
