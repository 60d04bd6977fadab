/// Impacts on random foams by curves. Repeat one case with DASHPAD_RANDOM_SEED and DASHPAD_RANDOM_CASES.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <map>
#include <string>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

/// No impact gives back more than it took, and next to all are solved.
TEST(FoamImpacts, LoseEnergyAndAreSolved) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", 200);
  std::map<std::string, std::uint64_t> count;
  double slowest = 0;
  std::uint64_t slowest_seed = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const ImpactCase impact = foam_case(seed);
    SCOPED_TRACE(fmt::format("seed {}, {}", seed, name_of(impact.pad.material.law)));
    ASSERT_TRUE(violations(impact).empty());
    Solution solution;
    ASSERT_NO_THROW(solution = solve(impact, {.tolerance = 1e-3}));
    const Summary& s = solution.summary;
    ++count[to_string(s.status)];
    if (s.wall_time > slowest) slowest = s.wall_time, slowest_seed = seed;
    EXPECT_FALSE(gained_energy(s)) << "absorbed " << s.energy_absorbed_fraction << " of the energy, "
                                   << to_string(s.status);
    EXPECT_NE(s.status, Status::not_run);
    EXPECT_TRUE(std::isfinite(s.peak_motion + s.peak_penetration + s.energy.residual));
    EXPECT_LE(s.peak_penetration, impact.pad.thickness * (1 + 1e-12));
    if (s.status == Status::tolerance_not_met) {
      fmt::print("tolerance not met: seed {}, {}, {}\n", seed, name_of(impact.pad.material.law),
                 name_of(impact.impactor.nose));
      continue;
    }
    if (s.status != Status::time_limit) {
      EXPECT_LE(std::abs(s.energy.residual), 1.001 * s.tolerance * s.energy.impact);
    }
    if (s.release) {
      EXPECT_LE(s.restitution.value(), 1 + s.errors.rebound_speed);
    }
    const History& h = solution.history;
    for (std::size_t i = 1; i < h.size(); ++i) ASSERT_GT(h.time[i], h.time[i - 1]) << "entry " << i;
    for (const double force : h.force) ASSERT_TRUE(std::isfinite(force) && force >= 0);
  }
  for (const auto& [status, number] : count) fmt::print("{:20} {:5} of {}\n", status, number, cases);
  fmt::print("slowest: {:.2f} s, seed {}\n", slowest, slowest_seed);
  const double most = cases < 100 ? 1 : 0.03;
  EXPECT_LE(static_cast<double>(count[to_string(Status::tolerance_not_met)]),
            most * static_cast<double>(cases));
}

void times(TableCurve& curve, double factor) {
  for (double& stress : curve.stress) stress *= factor;
}
void times(AvalleCurve& c, double factor) {
  c.plateau_stress *= factor, c.modulus *= factor, c.densification_stress *= factor;
}
void times(PowerCurve& c, double factor) { c.modulus *= factor; }
void times(GibsonAshbyCurve& c, double factor) {
  c.modulus *= factor, c.plateau_stress *= factor, c.gas_pressure *= factor;
}
void times(HyperfoamCurve& c, double factor) { c.first_modulus *= factor, c.second_modulus *= factor; }
void times(FoamCurves& curves, double factor) {
  std::visit([&](auto& form) { times(form, factor); }, curves.base);
  if (auto* effect = std::get_if<CurvesRateEffect>(&curves.rate_effect))
    for (auto& faster : effect->curves) times(faster.curve, factor);
}

/// A foam that returns next to nothing lets go from the edge on to the axis: a ring may press nowhere but
/// where it is looked at.
TEST(FoamImpacts, ThatReturnNextToNothingAreSolved) {
  Foam foam;
  foam.curves.base = AvalleCurve{297.7e3, 4.137e6, 0, 87.26e3, 2.101, 0.97};
  foam.curves.slowest_rate = 0.01;
  foam.continuation_exponent = 2.101;
  foam.unloading_factor = 0;
  ImpactCase impact;
  impact.impactor = {.mass = 1.873, .nose = Sphere{0.0508}, .speed = 7.957};
  impact.pad.thickness = 0.03048;
  impact.support = Support::through({{0.002428, 3826}, {0.004968, 43860}});
  for (const double shape : {15.0, 20.0, 22.236809307078609, 30.0}) {
    foam.unloading_shape = shape;
    impact.pad.material.law = foam;
    const Summary s = solve(impact, {.tolerance = 1e-3}).summary;
    EXPECT_EQ(s.status, Status::released) << "SHAPE " << shape;
    EXPECT_GT(s.energy_absorbed_fraction, 0.5);
  }
}

/// Twice the stress, twice the mass and twice as stiff a support: the same motion under twice the force.
TEST(FoamImpacts, OfTwiceTheMassOnTwiceTheStressMoveTheSame) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    ImpactCase impact = foam_case(seed);
    SCOPED_TRACE(fmt::format("seed {}, {}", seed, name_of(impact.pad.material.law)));
    // The event of the weight, which is not scaled with it, may ask for other runs.
    const Summary once = solve(impact, {.tolerance = 1e-3}).summary;
    impact.impactor.mass *= 2;
    std::visit(
        [&]<class Law>(Law& law) {
          if constexpr (SharesSlip<Law>) times(law.curves, 2);
          if constexpr (std::is_same_v<Law, Foam>)
            if (law.unloading_curve) times(*law.unloading_curve, 2);
          if constexpr (std::is_same_v<Law, CrushableFoam>) law.unloading_modulus *= 2;
        },
        impact.pad.material.law);
    std::vector<Support::Point> points = impact.support.points();
    for (auto& point : points) point.force *= 2;
    if (!points.empty()) impact.support = Support::through(points);
    const Summary twice = solve(impact, {.tolerance = 1e-3}).summary;
    ASSERT_EQ(once.status, twice.status);
    // Of two runs, each with its error.
    constexpr double limit = 2e-3;
    expect_relative(twice.peak_motion, once.peak_motion, limit, "peak motion");
    expect_relative(twice.peak_penetration, once.peak_penetration, limit, "peak penetration");
    ASSERT_EQ(once.peak_force.has_value(), twice.peak_force.has_value());
    if (once.peak_force) expect_relative(*twice.peak_force, 2 * *once.peak_force, limit, "peak force");
    EXPECT_NEAR(twice.energy_absorbed_fraction, once.energy_absorbed_fraction, limit);
  }
}

}  // namespace
}  // namespace dashpad::test
