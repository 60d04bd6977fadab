/// What is made of a solved impact and the limits of a standard. The solutions are made by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "dashpad/injury/standard.hpp"
#include "dashpad/report/assessment_text.hpp"
#include "example_result.hpp"

namespace dashpad {
namespace {

using ::testing::AllOf;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double g = standard_gravity;
constexpr double duration = 10e-3;

/// A half sine of 10 ms with a peak of 100 g: 3 ms lie above 100 g cos(0.15 pi) = 89.10 g, and the time above
/// 50 g is two thirds of it.
Solution half_sine(double error = 1e-4) {
  constexpr int steps = 1000;
  Solution solution;
  for (int i = 0; i <= steps; ++i) {
    solution.history.time.push_back(duration * i / steps);
    solution.history.acceleration.push_back(-100 * g * std::sin(std::numbers::pi * i / steps));
  }
  solution.summary = test::example_summary();
  solution.summary.peak_acceleration = 100 * g;
  solution.summary.errors.peak_force = error;
  return solution;
}

Criterion criterion(Metric metric, double limit) {
  Criterion made;
  made.metric = metric;
  made.level = 50 * g;
  made.limit = limit;
  made.origin.verified = true;
  return made;
}

StandardValue verified(double value) {
  StandardValue made;
  made.value = value;
  made.origin.verified = true;
  return made;
}

Standard standard_with(std::vector<Criterion> criteria) {
  Standard standard;
  standard.name = "made-up";
  standard.title = "Made up";
  standard.mass = verified(5);
  standard.radius = verified(0.08);
  standard.speed = verified(6);
  standard.criteria = std::move(criteria);
  return standard;
}

/// Of a material that says where it was fitted.
Assessment assess(const Standard& standard, const Solution& solution) {
  return assess(standard, test::example_case(), solution);
}

Assessment assess_peak(double limit, const Solution& solution) {
  return assess(standard_with({criterion(Metric::peak, limit)}), solution);
}

TEST(assessment, passes_below_and_fails_above_the_limit) {
  const Assessment pass = assess_peak(125 * g, half_sine());
  EXPECT_EQ(pass.verdict, Verdict::pass);
  EXPECT_THAT(pass.reservations, IsEmpty());
  EXPECT_TRUE(pass.unqualified());
  EXPECT_EQ(to_string(pass), "pass");
  ASSERT_EQ(pass.results.size(), 1U);
  EXPECT_NEAR(pass.results[0].value.value(), 100 * g, 1e-9);
  EXPECT_NEAR(pass.results[0].margin, 25 * g, 1e-9);
  EXPECT_NEAR(pass.results[0].relative_margin, 0.2, 1e-12);

  const Assessment fail = assess_peak(80 * g, half_sine());
  EXPECT_EQ(to_string(fail), "fail");
  EXPECT_NEAR(fail.results[0].relative_margin, -0.25, 1e-12);
}

TEST(assessment, is_undecided_within_the_error) {
  const Solution solution = half_sine(0.01);
  EXPECT_EQ(assess_peak(101.5 * g, solution).verdict, Verdict::pass);
  EXPECT_EQ(assess_peak(98.5 * g, solution).verdict, Verdict::fail);
  for (const double limit : {99.5, 100.5}) {
    const Assessment assessment = assess_peak(limit * g, solution);
    EXPECT_EQ(assessment.verdict, Verdict::undecided) << limit;
    EXPECT_THAT(assessment.results[0].reason, HasSubstr("within the error"));
  }
  EXPECT_EQ(assess_peak(1000 * g, half_sine(std::numeric_limits<double>::quiet_NaN())).verdict,
            Verdict::undecided);
  EXPECT_EQ(assess_peak(1000 * g, half_sine(std::numeric_limits<double>::infinity())).verdict,
            Verdict::undecided);
}

TEST(assessment, a_strict_limit_is_not_within_itself) {
  const auto verdict = [](double limit, bool strict) {
    Criterion of = criterion(Metric::peak, limit * g);
    of.strict = strict;
    return assess(standard_with({of}), half_sine(0)).verdict;
  };
  EXPECT_EQ(verdict(100, false), Verdict::pass);
  EXPECT_EQ(verdict(100, true), Verdict::fail);
  EXPECT_EQ(verdict(100.001, true), Verdict::pass);
  EXPECT_EQ(verdict(99.999, true), Verdict::fail);
}

TEST(assessment, a_history_too_short_for_an_error_decides_nothing_but_the_peak) {
  Solution solution = half_sine();
  solution.history.time = {0, duration / 2, duration};
  solution.history.acceleration = {0, -100 * g, 0};
  for (const MetricFacts& metric : metrics()) {
    const Assessment assessment = assess(standard_with({criterion(metric.metric, 1e30)}), solution);
    const bool known = metric.metric == Metric::peak;
    EXPECT_EQ(assessment.verdict, known ? Verdict::pass : Verdict::undecided) << metric.key;
    EXPECT_EQ(std::isfinite(assessment.results[0].error), known) << metric.key;
    EXPECT_EQ(assessment.results[0].reason, known ? "" : "the error is unknown") << metric.key;
  }
}

TEST(assessment, values_are_those_of_the_pulse) {
  const Solution solution = half_sine();
  const Assessment assessment =
      assess(standard_with({criterion(Metric::contiguous_3ms, 80 * g),
                            criterion(Metric::cumulative_3ms, 80 * g), criterion(Metric::dwell, 4e-3)}),
             solution);
  const double clip = 100 * g * std::cos(0.15 * std::numbers::pi);
  EXPECT_NEAR(assessment.results[0].value.value(), clip, 1e-4 * clip);
  EXPECT_NEAR(assessment.results[1].value.value(), clip, 1e-4 * clip);
  EXPECT_NEAR(assessment.results[2].value.value(), duration * 2 / 3, 1e-3 * duration);
}

/// 1 % more or less force moves the crossings of 50 g by 0.01 tan(pi / 6) / pi of the duration each.
TEST(assessment, the_error_of_a_dwell_time_follows_from_that_of_the_force) {
  const Assessment assessment = assess(standard_with({criterion(Metric::dwell, 4e-3)}), half_sine(0.01));
  const double expected = 2 * 0.01 * std::tan(std::numbers::pi / 6) / std::numbers::pi * duration;
  EXPECT_NEAR(assessment.results[0].error, expected, 0.05 * expected);
}

TEST(assessment, hic_36_and_hic_d_belong_together) {
  const Assessment assessment =
      assess(standard_with({criterion(Metric::hic36, 1000), criterion(Metric::hic_d, 1000)}), half_sine());
  EXPECT_DOUBLE_EQ(assessment.results[1].value.value(),
                   0.75446 * assessment.results[0].value.value() + 166.4);
}

TEST(assessment, one_failure_decides_and_one_undecided_criterion_leaves_a_pass_open) {
  const auto verdict = [](double first, double second) {
    const Standard standard =
        standard_with({criterion(Metric::peak, first * g), criterion(Metric::peak, second * g)});
    return assess(standard, half_sine(0.01)).verdict;
  };
  EXPECT_EQ(verdict(200, 200), Verdict::pass);
  EXPECT_EQ(verdict(200, 100), Verdict::undecided);
  EXPECT_EQ(verdict(100, 50), Verdict::fail);
}

// --- Reservations: each of these alone must keep a pass from being unqualified ---

TEST(assessment, an_extrapolated_result_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.extrapolated = true;
  EXPECT_THAT(assess_peak(200 * g, solution).reservations, ElementsAre(StartsWith("EXTRAPOLATED: outside")));
  solution.summary.extrapolations = {"strain too large", "rate too large"};
  const Assessment assessment = assess_peak(200 * g, solution);
  EXPECT_EQ(to_string(assessment), "pass, with reservations");
  EXPECT_THAT(assessment.reservations,
              ElementsAre("EXTRAPOLATED: strain too large", "EXTRAPOLATED: rate too large"));
}

TEST(assessment, an_unknown_range_is_no_unqualified_pass) {
  const Standard standard = standard_with({criterion(Metric::peak, 200 * g)});
  ImpactCase impact = test::example_case();
  EXPECT_TRUE(assess(standard, impact, half_sine()).unqualified());
  impact.pad.material.fitted.reset();
  const Assessment assessment = assess(standard, impact, half_sine());
  EXPECT_EQ(to_string(assessment), "pass, with reservations");
  EXPECT_THAT(assessment.reservations,
              ElementsAre("UNKNOWN RANGE: the card does not say where its law was fitted"));
  impact.pad.material.name = "in line";
  EXPECT_THAT(assess(standard, impact, half_sine()).reservations,
              ElementsAre("UNKNOWN RANGE: the case does not say where its law was fitted"));
}

TEST(assessment, a_bottomed_result_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.bottomed = Moment{.time = 0.004, .velocity = 1};
  const Assessment assessment = assess_peak(200 * g, solution);
  EXPECT_EQ(to_string(assessment), "pass, with reservations");
  EXPECT_THAT(assessment.reservations,
              ElementsAre(AllOf(StartsWith("BOTTOMED"), HasSubstr("support gave way"))));
}

TEST(assessment, a_missed_tolerance_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.status = Status::tolerance_not_met;
  EXPECT_THAT(assess_peak(200 * g, solution).reservations, ElementsAre(StartsWith("TOLERANCE NOT MET")));
}

TEST(assessment, unverified_values_are_no_unqualified_pass) {
  Standard standard = standard_with({criterion(Metric::peak, 200 * g), criterion(Metric::dwell, 1)});
  for (Criterion& of : standard.criteria) of.origin.verified = false;
  standard.radius.origin.verified = false;
  EXPECT_THAT(assess(standard, half_sine()).reservations,
              ElementsAre(AllOf(StartsWith("UNVERIFIED"),
                                HasSubstr(": radius, limit of peak, limit of dwell above 50 g"))));
}

TEST(assessment, a_value_that_the_case_gives_needs_no_verification) {
  Standard standard = standard_with({criterion(Metric::peak, 200 * g)});
  standard.speed = {};
  EXPECT_TRUE(assess(standard, half_sine()).unqualified());
  standard = with_user_values(standard, {.mass = {}, .radius = {}, .speed = 3, .drop_height = {}});
  EXPECT_TRUE(assess(standard, half_sine()).unqualified());
}

TEST(assessment, a_replaced_value_is_no_unqualified_pass) {
  const Standard standard = with_user_values(standard_with({criterion(Metric::peak, 200 * g)}),
                                             {.mass = 4, .radius = {}, .speed = {}, .drop_height = {}});
  EXPECT_THAT(assess(standard, half_sine()).reservations,
              ElementsAre("REPLACED: the mass is not that of the standard"));
}

/// On a rigid support, until the pad was fully compressed: the first 3 ms of the half sine.
Solution bottomed_out() {
  Solution solution = half_sine();
  solution.history.time.resize(301);
  solution.history.acceleration.resize(301);
  solution.summary = test::bottomed_out_summary();
  solution.summary.errors = {};
  return solution;
}

TEST(assessment, bottoming_on_a_rigid_support_fails_what_follows_the_force) {
  for (const MetricFacts& metric : metrics()) {
    if (!metric.grows_without_bound) continue;
    const Assessment assessment = assess(standard_with({criterion(metric.metric, 1e30)}), bottomed_out());
    EXPECT_EQ(assessment.verdict, Verdict::fail) << metric.key;
    EXPECT_FALSE(assessment.results[0].value) << metric.key;
    EXPECT_THAT(assessment.results[0].reason, HasSubstr("no finite value")) << metric.key;
    EXPECT_THAT(assessment.reservations, ElementsAre(StartsWith("BOTTOMED"))) << metric.key;
  }
}

TEST(assessment, bottoming_on_a_rigid_support_leaves_lower_bounds_of_times) {
  const Assessment assessment =
      assess(standard_with({criterion(Metric::dwell, 4e-3), criterion(Metric::dwell, 1e-3)}), bottomed_out());
  EXPECT_NEAR(assessment.results[0].value.value(), (0.3 - 1.0 / 6) * duration, 1e-3 * duration);
  EXPECT_TRUE(assessment.results[0].lower_bound);
  EXPECT_EQ(assessment.results[0].verdict, Verdict::undecided);
  EXPECT_THAT(assessment.results[0].reason, HasSubstr("can only grow"));
  EXPECT_EQ(assessment.results[1].verdict, Verdict::fail);
}

TEST(assessment, an_impact_that_was_not_computed_to_its_end_cannot_pass) {
  Solution solution = half_sine();
  solution.summary.status = Status::time_limit;
  solution.summary.contact_end.reset();
  const Assessment below = assess_peak(200 * g, solution);
  EXPECT_EQ(below.verdict, Verdict::undecided);
  EXPECT_THAT(below.reservations, ElementsAre(StartsWith("PULSE CUT"), StartsWith("INCOMPLETE")));
  EXPECT_EQ(assess_peak(50 * g, solution).verdict, Verdict::fail);
}

TEST(assessment, needs_criteria_and_a_solution) {
  EXPECT_THROW(assess(standard_with({}), half_sine()), std::invalid_argument);
  EXPECT_THROW(assess_peak(g, Solution{}), std::invalid_argument);
}

// --- Text and JSON ---

struct Written {
  std::string text, json;
};

Written write(const Standard& standard, const Solution& solution) {
  const ImpactCase given = test::example_case();
  const ImpactCase assessed = with_impactor_of(standard, given);
  const Assessment assessment = assess(standard, assessed, solution);
  const AssessmentReport report{standard, given, assessed, solution, assessment};
  return {assessment_text(report, unit_systems().front()), assessment_json(report)};
}

TEST(assessment_text, says_what_was_replaced_and_how_large_the_margin_is) {
  Standard standard = standard_with({criterion(Metric::peak, 80 * g)});
  standard.radius = {};
  standard = with_user_values(standard, {.mass = {}, .radius = {}, .speed = 8, .drop_height = {}});
  const std::string text = write(standard, half_sine()).text;
  EXPECT_THAT(
      text, AllOf(StartsWith("Made up (made-up)\n"), HasSubstr("5 kg, of the standard; the case has 4.5 kg"),
                  HasSubstr("8 m/s, given by you; the case has 8.9408 m/s, the standard 6 m/s"),
                  HasSubstr("Kept from the case: radius (76.2 mm), pad, support, solver.")));
  EXPECT_THAT(text, AllOf(HasSubstr("-20 g (-25.0 %)"), HasSubstr("\nFAIL, with reservations:\n  - REPLACED"),
                          HasSubstr(assessment_caveat())));
}

TEST(assessment_text, an_unqualified_pass_has_no_reservations) {
  const std::string text = write(standard_with({criterion(Metric::peak, 125 * g)}), half_sine()).text;
  EXPECT_THAT(text, AllOf(HasSubstr("+25 g (+20.0 %)"), HasSubstr("\nPASS\n"), Not(HasSubstr("reservation")),
                          HasSubstr("no certification")));
}

TEST(assessment_text, the_margin_of_a_lower_bound_is_an_upper_bound) {
  Solution solution = half_sine();
  solution.summary.status = Status::time_limit;
  solution.summary.contact_end.reset();
  const Written open = write(standard_with({criterion(Metric::peak, 125 * g)}), solution);
  EXPECT_THAT(open.text, AllOf(HasSubstr("> 100 g"), HasSubstr(" < +25 g (+20.0 %)")));
  EXPECT_EQ(nlohmann::json::parse(open.json)["criteria"][0]["margin_is_upper_bound"], true);
  const Written whole = write(standard_with({criterion(Metric::peak, 125 * g)}), half_sine());
  EXPECT_THAT(whole.text, Not(HasSubstr("<")));
  EXPECT_EQ(nlohmann::json::parse(whole.json)["criteria"][0]["margin_is_upper_bound"], false);
}

TEST(assessment_text, a_strict_limit_is_marked) {
  Criterion of = criterion(Metric::peak, 125 * g);
  of.strict = true;
  const Written written = write(standard_with({of}), half_sine());
  EXPECT_THAT(written.text, HasSubstr(" < 125 g "));
  EXPECT_EQ(nlohmann::json::parse(written.json)["criteria"][0]["strict"], true);
}

TEST(assessment_text, an_error_that_nobody_knows_is_called_unknown) {
  Solution solution = half_sine();
  solution.history.time = {0, duration / 2, duration};
  solution.history.acceleration = {0, -100 * g, 0};
  const Written written = write(standard_with({criterion(Metric::hic36, 1000)}), solution);
  EXPECT_THAT(written.text, HasSubstr("± unknown"));
  EXPECT_EQ(nlohmann::json::parse(written.json)["criteria"][0]["error"], nullptr);
}

TEST(assessment_json, has_the_same_for_programs) {
  const auto json = nlohmann::json::parse(
      write(standard_with({criterion(Metric::peak, 125 * g), criterion(Metric::dwell, 10e-3)}), half_sine())
          .json);
  EXPECT_EQ(json["verdict"], "pass");
  EXPECT_EQ(json["unqualified"], true);
  EXPECT_EQ(json["standard"]["name"], "made-up");
  EXPECT_EQ(json["impactor"]["mass_kg"]["from"], "standard");
  EXPECT_EQ(json["impactor"]["mass_kg"]["case_value"], 4.5);
  EXPECT_EQ(json["criteria"][0]["unit"], "g");
  EXPECT_NEAR(json["criteria"][0]["margin"].get<double>(), 25, 1e-9);
  EXPECT_EQ(json["criteria"][0]["level_g"], nullptr);
  EXPECT_EQ(json["criteria"][1]["unit"], "s");
  EXPECT_DOUBLE_EQ(json["criteria"][1]["level_g"].get<double>(), 50);
  EXPECT_EQ(json["result"]["status"], "released");
  EXPECT_EQ(json["caveat"], assessment_caveat());
}

TEST(assessment_json, has_null_where_there_is_no_finite_value) {
  const auto json =
      nlohmann::json::parse(write(standard_with({criterion(Metric::peak, 125 * g)}), bottomed_out()).json);
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["criteria"][0]["value"], nullptr);
  EXPECT_EQ(json["criteria"][0]["margin"], nullptr);
  EXPECT_EQ(json["criteria"][0]["verdict"], "fail");
}

}  // namespace
}  // namespace dashpad
