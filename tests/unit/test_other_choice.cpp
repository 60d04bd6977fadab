/// The nose and speed of a standard or of the case: which choice turns the verdict, and how it is said.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/output/assessment.hpp"
#include "dashpad/quantities/unit_system.hpp"

namespace dashpad {
namespace {

using injury::Kept;
using injury::OtherChoice;
using injury::Standard;
using injury::Verdict;

/// A flat disc at 5 m/s on an elastic pad: harder than the sphere of the standard, and faster.
ImpactCase given() {
  ImpactCase impact;
  impact.impactor = {.mass = 4, .nose = FlatDisc{0.08}, .speed = 5};
  impact.pad = {.thickness = 0.05, .material = {.name = "made up", .law = Elastic{4e5}}};
  impact.support = Support::linear(1e5);
  return impact;
}

injury::StandardValue value(double number) {
  injury::StandardValue made;
  made.value = number;
  return made;
}

Standard standard(double limit) {
  Standard made;
  made.radius = value(0.08);
  made.speed = value(4);
  injury::Criterion peak;
  peak.limit = limit;
  made.criteria = {peak};
  return made;
}

double peak(Kept kept) {
  return solve(injury::with_impactor_of(injury::with_kept(standard(1), given().impactor, kept), given()))
      .summary.peak_acceleration.value();
}

injury::Assessment by_values(const Standard& standard, const ImpactCase& impact) {
  return injury::assess(standard, impact, solve(impact));
}

std::vector<OtherChoice> turning(double limit, Kept kept, Verdict verdict) {
  return injury::turning_choices(standard(limit), given(), kept, verdict, by_values);
}

std::string said(const OtherChoice& choice, const char* units = "si") {
  return output::other_choice(choice, standard(1), given(), unit_system(units)).text;
}

constexpr Kept keep_nothing{}, keep_nose{.nose = true, .speed = false},
    keep_speed{.nose = false, .speed = true}, keep_both{.nose = true, .speed = true};

TEST(OtherChoice, keeps_what_differs) {
  const Standard kept = injury::with_kept(standard(1), given().impactor, keep_both);
  EXPECT_FALSE(kept.radius.value.has_value());
  EXPECT_EQ(kept.radius.instead, 0.08);
  EXPECT_EQ(kept.speed.instead, 4);
  Impactor same = given().impactor;
  same.nose = Sphere{0.08};
  EXPECT_EQ(injury::with_kept(standard(1), same, keep_nose).radius.value, 0.08) << "nothing is replaced";
}

TEST(OtherChoice, one_that_turns_the_verdict_is_told) {
  const double limit = (peak(keep_nothing) + std::min(peak(keep_nose), peak(keep_speed))) / 2;
  const std::vector<OtherChoice> choices = turning(limit, keep_nothing, Verdict::pass);
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_THAT(
      said(choices[0]),
      testing::MatchesRegex("OTHER NOSE: with the case's nose, a flat disc, the verdict would be fail "
                            ".peak acceleration [0-9.]+ g.; to check, run with --keep-nose"));
  EXPECT_THAT(
      said(choices[1], "us"),
      testing::MatchesRegex("OTHER SPEED: with the case's speed, 11.185 mph, the verdict would be fail "
                            ".peak acceleration [0-9.]+ g.; to check, run with --keep-speed"));
  EXPECT_TRUE(turning(0.9 * peak(keep_nothing), keep_nothing, Verdict::fail).empty());
  EXPECT_TRUE(turning(1.1 * peak(keep_both), keep_nothing, Verdict::pass).empty());
}

TEST(OtherChoice, one_that_decides_nothing_turns_nothing) {
  const auto undecided = [](const Standard& standard, const ImpactCase& impact) {
    injury::Assessment assessment = by_values(standard, impact);
    assessment.verdict = Verdict::undecided;
    return assessment;
  };
  EXPECT_TRUE(injury::turning_choices(standard(1), given(), keep_nothing, Verdict::pass, undecided).empty());
}

TEST(OtherChoice, what_was_kept_may_be_left_out) {
  const std::vector<OtherChoice> choices =
      turning((peak(keep_nothing) + peak(keep_speed)) / 2, keep_speed, Verdict::fail);
  ASSERT_EQ(choices.size(), 1U);
  EXPECT_THAT(
      said(choices[0]),
      testing::MatchesRegex("OTHER SPEED: with the standard's speed, 4 m/s, the verdict would be pass "
                            ".peak acceleration [0-9.]+ g.; to check, run without --keep-speed"));
}

TEST(OtherChoice, both_are_tried_where_neither_alone_turns_it) {
  const double limit = (std::max(peak(keep_nose), peak(keep_speed)) + peak(keep_both)) / 2;
  const std::vector<OtherChoice> choices = turning(limit, keep_nothing, Verdict::pass);
  ASSERT_EQ(choices.size(), 1U);
  EXPECT_THAT(
      said(choices[0]),
      testing::MatchesRegex("OTHER NOSE AND SPEED: with the case's nose, a flat disc, and the case's "
                            "speed, 5 m/s, the verdict would be fail .*; to check, run with --keep-nose "
                            "--keep-speed"));
}

TEST(OtherChoice, a_number_of_the_user_is_no_choice) {
  Standard chosen = injury::with_user_values(standard((peak(keep_nothing) + peak(keep_nose)) / 2),
                                             {.mass = {}, .radius = 0.07, .speed = 4.5, .drop_height = {}});
  EXPECT_TRUE(injury::turning_choices(chosen, given(), keep_nothing, Verdict::pass, by_values).empty());
}

}  // namespace
}  // namespace dashpad
