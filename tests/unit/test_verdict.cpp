/// The rules of the validation on made-up tests and predictions: each of them can pass and can fail.

#include "dashpad/report1986/validation/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "dashpad/report1986/validation/energy.hpp"

namespace dashpad::report1986 {
namespace {

constexpr double radius = 2;

/// Two projectiles on the load cell at six speeds each, one test on the plate.
ValidationData made_up_data() {
  ValidationData data;
  int number = 0;
  for (const double speed : {11., 13., 15., 17., 19., 20.})
    data.measured.tests.push_back({++number,
                                   Projectile::aluminium,
                                   4.13,
                                   TestSupport::load_cell,
                                   speed,
                                   impact_energy_in_lb(4.13, speed),
                                   0.44 * speed,
                                   90 / speed,
                                   {},
                                   20 * speed * speed,
                                   {},
                                   {}});
  for (const double speed : {10., 11., 12., 13., 14., 15.})
    data.measured.tests.push_back({++number,
                                   Projectile::steel,
                                   7.7,
                                   TestSupport::load_cell,
                                   speed,
                                   impact_energy_in_lb(7.7, speed),
                                   0.44 * speed,
                                   95 / speed,
                                   {},
                                   25 * speed * speed,
                                   0.95,
                                   {}});
  data.measured.tests.push_back(
      {++number, Projectile::aluminium, 4.13, TestSupport::plate, 15, 370, 9, {}, {}, {}, 0.8, 0.82});
  data.load_cell = {{0.1, 900}, {0.2, 9900}};
  data.plate_stiffness_lb_per_in = 5180;
  data.pad_thickness_in = 1.2;
  data.printed = {
      {"energy_trend_factor", 6876, "1", ""},          {"energy_trend_exponent", 0.372, "1", ""},
      {"force_ratio_aluminium_low_speed", 1, "1", ""}, {"force_ratio_aluminium_high_speed", 0.4, "1", ""},
      {"force_ratio_steel_low_speed", 1.4, "1", ""},   {"force_ratio_steel_high_speed", 0.4, "1", ""}};
  return data;
}

using Change = std::function<void(const MeasuredTest&, Prediction&)>;

/// What was measured is predicted, but for a change.
std::vector<Prediction> perfect(const ValidationData& data, Program program, const Change& change = {}) {
  std::vector<Prediction> predictions;
  for (const MeasuredTest& test : data.measured.tests) {
    Prediction prediction{program,
                          {test.projectile, test.support, test.speed_mph, radius},
                          test.peak_force_lb,
                          test.time_to_peak_ms,
                          test.rebound_mph,
                          peak_strain(test),
                          false,
                          0,
                          {}};
    if (change) change(test, prediction);
    predictions.push_back(prediction);
  }
  return predictions;
}

Score on_load_cell(const ValidationData& data, Quantity quantity, const Change& change = {},
                   std::optional<Projectile> projectile = {}) {
  return score(data.measured, perfect(data, Program::accurate, change), Program::accurate,
               TestSupport::load_cell, quantity, radius, projectile);
}

TEST(Verdict, RulesAreThoseOfTheDecision) {
  const auto is = [](Quantity quantity, double low, double high, double scatter, bool logarithmic) {
    const Rule& rule = rule_of(quantity);
    return rule.low == low && rule.high == high && rule.scatter == scatter && rule.logarithmic == logarithmic;
  };
  EXPECT_TRUE(is(Quantity::peak_force, -0.15, 0.15, 0.25, true));
  EXPECT_TRUE(is(Quantity::time_to_peak, -0.10, 0.10, 0.15, true));
  EXPECT_TRUE(is(Quantity::rebound_speed, -0.15, 0.15, 0.15, true));
  EXPECT_TRUE(is(Quantity::peak_strain, -0.05, 0.05, 0.05, false));
}

TEST(Verdict, EveryBoundOfEveryRuleDecides) {
  for (const Rule& rule : rules) {
    SCOPED_TRACE(to_string(rule.quantity));
    const auto errors = [&](double bias, double scatter) {
      const double mean = rule.logarithmic ? std::log1p(bias) : bias;
      return std::vector{mean - scatter / std::sqrt(2.0), mean + scatter / std::sqrt(2.0)};
    };
    const Statistics seen = judge(rule, errors(0.03, 0.04));
    EXPECT_NEAR(seen.bias, 0.03, 1e-14);
    EXPECT_NEAR(seen.scatter, 0.04, 1e-14);
    EXPECT_TRUE(seen.passed);
    EXPECT_TRUE(judge(rule, errors(rule.high - 1e-9, rule.scatter - 1e-9)).passed);
    EXPECT_TRUE(judge(rule, errors(rule.low + 1e-9, rule.scatter - 1e-9)).passed);
    EXPECT_FALSE(judge(rule, errors(rule.high + 1e-9, 0)).passed);
    EXPECT_FALSE(judge(rule, errors(rule.low - 1e-9, 0)).passed);
    EXPECT_FALSE(judge(rule, errors(0, rule.scatter + 1e-9)).passed);
    EXPECT_FALSE(judge(rule, {0}).passed) << "one test has no scatter";
    EXPECT_FALSE(judge(rule, {}).passed);
  }
}

TEST(Verdict, ScoreIsOfTheTestsAskedFor) {
  const ValidationData data = made_up_data();
  const Change steel_too_high = [](const MeasuredTest& test, Prediction& prediction) {
    if (test.projectile == Projectile::steel) *prediction.peak_force_lb *= 1.3;
  };
  const Score both = on_load_cell(data, Quantity::peak_force, steel_too_high);
  EXPECT_EQ(both.errors.size(), 12U);
  EXPECT_NEAR(both.bias, std::sqrt(1.3) - 1, 1e-12);
  EXPECT_NEAR(both.scatter, std::log(1.3) / 2 * std::sqrt(12.0 / 11), 1e-12);
  EXPECT_TRUE(both.passed) << "a mixture hides what each projectile shows";
  EXPECT_FALSE(on_load_cell(data, Quantity::peak_force, steel_too_high, Projectile::steel).passed);
  EXPECT_TRUE(on_load_cell(data, Quantity::peak_force, steel_too_high, Projectile::aluminium).passed);
  EXPECT_NEAR(both.errors.back().error, 0.3, 1e-12);
}

TEST(Verdict, StrainIsTheMeanOfBothMethodsAndComparedByDifference) {
  ValidationData data = made_up_data();
  data.measured.tests.push_back(data.measured.tests.back());
  data.measured.tests.back().speed_mph = 18;
  const auto predictions = perfect(data, Program::accurate, [](const MeasuredTest&, Prediction& prediction) {
    if (prediction.peak_strain) *prediction.peak_strain += 0.04;
  });
  const Score strain =
      score(data.measured, predictions, Program::accurate, TestSupport::plate, Quantity::peak_strain, radius);
  ASSERT_EQ(strain.errors.size(), 2U);
  EXPECT_NEAR(strain.errors.front().measured, 0.81, 1e-12);
  EXPECT_NEAR(strain.bias, 0.04, 1e-12);
  EXPECT_TRUE(strain.passed);
}

TEST(Verdict, NobodyPassesByLeavingFiguresOut) {
  const ValidationData data = made_up_data();
  const Score force =
      on_load_cell(data, Quantity::peak_force, [](const MeasuredTest& test, Prediction& prediction) {
        if (test.number == 3) prediction.peak_force_lb.reset();
      });
  EXPECT_EQ(force.missing, 1);
  EXPECT_EQ(force.errors.size(), 11U);
  EXPECT_EQ(force.bias, 0);
  EXPECT_FALSE(force.passed);
  EXPECT_EQ(score(data.measured, perfect(data, Program::accurate), Program::accurate, TestSupport::load_cell,
                  Quantity::peak_force, radius + 1)
                .missing,
            12);
}

TEST(Verdict, BoundOfTable32) {
  const ValidationData data = made_up_data();
  MeasuredTest test = data.measured.tests.front();
  const double energy = impact_energy_in_lb(4.13, test.speed_mph);
  const double stored = 45 + (*test.peak_force_lb * *test.peak_force_lb - 900. * 900) / (2 * 90000);
  EXPECT_NEAR(*rebound_bound_mph(data, test), test.speed_mph * std::sqrt(0.44 * 0.44 + stored / energy),
              1e-9);
  test.peak_force_lb.reset();
  EXPECT_FALSE(rebound_bound_mph(data, test));
  EXPECT_FALSE(rebound_bound_mph(data, data.measured.tests.back())) << "no force was measured on the plate";
}

TEST(Verdict, AdmissibleReboundsCountEachFault) {
  const ValidationData data = made_up_data();
  const auto counted = [&](double factor, int from, int to, bool of_bound) {
    return admissible_rebounds(data,
                               perfect(data, Program::accurate,
                                       [&](const MeasuredTest& test, Prediction& prediction) {
                                         if (test.number < from || test.number > to) return;
                                         *prediction.rebound_mph =
                                             factor *
                                             (of_bound ? *rebound_bound_mph(data, test) : *test.rebound_mph);
                                       }),
                               Program::accurate, radius);
  };
  EXPECT_TRUE(counted(1.04, 1, 12, true).passed);
  EXPECT_TRUE(counted(0.96, 1, 12, false).passed);
  const Admissible high = counted(1.06, 1, 2, true), low = counted(0.94, 1, 3, false);
  EXPECT_EQ(high.tests, 12);
  EXPECT_EQ(high.too_high, 2);
  EXPECT_TRUE(high.passed) << "10 of 12 are more than 80 %";
  EXPECT_EQ(low.too_low, 3);
  EXPECT_FALSE(low.passed) << "9 of 12 are not";
  EXPECT_EQ(admissible_rebounds(data, {}, Program::accurate, radius).missing, 12);
  EXPECT_FALSE(admissible_rebounds(data, {}, Program::accurate, radius).passed);
}

TEST(Verdict, ReadingsWithoutRowsAreScoredInEveryPlacing) {
  ValidationData data = made_up_data();
  auto& tests = data.measured.tests;
  for (int i = 0; i < 3; ++i) tests[static_cast<std::size_t>(i)].peak_force_lb.reset();
  data.measured.unplaced = {{"peak_force_lb", 1, 3, {1000, 2000}}, {"total_time_ms", 1, 3, {10}}};
  const auto predictions =
      perfect(data, Program::accurate, [](const MeasuredTest& test, Prediction& prediction) {
        if (test.number <= 3) prediction.peak_force_lb = 1000 * test.number;
      });
  const auto placed = placed_scores(data.measured, predictions, Program::accurate, radius);
  ASSERT_EQ(placed.size(), 1U) << "no quantity of ours is the total time";
  EXPECT_EQ(placed[0].placings, 3);
  EXPECT_EQ(placed[0].placings_passed, 1) << "tests 1 and 2";
  EXPECT_NEAR(placed[0].bias_over_placings.low, 0, 1e-12);
  EXPECT_NEAR(placed[0].bias_over_placings.high, std::sqrt(2 * 1.5) - 1, 1e-12);
  EXPECT_NEAR(placed[0].bias, (0 + std::sqrt(1.5) - 1 + std::sqrt(3.0) - 1) / 3, 1e-12);
  EXPECT_NEAR(placed[0].scatter_over_placings.low, 0, 1e-12);
}

TEST(Verdict, CurveAHasATailForTheAluminiumProjectileOnly) {
  const ValidationData data = made_up_data();
  const double tail = *data.measured.tests.front().peak_force_lb;  // there is no test 24 here
  EXPECT_EQ(curve_a_force_lb(data, Projectile::aluminium, 10), tail);
  const double steel = curve_a_force_lb(data, Projectile::steel, 10);
  EXPECT_NEAR(curve_a_speed_mph(data, Projectile::steel, steel), 10, 1e-9);
  EXPECT_LT(steel, tail);
  const double plate = curve_b_force_lb(data, Projectile::aluminium, 18);
  EXPECT_NEAR(curve_b_speed_mph(data, Projectile::aluminium, plate), 18, 1e-9);
}

/// Predictions whose ratio to what was measured follows a power of the speed, with a little noise.
std::vector<Prediction> sloping(const ValidationData& data, Program program, double slope) {
  return perfect(data, program, [&](const MeasuredTest& test, Prediction& prediction) {
    if (prediction.peak_force_lb)
      *prediction.peak_force_lb *=
          std::pow(test.speed_mph / 14, slope) * (test.number % 2 == 0 ? 1.01 : 0.99);
  });
}

TEST(Verdict, ForceTrendFindsTheSlopeAndTheRatios) {
  const ValidationData data = made_up_data();
  const std::vector<Prediction> on_curves{{Program::accurate,
                                           {Projectile::aluminium, TestSupport::load_cell, 20, radius},
                                           0.5 * curve_a_force_lb(data, Projectile::aluminium, 20),
                                           {},
                                           {},
                                           {},
                                           false,
                                           0,
                                           {}}};
  const ForceTrend trend =
      force_trend(data, sloping(data, Program::accurate, -1.5), on_curves, Program::accurate, radius);
  EXPECT_EQ(trend.tests, 12);
  EXPECT_NEAR(trend.slope, -1.5, 0.03);
  EXPECT_TRUE(trend.slope_confidence.holds(-1.5));
  EXPECT_FALSE(trend.slope_confidence.holds(0));
  EXPECT_NEAR(trend.aluminium_slope, -1.5, 0.03);
  EXPECT_NEAR(trend.aluminium_high, 0.5, 1e-9);
  EXPECT_TRUE(std::isnan(trend.aluminium_low));
  EXPECT_TRUE(std::isnan(force_trend(data, {}, {}, Program::accurate, radius).slope));
}

ForceTrend trend_of(Program program, double slope, double half_width) {
  ForceTrend trend;
  trend.program = program;
  trend.slope = slope;
  trend.slope_confidence = {slope - half_width, slope + half_width};
  trend.aluminium_low = 1.2, trend.aluminium_high = 0.35, trend.steel_low = 1.1, trend.steel_high = 0.48;
  return trend;
}

AnomalyVerdict anomaly(double slope, bool force_passed, const std::function<void(ForceTrend&)>& change = {}) {
  ForceTrend first = trend_of(Program::accurate_first_slope, -2, 0.3);
  if (change) change(first);
  return judge_anomaly(made_up_data(), {trend_of(Program::accurate, slope, 0.3), first}, force_passed);
}

TEST(Verdict, TheDefectExplainsTheAnomalyOnlyIfBothHold) {
  EXPECT_EQ(anomaly(0.2, true).explanation, Explanation::explains);
  EXPECT_EQ(anomaly(0.2, false).explanation, Explanation::in_part) << "the force rule fails";
  EXPECT_EQ(anomaly(-0.9, true).explanation, Explanation::in_part) << "halved, but not gone";
  EXPECT_EQ(anomaly(-1.1, true).explanation, Explanation::does_not) << "not halved";
  EXPECT_EQ(anomaly(1.1, true).explanation, Explanation::does_not) << "turned round";
}

TEST(Verdict, EachRatioOfTheFirstSlopeMustBeNearThePrintedOne) {
  for (double ForceTrend::*ratio : {&ForceTrend::aluminium_low, &ForceTrend::aluminium_high,
                                    &ForceTrend::steel_low, &ForceTrend::steel_high}) {
    EXPECT_EQ(anomaly(0, true, [&](ForceTrend& trend) { trend.*ratio *= 1.8; }).explanation,
              Explanation::does_not);
    EXPECT_EQ(anomaly(0, true, [&](ForceTrend& trend) { trend.*ratio *= 0.5; }).explanation,
              Explanation::does_not);
    EXPECT_EQ(anomaly(0, true, [&](ForceTrend& trend) { trend.*ratio = std::nan(""); }).explanation,
              Explanation::does_not);
  }
}

}  // namespace
}  // namespace dashpad::report1986
