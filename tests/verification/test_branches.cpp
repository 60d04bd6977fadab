/// Which branch the pad takes where the equations admit several (theory.md, Eq. 26): cases in which two paths
/// of the solver, or two resolutions, once went different ways. The reference is the damped oracle
/// (oracle/damped_impact.hpp), which needs no rule about loading and unloading.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "oracle/damped_impact.hpp"
#include "property/random_case.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

struct BranchCase {
  std::uint64_t seed;  ///< of random_case()
  const char* why;
  double peak_force;     ///< N
  double rebound_speed;  ///< m/s
  double release_time;   ///< s
  double allowance;      ///< of the reference, relative
};

/// Damped oracle with 600 to 1200 columns; its damping and its step were halved until the figures kept still
/// to the allowance.
const std::vector<BranchCase> branch_cases{
    {1021, "the unloading ends twice, the second time for a moment only", 9.0598, 0.38566, 0.0171, 1e-3},
    {1891, "the unloading ends twice", 54.63, 1.0193, 0.0020349, 1e-3},
};

void expect_reference(const Summary& s, const BranchCase& reference) {
  ASSERT_EQ(s.status, Status::released) << to_string(s.status);
  const double allowance = s.tolerance + reference.allowance;
  expect_relative(s.peak_force.value(), reference.peak_force, allowance, "peak force");
  expect_relative(s.rebound_speed.value(), reference.rebound_speed, allowance, "rebound speed");
  expect_relative(s.release->time, reference.release_time, allowance, "release time");
}

TEST(Branches, AreThoseOfADampedSupportOnBothPaths) {
  for (const BranchCase& reference : branch_cases)
    for (const double tolerance : {1e-3, 2e-4})
      for (const bool plain : {false, true}) {
        SCOPED_TRACE(fmt::format("seed {}, {}, tolerance {}, plain {}", reference.seed, reference.why,
                                 tolerance, plain));
        const ImpactCase impact = random_case(reference.seed);
        expect_reference(solve(impact, {.tolerance = tolerance, .plain = plain}).summary, reference);
      }
}

/// A corner of the support that is passed downwards, from steep to soft: the pad is pressed again. Once the
/// finer runs took an unloading of 1e10 m/s instead, and left with 1.3 times the impact speed.
TEST(Branches, PadIsPressedAgainWhereTheSupportGrowsSoft) {
  const ImpactCase impact = random_case(326);
  for (const double tolerance : {1e-3, 2e-4, 1e-4})
    for (const bool plain : {false, true}) {
      const Summary s = solve(impact, {.tolerance = tolerance, .plain = plain}).summary;
      EXPECT_NEAR(s.rebound_speed.value(), 3.153, 0.003);
      EXPECT_NEAR(s.release.value().time, 6.860e-3, 7e-6);
      EXPECT_GT(s.energy_absorbed_fraction, 0);
    }
}

/// The references are the oracle's: once more, with fewer columns and a longer step.
TEST(Branches, ReferenceComesFromTheDampedOracle) {
  const BranchCase& reference = branch_cases.back();
  const auto damped = oracle::solve_damped(random_case(reference.seed),
                                           {.damping = 0.01, .step = 1e-6, .columns = 400, .longest = 3e-3});
  ASSERT_TRUE(damped.released);
  EXPECT_EQ(damped.turnings.size(), 3U);
  EXPECT_EQ(damped.reloadings.size(), 2U);
  expect_relative(damped.peak_force, reference.peak_force, 2e-3, "peak force");
  expect_relative(damped.rebound_speed, reference.rebound_speed, 2e-3, "rebound speed");
  expect_relative(damped.release_time, reference.release_time, 2e-3, "release time");
}

}  // namespace
}  // namespace dashpad::test
