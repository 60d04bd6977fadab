/// Reading of the data of the validation study: what is in the files, and every fault at once.

#include "dashpad/report1986/validation/measured_tests.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <string>

#include "report1986/validation/placings.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::report1986 {
namespace {

namespace fs = std::filesystem;
using test::TemporaryFolder;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

const fs::path data_folder = fs::path(DASHPAD_SOURCE_DIR) / "data" / "validation";

/// A copy of the data in which some text is another.
class Data {
 public:
  Data() { fs::copy(data_folder, folder_.path(), fs::copy_options::recursive); }

  Data& replace(const std::string& file, const std::string& old, const std::string& now) {
    std::ifstream stream(folder_.path() / file);
    std::string text(std::istreambuf_iterator<char>(stream), {});
    const auto at = text.find(old);
    EXPECT_NE(at, std::string::npos) << file << " does not hold " << old;
    if (at != std::string::npos) text.replace(at, old.size(), now);
    folder_.write(file, text);
    return *this;
  }
  Data& remove(const std::string& file) {
    fs::remove(folder_.path() / file);
    return *this;
  }
  /// The faults, without the folder.
  [[nodiscard]] std::vector<std::string> faults() const {
    std::vector<input::Fault> faults;
    read_validation_data(folder_.path(), faults);
    std::vector<std::string> texts;
    for (input::Fault& fault : faults) {
      fault.file = fs::path(fault.file).filename().string();
      texts.push_back(to_string(fault));
    }
    return texts;
  }

