/// The report's energy account against hand calculations.

#include "dashpad/report1986/validation/energy.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace dashpad::report1986 {
namespace {

constexpr double exact = 1e-12;  // relative: a few roundings

/// Weights of 386.4 and 4 times 386.4 lb have masses of 1 and 4 lb s2/in.
ValidationData sample() {
  ValidationData data;
  data.measured.tests.resize(2);
  data.measured.tests[0].weight_lb = 386.4;
  data.measured.tests[1].weight_lb = 4 * 386.4;
  data.measured.tests[1].projectile = Projectile::steel;
  data.load_cell = {{0.1, 100}, {0.2, 1100}};
  data.plate_stiffness_lb_per_in = 500;
  data.printed = {{"energy_trend_factor", 2, "1", ""}, {"energy_trend_exponent", 0.5, "1", ""}};
  return data;
}

TEST(energy, of_an_impact) {
  EXPECT_NEAR(mass_of(772.8), 2, 2 * exact);
  EXPECT_NEAR(impact_energy_in_lb(386.4, 10), 17.64 * 17.64 * 50, 1e-8);
}

TEST(energy, elastic_time_and_its_stiffness) {
  EXPECT_NEAR(elastic_time_to_peak_ms(386.4, 25), 1e3 * std::numbers::pi / 10, 1e-9);
  EXPECT_NEAR(stiffness_of_time(386.4, elastic_time_to_peak_ms(386.4, 1234)), 1234, 1e-8);
}

TEST(energy, elastic_peak_force) { EXPECT_NEAR(elastic_peak_force_lb(386.4, 2, 25), 2 * 17.64 * 5, 1e-9); }

TEST(energy, of_a_support_of_two_slopes) {
  const std::vector<StaticPoint> points = sample().load_cell;
  EXPECT_EQ(support_energy_in_lb(points, 0), 0);
  EXPECT_NEAR(support_energy_in_lb(points, 50), 1.25, exact);             // triangle, 0.05 in
  EXPECT_NEAR(support_energy_in_lb(points, 100), 5, 5 * exact);           // whole triangle
  EXPECT_NEAR(support_energy_in_lb(points, 600), 5 + 0.05 * 350, 1e-10);  // and half the trapezium
  EXPECT_NEAR(support_energy_in_lb(points, 1100), 5 + 0.1 * 600, 1e-10);
  EXPECT_NEAR(support_energy_in_lb(points, 2100), 65 + 0.1 * 1600, 1e-10);  // the last slope goes on
}

TEST(energy, trend_and_its_inverse) {
  EXPECT_NEAR(trend_energy_in_lb(8, 2, 0.5), 4, exact);
  EXPECT_NEAR(trend_force_lb(4, 2, 0.5), 8, 8 * exact);
  EXPECT_NEAR(trend_force_lb(trend_energy_in_lb(5500, 6876, 0.372), 6876, 0.372), 5500, 1e-7);
}

/// At 200 lb: the trend has 20 in.lb, the load cell 5 + 0.01 x 150, the plate 40.
TEST(energy, with_the_plate_in_place_of_the_load_cell) {
  EXPECT_NEAR(energy_on_plate_in_lb(sample(), 200), 20 - 6.5 + 40, 1e-10);
}

TEST(energy, curves_of_speed) {
  const ValidationData data = sample();
  EXPECT_NEAR(curve_a_speed_mph(data, Projectile::aluminium, 200), std::sqrt(40.0) / 17.64, 1e-10);
  EXPECT_NEAR(curve_a_speed_mph(data, Projectile::steel, 200), std::sqrt(10.0) / 17.64, 1e-10);
  EXPECT_NEAR(curve_b_speed_mph(data, Projectile::aluminium, 200), std::sqrt(2 * 53.5) / 17.64, 1e-10);
}

TEST(energy, expectation_bounds_the_rebound) {
  const ExpectationExample example = expectation(sample(), Projectile::aluminium, 2, 600, 0.5);
  const double energy = 2 * 17.64 * 17.64;
  EXPECT_NEAR(example.energy_in_lb, energy, 1e-9);
  EXPECT_NEAR(example.rebound_energy_in_lb, energy / 4, 1e-9);
  EXPECT_NEAR(example.support_energy_in_lb, 22.5, 1e-10);
  EXPECT_NEAR(example.speed_ratio, std::sqrt(0.25 + 22.5 / energy), 1e-12);
  EXPECT_NEAR(example.rebound_mph, 2 * example.speed_ratio, 1e-12);
}

TEST(energy, needs_a_test_of_the_projectile) {
  ValidationData data = sample();
  data.measured.tests.pop_back();
  EXPECT_THROW(weight_of(data, Projectile::steel), std::out_of_range);
}

}  // namespace
}  // namespace dashpad::report1986
