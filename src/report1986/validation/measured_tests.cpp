#include "dashpad/report1986/validation/measured_tests.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <sstream>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "report1986/validation/measured_tests_csv.hpp"
#include "report1986/validation/placings.hpp"

namespace dashpad::report1986 {

namespace {

namespace fs = std::filesystem;

Projectile read_projectile(const CsvRecord& record) {
  return record.choice("projectile", {"aluminium", "steel"}) == 1 ? Projectile::steel : Projectile::aluminium;
}

TestSupport read_support(const CsvRecord& record) {
  return record.choice("support", {"load-cell", "plate"}) == 1 ? TestSupport::plate : TestSupport::load_cell;
}

// --- Table 3-1 in two files: the certain rows, and the readings whose rows are lost ---

constexpr double energy_tolerance = 0.01;  // relative: the speeds have three digits

std::vector<std::string> columns_of_tests() {
  std::vector<std::string> columns{"test", "projectile", "weight_lb", "support", "speed_mph", "energy_in_lb"};
  for (const MeasuredColumn& column : measured_columns) columns.emplace_back(column.name);
  return columns;
}

MeasuredTest read_test(const CsvRecord& record) {
  MeasuredTest test;
  test.number = record.whole("test");
  test.projectile = read_projectile(record);
  test.weight_lb = record.number("weight_lb");
  test.support = read_support(record);
  test.speed_mph = record.number("speed_mph");
  test.energy_in_lb = record.number("energy_in_lb");
  for (const MeasuredColumn& column : measured_columns)
    test.*column.reading = record.reading(column.name, column.is_fraction());
  return test;
}

void check_physics(const CsvRecord& record, const MeasuredTest& test) {
  const double energy = impact_energy_in_lb(test.weight_lb, test.speed_mph);
  if (std::abs(test.energy_in_lb - energy) > energy_tolerance * energy)
    record.fault("energy_in_lb", fmt::format("must be within 1 % of M V^2/2, which is {:.1f} in.lb", energy));
  if (test.rebound_mph && *test.rebound_mph >= test.speed_mph)
    record.fault("rebound_mph", "must be less than the impact speed");
  if (test.time_to_peak_ms && test.total_time_ms && *test.time_to_peak_ms >= *test.total_time_ms)
    record.fault("time_to_peak_ms", "must be less than the total time");
}

/// Checks that numbers increase, that each projectile has one weight, and that both projectiles occur.
void check_rows(CsvTable& table, const std::vector<MeasuredTest>& tests) {
  std::map<Projectile, double> weights;
  for (std::size_t i = 0; i < tests.size(); ++i) {
    const CsvRecord& record = table.records[i];
    if (i > 0 && tests[i].number > 0 && tests[i].number <= tests[i - 1].number)
      record.fault("test", "must be more than that of the previous row");
    if (!std::isfinite(tests[i].weight_lb)) continue;
    const double weight = weights.emplace(tests[i].projectile, tests[i].weight_lb).first->second;
    if (weight != tests[i].weight_lb)
      record.fault("weight_lb", fmt::format("must be {:g}, as in earlier rows for this projectile", weight));
  }
  for (const Projectile projectile : {Projectile::aluminium, Projectile::steel})
    if (!tests.empty() && std::ranges::count(tests, projectile, &MeasuredTest::projectile) == 0)
      table.fault(fmt::format("has no test with the {} projectile", to_string(projectile)));
}

std::vector<double> read_readings(const CsvRecord& record, bool is_fraction) {
  std::vector<double> readings;
  std::istringstream words(record.text("readings"));
  for (std::string word; words >> word;) {
    double value = 0;
    const std::string rule = why_no_reading(word, is_fraction, value);
    if (!rule.empty()) record.fault("readings", fmt::format("\"{}\" {}", word, rule));
    readings.push_back(value);
  }
  return readings;
}

/// The rule that a group breaks; empty if none.
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
      return fmt::format("test {} has a reading of its own; the group must not include it", test.number);
  const std::size_t rows = free_tests(measured, group).size();
  if (group.readings.size() > rows)
    return fmt::format("the number of readings must be at most {}, not {}", rows, group.readings.size());
  for (const UnplacedReadings& other : measured.unplaced)
    if (other.column == group.column && other.first_test <= group.last_test &&
        group.first_test <= other.last_test)
      return fmt::format("shares tests with the group for tests {} to {}", other.first_test, other.last_test);
  return "";
}

/// Reads the certain part of Table 3-1. Checks that each energy is M V^2/2, that a rebound is slower than the
/// impact, and that the peak precedes the end.
std::vector<MeasuredTest> read_certain_rows(const fs::path& file, std::vector<input::Fault>& faults) {
  CsvTable table(file, columns_of_tests(), faults);
  std::vector<MeasuredTest> tests;
  for (const CsvRecord& record : table.records) {
    tests.push_back(read_test(record));
    check_physics(record, tests.back());
  }
  check_rows(table, tests);
  return tests;
}

/// Reads the readings whose rows are lost. Checks that each group fits its rows: tests that exist, have no
/// reading of their own, suffice in number, and belong to one group of the column only.
std::vector<UnplacedReadings> read_unplaced(const fs::path& file, const std::vector<MeasuredTest>& tests,
                                            std::vector<input::Fault>& faults) {
  std::vector<std::string> names;
  for (const MeasuredColumn& column : measured_columns) names.emplace_back(column.name);

  CsvTable table(file, {"column", "first_test", "last_test", "readings"}, faults);
  MeasuredTests measured{tests, {}};
  const bool rows_are_known = !tests.empty() && std::ranges::count(tests, 0, &MeasuredTest::number) == 0;
  for (const CsvRecord& record : table.records) {
    const auto column = record.choice("column", names);
    const int first = record.whole("first_test");
    const int last = record.whole("last_test");
    if (!column || first == 0 || last == 0) continue;
    UnplacedReadings group{names[*column], first, last,
                           read_readings(record, measured_columns[*column].is_fraction())};
    const std::string rule = rows_are_known ? broken_rule(group, measured) : "";
    if (!rule.empty()) record.fault("column", rule);
    measured.unplaced.push_back(std::move(group));
  }
  return measured.unplaced;
}

/// The printed constants that the study needs.
constexpr const char* constants_of_the_study =
    "pad_thickness_in inch_per_s_of_mph tests load_cell_tests plate_tests aluminium_load_cell_tests "
    "steel_load_cell_tests force_readings plug_only_strains strains_by_both load_cell_first_slope_lb_per_in "
    "load_cell_last_slope_lb_per_in travel_in expected_travel_in least_excess_time_ms "
    "greatest_excess_time_ms shortest_elastic_time_ms longest_elastic_time_ms nominal_stress_tests "
    "nominal_stress_clustered_tests rebound_readings rebound_ratio_load_cell rebound_ratio_plate "
    "plate_speed_mph plate_peak_force_lb plate_deflection_in least_storage_fraction "
    "greatest_storage_fraction energy_trend_factor energy_trend_exponent energy_trend_from_in_lb "
    "excess_of_predicted_time_ms stiffness_of_time_aluminium_lb_per_in stiffness_of_time_steel_lb_per_in "
    "expected_force_ratio_aluminium_low_speed expected_force_ratio_aluminium_high_speed "
    "expected_force_ratio_steel_low_speed expected_force_ratio_steel_high_speed "
    "force_ratio_aluminium_low_speed force_ratio_aluminium_high_speed force_ratio_steel_low_speed "
    "force_ratio_steel_high_speed";

/// Checks that deflections and forces increase, and that the plate has one point.
void read_supports(const fs::path& file, ValidationData& data, std::vector<input::Fault>& faults) {
  CsvTable table(file, {"support", "deflection_in", "force_lb"}, faults);
  bool has_plate = false;
  for (const CsvRecord& record : table.records) {
    const TestSupport support = read_support(record);
    const StaticPoint point{record.number("deflection_in"), record.number("force_lb")};
    if (support == TestSupport::plate) {
      if (has_plate) record.fault("support", "the plate must have only one point, because it is linear");
      has_plate = true;
      data.plate_stiffness_lb_per_in = point.force_lb / point.deflection_in;
      if (data.plate_stiffness_lb_per_in == 0 || std::isinf(data.plate_stiffness_lb_per_in))
        record.fault("force_lb", "gives a stiffness that is too large or too small to compute with");
      continue;
    }
    const StaticPoint last = data.load_cell.empty() ? StaticPoint{} : data.load_cell.back();
    if (point.deflection_in <= last.deflection_in)
      record.fault("deflection_in", "must be more than that of the previous point");
    if (point.force_lb <= last.force_lb)
      record.fault("force_lb", "must be more than that of the previous point");
    data.load_cell.push_back(point);
  }
  if (!table.records.empty() && data.load_cell.empty()) table.fault("has no point for the load cell");
  if (!table.records.empty() && !has_plate) table.fault("has no point for the plate");
}

void read_constants(const fs::path& file, ValidationData& data, std::vector<input::Fault>& faults) {
  CsvTable table(file, {"name", "value", "unit", "where"}, faults);
  for (const CsvRecord& record : table.records) {
    PrintedConstant constant{record.text("name"), record.number("value"), record.text("unit"),
                             record.text("where")};
    if (std::ranges::count(data.printed, constant.name, &PrintedConstant::name) > 0)
      record.fault("name", "appears twice");
    data.printed.push_back(std::move(constant));
  }
  if (table.records.empty()) return;
  std::istringstream names(constants_of_the_study);
  for (std::string name; names >> name;)
    if (std::ranges::count(data.printed, name, &PrintedConstant::name) == 0)
      table.fault("does not contain the constant " + name);
}

void read_table_3_2(const fs::path& file, ValidationData& data, std::vector<input::Fault>& faults) {
  CsvTable table(file,
                 {"projectile", "speed_mph", "energy_in_lb", "peak_force_lb", "rebound_energy_in_lb",
                  "support_energy_in_lb", "speed_ratio", "rebound_mph"},
                 faults);
  for (const CsvRecord& record : table.records)
    data.table_3_2.push_back({read_projectile(record), record.number("speed_mph"),
                              record.number("energy_in_lb"), record.number("peak_force_lb"),
                              record.number("rebound_energy_in_lb"), record.number("support_energy_in_lb"),
                              record.number("speed_ratio", true), record.number("rebound_mph")});
}

}  // namespace