 private:
  TemporaryFolder folder_;
};

constexpr const char* rows = "table-3-1.csv";
constexpr const char* groups = "table-3-1-unplaced.csv";

ValidationData report() {
  std::vector<input::Fault> faults;
  ValidationData data = read_validation_data(data_folder, faults);
  for (const input::Fault& fault : faults) ADD_FAILURE() << to_string(fault);
  return data;
}

TEST(measured_tests, rows_of_the_report) {
  const ValidationData data = report();
  ASSERT_EQ(data.measured.tests.size(), 33U);
  const MeasuredTest& first = data.measured.tests.front();
  EXPECT_EQ(first.number, 1);
  EXPECT_EQ(first.projectile, Projectile::aluminium);
  EXPECT_EQ(first.support, TestSupport::load_cell);
  EXPECT_EQ(first.weight_lb, 4.13);
  EXPECT_EQ(first.speed_mph, 10.6);
  EXPECT_EQ(first.rebound_mph, 3.7);
  EXPECT_EQ(first.peak_force_lb, 486);
  EXPECT_FALSE(first.time_to_peak_ms);
  EXPECT_FALSE(peak_strain(first));
  const MeasuredTest& on_plate = data.measured.tests[25];
  EXPECT_EQ(on_plate.number, 26);
  EXPECT_EQ(on_plate.support, TestSupport::plate);
  EXPECT_EQ(peak_strain(on_plate), 0.84);
  const MeasuredTest& last = data.measured.tests.back();
  EXPECT_EQ(last.projectile, Projectile::steel);
  EXPECT_EQ(last.time_to_peak_ms, 6.5);
}

TEST(measured_tests, unplaced_readings_and_their_rows) {
  const ValidationData data = report();
  ASSERT_EQ(data.measured.unplaced.size(), 12U);
  const UnplacedReadings& rebound = data.measured.unplaced.front();
  EXPECT_EQ(rebound.column, "rebound_mph");
  EXPECT_EQ(rebound.readings.size(), 13U);
  EXPECT_EQ(free_tests(data.measured, rebound).size(), 16U);
  EXPECT_EQ(free_tests(data.measured, rebound).front()->number, 3);
  const UnplacedReadings& force = data.measured.unplaced[5];
  EXPECT_THAT(force.readings, ElementsAre(1060, 686, 636, 1873, 819));
}

TEST(measured_tests, supports_constants_and_table_3_2) {
  const ValidationData data = report();
  EXPECT_EQ(data.plate_stiffness_lb_per_in, 5180);
  EXPECT_EQ(data.pad_thickness_in, 1.2);
  ASSERT_EQ(data.load_cell.size(), 2U);
  EXPECT_EQ(data.load_cell[1].force_lb, 9860);
  EXPECT_EQ(data.constant("energy_trend_factor"), 6876);
  EXPECT_THROW((void)data.constant("no such"), std::out_of_range);
  ASSERT_EQ(data.table_3_2.size(), 2U);
  EXPECT_EQ(data.table_3_2[1].rebound_mph, 6);
}

TEST(measured_tests, mean_of_both_strains) {
  MeasuredTest test;
  EXPECT_FALSE(peak_strain(test));
  test.diameter_strain = 0.9;
  EXPECT_EQ(peak_strain(test), 0.9);
  test.plug_strain = 0.8;
  EXPECT_DOUBLE_EQ(*peak_strain(test), 0.85);
}

TEST(measured_tests, all_faults_of_all_files_at_once) {
  Data data;
  data.replace(rows, "5,aluminium,4.13,load-cell,13.2,290", "4,brass,nan,floor,-13.2,ten");
  data.replace(groups, "total_time_ms,1,18", "total_tme_ms,1,18");
  data.replace("table-3-2.csv", "steel,14.6", "steel,fast");
  data.replace("printed-constants.csv", "\ntravel_in,1.65,in,", "\ntravel_in,1.65,,");
  data.replace("supports.csv", "0.1956", "0.0556");
  EXPECT_THAT(
      data.faults(),
      ElementsAre(HasSubstr("table-3-1.csv:9: projectile = brass: must be one of aluminium, steel"),
                  HasSubstr("table-3-1.csv:9: weight_lb = nan: must be a finite number"),
                  HasSubstr("table-3-1.csv:9: support = floor: must be one of load-cell, plate"),
                  HasSubstr("table-3-1.csv:9: speed_mph = -13.2: must be more than 0"),
                  HasSubstr("table-3-1.csv:9: energy_in_lb = ten: must be a number"),
                  HasSubstr("table-3-1.csv:9: test = 4: must be more than that of the previous row"),
                  HasSubstr("table-3-1-unplaced.csv:6: column = total_tme_ms: must be one of"),
                  HasSubstr("table-3-2.csv:4: speed_mph = fast: must be a number"),
                  HasSubstr("printed-constants.csv:16: unit: is missing"),
                  HasSubstr("supports.csv:7: deflection_in = 0.0556: must be more than that of the")));
}

TEST(measured_tests, byte_order_mark_is_no_column) {
  EXPECT_TRUE(Data().replace("table-3-2.csv", "#", "\xef\xbb\xbf#").faults().empty());
  EXPECT_TRUE(Data().replace("supports.csv", "#", "\xef\xbb\xbf#").faults().empty());
}

TEST(measured_tests, files_that_are_no_tables) {
  Data data;
  data.remove(rows).remove(groups);
  data.replace("table-3-2.csv", "projectile,speed_mph", "speed_mph,projectile");
  data.replace("supports.csv", "plate,1,5180", "plate,1");
  EXPECT_THAT(
      data.faults(),
      ElementsAre("table-3-1.csv: no such file", "table-3-1-unplaced.csv: no such file",
                  HasSubstr("table-3-2.csv:3: must name these columns, in this order: projectile, speed_mph"),
                  HasSubstr("supports.csv:8: must have 3 fields, not 2"),
                  "supports.csv: has no point for the plate"));
}

struct WrongText {
  const char* name;
  const char* file;
  const char* old;
  const char* now;
  const char* fault;
};
void PrintTo(const WrongText& wrong, std::ostream* out) { *out << wrong.name; }

class measured_tests_rules : public ::testing::TestWithParam<WrongText> {};

TEST_P(measured_tests_rules, is_a_fault) {
  Data data;
  data.replace(GetParam().file, GetParam().old, GetParam().now);
  EXPECT_THAT(data.faults(), ElementsAre(HasSubstr(GetParam().fault)));
}

constexpr WrongText wrong_texts[] = {
    {"energy", rows, "13.2,290", "13.2,300",
     "energy_in_lb = 300: must be within 1 % of M V^2/2, which is 289.8"},
    {"rebound", rows, "187,3.7", "187,10.6", "rebound_mph = 10.6: must be less than the impact speed"},
    {"weight", rows, "3,aluminium,4.13,load-cell,12.9,277", "3,aluminium,4.14,load-cell,12.9,277",
     "weight_lb = 4.14: must be 4.13, as in earlier rows for this projectile"},
    {"strain", rows, "0.82", "1", "plug_strain = 1: must be less than 1"},
    {"infinite", rows, "4390", "inf", "peak_force_lb = inf: must be a finite number"},
    {"half_a_test", rows, "\n1,aluminium", "\n0.5,aluminium", "test = 0.5: must be a whole number"},
    {"total_time", rows, "354.5,9.1,,,", "354.5,9.1,5.0,4.0,",
     "time_to_peak_ms = 5.0: must be less than the total time"},
    {"too_many", groups, "1060 686 636 1873 819", "1 2 3 4 5 6 7 8", "must be at most 7, not 8"},
    {"over_a_reading", groups, "peak_force_lb,7,13", "peak_force_lb,6,13", "test 6 has a reading of its own"},
    {"no_test", groups, "rebound_mph,3,18", "rebound_mph,0.1,18", "first_test = 0.1: must be a whole number"},
    {"backwards", groups, "peak_force_lb,7,13", "peak_force_lb,13,7", "the last test must not come before"},
    {"beyond", groups, "plug_strain,28,33", "plug_strain,28,34", "there is no test 34 in table-3-1.csv"},
    {"shared", groups, "plug_strain,19,24", "plug_strain,18,24",
     "shares tests with the group for tests 1 to 18"},
    {"reading", groups, "0.93", "-0.93", "\"-0.93\" must be more than 0"},
    {"no_reading", groups, "19,24,0.94", "19,24,", "readings: is missing"},
    {"twice", "printed-constants.csv", "\nexpected_travel_in", "\ntravel_in,1,in,here\nexpected_travel_in",
     "name = travel_in: appears twice"},
    {"no_stiffness", "supports.csv", "plate,1,5180", "plate,1e300,1e-300",
     "force_lb = 1e-300: gives a stiffness that is too large or too small"},
    {"endless_stiffness", "supports.csv", "plate,1,5180", "plate,1e-300,1e300",
     "force_lb = 1e300: gives a stiffness that is too large or too small"},
    {"two_plates", "supports.csv", "plate,1,5180", "plate,1,5180\nplate,2,10360",
     "the plate must have only one point"},
};
INSTANTIATE_TEST_SUITE_P(each, measured_tests_rules, ::testing::ValuesIn(wrong_texts),
                         [](const auto& rule) { return std::string(rule.param.name); });

TEST(measured_tests, constant_that_the_study_needs) {
  Data data;
  data.replace("printed-constants.csv", "expected_travel_in", "expected_trip_in");
  EXPECT_THAT(data.faults(),
              ElementsAre("printed-constants.csv: does not contain the constant expected_travel_in"));
  data.replace("printed-constants.csv", "inch_per_s_of_mph", "inch_per_s_of_knot");
  EXPECT_THAT(data.faults(),
              ElementsAre("printed-constants.csv: does not contain the constant inch_per_s_of_mph",
                          "printed-constants.csv: does not contain the constant expected_travel_in"));
}

}  // namespace
}  // namespace dashpad::report1986
