/// The solver's door and its endings: what it refuses, and how runs end that are no plain rebound.

#include "dashpad/impact/solve.hpp"

#include <gtest/gtest.h>

#include <limits>

#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

const ImpactCase sound = impact_on(Elastic{6e5}, Support::linear(2e5));

std::string refusal(const ImpactCase& impact, const Options& options = {}) {
  try {
    static_cast<void>(solve(impact, options));
  } catch (const std::invalid_argument& fault) {
    return fault.what();
  }
  return "";
}

TEST(solve, refuses_a_case_that_breaks_rules_and_names_them_all) {
  ImpactCase impact = sound;
  EXPECT_EQ(refusal(impact), "");
  impact.impactor.mass = -1;
  impact.pad.thickness = std::numeric_limits<double>::quiet_NaN();
  impact.pad.material.law = Elastic{0};
  const std::string message = refusal(impact);
  for (const char* key : {"impactor.mass", "pad.thickness", "pad.parameters.modulus"})
    EXPECT_NE(message.find(key), std::string::npos) << key << " is missing in: " << message;
}

TEST(solve, refuses_options_out_of_range) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  constexpr double infinity = std::numeric_limits<double>::infinity();
  for (const double tolerance : {0.0, 9.9e-9, 1.1e-2, -1e-4, nan, infinity})
    EXPECT_NE(refusal(sound, {.tolerance = tolerance}).find("tolerance"), std::string::npos) << tolerance;
  for (const double limit : {0.0, -1.0, nan, infinity})
    EXPECT_NE(refusal(sound, {.time_limit = limit}).find("time_limit"), std::string::npos) << limit;
  for (const double tolerance : {1e-8, 1e-2})
    EXPECT_EQ(refusal(sound, {.tolerance = tolerance}), "") << tolerance;
}

TEST(solve, gives_an_impact_up_at_the_time_limit) {
  const double contact = solve(sound).summary.release.value().time;
  const Solution cut = solve(sound, {.time_limit = contact / 2});
  EXPECT_EQ(cut.summary.status, Status::time_limit);
  EXPECT_TRUE(cut.summary.trustworthy());
  EXPECT_FALSE(cut.summary.release);
  EXPECT_FALSE(cut.summary.restitution);
  EXPECT_NEAR(cut.history.time.back(), contact / 2, 1e-12);
  const Solution whole = solve(sound, {.time_limit = 1.01 * contact});
  EXPECT_EQ(whole.summary.status, Status::released);
}

TEST(solve, says_so_when_it_runs_out_of_steps) {
  const Summary s = solve(sound, {.tolerance = 1e-8, .max_steps = 50}).summary;
  EXPECT_EQ(s.status, Status::tolerance_not_met);
  EXPECT_FALSE(s.trustworthy());
}

// Locked, and coming back from it, laws 4 and 5 want more and more stations: from the tenth run on more than
// there is memory for. Such a run gave 3.63 m/s.
TEST(solve, leaves_out_a_run_that_lacks_memory_for_its_stations) {
  ImpactCase impact =
      impact_on(NineParameter{47738, 0.58796, 0.63136, 0.0077089, 23784, 0.13976, 4.88833e-6, 0.0688717},
                Support::linear(4.5e5));
  impact.impactor.mass = 16.436;
  impact.impactor.nose = Sphere{0.172585};
  impact.impactor.speed = 4.3399;
  impact.pad.thickness = 0.0359236;
  const Summary fine = solve(impact, {.tolerance = 1e-5}).summary;
  const Summary finest = solve(impact, {.tolerance = 1e-8}).summary;
  ASSERT_TRUE(fine.bottomed.has_value());
  EXPECT_NEAR(*finest.rebound_speed / *fine.rebound_speed, 1, 1e-5);
}