std::optional<double> peak_strain(const MeasuredTest& test) {
  if (test.plug_strain && test.diameter_strain) return (*test.plug_strain + *test.diameter_strain) / 2;
  return test.plug_strain ? test.plug_strain : test.diameter_strain;
}

double ValidationData::constant(const std::string& name) const {
  const auto found = std::ranges::find(printed, name, &PrintedConstant::name);
  if (found == printed.end()) throw std::out_of_range("no printed constant is called " + name);
  return found->value;
}

ValidationData read_validation_data(const fs::path& folder, std::vector<input::Fault>& faults) {
  ValidationData data;
  const std::size_t before = faults.size();
  const auto table = [&](const char* name) {
    data.files.push_back({"a table of the measured tests", folder / name});
    return data.files.back().file;
  };
  data.measured.tests = read_certain_rows(table("table-3-1.csv"), faults);
  data.measured.unplaced = read_unplaced(table("table-3-1-unplaced.csv"), data.measured.tests, faults);
  read_table_3_2(table("table-3-2.csv"), data, faults);
  read_constants(table("printed-constants.csv"), data, faults);
  read_supports(table("supports.csv"), data, faults);
  if (faults.size() == before) data.pad_thickness_in = data.constant("pad_thickness_in");
  return data;
}

const char* to_string(Projectile projectile) {
  return projectile == Projectile::aluminium ? "aluminium" : "steel";
}

const char* to_string(TestSupport support) {
  return support == TestSupport::load_cell ? "load cell" : "flexible plate";
}

}  // namespace dashpad::report1986
