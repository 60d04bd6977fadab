/// Which readings a fit does not see, and what the scores make of them.

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <set>

#include "dashpad/report1986/validation/study.hpp"

namespace dashpad::report1986 {
namespace {

Reading reading(int test, Projectile projectile, TestSupport support, double speed_mph) {
  return {test, {projectile, support, speed_mph, held_out_radius_in}, Quantity::peak_force, 1000};
}

/// Thirteen tests on the load cell with two repeated speeds, three on the plate at one speed.
std::vector<Reading> made_up() {
  using enum Projectile;
  using enum TestSupport;
  std::vector<Reading> readings;
  int test = 0;
  for (const double speed : {10., 11., 12., 13., 14., 15., 12.})
    readings.push_back(reading(++test, aluminium, load_cell, speed));
  for (const double speed : {10., 12., 12., 13., 14., 15.})
    readings.push_back(reading(++test, steel, load_cell, speed));
  for (int i = 0; i < 3; ++i) readings.push_back(reading(++test, aluminium, plate, 16));
  readings.push_back(readings.back());  // a second reading of the last test
  return readings;
}

TEST(Folds, HoldEachReadingOnce) {
  const std::vector<Reading> readings = made_up();
  std::multiset<std::size_t> places;
  for (const auto& fold : folds_of(readings)) places.insert(fold.begin(), fold.end());
  ASSERT_EQ(places.size(), readings.size());
  for (std::size_t i = 0; i < readings.size(); ++i) EXPECT_EQ(places.count(i), 1U);
}

TEST(Folds, KeepRepeatedTestsTogetherAndProjectilesApart) {
  const std::vector<Reading> readings = made_up();
  const auto folds = folds_of(readings);
  ASSERT_EQ(folds.size(), 5U + 3U);
  std::map<int, std::size_t> fold_of;
  for (std::size_t k = 0; k < folds.size(); ++k)
    for (const std::size_t i : folds[k]) fold_of[readings[i].test] = k;
  EXPECT_EQ(fold_of[3], fold_of[7]) << "both at 12 mph";
  EXPECT_EQ(fold_of[1], fold_of[6]) << "ranks 0 and 5 of aluminium";
  EXPECT_NE(fold_of[1], fold_of[2]);
  EXPECT_EQ(fold_of[9], fold_of[10]) << "steel, both at 12 mph";
  EXPECT_EQ(fold_of[9], fold_of[2]) << "rank 1 among the speeds of its own projectile";
  EXPECT_EQ(std::set<std::size_t>({fold_of[14], fold_of[15], fold_of[16]}).size(), 3U)
      << "plate: test by test";
}

TEST(CertainReadings, AreThoseOfTheDecision) {
  std::vector<input::Fault> faults;
  const ValidationData data = read_validation_data(DASHPAD_SOURCE_DIR "/data/validation", faults);
  std::map<std::pair<TestSupport, Quantity>, int> counts;
  for (const Reading& reading : certain_readings(data.measured))
    ++counts[{reading.setup.support, reading.quantity}];
  const std::map<std::pair<TestSupport, Quantity>, int> expected{
      {{TestSupport::load_cell, Quantity::peak_force}, 23},
      {{TestSupport::load_cell, Quantity::time_to_peak}, 14},
      {{TestSupport::load_cell, Quantity::rebound_speed}, 14},
      {{TestSupport::plate, Quantity::rebound_speed}, 3},
      {{TestSupport::plate, Quantity::peak_strain}, 3}};
  EXPECT_EQ(counts, expected);
}

TEST(FittedFoam, MakesASoundCard) {
  const Material material = material_of({.plateau_stress_psi = 40,
                                         .densification_stress_psi = 10,
                                         .densification_exponent = 0.7,
                                         .unloading_shape = 20});
  EXPECT_TRUE(violations(material).empty());
  const Foam& foam = std::get<Foam>(material.law);
  EXPECT_NEAR(std::get<AvalleCurve>(foam.curves.base).plateau_stress, 275790, 1) << "40 psi in Pa";
  EXPECT_EQ(foam.continuation_exponent, 1) << "not below its least";
}

}  // namespace
}  // namespace dashpad::report1986
