#include "report1986/validation/measured_tests_table.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <string>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "report1986/validation/measured_tests_columns.hpp"
#include "report1986/validation/measured_tests_csv.hpp"
#include "report1986/validation/measured_tests_words.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double energy_tolerance = 0.01;  // relative: the speeds have three digits

std::vector<std::string> columns_of_tests() {
  std::vector<std::string> columns{"test", "projectile", "weight_lb", "support", "speed_mph", "energy_in_lb"};
  for (const MeasuredColumn& column : measured_columns) columns.emplace_back(column.name);
  return columns;
}

MeasuredTest read_test(CsvTable& table, const CsvRecord& record) {
  MeasuredTest test;
  test.number = table.whole(record, "test");
  test.projectile = read_projectile(table, record);
  test.weight_lb = table.number(record, "weight_lb");
  test.support = read_support(table, record);
  test.speed_mph = table.number(record, "speed_mph");
  test.energy_in_lb = table.number(record, "energy_in_lb");
  for (const MeasuredColumn& column : measured_columns)
    test.*column.reading = table.reading(record, column.name, column.is_fraction);
  return test;
}

void check_physics(CsvTable& table, const CsvRecord& record, const MeasuredTest& test) {
  const double energy = impact_energy_in_lb(test.weight_lb, test.speed_mph);
  if (std::abs(test.energy_in_lb - energy) > energy_tolerance * energy)
    table.fault(record, "energy_in_lb",
                fmt::format("must be within 1 % of M V^2/2, which is {:.1f} in.lb", energy));
  if (test.rebound_mph && *test.rebound_mph >= test.speed_mph)
    table.fault(record, "rebound_mph", "must be less than the speed of the impact");
  if (test.time_to_peak_ms && test.total_time_ms && *test.time_to_peak_ms >= *test.total_time_ms)
    table.fault(record, "time_to_peak_ms", "must be less than the total time");
}

/// Among all rows: numbers go up, a projectile has one weight, both projectiles are there.
void check_rows(CsvTable& table, const std::vector<MeasuredTest>& tests) {
  std::map<Projectile, double> weights;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const CsvRecord& record = table.records()[i];
    if (i > 0 && tests[i].number > 0 && tests[i].number <= tests[i - 1].number)
      table.fault(record, "test", "must be more than that of the row before");
    if (!std::isfinite(tests[i].weight_lb)) continue;
    const double weight = weights.emplace(tests[i].projectile, tests[i].weight_lb).first->second;
    if (weight != tests[i].weight_lb)
      table.fault(record, "weight_lb", fmt::format("must be that of the rows before: {:g}", weight));
  }
  for (const Projectile projectile : {Projectile::aluminium, Projectile::steel})
    if (!tests.empty() && std::ranges::count(tests, projectile, &MeasuredTest::projectile) == 0)
      table.fault(std::string("has no test of the projectile ") + to_string(projectile));
}

std::vector<double> read_readings(CsvTable& table, const CsvRecord& record, bool is_fraction) {
  std::vector<double> readings;
  std::istringstream words(table.text(record, "readings"));
  for (std::string word; words >> word;) {
    double value = 0;
    const std::string rule = why_no_reading(word, is_fraction, value);
    if (!rule.empty()) table.fault(record, "readings", fmt::format("\"{}\": {}", word, rule));
    readings.push_back(value);
  }
  return readings;
}

bool share_tests(const UnplacedReadings& one, const UnplacedReadings& other) {
  return one.column == other.column && one.first_test <= other.last_test && other.first_test <= one.last_test;
}

/// The rule about the rows that a group breaks; empty if none.
std::string broken_rule(const UnplacedReadings& group, const MeasuredTests& measured) {
  const auto exists = [&](int number) {
    return std::ranges::count(measured.tests, number, &MeasuredTest::number) > 0;
  };
  if (group.first_test > group.last_test) return "the last test must not come before the first";
  for (const int number : {group.first_test, group.last_test})
    if (!exists(number)) return fmt::format("there is no test {} in table-3-1.csv", number);
  for (const MeasuredTest& test : measured.tests)
    if (test.number >= group.first_test && test.number <= group.last_test &&
        test.*measured_column(group.column).reading)
      return fmt::format("test {} has a reading of its own; the group must not reach over it", test.number);
  const std::size_t rows = free_tests(measured, group).size();
  if (group.readings.size() > rows)
    return fmt::format("{} readings cannot belong to {} tests", group.readings.size(), rows);
  for (const UnplacedReadings& other : measured.unplaced)
    if (share_tests(other, group))
      return fmt::format("shares tests with the group {} to {}", other.first_test, other.last_test);
  return "";
}

}  // namespace

std::vector<MeasuredTest> read_certain_rows(const std::filesystem::path& file,
                                            std::vector<input::Fault>& faults) {
  CsvTable table(file, columns_of_tests(), faults);
  std::vector<MeasuredTest> tests;
  for (const CsvRecord& record : table.records()) {
    tests.push_back(read_test(table, record));
    check_physics(table, record, tests.back());
  }
  check_rows(table, tests);
  return tests;
}

std::vector<UnplacedReadings> read_unplaced(const std::filesystem::path& file,
                                            const std::vector<MeasuredTest>& tests,
                                            std::vector<input::Fault>& faults) {
  std::vector<std::string> names;
  for (const MeasuredColumn& column : measured_columns) names.emplace_back(column.name);

  CsvTable table(file, {"column", "first_test", "last_test", "readings"}, faults);
  MeasuredTests measured{tests, {}};
  const bool rows_are_known = !tests.empty() && std::ranges::count(tests, 0, &MeasuredTest::number) == 0;
  for (const CsvRecord& record : table.records()) {
    const auto column = table.choice(record, "column", names);
    const int first = table.whole(record, "first_test");
    const int last = table.whole(record, "last_test");
    if (!column || first == 0 || last == 0) continue;
    UnplacedReadings group{names[*column], first, last,
                           read_readings(table, record, measured_columns[*column].is_fraction)};
    const std::string rule = rows_are_known ? broken_rule(group, measured) : "";
    if (!rule.empty()) table.fault(record, "column", rule);
    measured.unplaced.push_back(std::move(group));
  }
  return measured.unplaced;
}

}  // namespace dashpad::report1986
