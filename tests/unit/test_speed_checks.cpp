// What a velocity change, a speed or a drop height, and a fall in the record say of each other.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <utility>

#include "dashpad/injury/pulse_report.hpp"

namespace dashpad::injury {
namespace {

using testing::HasSubstr;
using testing::Not;

/// A contact of 10 ms over which a sensor shows `sensed` m/s.
PulseReport report_of(double sensed, const std::optional<MeasuredImpact>& impact) {
  PulseReport report;
  report.contact = {5e-3, 15e-3, sensed};
  report.impact = impact;
  return report;
}

TEST(SpeedCheck, SaysWhichScalesWouldAgree) {
  const SpeedCheck check = speed_check(report_of(6, MeasuredImpact{.speed = 4})).value();
  EXPECT_TRUE(check.agrees());
  EXPECT_EQ(check.change, 6);
  EXPECT_NEAR(*check.min_scale, 4.0 / 6, 1e-12);
  EXPECT_NEAR(*check.greatest_scale, 8.0 / 6, 1e-12);
  EXPECT_THAT(check.text,
              HasSubstr("The velocity change agrees with the speed: 6 m/s lies between 4 m/s (no rebound) "
                        "and twice that. It would also agree if all accelerations were 0.667 "
                        "to 1.33 times as large"));
}

/// Gravity gives 0.098 m/s in 10 ms: the sensor has to show that much more, at either end.
TEST(SpeedCheck, OfADropHeightIsWithoutGravity) {
  const MeasuredImpact fall = after_fall(0.8);
  const double given = standard_gravity * 10e-3;
  const SpeedCheck check = speed_check(report_of(6, fall)).value();
  EXPECT_NEAR(check.change, 6 - given, 1e-12);
  EXPECT_NEAR(*check.min_scale * 6 - given, fall.speed, 1e-12);
  EXPECT_NEAR(*check.greatest_scale * 6 - given, 2 * fall.speed, 1e-12);
  EXPECT_THAT(check.text, HasSubstr("The velocity change agrees with the drop height: 5.902 m/s (after "
                                    "subtracting 0.0981 m/s due to gravity) lies between "));
}

TEST(SpeedCheck, SaysWhatWouldMakeUpForADisagreement) {
  const SpeedCheck low = speed_check(report_of(6, MeasuredImpact{.speed = 8})).value();
  EXPECT_FALSE(low.agrees());
  EXPECT_NEAR(low.shortfall, 2, 1e-12);
  EXPECT_THAT(
      low.text,
      HasSubstr(
          "agree with the speed, the scale (unit, sensitivity) would have to be 1.33 times the present one, "
          "or the "
          "sensor would have to read 20 g too low during contact, or samples would have to be missing."));
  const SpeedCheck high = speed_check(report_of(6, MeasuredImpact{.speed = 2})).value();
  EXPECT_NEAR(high.shortfall, -2, 1e-12);
  EXPECT_THAT(
      high.text,
      testing::AllOf(HasSubstr("0.667 times the present one, or the sensor would have to read 20 g too high"),
                     Not(HasSubstr("missing"))));
  EXPECT_THAT(speed_check(report_of(5.994, MeasuredImpact{.speed = 6.01}))->text,
              HasSubstr("would have to be 0.27 % greater, or"));
  EXPECT_THAT(speed_check(report_of(6, MeasuredImpact{.speed = 2.9}))->text,
              HasSubstr("would have to be 3.3 % smaller, or"));
}

TEST(SpeedCheck, ForgivesOneInAThousandAtEitherEnd) {
  const auto agrees = [](double sensed) {
    return speed_check(report_of(sensed, MeasuredImpact{.speed = 4}))->agrees();
  };
  EXPECT_TRUE(agrees(4 * 0.9991));
  EXPECT_FALSE(agrees(4 * 0.9989));
  EXPECT_TRUE(agrees(8 * 1.0009));
  EXPECT_FALSE(agrees(8 * 1.0011));
}

TEST(SpeedCheck, OfWhatIsNotThere) {
  EXPECT_FALSE(speed_check(report_of(6, {})));
  const SpeedCheck still = speed_check(report_of(0, MeasuredImpact{.speed = 4})).value();
  EXPECT_FALSE(still.agrees());
  EXPECT_FALSE(still.min_scale);
  EXPECT_FALSE(still.greatest_scale);
  EXPECT_THAT(still.text, HasSubstr("the pulse would have to show an acceleration"));
}

TEST(UnlikeSpeeds, AreMoreThanOnePercentApart) {
  const auto flag = [](double computed) {
    return unlike_speeds({.speed = 5}, MeasuredImpact{.speed = computed});
  };
  for (const double share : {0.9901, 1.0, 1.0099}) EXPECT_FALSE(flag(5 * share)) << share;
  for (const double share : {0.9899, 1.0101}) EXPECT_TRUE(flag(5 * share)) << share;
  EXPECT_EQ(flag(4)->name, "UNLIKE SPEEDS");
  EXPECT_THAT(flag(4)->text,
              HasSubstr("the case, 4 m/s, is 20 % lower than that of the measured impact, 5 m/s:"));
  EXPECT_EQ(flag(4)->figures[0].key, "speed_m_per_s");
  EXPECT_EQ(flag(4)->figures[0].value, 4);
  EXPECT_EQ(flag(4)->figures[1].key, "measured_speed_m_per_s");
  EXPECT_EQ(flag(4)->figures[1].value, 5);
  EXPECT_THAT(flag(60)->text, HasSubstr("1100 % higher"));
  EXPECT_THAT(unlike_speeds(after_fall(1.8), {.speed = 5})->text, HasSubstr("(1.8 m drop)"));
}

/// A fall of 0.6 s is one of 1.765 m. Samples every 0.1 ms leave 0.13 % of it open, beside 1 %.
TEST(HeightInDoubt, IsOneThatTheFallInTheRecordDoesNotHave) {
  constexpr double fall = 0.6, height = standard_gravity * fall * fall / 2;
  const auto flag = [](double said, bool rests) {
    PulseReport report = report_of(6, after_fall(said));
    report.measured.pulse.time = {0, 1e-4};
    report.contact.begin = 0.1 + fall;
    report.offset = OffsetEffect{.offset = {.begin = 0.1, .end = 0.5}};
    if (rests) report.offset->offset.rest = {.end = 0.1, .mean = {standard_gravity}};
    return height_in_doubt(report);
  };
  for (const double share : {0.9889, 1.0, 1.0111}) EXPECT_FALSE(flag(height / share, true)) << share;
  for (const double share : {0.9885, 1.0115}) EXPECT_TRUE(flag(height / share, true)) << share;
  EXPECT_FALSE(flag(2 * height, false));
  EXPECT_THAT(flag(2, true)->text, HasSubstr("lasts 600 ms, as in a drop of 1.77 m, but 2 m was given"));
  const std::vector<FlagFigure> figures = flag(2, true)->figures;
  for (const auto& [i, expected] : {std::pair{0U, FlagFigure{"fall_s", fall}},
                                    {1U, {"height_m", height}},
                                    {2U, {"stated_height_m", 2}}}) {
    EXPECT_EQ(figures.at(i).key, expected.key);
    EXPECT_NEAR(figures.at(i).value, expected.value, 1e-12);
  }
  PulseReport of_speed = report_of(6, MeasuredImpact{.speed = 1});
  EXPECT_FALSE(height_in_doubt(of_speed));
}

}  // namespace
}  // namespace dashpad::injury
