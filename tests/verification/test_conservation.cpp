/// Energy and momentum: what goes in comes out, is stored or is absorbed.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

const Support yielding = Support::linear(2e5);
const Support stiffening = Support::through({{0.004, 300}, {0.009, 1500}, {0.02, 9000}});

void expect_no_loss(const ImpactCase& impact) {
  const Summary s = solve(impact).summary;
  SCOPED_TRACE(fmt::format("peak strain {}, {}", s.peak_strain, to_string(s.status)));
  ASSERT_EQ(s.status, Status::released);
  EXPECT_NEAR(s.restitution.value(), 1, 1e-9);
  EXPECT_LT(std::abs(s.energy.residual), 1e-9 * s.energy.impact);
  EXPECT_NEAR(s.energy_absorbed_fraction, 0, 2e-9);
}

TEST(Conservation, AnElasticPadLosesNothingOnAnySupport) {
  for (const Support& support : {Support::rigid(), yielding, stiffening})
    for (const double speed : {0.05, 1.0, 2.5}) {
      ImpactCase impact = impact_on(Elastic{6e5}, support);
      impact.impactor.speed = speed;
      expect_no_loss(impact);
    }
}

TEST(Conservation, AnElasticPadLosesNothingWhenPenetratedBeyondTheRadius) {
  for (const Support& support : {Support::rigid(), yielding, stiffening}) {
    ImpactCase impact = impact_on(Elastic{2e6}, support);
    impact.impactor.nose = Sphere{0.01};
    impact.pad.thickness = 0.1;
    ASSERT_GT(solve(impact).summary.peak_penetration, sphere_radius(impact.impactor.nose));
    expect_no_loss(impact);
  }
}

TEST(Conservation, AnElasticPadThatLocksOnAYieldingSupportLosesNothing) {
  for (const Support& support : {yielding, stiffening}) {
    const ImpactCase impact = impact_on(Elastic{5e4}, support);
    const Summary s = solve(impact).summary;
    ASSERT_TRUE(s.bottomed);
    EXPECT_EQ(s.peak_strain, 1);
    expect_no_loss(impact);
  }
}

// --- All laws
// -------------------------------------------------------------------------------------------------

template <class Law>
class ConservationOf : public testing::Test {};
TYPED_TEST_SUITE(ConservationOf, AllLaws);

std::vector<ImpactCase> impacts_on(const PadLaw& law) {
  std::vector<ImpactCase> impacts;
  for (const Support& support : {Support::rigid(), yielding, stiffening})
    for (const double speed : {0.3, 1.5, 4.0}) {
      impacts.push_back(impact_on(law, support));
      impacts.back().impactor.speed = speed;
    }
  return impacts;
}

TYPED_TEST(ConservationOf, TheImpulseOfTheForceIsTheChangeOfMomentum) {
  for (const ImpactCase& impact : impacts_on(sample_law<TypeParam>())) {
    const Solution solution = solve(impact, {.tolerance = 1e-5});
    const History& h = solution.history;
    const double momentum = impact.impactor.mass * impact.impactor.speed;
    double impulse = 0;
    std::size_t parabolas = 0;
    for (std::size_t i = 1; i < h.size(); ++i) {
      const double step = h.time[i] - h.time[i - 1];
      const double line = (h.force[i] + h.force[i - 1]) / 2 * step;
      impulse += line;
      if (TypeParam::memoryless || i < 2) continue;
      // With memory each step takes the force for a parabola through the last three moments, or for a line
      // after an event (theory.md, Eq. 23).
      const double before = h.time[i - 1] - h.time[i - 2];
      const double bend = step / (step + before) *
                          (h.force[i] - h.force[i - 1] - (h.force[i - 1] - h.force[i - 2]) / before * step);
      const double change = impact.impactor.mass * (h.velocity[i - 1] - h.velocity[i]);
      const bool is_parabola = std::abs(line - bend / 6 * step - change) <= 1e-12 * momentum;
      EXPECT_TRUE(is_parabola || std::abs(line - change) <= 1e-12 * momentum) << "step " << i;
      parabolas += is_parabola ? 1 : 0;
    }
    if (!TypeParam::memoryless) {
      EXPECT_GE(parabolas, h.size() - 12) << "of " << h.size();
    }
    // Without memory a step takes the mean force whose work is exact.
    expect_relative(impulse, impact.impactor.mass * (h.velocity.front() - h.velocity.back()), 1e-3,
                    fmt::format("impulse at {} m/s", impact.impactor.speed));
    if (solution.summary.release)
      expect_relative(solution.summary.release->velocity, h.velocity.back(), 1e-3, "velocity of the summary");
  }
}

TYPED_TEST(ConservationOf, ThePadAbsorbsBetweenNothingAndEverything) {
  for (const ImpactCase& impact : impacts_on(sample_law<TypeParam>())) {
    const Summary s = solve(impact).summary;
    SCOPED_TRACE(fmt::format("speed {}: {}", impact.impactor.speed, to_string(s.status)));
    EXPECT_NE(s.status, Status::tolerance_not_met);
    EXPECT_GE(s.energy_absorbed_fraction, -1e-9);
    EXPECT_LE(s.energy_absorbed_fraction, 1 + 1e-9);
    EXPECT_LE(std::abs(s.energy.residual), 1e-4 * s.energy.impact);
    EXPECT_NEAR(s.energy.kinetic + s.energy.support + s.energy.pad + s.energy.residual, s.energy.impact,
                1e-12 * s.energy.impact);
  }
}

}  // namespace
}  // namespace dashpad::test
