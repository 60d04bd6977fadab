// Compression tests at several temperatures become one foam with a table of factors.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <string>
#include <vector>

#include "dashpad/input/fault.hpp"
#include "dashpad/input/material_deck.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad {
namespace {

using ::testing::DoubleNear;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Pointwise;

class TestTemperaturesTest : public testing::Test {
 protected:
  static constexpr double warm = 296.15, cold = 253.15, hot = 323.15;  // K

  /// A test whose stresses are those of 60 kPa times a factor, at its own strains.
  std::filesystem::path test(double factor, int points = 20, double wave = 0) {
    std::string text = "strain,stress_kPa\n";
    for (int i = 1; i <= points; ++i) {
      const double e = 0.6 * i / points;
      text += fmt::format("{},{}\n", e, factor * 60 * e / (1 - e) * (1 + wave * (i % 2 == 0 ? 1 : -1)));
    }
    return folder_.write(fmt::format("test{}.csv", ++count_), text);
  }
  std::string said(const std::vector<std::filesystem::path>& files, const input::TestConditions& conditions) {
    const auto made = input::read_stress_tables(files, conditions, {});
    return made ? "" : made.faults().front().rule;
  }

 private:
  test::TemporaryFolder folder_;
  int count_ = 0;
};

TEST_F(TestTemperaturesTest, TheFirstMakesTheCurveAndOthersFactors) {
  const auto made =
      input::read_stress_tables({test(1), test(1.5), test(0.7)}, {{0.01, 0.01, 0.01}, {warm, cold, hot}}, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(made->material.temperature_table.temperature, ElementsAre(cold, warm, hot));
  EXPECT_THAT(made->material.temperature_table.factor, Pointwise(DoubleNear(1e-6), {1.5, 1.0, 0.7}));
  const auto& curves = std::get<Foam>(made->material.law).curves;
  EXPECT_TRUE(std::holds_alternative<NoRateEffect>(curves.rate_effect)) << "the other tests are no curves";
  EXPECT_NEAR(std::get<TableCurve>(curves.base).stress.back(), 90e3, 1);
  EXPECT_THAT(made->differences,
              testing::Contains(HasSubstr("At -20 degC, the stress is 1.5 times that at 23 degC")));
}

/// Tests at several rates share one factor; the account says how far they are from it.
TEST_F(TestTemperaturesTest, TheMisfitIsSaid) {
  const auto made = input::read_stress_tables({test(1), test(1.3), test(2, 20, 0.1), test(2.6)},
                                              {{0.01, 10, 0.01, 10}, {warm, warm, cold, cold}}, {});
  ASSERT_TRUE(made);
  ASSERT_EQ(made->material.temperature_table.factor.size(), 2u);
  EXPECT_NEAR(made->material.temperature_table.factor.front(), 2, 0.03);
  EXPECT_FALSE(std::holds_alternative<NoRateEffect>(std::get<Foam>(made->material.law).curves.rate_effect));
  EXPECT_THAT(made->differences,
              testing::Contains(testing::ContainsRegex("deviates from that by [4-9](\\.[0-9])? %")));
}

TEST_F(TestTemperaturesTest, OneTemperatureMakesNoTable) {
  const auto made = input::read_stress_tables({test(1), test(1.3)}, {{0.01, 10}, {warm, warm}}, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(made->material.temperature_table.temperature, IsEmpty());
  EXPECT_THAT(made->differences,
              testing::Contains("Tested at 23 degC; the effect of other temperatures was not measured."));
}

TEST_F(TestTemperaturesTest, TemperaturesThatAreNearlyTheSameAreOne) {
  const auto made =
      input::read_stress_tables({test(1), test(1.3), test(1.5), test(1.5)},
                                {{0.01, 10, 0.01, 0.01}, {warm, warm + 0.4, cold, cold + 0.3}}, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(made->material.temperature_table.temperature, ElementsAre(cold, warm));
  EXPECT_THAT(made->material.temperature_table.factor, Pointwise(DoubleNear(1e-6), {1.5, 1.0}));
  EXPECT_FALSE(std::holds_alternative<NoRateEffect>(std::get<Foam>(made->material.law).curves.rate_effect));
}

TEST_F(TestTemperaturesTest, AFactorThatIsHardlyThatOfAFoamIsDoubted) {
  const auto made =
      input::read_stress_tables({test(1), test(25), test(0.7)}, {{0.01, 0.01, 0.01}, {warm, cold, hot}}, {});
  ASSERT_TRUE(made);
  EXPECT_THAT(made->differences,
              testing::Contains(
                  testing::AllOf(HasSubstr("25 times"), HasSubstr("(rms); check the units of the tests."))));
  EXPECT_THAT(made->differences,
              testing::Contains(testing::AllOf(HasSubstr("0.7 times"), testing::Not(HasSubstr("units")))));
}

TEST_F(TestTemperaturesTest, TwoTestsAtOneRateAndTemperatureAreRefused) {
  const auto made = input::read_stress_tables({test(1), test(1.3)}, {{0.01, 0.01}, {warm, warm}}, {});
  ASSERT_FALSE(made);
  ASSERT_EQ(made.faults().size(), 1u);
  EXPECT_THAT(made.faults().front().file, testing::EndsWith("test2.csv"));
  EXPECT_EQ(
      made.faults().front().rule,
      "has the rate of test1.csv, 0.01 1/s, and its temperature; leave one of them out, or average them");
}

TEST_F(TestTemperaturesTest, ATestAtAnotherRateHasNothingToBeComparedWith) {
  EXPECT_THAT(said({test(1), test(1.5)}, {{0.01, 10}, {warm, cold}}),
              HasSubstr("needs a test at 23 degC and the same rate, 10 1/s"));
}

}  // namespace
}  // namespace dashpad
