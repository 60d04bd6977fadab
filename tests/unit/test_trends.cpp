/// Fits with closed forms, placings that can be counted, and the search over them against going through all.

#include "dashpad/report1986/validation/trends.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <stdexcept>
#include <vector>

#include "dashpad/report1986/validation/energy.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation/trends_least_squares.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::report1986 {
namespace {

// --- Least squares. Quantiles of Student's t: tables, two-sided 95 %. ---

TEST(least_squares, student_quantiles) {
  EXPECT_NEAR(uncertainty::student_95(1), 12.7062, 5e-5);
  EXPECT_NEAR(uncertainty::student_95(2), 4.30265, 5e-6);
  EXPECT_NEAR(uncertainty::student_95(13), 2.16037, 5e-6);
  EXPECT_TRUE(std::isinf(uncertainty::student_95(0)));
}

/// x = 1, 2, 2 and y = 2, 3, 5: constant 18/9 = 2, residuals 0, -1, 1, variance 2/2, standard error 1/3.
TEST(least_squares, proportional) {
  const ProportionalFit fit = fit_proportional({{1, 2}, {2, 3}, {2, 5}});
  EXPECT_DOUBLE_EQ(fit.constant.value, 2);
  EXPECT_DOUBLE_EQ(fit.scatter, 1);
  EXPECT_NEAR(fit.constant.high, 2 + 4.30265 / 3, 2e-6);
  EXPECT_NEAR(fit.constant.low, 2 - 4.30265 / 3, 2e-6);
}

TEST(least_squares, one_point_has_no_interval) {
  const ProportionalFit fit = fit_proportional({{2, 3}});
  EXPECT_DOUBLE_EQ(fit.constant.value, 1.5);
  EXPECT_TRUE(std::isinf(fit.constant.high));
}

/// x = -1, 0, 1 and y = 1, 4, 3 about the mean: intercept 8/3, slope 1, residuals -2/3, 4/3, -2/3, variance
/// 8/3, standard errors sqrt(8/9) and sqrt(4/3). One degree of freedom.
TEST(least_squares, line) {
  const LineFit fit = fit_line({{-1, 1}, {0, 4}, {1, 3}});
  EXPECT_DOUBLE_EQ(fit.intercept.value, 8.0 / 3);
  EXPECT_DOUBLE_EQ(fit.slope.value, 1);
  EXPECT_NEAR(fit.scatter, std::sqrt(8.0 / 3), 1e-12);
  EXPECT_NEAR(fit.intercept.high, 8.0 / 3 + 12.7062 * std::sqrt(8.0 / 9), 1e-4);
  EXPECT_NEAR(fit.slope.low, 1 - 12.7062 * std::sqrt(4.0 / 3), 1e-4);
  EXPECT_TRUE(std::isinf(fit.ratio.low)) << "the slope may be 0";
}

/// At the ends of Fieller's interval the line's value at -ratio differs from 0 by exactly its own half width.
TEST(least_squares, ratio_by_fieller) {
  const std::vector<Point> points{{1, 3.1}, {2, 4.9}, {3, 7.2}, {4, 9.1}, {5, 10.8}, {6, 13.1}};
  const LineFit fit = fit_line(points);
  EXPECT_NEAR(fit.ratio.value, fit.intercept.value / fit.slope.value, 1e-12);
  for (const double end : {fit.ratio.low, fit.ratio.high}) {
    std::vector<Point> shifted = points;  // its intercept is the line's value at x = -end
    for (Point& point : shifted) point.x += end;
    const LineFit there = fit_line(shifted);
    const double half_width = there.intercept.high - there.intercept.value;
    EXPECT_NEAR(std::abs(there.intercept.value), half_width, 1e-9);
  }
  EXPECT_LT(fit.ratio.low, fit.ratio.value);
  EXPECT_GT(fit.ratio.high, fit.ratio.value);
}

// --- Placings ---

/// Tests of mass 1 and speeds 1, 2, ... mph on the load cell.
MeasuredTests tests_of(int count) {
  MeasuredTests measured;
  for (int number = 1; number <= count; ++number) {
    MeasuredTest& test = measured.tests.emplace_back();
    test.number = number;
    test.weight_lb = 386.4;
    test.speed_mph = number;
    test.energy_in_lb = impact_energy_in_lb(386.4, number);
  }
  return measured;
}

TEST(placings, counts) {
  EXPECT_EQ(placings(16, 13), 560);
  EXPECT_EQ(placings(7, 5), 21);
  EXPECT_EQ(placings(4, 0), 1);
  EXPECT_EQ(placings(3, 4), 0);
}

TEST(placings, each_once_in_order_around_certain_readings) {
  MeasuredTests measured = tests_of(6);
  measured.tests[0].rebound_mph = 0.5;
  measured.unplaced = {
      {"rebound_mph", 2, 4, {1, 2}}, {"rebound_mph", 5, 6, {3}}, {"plug_strain", 1, 6, {0.5}}};
  std::set<std::vector<double>> seen;
  long visits = 0;
  for_each_placing(measured, "rebound_mph", [&](const std::vector<MeasuredTest>& tests) {
    std::vector<double> column;
    std::vector<double> readings;
    for (const MeasuredTest& test : tests) {
      column.push_back(test.rebound_mph.value_or(0));
      if (test.rebound_mph) readings.push_back(*test.rebound_mph);
      EXPECT_FALSE(test.plug_strain);
    }
    EXPECT_EQ(readings, (std::vector<double>{0.5, 1, 2, 3}));
    seen.insert(column);
    ++visits;
  });
  EXPECT_EQ(visits, 6);
  EXPECT_EQ(seen.size(), 6U);
  EXPECT_EQ(placings(measured, "rebound_mph"), 6);
}

TEST(placings, too_many_to_go_through) {
  MeasuredTests measured = tests_of(40);
  measured.unplaced = {{"rebound_mph", 1, 40, std::vector<double>(20, 1.0)}};
  EXPECT_THROW(for_each_placing(measured, "rebound_mph", [](const auto&) {}), std::length_error);
}

// --- Trends ---

ValidationData made_up() {
  ValidationData data;
  data.pad_thickness_in = 1;
  data.measured = tests_of(5);
  for (const char* name :
       {"travel_in", "rebound_ratio_load_cell", "rebound_ratio_plate", "energy_trend_factor",
        "energy_trend_exponent", "energy_trend_from_in_lb", "plate_speed_mph"})
    data.printed.push_back({name, 1, "1", "nowhere"});
  for (MeasuredTest& test : data.measured.tests) {
    test.time_to_peak_ms = 1e3 * 2 / (17.64 * test.speed_mph);  // V T = 2 in
    test.peak_force_lb = trend_force_lb(test.energy_in_lb, 50, 0.4);
    test.rebound_mph = 0.3 * test.speed_mph;
  }
  for (const double speed : {10, 11}) {
    MeasuredTest plate = data.measured.tests.front();
    plate.number = static_cast<int>(speed);
    plate.support = TestSupport::plate;
    plate.speed_mph = speed;
    plate.rebound_mph = 0.7 * speed;
    data.measured.tests.push_back(plate);
  }
  data.printed.back().value = 11;  // the plate's fastest test
  return data;
}

TEST(trends, come_back_from_readings_without_scatter) {
  const std::vector<FittedConstant> constants = fit_trends(made_up());
  ASSERT_EQ(constants.size(), 8U);
  const double expected[] = {2, 0.3, 0.7, 0.7, 0.4, 50, 0.4, 50};
  for (std::size_t i = 0; i < constants.size(); ++i) {
    EXPECT_NEAR(constants[i].value, expected[i], 1e-9 * expected[i]) << constants[i].title;
    EXPECT_NEAR(constants[i].scatter, 0, 1e-9) << constants[i].title;
    EXPECT_EQ(constants[i].placings, 1);
    EXPECT_EQ(constants[i].over_placings.low, constants[i].value);
    EXPECT_EQ(constants[i].printed_in_confidence, constants[i].tests.size() == 1) << constants[i].title;
  }
  EXPECT_EQ(constants[0].tests, (std::vector<int>{1, 2, 3, 4, 5}));
  EXPECT_EQ(constants[2].tests, (std::vector<int>{10, 11}));
  EXPECT_EQ(constants[3].tests, (std::vector<int>{10}));
}

/// Rebounds 1 and 2 mph of 1 and 2 mph certain; 3 mph belongs to 3 or 4 mph: (1 + 4 + 9)/14 or (1 + 4 +
/// 12)/21.
TEST(trends, span_over_placings) {
  ValidationData data = made_up();
  data.measured.tests.resize(4);
  for (std::size_t i = 0; i < 4; ++i)
    data.measured.tests[i].rebound_mph = i < 2 ? std::optional(static_cast<double>(i + 1)) : std::nullopt;
  MeasuredTest plate = made_up().measured.tests[5];
  data.measured.tests.push_back(plate);
  plate.speed_mph = 11;
  data.measured.tests.push_back(plate);
  data.measured.unplaced = {{"rebound_mph", 3, 4, {3}}};
  const std::vector<FittedConstant> constants = fit_trends(data);
  EXPECT_DOUBLE_EQ(constants[1].value, 1);
  EXPECT_EQ(constants[1].placings, 2);
  EXPECT_DOUBLE_EQ(constants[1].over_placings.low, 17.0 / 21);
  EXPECT_DOUBLE_EQ(constants[1].over_placings.high, 1);
  EXPECT_LT(constants[1].confidence_over_placings.low, 17.0 / 21);
  EXPECT_TRUE(constants[1].printed_in_placings);
  EXPECT_EQ(constants[2].placings, 1) << "the lost readings are of the load cell";
}

TEST(trends, energies_at_the_limit_are_left_out) {
  ValidationData data = made_up();
  auto& printed = data.printed[5];
  ASSERT_EQ(printed.name, "energy_trend_from_in_lb");
  printed.value = data.measured.tests[0].energy_in_lb;
  EXPECT_EQ(fit_trends(data)[4].tests, (std::vector<int>{2, 3, 4, 5}));
}

// --- Nominal stress ---

Material ensolite_like() {
  constexpr double psi = 6894.757293168361;
  NineParameter law;
  law.asymptotic_modulus = 2 * psi;
  law.contact_exponent = 0.5;
  law.compaction_exponent = 2;
  law.rate_modulus = 3 * psi;
  law.rate_exponent = 0.5;
  Material material;
  material.law = law;
  return material;
}

/// e = 0.64, V/L = 16/s: 0.8 / 0.36^2 (2 + 3 x 4).
TEST(nominal_stress, of_the_law) {
  EXPECT_NEAR(nominal_stress_psi(ensolite_like(), 0.64, 16 / 17.64 * 1.5, 1.5), 0.8 / 0.1296 * 14, 1e-10);
  EXPECT_EQ(nominal_stress_psi(ensolite_like(), 0, 10, 1), 0);
  EXPECT_THROW(nominal_stress_psi(Material{}, 0.5, 10, 1), std::invalid_argument);
}

/// Six tests, three plug strains, a diameter strain, and two of the six forces in two rows of three.
MeasuredTests strains_without_tests() {
  MeasuredTests measured = tests_of(6);
  for (const std::size_t i : {0U, 4U, 5U})
    measured.tests[i].peak_force_lb = 300 + 700 * static_cast<double>(i);
  measured.unplaced = {{"plug_strain", 1, 6, {0.5, 0.8, 0.7}},
                       {"diameter_strain", 2, 5, {0.9}},
                       {"peak_force_lb", 2, 4, {900, 1500}}};
  return measured;
}

struct Extremes {
  Interval mean{1e300, -1e300};
  Interval scatter{1e300, -1e300};
};

/// Goes through all placings.
Extremes by_going_through(const MeasuredTests& measured, const Material& material) {
  Extremes found;
  const auto count_in = [&](const std::vector<MeasuredTest>& tests) {
    std::vector<double> ratios;
    for (const MeasuredTest& test : tests)
      if (peak_strain(test) && test.peak_force_lb)
        ratios.push_back(std::log(*test.peak_force_lb /
                                  nominal_stress_psi(material, *peak_strain(test), test.speed_mph, 1)));
    if (ratios.empty()) return;
    double mean = 0;
    for (const double ratio : ratios) mean += ratio / static_cast<double>(ratios.size());
    found.mean = {std::min(found.mean.low, mean), std::max(found.mean.high, mean)};
    if (ratios.size() < 3) return;
    double squares = 0;
    for (const double ratio : ratios) squares += (ratio - mean) * (ratio - mean);
    const double scatter = std::sqrt(squares / static_cast<double>(ratios.size() - 1));
    found.scatter = {std::min(found.scatter.low, scatter), std::max(found.scatter.high, scatter)};
  };
  MeasuredTests now = measured;
  for_each_placing(measured, "plug_strain", [&](const std::vector<MeasuredTest>& plugs) {
    now.tests = plugs;
    for_each_placing(now, "diameter_strain", [&](const std::vector<MeasuredTest>& strains) {
      MeasuredTests last = measured;
      last.tests = strains;
      for_each_placing(last, "peak_force_lb", count_in);
    });
  });
  return found;
}

TEST(nominal_stress, search_agrees_with_going_through_all_placings) {
  ValidationData data;
  data.pad_thickness_in = 1;
  data.measured = strains_without_tests();
  data.printed = {{"nominal_stress_tests", 15, "1", ""}, {"nominal_stress_clustered_tests", 13, "1", ""}};
  const Extremes expected = by_going_through(data.measured, ensolite_like());
  const NominalStressFit fit = fit_nominal_stress(data, ensolite_like());
  EXPECT_NEAR(fit.area_over_placings.low, std::exp(expected.mean.low), 1e-9 * fit.area_in2);
  EXPECT_NEAR(fit.area_over_placings.high, std::exp(expected.mean.high), 1e-9 * fit.area_in2);
  EXPECT_NEAR(fit.scatter, expected.scatter.low, 1e-9);
  EXPECT_GE(fit.scatter_over_placings.high, expected.scatter.high - 1e-12);
  EXPECT_LE(fit.scatter_over_placings.high, 1.2 * expected.scatter.high) << "a bound, but no idle one";
}

TEST(nominal_stress, of_certain_tests) {
  ValidationData data;
  data.pad_thickness_in = 1;
  data.measured = tests_of(4);
  data.printed = {{"nominal_stress_tests", 15, "1", ""}, {"nominal_stress_clustered_tests", 13, "1", ""}};
  for (MeasuredTest& test : data.measured.tests) {
    test.plug_strain = 0.2 * test.number - 0.1;
    test.peak_force_lb = 3 * nominal_stress_psi(ensolite_like(), *test.plug_strain, test.speed_mph, 1);
  }
  const NominalStressFit fit = fit_nominal_stress(data, ensolite_like());
  EXPECT_NEAR(fit.area_in2, 3, 1e-12);
  EXPECT_NEAR(fit.area_over_placings.high, 3, 1e-12);
  EXPECT_NEAR(fit.scatter, 0, 1e-12);
  EXPECT_NEAR(fit.slope, 1, 1e-12);
  ASSERT_EQ(fit.points.size(), 4U);
  EXPECT_EQ(fit.points[2].test, 3);
}

TEST(nominal_stress, no_points) {
  ValidationData data;
  data.measured = tests_of(3);
  EXPECT_TRUE(fit_nominal_stress(data, ensolite_like()).points.empty());
}

}  // namespace
}  // namespace dashpad::report1986
