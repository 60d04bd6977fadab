/// What is made of a solved impact and the limits of a standard. The solutions are made by hand.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <sstream>
#include <stdexcept>
#include <string>

#include <nlohmann/json.hpp>

#include "coarser_run.hpp"
#include "dashpad/injury/standard.hpp"
#include "dashpad/output/assessment.hpp"
#include "example_result.hpp"
#include "quantities/text.hpp"
#include "shared/gravity.hpp"
#include "shown_values.hpp"

namespace dashpad {
namespace {

using injury::Assessment;
using injury::Standard;
using injury::Verdict;
using ::testing::AllOf;
using ::testing::ContainsRegex;
using ::testing::ElementsAre;
using ::testing::EndsWith;
using ::testing::Field;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;
using ::testing::StartsWith;

constexpr double pulse_duration = 10e-3;

/// A half sine of 10 ms with a peak of 100 g: 3 ms lie above 100 g cos(0.15 pi) = 89.10 g, and the time above
/// 50 g is two thirds of it.
Solution half_sine(double error = 1e-4) {
  constexpr int steps = 1000;
  Solution solution;
  for (int i = 0; i <= steps; ++i) {
    solution.history.time.push_back(pulse_duration * i / steps);
    solution.history.acceleration.push_back(-100 * g * std::sin(std::numbers::pi * i / steps));
  }
  test::add_coarser_run(solution);
  solution.summary = test::example_summary();
  solution.summary.peak_acceleration = 100 * g;
  solution.summary.errors.peak_force = error;
  solution.summary.intervals = Intervals{};  // nothing is open
  return solution;
}

/// The figures of a pulse that may be limited.
constexpr const char* pulse_metrics[]{"peak_acceleration", "clip_3ms", "cumulative_3ms",
                                      "dwell_time",        "hic15",    "hic36",
                                      "hic_unlimited",     "hic_d",    "severity_index"};

injury::Criterion criterion(const char* metric, double limit) {
  injury::Criterion made;
  made.quantity = &result_quantity(metric);
  made.level = 50 * g;
  made.limit = limit;
  made.origin = {.source = "made up", .kind = injury::SourceKind::own_text, .verified = true, .note = ""};
  return made;
}

injury::StandardValue verified(double value) {
  injury::StandardValue made;
  made.value = value;
  made.origin = {.source = "made up", .kind = injury::SourceKind::own_text, .verified = true, .note = ""};
  return made;
}

Standard standard_with(std::vector<injury::Criterion> criteria) {
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
  return injury::assess(standard, test::example_case(), solution);
}

/// A reservation whose text is so.
template <class Matcher>
auto says(const Matcher& text) {
  return Field("text", &Flag::text, text);
}

Assessment assess_peak(double limit, const Solution& solution) {
  return assess(standard_with({criterion("peak_acceleration", limit)}), solution);
}

TEST(assessment, passes_below_and_fails_above_the_limit) {
  const Assessment pass = assess_peak(125 * g, half_sine());
  EXPECT_EQ(pass.verdict, Verdict::pass);
  EXPECT_THAT(pass.reservations, IsEmpty());
  EXPECT_TRUE(pass.unqualified());
  EXPECT_EQ(to_string(pass), "pass");
  ASSERT_EQ(pass.results.size(), 1U);
  EXPECT_NEAR(pass.results[0].value.value(), 100 * g, 1e-9);
  EXPECT_NEAR(pass.results[0].margin.value(), 25 * g, 1e-9);
  EXPECT_NEAR(pass.results[0].relative_margin.value(), 0.2, 1e-12);

  const Assessment fail = assess_peak(80 * g, half_sine());
  EXPECT_EQ(to_string(fail), "fail");
  EXPECT_NEAR(fail.results[0].relative_margin.value(), -0.25, 1e-12);
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
    injury::Criterion of = criterion("peak_acceleration", limit * g);
    of.strict = strict;
    return assess(standard_with({of}), half_sine(0)).verdict;
  };
  EXPECT_EQ(verdict(100, false), Verdict::pass);
  EXPECT_EQ(verdict(100, true), Verdict::fail);
  EXPECT_EQ(verdict(100.001, true), Verdict::pass);
  EXPECT_EQ(verdict(99.999, true), Verdict::fail);
}

/// The value with its error reaches the limit exactly.
TEST(assessment, what_may_be_a_strict_limit_does_not_pass_it) {
  const Solution solution = half_sine(1.0 / 16);
  injury::Criterion of = criterion("peak_acceleration", 0);
  of.limit = *solution.summary.peak_acceleration * (1 + 1.0 / 16);
  EXPECT_EQ(assess(standard_with({of}), solution).verdict, Verdict::pass);
  of.strict = true;
  EXPECT_EQ(assess(standard_with({of}), solution).verdict, Verdict::undecided);
}

TEST(assessment, a_history_too_short_for_an_error_decides_nothing_but_the_peak) {
  Solution solution = half_sine();
  solution.history.time = {0, pulse_duration / 2, pulse_duration};
  solution.history.acceleration = {0, -100 * g, 0};
  solution.coarser = {};
  for (const char* const metric : pulse_metrics) {
    const Assessment assessment = assess(standard_with({criterion(metric, 1e30)}), solution);
    const bool known = metric == std::string("peak_acceleration");
    EXPECT_EQ(assessment.verdict, known ? Verdict::pass : Verdict::undecided) << metric;
    EXPECT_EQ(std::isfinite(assessment.results[0].error), known) << metric;
    EXPECT_EQ(assessment.results[0].reason, known ? "" : "the error is unknown") << metric;
  }
}

TEST(assessment, values_are_those_of_the_pulse) {
  const Solution solution = half_sine();
  const Assessment assessment =
      assess(standard_with({criterion("clip_3ms", 80 * g), criterion("cumulative_3ms", 80 * g),
                            criterion("dwell_time", 4e-3)}),
             solution);
  const double clip = 100 * g * std::cos(0.15 * std::numbers::pi);
  EXPECT_NEAR(assessment.results[0].value.value(), clip, 1e-4 * clip);
  EXPECT_NEAR(assessment.results[1].value.value(), clip, 1e-4 * clip);
  EXPECT_NEAR(assessment.results[2].value.value(), pulse_duration * 2 / 3, 1e-3 * pulse_duration);
}

/// Two triangles of 4 ms with a peak of 100 g: of each 4 ms (1 - a / 100 g) lie above a.
TEST(assessment, of_two_humps_only_the_cumulative_time_counts_both) {
  Solution solution = half_sine();
  solution.history.time = {};
  solution.history.acceleration = {};
  for (int i = 0; i <= 1000; ++i) {
    const double time = 1e-5 * i;  // the humps from 0 and from 6 ms on
    const double into = time < 5e-3 ? time : time - 6e-3;
    solution.history.time.push_back(time);
    solution.history.acceleration.push_back(-100 * g * std::max(0.0, 1 - std::abs(into / 2e-3 - 1)));
  }
  solution.coarser = {solution.history.time, solution.history.acceleration};
  const Assessment assessment =
      assess(standard_with({criterion("clip_3ms", 80 * g), criterion("cumulative_3ms", 80 * g)}), solution);
  EXPECT_NEAR(assessment.results[0].value.value(), 25 * g, 1e-3 * g);
  EXPECT_NEAR(assessment.results[1].value.value(), 62.5 * g, 1e-3 * g);
}

/// 1 % more or less force moves the crossings of 50 g by 0.01 tan(pi / 6) / pi of the duration each.
TEST(assessment, the_error_of_a_dwell_time_follows_from_that_of_the_force) {
  const Assessment assessment = assess(standard_with({criterion("dwell_time", 4e-3)}), half_sine(0.01));
  const double expected = 2 * 0.01 * std::tan(std::numbers::pi / 6) / std::numbers::pi * pulse_duration;
  EXPECT_NEAR(assessment.results[0].error, expected, 0.05 * expected);
}

/// Steep above 50 g and flat below, a little less force shortens the time above 50 g by little, a little more
/// lengthens it much: the error is the larger of both.
TEST(assessment, the_error_of_a_dwell_time_is_that_to_the_worse_side) {
  Solution solution = half_sine(0.01);
  History& history = solution.history;
  history.time.clear();
  history.acceleration.clear();
  for (int i = 0; i <= 2200; ++i) {
    const double time = 1e-5 * i, from_end = std::min(time, 22e-3 - time);
    history.time.push_back(time);
    history.acceleration.push_back(-g * (from_end < 10e-3 ? 5e3 * from_end : 50 + 50e3 * (from_end - 10e-3)));
  }
  solution.coarser = {history.time, history.acceleration};  // the steps leave nothing
  const Assessment assessment = assess(standard_with({criterion("dwell_time", 1e-3)}), solution);
  EXPECT_NEAR(assessment.results[0].value.value(), 2e-3, 1e-6);
  EXPECT_NEAR(assessment.results[0].error, 2 * 0.5 / 5e3, 5e-6);
}

TEST(assessment, hic_36_and_hic_d_belong_together) {
  const Assessment assessment =
      assess(standard_with({criterion("hic36", 1000), criterion("hic_d", 1000)}), half_sine());
  EXPECT_DOUBLE_EQ(assessment.results[1].value.value(),
                   0.75446 * assessment.results[0].value.value() + 166.4);
}

TEST(assessment, one_failure_decides_and_one_undecided_criterion_leaves_a_pass_open) {
  const auto verdict = [](double first, double second) {
    const Standard standard = standard_with(
        {criterion("peak_acceleration", first * g), criterion("peak_acceleration", second * g)});
    return assess(standard, half_sine(0.01)).verdict;
  };
  EXPECT_EQ(verdict(200, 200), Verdict::pass);
  EXPECT_EQ(verdict(200, 100), Verdict::undecided);
  EXPECT_EQ(verdict(100, 50), Verdict::fail);
}

// --- Reservations: each of these alone must keep a pass from being unqualified ---

TEST(assessment, an_extrapolated_result_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.extrapolations = {{Beyond::strain, "strain too large"}, {Beyond::rate, "rate too large"}};
  const Assessment assessment = assess_peak(200 * g, solution);
  EXPECT_EQ(to_string(assessment), "pass, with reservations");
  EXPECT_THAT(assessment.reservations, ElementsAre(says("EXTRAPOLATED STRAIN: strain too large"),
                                                   says("EXTRAPOLATED RATE: rate too large")));
}

TEST(assessment, an_unknown_range_is_no_unqualified_pass) {
  const Standard standard = standard_with({criterion("peak_acceleration", 200 * g)});
  ImpactCase impact = test::example_case();
  EXPECT_TRUE(injury::assess(standard, impact, half_sine()).unqualified());
  impact.pad.material.fitted.reset();
  const Assessment assessment = injury::assess(standard, impact, half_sine());
  EXPECT_EQ(to_string(assessment), "pass, with reservations");
  EXPECT_THAT(
      assessment.reservations,
      ElementsAre(says("UNKNOWN RANGE: the card does not state the range over which its law was fitted")));
  impact.pad.material.name = foam_of_the_case;
  EXPECT_THAT(
      injury::assess(standard, impact, half_sine()).reservations,
      ElementsAre(says("UNKNOWN RANGE: the case does not state the range over which its law was fitted")));
}

TEST(assessment, a_bottomed_result_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.bottomed = Moment{.time = 0.004, .velocity = 1};
  const Assessment assessment = assess_peak(200 * g, solution);
  EXPECT_EQ(to_string(assessment), "pass, with reservations");
  EXPECT_THAT(assessment.reservations,
              ElementsAre(says(AllOf(StartsWith("BOTTOMED"), HasSubstr("support yielded")))));
}

TEST(assessment, a_missed_tolerance_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.status = Status::tolerance_not_met;
  EXPECT_THAT(assess_peak(200 * g, solution).reservations,
              ElementsAre(says(StartsWith("TOLERANCE NOT MET"))));
}

TEST(assessment, unverified_values_are_no_unqualified_pass) {
  Standard standard = standard_with({criterion("peak_acceleration", 200 * g), criterion("dwell_time", 1)});
  for (injury::Criterion& criterion : standard.criteria) criterion.origin.verified = false;
  standard.radius.origin.verified = false;
  EXPECT_THAT(assess(standard, half_sine()).reservations,
              ElementsAre(says(AllOf(
                  StartsWith("UNVERIFIED"),
                  HasSubstr(": radius, limit on peak acceleration, limit on dwell time above 50 g (")))));
}

TEST(assessment, values_that_were_read_elsewhere_are_no_unqualified_pass) {
  Standard standard = standard_with({criterion("peak_acceleration", 200 * g), criterion("dwell_time", 1)});
  standard.mass.origin.kind = injury::SourceKind::secondary;
  standard.criteria[1].origin.kind = injury::SourceKind::secondary;
  EXPECT_THAT(
      assess(standard, half_sine()).reservations,
      ElementsAre(says("SECONDARY SOURCE: mass, limit on dwell time above 50 g (found in a source that "
                       "quotes the standard, not in the standard itself)")));
  // What was not even read there is named once.
  standard.mass.origin.verified = false;
  EXPECT_THAT(assess(standard, half_sine()).reservations,
              ElementsAre(says(StartsWith("UNVERIFIED: ")),
                          says(AllOf(StartsWith("SECONDARY SOURCE: "), Not(HasSubstr("mass"))))));
}

TEST(assessment, a_value_that_the_case_gives_needs_no_verification) {
  Standard standard = standard_with({criterion("peak_acceleration", 200 * g)});
  standard.speed = {};
  standard.speed.origin.kind = injury::SourceKind::secondary;
  EXPECT_TRUE(assess(standard, half_sine()).unqualified());
  standard = injury::with_user_values(standard, {.mass = {}, .radius = {}, .speed = 3, .drop_height = {}});
  EXPECT_TRUE(assess(standard, half_sine()).unqualified());
}

TEST(assessment, a_replaced_value_is_no_unqualified_pass) {
  const Standard standard =
      injury::with_user_values(standard_with({criterion("peak_acceleration", 200 * g)}),
                               {.mass = 4, .radius = {}, .speed = {}, .drop_height = {}});
  EXPECT_THAT(assess(standard, half_sine()).reservations,
              ElementsAre(says("REPLACED: the mass is not that of the standard")));
}

/// On a rigid support, until the pad was fully compressed: the first 3 ms of the half sine.
Solution bottomed_out() {
  Solution solution = half_sine();
  solution.history.time.resize(301);
  solution.history.acceleration.resize(301);
  test::add_coarser_run(solution);
  solution.summary = test::bottomed_out_summary();
  solution.summary.errors = {};
  solution.summary.intervals = Intervals{};
  return solution;
}

/// No figure of it is a margin: the pad bottomed out.
TEST(assessment, a_pad_that_is_struck_through_fails_whatever_is_asked_for) {
  for (const char* const metric : pulse_metrics) {
    const Assessment assessment = assess(standard_with({criterion(metric, 1e30)}), bottomed_out());
    EXPECT_EQ(assessment.verdict, Verdict::fail) << metric;
    const injury::CriterionResult& result = assessment.results[0];
    EXPECT_FALSE(result.value || result.margin || result.relative_margin) << metric;
    EXPECT_THAT(result.reason, HasSubstr("bottomed out on a rigid support")) << metric;
    EXPECT_THAT(assessment.reservations, ElementsAre(says(StartsWith("BOTTOMED")))) << metric;
  }
  const injury::KeyFigures figures = assess_peak(1e30, bottomed_out()).figures;
  EXPECT_FALSE(figures.peak_acceleration.value || figures.hic15.value || figures.hic36.value);
  EXPECT_FALSE(figures.contact_end.value || figures.rebound_speed.value || figures.restitution.value);
  EXPECT_TRUE(figures.peak_strain.value && !figures.peak_strain.lower_bound);
}

/// On a yielding support the force stays finite and the pulse whole: its figures decide.
TEST(assessment, a_pad_that_bottoms_on_a_yielding_support_is_judged_by_its_figures) {
  Solution solution = half_sine();
  solution.summary.bottomed = Moment{.time = 0.004, .velocity = 1};
  for (const char* const metric : pulse_metrics) {
    const Assessment mild = assess(standard_with({criterion(metric, 1e30)}), solution);
    EXPECT_EQ(to_string(mild), "pass, with reservations") << metric;
    const Assessment harsh = assess(standard_with({criterion(metric, 1e-30)}), solution);
    EXPECT_EQ(harsh.verdict, Verdict::fail) << metric;
    EXPECT_TRUE(harsh.results[0].margin) << metric;
  }
}

/// The half sine up to its peak, where the impactor comes to rest and stays.
Solution rising_flank() {
  Solution solution = half_sine();
  solution.history.time.resize(501);
  solution.history.acceleration.resize(501);
  test::add_coarser_run(solution);
  solution.summary.force_below_weight.reset();
  solution.summary.contact_end.reset();
  solution.summary.rebound_speed = 0;
  solution.summary.restitution = 0;
  solution.summary.release = Moment{.time = pulse_duration / 2, .velocity = 0};
  return solution;
}

/// The clip of the flank alone is below 80 g, that of the whole pulse above.
TEST(assessment, a_pulse_without_its_falling_flank_is_judged_by_nothing_but_its_peak) {
  for (const char* const metric : pulse_metrics) {
    const Assessment mild = assess(standard_with({criterion(metric, 1e30)}), rising_flank());
    EXPECT_THAT(mild.reservations, ElementsAre(says(StartsWith("PULSE CUT")))) << metric;
    const bool is_peak = metric == std::string("peak_acceleration");
    EXPECT_EQ(mild.verdict, is_peak ? Verdict::pass : Verdict::undecided) << metric;
    EXPECT_EQ(mild.results[0].lower_bound, !is_peak) << metric;
    EXPECT_EQ(mild.results[0].margin.has_value(), is_peak) << metric;
    EXPECT_THAT(mild.results[0].reason, StartsWith(is_peak ? "" : "the pulse ends at its peak"));
    // What is there already is above: it can only grow.
    const Assessment harsh = assess(standard_with({criterion(metric, 1e-30)}), rising_flank());
    EXPECT_EQ(harsh.verdict, Verdict::fail) << metric;
  }
  const Standard clip = standard_with({criterion("clip_3ms", 80 * g)});
  EXPECT_NEAR(assess(clip, rising_flank()).results[0].value.value(),
              100 * g * std::sin(0.2 * std::numbers::pi), 0.1 * g);
  EXPECT_EQ(assess(clip, rising_flank()).verdict, Verdict::undecided);
  EXPECT_EQ(assess(clip, half_sine()).verdict, Verdict::fail);
}

TEST(assessment, an_impact_that_was_not_computed_to_its_end_cannot_pass) {
  Solution solution = half_sine();
  solution.summary.status = Status::time_limit;
  solution.summary.contact_end.reset();
  solution.summary.release.reset();
  solution.summary.rebound_speed.reset();
  solution.summary.restitution.reset();
  for (const char* const metric : pulse_metrics) {
    const Assessment below = assess(standard_with({criterion(metric, 1e30)}), solution);
    EXPECT_EQ(below.verdict, Verdict::undecided) << metric;
    EXPECT_THAT(below.results[0].reason, StartsWith("the pulse ends with")) << metric;
    EXPECT_THAT(below.reservations,
                ElementsAre(says(StartsWith("TIME LIMIT")), says(StartsWith("PULSE CUT"))));
    EXPECT_TRUE(below.figures.peak_acceleration.lower_bound && below.figures.peak_strain.lower_bound);
  }
  const Assessment above = assess_peak(50 * g, solution);
  EXPECT_EQ(above.verdict, Verdict::fail);
  EXPECT_NEAR(above.results[0].margin.value(), -50 * g, 1e-9);
}

/// Whatever the standard asks for.
TEST(assessment, says_the_key_figures_of_the_impact) {
  const Summary summary = half_sine().summary;
  const injury::KeyFigures whole = assess_peak(200 * g, half_sine()).figures;
  EXPECT_EQ(whole.peak_acceleration.value, 100 * g);
  EXPECT_NEAR(whole.hic15.value.value(), 414.65, 0.05);
  EXPECT_NEAR(whole.hic36.value.value(), 414.65, 0.05);
  EXPECT_EQ(whole.peak_strain.value, summary.peak_strain);
  EXPECT_TRUE(whole.contact_end.value);
  EXPECT_EQ(whole.rebound_speed.value, summary.rebound_speed);
  EXPECT_EQ(whole.restitution.value, summary.restitution);
  EXPECT_FALSE(whole.hic15.lower_bound || whole.peak_acceleration.lower_bound);

  const injury::KeyFigures cut = assess_peak(200 * g, rising_flank()).figures;
  EXPECT_FALSE(cut.peak_acceleration.lower_bound || cut.peak_strain.lower_bound);
  EXPECT_TRUE(cut.hic15.lower_bound && cut.hic36.lower_bound);
  EXPECT_LT(cut.hic15.value, whole.hic15.value);
  EXPECT_FALSE(cut.contact_end.value || cut.rebound_speed.value || cut.restitution.value);
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
  const ImpactCase assessed = injury::with_impactor_of(standard, given);
  const Assessment assessment = injury::assess(standard, assessed, solution);
  const output::AssessmentReport report{standard, given, assessed, solution, assessment};
  return {
      output::to_terminal(output::assessment_document(report, unit_systems().front()), output::Detail::main),
      output::assessment_json(report)};
}

// --- The answer on top of the page ---

std::string answer_to(const Standard& standard, const Solution& solution) {
  const ImpactCase given = test::example_case();
  const ImpactCase assessed = injury::with_impactor_of(standard, given);
  const Assessment assessment = injury::assess(standard, assessed, solution);
  const output::AssessmentReport report{standard, given, assessed, solution, assessment};
  const output::Lead lead = *output::assessment_document(report, unit_systems().front()).lead;
  EXPECT_EQ(lead.answer.find(" to spare,") != std::string::npos,
            lead.tone == output::Tone::doubtful && assessment.verdict == Verdict::pass);
  return lead.answer;
}

TEST(assessment_answer, a_pass_of_a_pad_that_is_struck_through_is_doubtful) {
  const Standard standard = standard_with({criterion("peak_acceleration", 150 * g)});
  Solution solution = half_sine();
  EXPECT_EQ(answer_to(standard, solution), "Passes: peak acceleration has 50 g to spare");
  solution.summary.peak_penetration = 0.9999 * test::example_case().pad.thickness;
  EXPECT_THAT(answer_to(standard, solution),
              StartsWith("Passes: peak acceleration has 50 g to spare, but "
                         "less than 0.1 % of the pad thickness is left, at a peak of"));
}

/// A half sine with a spike, after which the pad is as given, of which a clip passes that a peak would not.
Solution half_sine_of_pad(double strain, std::vector<Extrapolation> extrapolations = {}, double spike = 150) {
  Solution solution = half_sine();
  solution.summary.peak_acceleration = spike * g;
  solution.summary.peak_strain = strain;
  solution.summary.extrapolations = std::move(extrapolations);
  return solution;
}

TEST(assessment_answer, a_pass_by_the_clip_alone_tells_of_the_spike_of_a_crushed_pad) {
  const Standard standard = standard_with({criterion("clip_3ms", 95 * g)});
  EXPECT_THAT(answer_to(standard, half_sine_of_pad(0.9999)),
              EndsWith(" g to spare, but the pad is crushed through, with a peak of 150 g too short for the "
                       "3 ms clip to see"));
  EXPECT_THAT(
      answer_to(standard, half_sine_of_pad(0.87, {{Beyond::strain, "the strain reaches 0.870"}})),
      EndsWith(" g to spare, but the pad is strained to 0.87, beyond the tests of its foam, with a peak of "
               "150 g too short for the 3 ms clip to see"));
  EXPECT_THAT(answer_to(standard, half_sine_of_pad(0.87)), EndsWith(" g to spare"));
  // A smooth pulse has no spike, though its peak is a little above its clip.
  EXPECT_THAT(answer_to(standard, half_sine_of_pad(0.9999, {}, 110)), EndsWith(" g to spare"));
}

TEST(assessment, has_a_short_spike_only_if_no_limit_sees_it) {
  const Solution crushed = half_sine_of_pad(0.9999);
  const auto spikes = [&](std::vector<injury::Criterion> criteria) {
    const Assessment of = assess(standard_with(std::move(criteria)), crushed);
    return std::ranges::count(of.reservations, "SHORT SPIKE", &Flag::name);
  };
  const injury::Criterion clip = criterion("clip_3ms", 95 * g);
  EXPECT_EQ(spikes({clip}), 1);
  EXPECT_EQ(spikes({criterion("dwell_time", 8e-3)}), 1);
  EXPECT_EQ(spikes({clip, criterion("peak_penetration", 1)}), 1);
  EXPECT_EQ(spikes({clip, criterion("peak_acceleration", 160 * g)}), 0);
  EXPECT_EQ(spikes({clip, criterion("hic15", 1e4)}), 0);
  EXPECT_EQ(spikes({criterion("clip_3ms", 150 * g)}), 0) << "the peak itself keeps the limit";
  EXPECT_EQ(spikes({criterion("clip_3ms", 50 * g)}), 0) << "a fail needs no reservation";
  const Assessment of = assess(standard_with({clip}), crushed);
  EXPECT_EQ(of.verdict, Verdict::pass);
  EXPECT_FALSE(of.unqualified());
}

/// A half sine whose peak may lie between two values, by how its foam goes on.
Solution half_sine_between(double low, double high) {
  Solution solution = half_sine();
  solution.summary.intervals =
      Intervals{.figures = {{.key = "peak_acceleration",
                             .nominal = 100 * g,
                             .low = low * g,
                             .high = high * g,
                             .sources = {{Source::continuation, low * g, high * g}}}},
                .sources = {{Source::continuation, "the stress beyond a strain of 0.75", ""}},
                .warning = {}};
  return solution;
}

TEST(assessment, is_decided_by_the_interval_as_a_whole) {
  EXPECT_EQ(assess_peak(150 * g, half_sine_between(95, 140)).verdict, Verdict::pass);
  EXPECT_EQ(assess_peak(150 * g, half_sine_between(95, 160)).verdict, Verdict::undecided);
  EXPECT_EQ(assess_peak(99 * g, half_sine_between(98, 120)).verdict, Verdict::undecided);
  EXPECT_EQ(assess_peak(90 * g, half_sine_between(95, 140)).verdict, Verdict::fail);
  constexpr double without_limit = std::numeric_limits<double>::infinity();
  EXPECT_EQ(assess_peak(1e6 * g, half_sine_between(95, without_limit)).verdict, Verdict::undecided);
}

TEST(assessment, without_intervals_or_with_what_has_none_is_no_unqualified_pass) {
  Solution solution = half_sine();
  solution.summary.intervals.reset();
  EXPECT_THAT(assess_peak(150 * g, solution).reservations, ElementsAre(says(StartsWith("NO INTERVALS: "))));
  solution.summary.intervals =
      Intervals{.figures = {}, .sources = {{Source::scatter, "how it scatters", "why"}}, .warning = {}};
  EXPECT_THAT(assess_peak(150 * g, solution).reservations,
              ElementsAre(says("NO INTERVAL for how it scatters: why")));
}

TEST(assessment_answer, gives_the_interval_that_leaves_it_undecided) {
  const Standard standard = standard_with({criterion("peak_acceleration", 150 * g)});
  EXPECT_EQ(answer_to(standard, half_sine_between(95, 140)), "Passes: peak acceleration has 50 g to spare");
  EXPECT_EQ(answer_to(standard, half_sine_between(95, 160)),
            "Undecided: peak acceleration could be anywhere from 95 to 160 g, but must be at most 150 g");
  constexpr double without_limit = std::numeric_limits<double>::infinity();
  EXPECT_EQ(answer_to(standard, half_sine_between(95, without_limit)),
            "Undecided: peak acceleration could be 95 g or more, but must be at most 150 g");
  EXPECT_EQ(answer_to(standard, half_sine_between(0, 160)),
            "Undecided: peak acceleration could be at most 160 g, but must be at most 150 g");
  EXPECT_EQ(answer_to(standard, half_sine_between(0, without_limit)),
            "Undecided: peak acceleration could be any value, but must be at most 150 g");
}

TEST(assessment_text, names_what_the_interval_comes_from) {
  const Standard standard = standard_with({criterion("peak_acceleration", 150 * g)});
  EXPECT_THAT(
      test::in_one_line(write(standard, half_sine_between(95, 160)).text),
      HasSubstr("95 % interval 95 to 160 g. The only contributing source of uncertainty is the stress "
                "beyond a strain of 0.75."));
}

TEST(assessment_text, says_what_was_replaced_and_how_large_the_margin_is) {
  Standard standard = standard_with({criterion("peak_acceleration", 80 * g)});
  standard.radius = {};
  standard = injury::with_user_values(standard, {.mass = {}, .radius = {}, .speed = 8, .drop_height = {}});
  const std::string text = write(standard, half_sine()).text;
  EXPECT_THAT(text, StartsWith("Fails: peak acceleration is 20 g above its limit\nMade up (made-up)\n"));
  EXPECT_THAT(test::in_one_line(text),
              AllOf(HasSubstr("mass, 5 kg from the standard instead of 4.5 kg; "),
                    HasSubstr("; speed, 8 m/s given by you instead of 8.9408 m/s (6 m/s in the standard)."),
                    HasSubstr("Kept from the case: radius (76.2 mm), pad, support and solver settings."),
                    HasSubstr(output::assessment_caveat())));
  EXPECT_THAT(text, AllOf(HasSubstr("fail by 20 g (25.0 %)"), HasSubstr("\nREPLACED: ")));
  // Also true of an assessment that keeps the nose of the case.
  EXPECT_THAT(output::assessment_caveat(), HasSubstr("a rigid nose on a flat pad"));
}

TEST(assessment_text, an_unqualified_pass_has_no_reservations) {
  const std::string text = write(standard_with({criterion("peak_acceleration", 125 * g)}), half_sine()).text;
  EXPECT_THAT(text,
              AllOf(HasSubstr("pass with 25 g (20.0 %) to spare"),
                    StartsWith("Passes: peak acceleration has 25 g to spare\nMade up (made-up)\n"),
                    ContainsRegex("instead\\s+of\\s+76.2 mm;\\s+speed,\\s+6 m/s\\s+from\\s+the\\s+standard"
                                  "\\s+instead\\s+of\\s+8.9408 m/s[.]\n\n  Peak"),
                    ContainsRegex("nor\\s+a\\s+certification")));
}

TEST(assessment_text, names_the_blow_that_its_figures_are_of) {
  const Standard standard = standard_with({criterion("peak_acceleration", 125 * g)});
  Solution solution = half_sine();
  EXPECT_THAT(write(standard, solution).text, Not(HasSubstr("blow")));
  solution.summary.blow = solution.summary.blows = 3;
  EXPECT_THAT(write(standard, solution).text, HasSubstr("\nFigures for blow 3 of 3\n"));
}

TEST(assessment_text, a_lower_bound_has_a_margin_only_where_it_fails) {
  const Written failed = write(standard_with({criterion("hic15", 100)}), rising_flank());
  EXPECT_THAT(failed.text,
              AllOf(StartsWith("Fails: "), HasSubstr("\nPULSE CUT: "),
                    ContainsRegex("HIC15 +≥ [0-9.]+ +at most 100 +fail by [0-9.]+ \\([0-9.]+ %\\) or "
                                  "more\n")));
  EXPECT_EQ(nlohmann::json::parse(failed.json)["criteria"][0]["margin_is_upper_bound"], true);
  const Written open = write(standard_with({criterion("hic15", 1000)}), rising_flank());
  EXPECT_THAT(
      open.text,
      AllOf(StartsWith("Undecided: the run ends before the impact does\n"),
            ContainsRegex("HIC15 +≥ [0-9.]+ +± [0-9.]+ % +at most 1000 +undecided: the\\s+pulse\\s+ends"),
            Not(HasSubstr("spare"))));
  const auto json = nlohmann::json::parse(open.json);
  EXPECT_EQ(json["verdict"], "undecided");
  EXPECT_EQ(json["criteria"][0]["margin"], nullptr);
  EXPECT_EQ(json["criteria"][0]["margin_fraction"], nullptr);
  EXPECT_EQ(json["criteria"][0]["lower_bound"], true);
  const Written whole = write(standard_with({criterion("peak_acceleration", 125 * g)}), half_sine());
  EXPECT_THAT(whole.text, AllOf(Not(HasSubstr("≥")), Not(HasSubstr("or more"))));
  EXPECT_EQ(nlohmann::json::parse(whole.json)["criteria"][0]["margin_is_upper_bound"], false);
}

TEST(assessment_text, says_at_which_speed_the_pad_was_struck_through) {
  const Written written = write(standard_with({criterion("clip_3ms", 80 * g)}), bottomed_out());
  EXPECT_THAT(written.text,
              AllOf(StartsWith("Fails: the pad bottoms out with the impactor still moving at 5.05 m/s\n"),
                    HasSubstr("\nBOTTOMED"),
                    ContainsRegex("3 ms clip +none +at most 80 g +fail: "
                                  "bottomed\\s+out\\s+on\\s+a\\s+rigid\\s+support"),
                    Not(HasSubstr("100.0 %"))));
  const auto json = nlohmann::json::parse(written.json);
  EXPECT_EQ(json["criteria"][0]["margin"], nullptr);
  EXPECT_EQ(json["criteria"][0]["margin_fraction"], nullptr);
  EXPECT_EQ(json["result"]["bottomed"]["velocity_m_per_s"], 5.05);
}

TEST(assessment_text, bottomed_stands_beside_the_verdict) {
  Solution solution = half_sine();
  solution.summary.bottomed = Moment{.time = 0.004, .velocity = 1};
  EXPECT_THAT(write(standard_with({criterion("peak_acceleration", 125 * g)}), solution).text,
              AllOf(StartsWith("Passes: "), HasSubstr("\nBOTTOMED"), Not(HasSubstr("bottoms out"))));
}

TEST(assessment_text, only_what_differs_was_replaced) {
  Standard standard = standard_with({criterion("peak_acceleration", 125 * g)});
  standard.mass = verified(4.5);
  const Written written = write(standard, half_sine());
  EXPECT_THAT(test::in_one_line(written.text),
              AllOf(Not(HasSubstr("instead of 4.5 kg")),
                    HasSubstr("Replaced in the case: radius, 80 mm from the standard"),
                    HasSubstr("Kept from the case: mass (4.5 kg), pad, support and solver settings.")));
  const auto impactor = nlohmann::json::parse(written.json)["impactor"];
  EXPECT_EQ(impactor["mass_kg"]["replaced"], false);
  EXPECT_EQ(impactor["radius_m"]["replaced"], true);
  standard.radius = verified(0.0762);
  standard.speed = verified(8.9408 * (1 + 1e-15));
  EXPECT_THAT(write(standard, half_sine()).text, HasSubstr("No values of the case were replaced.\n"));
}

TEST(assessment_text, says_what_kind_of_sources_the_figures_have) {
  Standard standard = standard_with({criterion("peak_acceleration", 125 * g)});
  standard.mass.origin.kind = injury::SourceKind::secondary;
  standard.radius.origin = {};
  standard.speed = {};
  const Written written = write(standard, half_sine());
  EXPECT_THAT(test::in_one_line(written.text),
              HasSubstr("own text (limit on peak acceleration), secondary (mass), no source (radius); "));
  const auto json = nlohmann::json::parse(written.json);
  EXPECT_EQ(json["criteria"][0]["source_kind"], "own text");
  EXPECT_EQ(json["impactor"]["mass_kg"]["source_kind"], "secondary");
}

TEST(assessment_text, has_the_key_figures_of_the_impact) {
  const Standard standard = standard_with({criterion("peak_acceleration", 125 * g)});
  const Written whole = write(standard, half_sine());
  EXPECT_THAT(
      whole.text,
      AllOf(ContainsRegex("Peak acceleration +100 g +at most 125 g"), ContainsRegex("Peak strain +0.8 "),
            ContainsRegex("HIC15 +414.6[0-9]*\n +HIC36 +414.6[0-9]*\n +End of contact +24.2 ms\n"),
            ContainsRegex("Rebound speed +8.603 m/s\n +Restitution +0.9622\n")));
  const auto figures = nlohmann::json::parse(whole.json)["figures"];
  EXPECT_NEAR(figures["peak_acceleration_g"]["value"].get<double>(), 100, 1e-9);
  EXPECT_EQ(figures["hic15"]["lower_bound"], false);
  EXPECT_EQ(figures["contact_end_s"]["value"], 0.0242);

  const Written cut = write(standard, rising_flank());
  EXPECT_THAT(cut.text, AllOf(ContainsRegex("HIC36 +≥ [0-9.]+\n"), Not(HasSubstr("Rebound speed")),
                              Not(HasSubstr("End of contact"))));
  const auto of_cut = nlohmann::json::parse(cut.json)["figures"];
  EXPECT_EQ(of_cut["hic36"]["lower_bound"], true);
  EXPECT_EQ(of_cut["contact_end_s"]["value"], nullptr);
}

TEST(assessment_text, fits_100_columns) {
  Standard standard = standard_with({criterion("clip_3ms", 80 * g), criterion("dwell_time", 4e-3)});
  for (injury::Criterion& criterion : standard.criteria) criterion.origin.verified = false;
  for (int word = 0; word < 100; ++word) standard.note += "word ";
  for (Solution solution : {half_sine(), rising_flank(), bottomed_out()}) {
    solution.summary.extrapolations = {{Beyond::strain, "strain too large"},
                                       {Beyond::rate, "rate too large"}};
    std::istringstream text(write(standard, solution).text);
    for (std::string line; std::getline(text, line);) EXPECT_LE(width_of(line), 100U) << line;
  }
}

TEST(assessment_text, a_strict_limit_is_marked) {
  injury::Criterion of = criterion("peak_acceleration", 125 * g);
  of.strict = true;
  const Written written = write(standard_with({of}), half_sine());
  EXPECT_THAT(written.text, HasSubstr(" below 125 g "));
  EXPECT_EQ(nlohmann::json::parse(written.json)["criteria"][0]["strict"], true);
}

TEST(assessment_text, an_error_that_nobody_knows_is_called_unknown) {
  Solution solution = half_sine();
  solution.coarser = {};
  const Written written = write(standard_with({criterion("hic36", 1000)}), solution);
  EXPECT_THAT(written.text, HasSubstr("± unknown"));
  EXPECT_EQ(nlohmann::json::parse(written.json)["criteria"][0]["error"], nullptr);
}

TEST(assessment_json, has_the_same_for_programs) {
  const auto json = nlohmann::json::parse(
      write(standard_with({criterion("peak_acceleration", 125 * g), criterion("dwell_time", 10e-3)}),
            half_sine())
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
  EXPECT_EQ(json["caveat"], output::assessment_caveat());
}

TEST(assessment_json, has_each_figure_under_its_key) {
  const Standard standard = standard_with({criterion("hic36", 1000)});
  const Solution solution = half_sine();
  Assessment assessment = assess(standard, solution);
  assessment.figures = {.peak_acceleration = {10 * g},
                        .hic15 = {11},
                        .hic36 = {12},
                        .peak_strain = {0.13},
                        .contact_end = {0.14},
                        .rebound_speed = {15},
                        .restitution = {0.16}};
  const ImpactCase impact = test::example_case();
  const auto figures = nlohmann::json::parse(
      output::assessment_json({standard, impact, impact, solution, assessment}))["figures"];
  const std::map<std::string, double> expected{
      {"peak_acceleration_g", 10}, {"hic15", 11},           {"hic36", 12},
      {"peak_strain", 0.13},       {"contact_end_s", 0.14}, {"rebound_speed_m_per_s", 15},
      {"restitution", 0.16}};
  EXPECT_EQ(figures.size(), expected.size());
  for (const auto& [key, value] : expected)
    EXPECT_DOUBLE_EQ(figures[key]["value"].get<double>(), value) << key;
}

TEST(assessment_json, has_null_where_there_is_no_finite_value) {
  const auto json = nlohmann::json::parse(
      write(standard_with({criterion("peak_acceleration", 125 * g)}), bottomed_out()).json);
  EXPECT_EQ(json["verdict"], "fail");
  EXPECT_EQ(json["criteria"][0]["value"], nullptr);
  EXPECT_EQ(json["criteria"][0]["margin"], nullptr);
  EXPECT_EQ(json["criteria"][0]["verdict"], "fail");
}

}  // namespace
}  // namespace dashpad