TEST(solve, stops_dead_on_rigid_foam_on_a_rigid_support) {
  ImpactCase impact = impact_on(sample_law<RigidFoam>());
  impact.impactor.speed = 2;
  const Solution solution = solve(impact);
  const Summary& s = solution.summary;
  ASSERT_EQ(s.status, Status::released);
  EXPECT_EQ(s.rebound_speed, 0);
  EXPECT_EQ(s.restitution, 0);
  EXPECT_NEAR(s.energy_absorbed_fraction, 1, 1e-12);
  EXPECT_NEAR(s.energy.pad, s.energy.impact, 1e-9 * s.energy.impact);
  EXPECT_NEAR(s.release->time, solution.history.time.back(), 1e-3 * s.release->time);
  EXPECT_NEAR(s.peak_penetration, solution.history.penetration.back(), 1e-6 * s.peak_penetration);
}

TEST(solve, lets_a_support_push_the_sphere_off_rigid_foam) {
  const Summary s = solve(impact_on(sample_law<RigidFoam>(), Support::linear(2e5))).summary;
  ASSERT_EQ(s.status, Status::released);
  EXPECT_GT(s.restitution.value(), 0.1);
  EXPECT_LT(s.restitution.value(), 1);
  // What the support gives back is what it held at the largest force; the foam keeps its deformation.
  const double stored = s.peak_force.value() * s.peak_force.value() / (2 * 2e5);
  EXPECT_NEAR(s.energy.kinetic, stored, 1e-4 * stored);
}

TEST(solve, marks_results_outside_the_fitted_range) {
  ImpactCase impact = impact_on(sample_law<NineParameter>(), Support::linear(2e5));
  impact.pad.material.fitted = FittedRange{.highest_strain = 0.999, .lowest_rate = 0, .highest_rate = 1e4};
  EXPECT_TRUE(solve(impact).summary.extrapolations.empty());
  impact.pad.material.fitted->highest_strain = 0.1;
  const Summary s = solve(impact).summary;
  ASSERT_EQ(s.extrapolations.size(), 1U);
  EXPECT_NE(s.extrapolations.front().text.find("strain reaches"), std::string::npos);
}

TEST(solve, reports_what_it_did) {
  const Solution solution = solve(impact_on(sample_law<NineParameter>()), {.tolerance = 1e-3});
  const Summary& s = solution.summary;
  EXPECT_EQ(s.tolerance, 1e-3);
  EXPECT_EQ(s.steps + 1, solution.history.size());
  EXPECT_GT(s.stations, 10U);
  EXPECT_GE(s.runs, 3);
  EXPECT_GT(s.wall_time, 0);
  EXPECT_EQ(solve(sound).summary.stations, 0U) << "no columns for a pad without memory";
}

TEST(status, has_a_name_for_each_ending) {
  EXPECT_EQ(to_string(Status::released), "released");
  EXPECT_EQ(to_string(Status::bottomed_out), "bottomed out");
  EXPECT_EQ(to_string(Status::time_limit), "time limit");
  EXPECT_EQ(to_string(Status::tolerance_not_met), "tolerance not met");
  EXPECT_EQ(to_string(Summary{}.status), "not run");
  EXPECT_FALSE(Summary{}.trustworthy());
}

TEST(solve, says_where_the_force_goes_beyond_the_support_curve) {
  const double peak = *solve(sound).summary.peak_force;
  ImpactCase impact = sound;
  impact.support = Support::through({{0.1 * peak / 2e5, 0.1 * peak}, {0.2 * peak / 2e5, 0.2 * peak}});
  const Summary beyond = solve(impact).summary;
  ASSERT_EQ(beyond.extrapolations.size(), 1U);
  EXPECT_NE(beyond.extrapolations[0].text.find("the support curve ends at"), std::string::npos);
  impact.support = Support::through({{peak / 2e5, peak}, {2 * peak / 2e5, 2 * peak}});
  EXPECT_TRUE(solve(impact).summary.extrapolations.empty());
}

}  // namespace
}  // namespace dashpad::test
