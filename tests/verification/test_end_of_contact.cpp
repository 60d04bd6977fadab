/// Impacts whose end is hard: contact is lost by a spot on the axis, or the pad waits for its support. The
/// cases are in tests/verification/cases, each with what is hard about it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using ::testing::Contains;
using ::testing::Field;

Solution solved(const std::string& name, double tolerance) {
  const input::CaseFile input =
      input::read_case(source_folder / "tests/verification/cases" / (name + ".toml"),
                       source_folder / "materials")
          .value();
  return solve(input.impact, {.tolerance = tolerance});
}

struct LateRelease {
  const char* name;
  /// s, by our own solution at 1e-6. Its time of release is that of an independent solver, 2.664864 ms and
  /// 61.98726 ms.
  double contact_end;
};

class EndOfContact : public testing::TestWithParam<LateRelease> {};

/// The time at which the last column lets go is 13 to 29 % off in these cases, with an estimate of 1e-5.
/// Twice the tolerance is allowed, as for the reference cases: whether the spot on the axis holds on changes
/// the rebound a little too (law 4 at 1e-4: 1.4e-4).
TEST_P(EndOfContact, IsRightToTwiceTheTolerance) {
  for (const double tolerance : {1e-2, 1e-3, 1e-4}) {
    const Summary s = solved(GetParam().name, tolerance).summary;
    ASSERT_EQ(s.status, Status::released);
    ASSERT_TRUE(s.contact_end);
    const double error = relative_error(s.contact_end->time, GetParam().contact_end);
    EXPECT_LE(error, 2 * tolerance) << tolerance;
    EXPECT_LE(error, 2 * s.errors.contact_end) << tolerance;
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, EndOfContact,
                         testing::Values(LateRelease{"late-release-law-4", 2.640735e-3},
                                         LateRelease{"late-release-law-5", 61.58804e-3}),
                         [](const auto& parameter) {
                           std::string name = parameter.param.name;
                           std::ranges::replace(name, '-', '_');
                           return name;
                         });

class WaitingPad : public testing::TestWithParam<const char*> {};

TEST_P(WaitingPad, HasNoFigureThatIsNoNumber) {
  const Summary fine = solved(GetParam(), 1e-4).summary;
  for (const double tolerance : {1e-2, 1e-3}) {
    const Solution solution = solved(GetParam(), tolerance);
    const Summary& s = solution.summary;
    ASSERT_EQ(s.status, Status::released) << tolerance;
    for (const double value : {*s.peak_force, s.peak_penetration, *s.rebound_speed, s.contact_end->time,
                               s.peak_strain_rate, s.energy_absorbed_fraction, s.energy.residual})
      EXPECT_TRUE(std::isfinite(value)) << value;
    for (const double velocity : solution.history.velocity) ASSERT_TRUE(std::isfinite(velocity));
    expect_relative(*s.peak_force, *fine.peak_force, tolerance, "peak force");
    expect_relative(s.contact_end->time, fine.contact_end->time, tolerance, "end of contact");
  }
}

INSTANTIATE_TEST_SUITE_P(Cases, WaitingPad, testing::Values("waiting-law-4", "waiting-law-5"),
                         [](const auto& parameter) { return std::string(parameter.param).substr(12); });

/// Once 1e15 1/s, of steps of a rounding error's length: the last columns pressed again, and neither loading
/// nor unloading had a solution.
TEST(PeakStrainRate, IsThatOfFirstContactWhereTheLastColumnsLetGo) {
  const Summary s = solved("let-go", 1e-3).summary;
  EXPECT_EQ(s.status, Status::released);
  EXPECT_GE(s.peak_strain_rate, 290) << "the impact speed over the thickness";
  EXPECT_LE(s.peak_strain_rate, 1e4);
}

TEST(EnergyGained, IsSaid) {
  const Summary s = solved("energy-gained", 1e-3).summary;
  ASSERT_EQ(s.status, Status::released);
  EXPECT_NEAR(*s.restitution, 1.033, 1e-3);
  EXPECT_NEAR(s.energy_absorbed_fraction, -0.0664, 1e-3);
  EXPECT_THAT(flags(s), Contains(Field(&Flag::name, "ENERGY GAINED")));
}

/// Law 4 that relaxes at once is law 1 with its crowding, until its pad, come to its turn, springs open.
TEST(PeakOnTheWayBack, IsSaidWhereLaw4SpringsOpen) {
  const auto solved_with = [](double relaxation_time) {
    ImpactCase impact =
        impact_on(NineParameter{1e5, 0.7, 1, relaxation_time, 1e4, 0.2, 1e-15, 1}, Support::linear(1e5));
    impact.impactor = {.mass = 5, .nose = Sphere{0.1}, .speed = 3};
    impact.pad.thickness = 0.05;
    return solve(impact, {.tolerance = 1e-3}).summary;
  };
  const Summary slow = solved_with(1e-4), fast = solved_with(1e-6);
  EXPECT_EQ(slow.force_on_way_in, 0);
  EXPECT_NEAR(fast.force_on_way_in / *slow.peak_force, 1, 2e-3);
  EXPECT_GT(*fast.peak_force, 1.05 * fast.force_on_way_in);
  EXPECT_THAT(flags(fast), Contains(Field(&Flag::name, "PEAK ON THE WAY BACK")));
}

/// Law 1 returns all: rounding is no gain.
TEST(EnergyGained, IsNotSaidOfAnElasticPad) {
  const Summary s =
      solve(impact_on(sample_law<Elastic>(), Support::linear(2e5)), {.tolerance = 1e-4}).summary;
  ASSERT_EQ(s.status, Status::released);
  EXPECT_FALSE(gained_energy(s));
}

}  // namespace
}  // namespace dashpad::test
