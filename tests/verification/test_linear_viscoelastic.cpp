/// Law 2, the standard linear solid: a column against closed forms, and a whole impact in its two limits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "oracle/closed_forms.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

const auto zener = sample_law<LinearViscoelastic>();

TEST(LinearViscoelasticColumn, IsExactAtConstantRateHoweverLongTheSteps) {
  for (const double rate : {0.5, 30.0, 300.0})
    for (const int steps : {1, 7, 100}) {
      const double time = 0.9 / rate;
      Column<LinearViscoelastic> column(zener);
      for (int i = 1; i <= steps; ++i) column.go(0.9 * i / steps, time * i / steps);
      expect_relative(column.stress(), oracle::linear_column_at_constant_rate(zener, rate, time), 1e-12,
                      fmt::format("rate {}", rate));
    }
}

TEST(LinearViscoelasticColumn, TendsToItsEnvelopeAtConstantRate) {
  const double rate = 0.9 / (40 * zener.relaxation_time);
  Column<LinearViscoelastic> column(zener);
  column.go(0.9, 0.9 / rate);
  const double viscous = (zener.initial_modulus - zener.asymptotic_modulus) * zener.relaxation_time * rate;
  expect_relative(column.stress(), zener.asymptotic_modulus * 0.9 + viscous, 1e-12, "stress");
}

TEST(LinearViscoelasticColumn, RelaxesUnderAStrainThatIsHeld) {
  Column<LinearViscoelastic> column(zener);
  constexpr double sudden = 1e-9;  // s
  column.go(0.2, sudden);
  expect_relative(column.stress(), 0.2 * zener.initial_modulus, 1e-6, "at once");
  for (const double time : {1e-3, 5e-3, 4e-2}) {
    column.go(0.2, sudden + time);
    expect_relative(column.stress(), oracle::linear_column_after_step(zener, 0.2, time), 1e-6, "later");
  }
}

/// Against the response to a tent of strain, by superposition of two ramps.
TEST(LinearViscoelasticColumn, UnloadsByTheSameLaw) {
  const double rate = 40;
  const double turning = 0.01;
  Column<LinearViscoelastic> column(zener);
  column.go(0.4, turning);
  for (const double time : {0.011, 0.014, 0.019}) {
    column.go(0.8 - rate * time, time);
    const double expected = oracle::linear_column_at_constant_rate(zener, rate, time) -
                            2 * oracle::linear_column_at_constant_rate(zener, rate, time - turning);
    EXPECT_NEAR(column.stress(), expected, 1e-12 * zener.initial_modulus);
  }
}

/// Relaxation far faster or far slower than the impact leaves an elastic pad.
TEST(LinearViscoelasticImpact, IsElasticInBothLimits) {
  LinearViscoelastic law{6e5, 12e5, 1e3};
  for (const auto& [time, modulus] : {std::pair{1e3, 12e5}, std::pair{1e-9, 6e5}}) {
    law.relaxation_time = time;
    for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
      const Summary viscous = solve(impact_on(law, support), {.tolerance = 1e-5}).summary;
      const Summary elastic = solve(impact_on(Elastic{modulus}, support), {.tolerance = 1e-6}).summary;
      ASSERT_EQ(viscous.status, Status::released) << time << to_string(viscous.status);
      expect_relative(viscous.peak_force.value(), elastic.peak_force.value(), 1e-5, "peak force");
      expect_relative(viscous.release.value().time, elastic.release.value().time, 1e-5, "release time");
      expect_relative(viscous.restitution.value(), 1, 1e-5, "restitution");
    }
  }
}

}  // namespace
}  // namespace dashpad::test
