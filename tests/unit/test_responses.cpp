/// What a study keeps of an impact.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/study/answers.hpp"
#include "dashpad/study/responses.hpp"
#include "sample_case.hpp"
#include "shared/generated_text.hpp"

namespace dashpad::study {
namespace {

Outcome outcome_of(const Solution& solution, std::vector<std::string> names) {
  Outcome outcome;
  ResponseReader{names}(solution, outcome);
  return outcome;
}

Solution dashboard(double speed = 8.9408, double tolerance = 1e-3) {
  ImpactCase impact = test::read(test::good_case).impact;
  impact.impactor.speed = speed;
  return solve(impact, {.tolerance = tolerance});
}

TEST(responses, are_the_figures_of_the_summary) {
  const Solution solution = dashboard();
  const Summary& summary = solution.summary;
  const std::map<std::string, std::pair<double, double>> expected{
      {"peak_force", {*summary.peak_force, summary.errors.peak_force}},
      {"peak_acceleration", {*summary.peak_acceleration, summary.errors.peak_force}},
      {"time_to_peak_force", {*summary.time_of_peak_force, summary.errors.time_of_peak_force}},
      {"peak_motion", {summary.peak_motion, summary.errors.peak_motion}},
      {"peak_penetration", {summary.peak_penetration, summary.errors.peak_penetration}},
      {"peak_strain", {summary.peak_strain, summary.errors.peak_penetration}},
      {"peak_strain_rate", {summary.peak_strain_rate, 0}},
      {"rebound_speed", {*summary.rebound_speed, summary.errors.rebound_speed}},
      {"restitution", {*summary.restitution, summary.errors.rebound_speed}},
      {"contact_end", {summary.contact_end->time, summary.errors.contact_end}},
      {"release", {summary.release->time, 0}},
      {"energy_absorbed_fraction", {summary.energy_absorbed_fraction, summary.errors.energy_absorbed}}};
  EXPECT_EQ(default_responses().size(), expected.size());
  for (const std::string& name : default_responses()) {
    const Outcome outcome = outcome_of(solution, {name});
    EXPECT_EQ(outcome.values.at(0), expected.at(name).first) << name;
    EXPECT_EQ(outcome.error, expected.at(name).second) << name;
  }
}

/// A pad that remembers its blows: each response against the blows one by one.
TEST(responses, are_of_single_blows_or_their_mean) {
  const ImpactCase impact =
      input::read_case(test::source / "examples" / "five-drops-on-a-cushion.toml", test::source / "materials")
          ->impact;
  const std::vector<Blow> blows = solve_blows(impact, {.tolerance = 1e-3});
  ASSERT_GE(blows.size(), 4u);
  const auto peak = [&](std::size_t blow) { return *blows.at(blow - 1).solution.summary.peak_acceleration; };
  const std::vector<std::string> names{"peak_acceleration.blow_1", "peak_acceleration.mean_2_4",
                                       "peak_acceleration", "hic15.mean_1_2", "peak_force.blow_99"};
  ResponseReader read{names};
  EXPECT_TRUE(read.needs_blows());
  Outcome outcome;
  for (int times = 0; times < 2; ++times) {  // the memory of the first is used again
    for (const Blow& blow : blows) read(blow.solution, outcome);
    EXPECT_EQ(outcome.values[0], peak(1));
    EXPECT_DOUBLE_EQ(outcome.values[1], (peak(2) + peak(3) + peak(4)) / 3);
    EXPECT_EQ(outcome.values[2], peak(blows.size()));
    EXPECT_DOUBLE_EQ(outcome.values[3], (injury::whole_pulse_figures(blows[0].solution)->hic15.value +
                                         injury::whole_pulse_figures(blows[1].solution)->hic15.value) /
                                            2);
    EXPECT_TRUE(std::isnan(outcome.values[4]));
  }
  EXPECT_FALSE(ResponseReader{std::vector<std::string>{"peak_force"}}.needs_blows());
}

TEST(responses, of_blows_have_one_spelling) {
  EXPECT_EQ(find_response("peak_force")->first_blow, 0);
  EXPECT_EQ(find_response("peak_force.blow_12")->last_blow, 12);
  EXPECT_EQ(find_response("peak_force.mean_2_5")->first_blow, 2);
  EXPECT_EQ(response_title("peak_force.mean_2_5"), "Peak force, mean of blows 2 to 5");
  EXPECT_EQ(response_title("peak_force.blow_1"), "Peak force of blow 1");
  for (const char* name :
       {"peak_force.", "peak_force.blow_0", "peak_force.blow_01", "peak_force.blow_1x", "peak_force.mean_5_2",
        "peak_force.mean_2", "peak_force.mean_2_2", "peak_force.mean_2_5_7", "peak_force.blow_-1",
        "peak_force.mean_ 2_5", "peak_farce.blow_1", ".blow_1", "peak_force.blow_99999999999999999999"})
    EXPECT_FALSE(find_response(name)) << name;
}

TEST(responses, are_all_in_the_documents) {
  const std::string document = test::text_of(test::source / "docs" / "studies.md");
  for (const ResultQuantity& kind : response_kinds())
    EXPECT_NE(document.find(fmt::format("`{}`", kind.key)), std::string::npos) << kind.key;
}

/// At three speeds: the pulse is shorter than 15 ms, between 15 and 36 ms, and longer.
TEST(responses, are_the_injury_figures) {
  for (const double stiffness : {4e6, 1e5, 1e4}) {
    ImpactCase impact = test::read(test::good_case).impact;
    impact.support = Support::linear(stiffness);
    const Solution solution = solve(impact, {.tolerance = 1e-3});
    const injury::InjuryFigures of = injury::injury_figures(solution);
    const std::map<std::string, std::pair<double, double>> expected{
        {"hic15", {of.hic15.value, of.errors.hic15}},
        {"hic36", {of.hic36.value, of.errors.hic36}},
        {"hic_unlimited", {of.hic_unlimited.value, of.errors.hic_unlimited}},
        {"hic_d", {of.hic_d, of.errors.hic_d}},
        {"clip_3ms", {of.clip_3ms.level, of.errors.clip_3ms}},
        {"cumulative_3ms", {of.cumulative_3ms.level, of.errors.cumulative_3ms}},
        {"severity_index", {of.severity_index, of.errors.severity_index}},
        {"velocity_change", {of.velocity_change, of.errors.velocity_change}}};
    std::size_t of_pulse = 0;
    for (const ResultQuantity& kind : response_kinds()) {
      if (kind.part != Part::pulse) continue;
      ++of_pulse;
      const Outcome outcome = outcome_of(solution, {kind.key});
      EXPECT_NEAR(outcome.values.at(0), expected.at(kind.key).first, 1e-11 * std::abs(outcome.values[0]))
          << kind.key;
      EXPECT_NEAR(outcome.error, expected.at(kind.key).second, 1e-9) << kind.key;
    }
    EXPECT_EQ(of_pulse, expected.size());
  }
}

TEST(responses, keep_order_and_the_largest_error) {
  const Solution solution = dashboard();
  const Outcome outcome = outcome_of(solution, {"rebound_speed", "hic15", "peak_force"});
  ASSERT_EQ(outcome.values.size(), 3u);
  EXPECT_EQ(outcome.values[0], *solution.summary.rebound_speed);
  EXPECT_EQ(outcome.values[2], *solution.summary.peak_force);
  EXPECT_EQ(outcome.error,
            std::max({outcome_of(solution, {"rebound_speed"}).error, outcome_of(solution, {"hic15"}).error,
                      outcome_of(solution, {"peak_force"}).error}));
  EXPECT_EQ(outcome.status, Status::released);
}

TEST(responses, have_no_value_where_the_impact_has_none) {
  const Solution solution = solve(
      input::read_case(test::source / "examples/rigid-floor-bottoming.toml", test::materials).value().impact);
  ASSERT_EQ(solution.summary.status, Status::bottomed_out);
  const Outcome outcome = outcome_of(solution, {"peak_force", "peak_acceleration", "rebound_speed", "release",
                                                "hic15", "velocity_change", "peak_strain"});
  for (std::size_t i = 0; i < 6; ++i) EXPECT_TRUE(std::isnan(outcome.values[i])) << i;
  EXPECT_EQ(outcome.values[6], 1);
  EXPECT_TRUE(outcome.bottomed);
  EXPECT_EQ(outcome.status, Status::bottomed_out);
}

/// What is left of an earlier row must not show.
TEST(responses, are_filled_afresh) {
  ResponseReader reader(std::vector<std::string>{"rebound_speed"});
  Outcome outcome;
  reader(dashboard(), outcome);
  const Solution bottomed = solve(
      input::read_case(test::source / "examples/rigid-floor-bottoming.toml", test::materials).value().impact);
  reader(bottomed, outcome);
  EXPECT_TRUE(std::isnan(outcome.values.at(0)));
  EXPECT_EQ(outcome.error, 0);
}

TEST(responses, take_an_error_that_is_no_number_for_unknown) {
  Solution solution = dashboard();
  solution.summary.errors.peak_force = std::nan("");
  EXPECT_TRUE(std::isinf(outcome_of(solution, {"peak_force"}).error));
}

/// What no impact can have is no value, and a row that claims to be good is then doubtful.
TEST(responses, leave_out_what_cannot_be) {
  for (const double wrong : {std::nan(""), HUGE_VAL, -HUGE_VAL, -1.0}) {
    Solution solution = dashboard();
    solution.summary.peak_force = wrong;
    const std::vector<std::string> names{"peak_force", "peak_strain"};
    const Outcome outcome = outcome_of(solution, names);
    EXPECT_TRUE(std::isnan(outcome.values.at(0))) << wrong;
    EXPECT_EQ(outcome.status, Status::released);
    EXPECT_TRUE(is_doubtful(outcome, names)) << wrong;
  }
}

TEST(responses, missing_by_nature_make_no_row_doubtful) {
  const std::vector<std::string> names{"peak_force", "hic15", "rebound_speed", "peak_strain"};
  const Solution bottomed = solve(
      input::read_case(test::source / "examples/rigid-floor-bottoming.toml", test::materials).value().impact);
  EXPECT_FALSE(is_doubtful(outcome_of(bottomed, names), names));
  Outcome outcome = outcome_of(dashboard(), names);
  EXPECT_FALSE(is_doubtful(outcome, names));
  outcome.values.at(2) = std::nan("");
  EXPECT_TRUE(is_doubtful(outcome, names));
  outcome.status = Status::time_limit;
  outcome.values.at(1) = std::nan("");
  EXPECT_FALSE(is_doubtful(outcome, names));
  outcome.values.at(0) = std::nan("");
  EXPECT_TRUE(is_doubtful(outcome, names)) << "the largest force so far is there";
}

/// Rigid foam on a rigid support: the force ends at its peak. The end of contact has no value by nature, HIC
/// has none that could be relied on.
TEST(responses, of_a_pulse_that_is_cut_are_doubtful_where_they_need_it_whole) {
  Solution cut = dashboard();
  cut.summary.contact_end.reset();
  const std::vector<std::string> hic{"hic15"};
  EXPECT_TRUE(std::isnan(outcome_of(cut, hic).values.at(0)));
  EXPECT_TRUE(is_doubtful(outcome_of(cut, hic), hic));
  const std::vector<std::string> all = default_responses();
  EXPECT_FALSE(is_doubtful(outcome_of(cut, all), all));
}

TEST(responses, may_be_below_zero_where_they_have_a_sign) {
  EXPECT_TRUE(is_possible(*find_response_kind("energy_absorbed_fraction"), -0.01));
  EXPECT_FALSE(is_possible(*find_response_kind("velocity_change"), -9));
  EXPECT_FALSE(is_possible(*find_response_kind("peak_force"), -1e-9));
  EXPECT_FALSE(is_possible(*find_response_kind("energy_absorbed_fraction"), -HUGE_VAL));
  EXPECT_EQ(find_response_kind("peak_farce"), nullptr);
}

TEST(responses, refuse_an_unknown_name) {
  EXPECT_THROW(ResponseReader(std::vector<std::string>{"peak_farce"}), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad::study
