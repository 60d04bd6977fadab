#include "report1986/validation/placings.hpp"

#include <algorithm>
#include <stdexcept>

namespace dashpad::report1986 {

namespace {

constexpr double max_placings = 1e6;

using Visit = std::function<void(const std::vector<MeasuredTest>&)>;

/// A group with the indices of its free rows in the vector of tests.
struct Group {
  const UnplacedReadings* readings = nullptr;
  std::vector<std::size_t> rows;
};

std::vector<Group> groups_of(const MeasuredTests& measured, const std::string& column) {
  std::vector<Group> groups;
  for (const UnplacedReadings& unplaced : measured.unplaced) {
    if (unplaced.column != column) continue;
    Group group{&unplaced, {}};
    for (const MeasuredTest* test : free_tests(measured, unplaced))
      group.rows.push_back(static_cast<std::size_t>(test - measured.tests.data()));
    groups.push_back(std::move(group));
  }
  return groups;
}

struct Search {
  std::optional<double> MeasuredTest::*reading;
  const std::vector<Group>& groups;
  const Visit& visit;
  std::vector<MeasuredTest> tests;

  /// Places the readings of group `g` from number `next` on, in the rows from number `row` on.
  void place(std::size_t g, std::size_t next, std::size_t row) {
    if (g == groups.size()) return visit(tests);
    const Group& group = groups[g];
    const std::size_t left = group.readings->readings.size() - next;
    if (left == 0) return place(g + 1, 0, 0);
    for (; row + left <= group.rows.size(); ++row) {
      std::optional<double>& place_of_it = tests[group.rows[row]].*reading;
      place_of_it = group.readings->readings[next];
      place(g, next + 1, row + 1);
      place_of_it.reset();
    }
  }
};

}  // namespace

const MeasuredColumn& measured_column(const std::string& name) {
  const auto* const found = std::ranges::find(measured_columns, name, &MeasuredColumn::name);
  if (found == measured_columns.end()) throw std::out_of_range("no measured column is called " + name);
  return *found;
}

std::vector<const MeasuredTest*> free_tests(const MeasuredTests& measured, const UnplacedReadings& group) {
  const MeasuredColumn& column = measured_column(group.column);
  std::vector<const MeasuredTest*> tests;
  for (const MeasuredTest& test : measured.tests)
    if (test.number >= group.first_test && test.number <= group.last_test && !(test.*column.reading))
      tests.push_back(&test);
  return tests;
}

double placings(std::size_t rows, std::size_t readings) {
  if (readings > rows) return 0;
  double ways = 1;
  for (std::size_t i = 1; i <= readings; ++i)
    ways = ways * static_cast<double>(rows - readings + i) / static_cast<double>(i);
  return ways;
}

double placings(const MeasuredTests& measured, const std::string& column) {
  double ways = 1;
  for (const Group& group : groups_of(measured, column))
    ways *= placings(group.rows.size(), group.readings->readings.size());
  return ways;
}

void for_each_placing(const MeasuredTests& measured, const std::string& column, const Visit& visit) {
  if (placings(measured, column) > max_placings)
    throw std::length_error("too many ways to assign the unassigned readings of " + column);
  const std::vector<Group> groups = groups_of(measured, column);
  Search{measured_column(column).reading, groups, visit, measured.tests}.place(0, 0, 0);
}

}  // namespace dashpad::report1986
