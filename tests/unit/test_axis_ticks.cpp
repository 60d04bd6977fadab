// Where axes end, and their marks.

#include <limits>
#include <optional>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/plot/axis_ticks.hpp"

namespace dashpad {
namespace {

using output::Axis;
using output::AxisRange;
using ::testing::ElementsAre;

AxisRange range(double low, double high, bool logarithmic = false, std::size_t most = 9) {
  return output::range_of({.logarithmic = logarithmic}, {low, high}, most);
}

std::vector<std::string> labels(const AxisRange& range, std::size_t most = 9) {
  std::vector<std::string> result;
  for (const output::Tick& tick : output::ticks_of(range, most))
    if (!tick.label.empty()) result.push_back(tick.label);
  return result;
}

TEST(AxisTicks, EndAtTheNextMarkOrHalfWayToIt) {
  const AxisRange time = range(0, 24.3);
  EXPECT_EQ(time.low, 0);
  EXPECT_EQ(time.high, 25);
  EXPECT_THAT(labels(time), ElementsAre("0", "5", "10", "15", "20", "25"));
  EXPECT_EQ(range(0, 27.4).high, 27.5);
  EXPECT_THAT(labels(range(-0.03, 0.11)), ElementsAre("−0.02", "0", "0.02", "0.04", "0.06", "0.08", "0.10"));
}

TEST(AxisTicks, StayWithinLimits) {
  const AxisRange speed = output::range_of({.low = 9, .high = 21}, {10, 20}, 9);
  EXPECT_EQ(speed.low, 9);
  EXPECT_EQ(speed.high, 21);
  EXPECT_THAT(labels(speed), ElementsAre("10", "12", "14", "16", "18", "20"));
}

TEST(AxisTicks, AreDecadesOnLogarithmicAxes) {
  const AxisRange rate = range(0.003, 2500, true);
  EXPECT_DOUBLE_EQ(rate.low, 0.002);
  EXPECT_DOUBLE_EQ(rate.high, 5000);
  EXPECT_THAT(labels(rate), ElementsAre("0.01", "0.1", "1", "10", "100", "1000"));
  EXPECT_THAT(labels(range(1e-9, 1, true)),
              ElementsAre("10⁻⁹", "10⁻⁸", "10⁻⁷", "10⁻⁶", "10⁻⁵", "10⁻⁴", "10⁻³", "10⁻²", "10⁻¹", "10⁰"));
}

TEST(AxisTicks, AreDenserOnFewDecades) {
  EXPECT_THAT(labels(range(7, 90, true)), ElementsAre("5", "10", "20", "50", "100"));
  EXPECT_THAT(labels(range(2, 3, true)), ElementsAre("2.0", "2.2", "2.4", "2.6", "2.8", "3.0"));
}

TEST(AxisTicks, ManyDecadesLeaveSomeOut) {
  const std::vector<std::string> few = labels(range(1e-300, 1e300, true));
  EXPECT_LE(few.size(), 11U);
  EXPECT_GE(few.size(), 5U);
  EXPECT_LE(output::ticks_of(range(1e-300, 1e300, true), 9).size(), 12U);
}

TEST(AxisTicks, AreShortForLargeAndSmallNumbers) {
  EXPECT_THAT(labels(range(0, 4e7)), ElementsAre("0", "0.5×10⁷", "1.0×10⁷", "1.5×10⁷", "2.0×10⁷", "2.5×10⁷",
                                                 "3.0×10⁷", "3.5×10⁷", "4.0×10⁷"));
  EXPECT_THAT(labels(range(0, 2e-9), 2), ElementsAre("0", "10⁻⁹", "2×10⁻⁹"));
}

TEST(AxisTicks, HaveALengthWhereTheDataHaveNone) {
  for (const bool logarithmic : {false, true}) {
    for (const double place : {1e-290, 0.5, 3.0, 1e290}) {
      const AxisRange range_of_one = range(place, place, logarithmic);
      EXPECT_LT(range_of_one.low, place);
      EXPECT_GT(range_of_one.high, place);
      EXPECT_GE(labels(range_of_one).size(), 2U);
    }
  }
  EXPECT_LT(range(0, 0).low, 0);
  const AxisRange below = output::range_of({.low = 4}, {}, 9);
  EXPECT_EQ(below.low, 4);
  EXPECT_GT(below.high, 4);
}

TEST(AxisTicks, AreFewAndInOrderWhateverTheEnds) {
  const std::vector<double> ends{-1e300,      -7.3, -1e-300,   0,    1e-300, 0.1,
                                 0.1 + 1e-17, 1,    1 + 4e-16, 1e15, 1e300};
  for (const bool logarithmic : {false, true}) {
    for (const double low : ends) {
      for (const double high : ends) {
        if (!(low < high) || (logarithmic && !(low > 0))) continue;
        const AxisRange exact =
            output::range_of({.logarithmic = logarithmic, .low = low, .high = high}, {low, high}, 7);
        for (const AxisRange& one : {range(low, high, logarithmic, 7), exact}) {
          EXPECT_LT(one.low, one.high);
          const auto ticks = output::ticks_of(one, 7);
          EXPECT_LE(ticks.size(), 80U) << low << " " << high;
          double before = -std::numeric_limits<double>::infinity();
          for (const output::Tick& tick : ticks) {
            EXPECT_GT(tick.value, before) << low << " " << high << " " << logarithmic;
            EXPECT_GE(one.share(tick.value), -1e-9);
            EXPECT_LE(one.share(tick.value), 1 + 1e-9);
            before = tick.value;
          }
        }
      }
    }
  }
}

}  // namespace
}  // namespace dashpad
