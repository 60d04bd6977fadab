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
constexpr double max_level = 0.05;  // of the largest force; more, not at a strain of 0, may be a plateau
constexpr double of_creep = 0.9;    // of the largest force, from the beginning on
constexpr double levelness = 0.2;   // of the level

/// Strains or displacements and stresses or forces of the rows that have both, as in the file.
struct RawTest {
  std::vector<double> place, force;
  std::vector<std::size_t> line;
  double travel = 0, most = 0;  ///< the largest change of the place since the first row; the largest force
};

RawTest raw_test(const CsvTable& csv, const TestColumns& columns) {
  RawTest test;
  CsvRows rows(csv.text, csv.separator);
  for (CsvRow row; test.place.size() <= max_rows_of_stresses && rows.next(row);) {
    if (row.line < csv.header.first_line) continue;
    const ReadNumber place = read_csv_number(field_in(row, columns.strain));
    const ReadNumber force = read_csv_number(field_in(row, columns.stresses.front().of));
    if (place.kind != NumberKind::number || force.kind != NumberKind::number) continue;
    test.place.push_back(place.value);
    test.force.push_back(force.value);
    test.line.push_back(row.line);
    test.travel = std::max(test.travel, std::abs(place.value - test.place.front()));
    test.most = std::max(test.most, std::abs(force.value));
  }
  return test;
}

std::string as_in_file(double value, const injury::MeasuredColumn& column) {
  return with_unit(brief(value), column.unit);
}

/// Rows around the beginning of the force.
struct Onset {
  std::size_t last = 0;  ///< before the force begins
  std::size_t risen = 0;
};

/// Where the force leaves its noise: it has risen above 1 % of the largest, and begins where it rises without
/// falling to there. The first row is without force.
Onset onset_of(const RawTest& test) {
  const auto force = [&](std::size_t row) { return std::abs(test.force[row]); };
  Onset onset;
  while (force(onset.risen) <= noise_of_test * test.most) ++onset.risen;
  onset.last = onset.risen - 1;
  while (onset.last > 0 && force(onset.last - 1) < force(onset.last)) --onset.last;
  return onset;
}

/// A displacement that begins without force counts from where the force begins; the approach is left out.
void settle_approach(const RawTest& test, TestColumns& columns, std::vector<std::string>& remarks) {
  auto [last, risen] = onset_of(test);
  const injury::MeasuredColumn& column = columns.strain;
  const std::vector<double>& place = test.place;
  const std::string first = as_in_file(place.front(), column);
  std::string from = "which was subtracted";
  const bool is_own_zero =
      std::abs(place[last]) <= noise_of_test * test.travel || place[last] * place[risen] < 0;
  if (is_own_zero) {
    while (last + 1 < risen && place[last] * place[risen] < 0) ++last;
    from = "so the 0 of the file was kept";
  } else {
    columns.zero = place[last];
  }
  columns.first_line = test.line[last];
  if (last == 0)
    remarks.push_back(
        fmt::format("{}: begins at {} without force and was counted from there", column.name, first));
  else
    remarks.push_back(
        fmt::format("{}: begins at {} without force; the force begins at {}, {}; {} before "
                    "{} left out",
                    column.name, first, as_in_file(place[last], column), from, plural(last, "row"),
                    last == 1 ? "was" : "were"));
}

/// Remarks on a displacement that begins at 0 long before the force. A soft foam looks the same.
void tell_of_gap(const RawTest& test, const injury::MeasuredColumn& column,
                 std::vector<std::string>& remarks) {
  const double begin = test.place[onset_of(test).last];
  if (std::abs(begin - test.place.front()) <= far_from_zero * test.travel) return;
  remarks.push_back(fmt::format(
      "{}: begins at 0 without force, and the force begins at {}; if the specimen is met there, subtract {} "
      "from the displacements",
      column.name, as_in_file(begin, column), as_in_file(begin, column)));
}

/// A displacement that begins elsewhere than at 0, or before the force.
void settle_zero(const RawTest& test, TestColumns& columns, std::vector<std::string>& remarks) {
  const double first = test.place.front(), force = std::abs(test.force.front());
  if (!columns.is_displacement) return;
  const injury::MeasuredColumn& column = columns.strain;
  const bool begins_at_zero = std::abs(first) <= noise_of_test * test.travel;
  if (force <= noise_of_test * test.most)
    begins_at_zero ? tell_of_gap(test, column, remarks) : settle_approach(test, columns, remarks);
  else if (std::abs(first) > far_from_zero * test.travel && force <= preload * test.most)
    remarks.push_back(fmt::format(
        "{}: begins at {} with {:.2g} % of the largest force and was counted from 0; if the specimen is "
        "uncompressed there, subtract {} from the displacements",
        column.name, as_in_file(first, column), 100 * force / test.most, as_in_file(first, column)));
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
  const double begin = std::abs(test.place.front() - columns.zero);
  if (begin > noise_of_test * test.travel && columns.first_line <= test.line.front()) return;
  const auto [rows, level] = level_at_beginning(test);
  const double share = std::abs(level) / test.most;
  const bool is_level = rows > 0 && share >= min_level;
  const bool is_told =
      begin == 0 ? (is_level || share > noise_of_test) && share < of_creep : is_level && share <= max_level;
  if (!is_told) return;
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
