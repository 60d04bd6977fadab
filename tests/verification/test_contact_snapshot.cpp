// The stress under the sphere, integrated, is the force of the history, for every law; and for an elastic pad
// it is the modulus times the sphere's shape.

#include <gtest/gtest.h>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {

namespace {

void expect_sound(const ImpactCase& impact, double tolerance = 1e-4) {
  const Solution solution = solve(impact, {.tolerance = tolerance});
  const auto snapshots = contact_snapshots(impact, solution.history);
  ASSERT_GE(snapshots.size(), 4U) << impact.title;
  for (const ContactSnapshot& snapshot : snapshots) {
    SCOPED_TRACE(impact.title + ", " + snapshot.when + ", at " + std::to_string(snapshot.time));
    // Two integrals of different stations, the run's own good to its tolerance.
    if (snapshot.determined)
      expect_relative(snapshot.force_of_stress(), snapshot.force, std::max(0.01, 2 * tolerance), "force");
    ASSERT_EQ(snapshot.radius.size(), snapshot.strain.size());
    ASSERT_EQ(snapshot.radius.size(), snapshot.stress.size());
    EXPECT_EQ(snapshot.radius.front(), 0);
    for (std::size_t i = 1; i < snapshot.radius.size(); ++i) {
      EXPECT_LT(snapshot.radius[i - 1], snapshot.radius[i]);
      EXPECT_GE(snapshot.strain[i - 1], snapshot.strain[i]);
      EXPECT_GE(snapshot.stress[i], 0);
    }
  }
}

template <class Law>
class Snapshot : public testing::Test {};
TYPED_TEST_SUITE(Snapshot, AllLaws);

TYPED_TEST(Snapshot, stress_adds_up_to_the_force) {
  for (const Support& support : {Support::rigid(), Support::linear(1e5)})
    expect_sound(impact_on(sample_law<TypeParam>(), support));
}

TYPED_TEST(Snapshot, stress_adds_up_to_the_force_with_few_steps_and_with_many) {
  const ImpactCase impact = impact_on(sample_law<TypeParam>(), Support::linear(1e5));
  expect_sound(impact, 1e-2);
  expect_sound(impact, 1e-6);
}

TEST(contact_snapshot, stress_adds_up_to_the_force_in_the_examples) {
  for (const char* name :
       {"dashboard-20mph", "dashboard-20mph-21-parameter", "load-cell-drop", "rigid-floor-bottoming"})
    expect_sound(input::read_case(source_folder / "examples" / (std::string{name} + ".toml"), material_folder)
                     .value()
                     .impact);
}

TEST(contact_snapshot, deeper_than_the_radius_the_edge_is_the_sphere_s_side) {
  ImpactCase impact = impact_on(Elastic{.modulus = 1e4});
  impact.impactor.nose = Sphere{0.01};
  impact.impactor.mass = 0.05;
  impact.pad.thickness = 0.1;
  const Solution solution = solve(impact, {});
  ASSERT_GT(solution.summary.peak_penetration, 0.01);
  const auto snapshots = contact_snapshots(impact, solution.history);
  for (const ContactSnapshot& snapshot : snapshots)
    expect_relative(snapshot.force_of_stress(), snapshot.force, 0.01, snapshot.when);
  EXPECT_DOUBLE_EQ(snapshots[2].radius.back(), 0.01);
}

TEST(contact_snapshot, elastic_stress_is_modulus_times_strain) {
  const ImpactCase impact = impact_on(Elastic{.modulus = 3e5});
  const Solution solution = solve(impact, {});
  for (const ContactSnapshot& snapshot : contact_snapshots(impact, solution.history)) {
    EXPECT_TRUE(snapshot.determined);
    EXPECT_NEAR(snapshot.strain.back(), 0, 1e-12);
    for (std::size_t i = 0; i < snapshot.radius.size(); ++i)
      EXPECT_NEAR(snapshot.stress[i], 3e5 * snapshot.strain[i], 1) << i;
  }
}

TEST(contact_snapshot, times_are_those_promised) {
  const ImpactCase impact = impact_on(sample_law<NineParameter>(), Support::linear(1e5));
  const Solution solution = solve(impact, {});
  const auto snapshots = contact_snapshots(impact, solution.history);
  ASSERT_EQ(snapshots.size(), 5U);
  EXPECT_EQ(snapshots[2].when, "peak force");
  expect_relative(snapshots[2].time, *solution.summary.time_of_peak_force, 0.02, "peak");
  expect_relative(snapshots[0].time, snapshots[2].time / 4, 0.1, "quarter");
  expect_relative(snapshots[1].time, snapshots[2].time / 2, 0.1, "half");
  EXPECT_EQ(snapshots[1].when, "loading");
  EXPECT_EQ(snapshots[4].when, "unloading");
  EXPECT_LT(snapshots[4].time, solution.history.time.back());
}

TEST(contact_snapshot, a_history_without_a_step_has_none) {
  EXPECT_TRUE(contact_snapshots(impact_on(Elastic{.modulus = 3e5}), {}).empty());
}

TEST(contact_snapshot, a_locked_pad_and_held_foam_are_said_to_be_undetermined) {
  const ImpactCase foam = impact_on(sample_law<RigidFoam>(), Support::linear(1e5));
  const auto held = contact_snapshots(foam, solve(foam, {}).history);
  EXPECT_TRUE(held.front().determined);
  EXPECT_FALSE(held.back().determined);

  const ImpactCase floor =
      input::read_case(source_folder / "examples/rigid-floor-bottoming.toml", material_folder).value().impact;
  EXPECT_FALSE(contact_snapshots(floor, solve(floor, {}).history).back().determined);
}

}  // namespace

}  // namespace dashpad::test
