/// A sheet with mass on the struck face (theory.md, Eq. 56): closed forms, another integration of the same
/// equations, the limit without mass, and the ledger.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <variant>

#include "dashpad/impact/solve.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

ImpactCase under_sheet(double mass_per_area, const PadLaw& law, const Support& support = Support::rigid()) {
  ImpactCase impact = impact_on(law, support);
  impact.pad.sheet = mass_per_area;
  return impact;
}

/// A plastic blow, then a mass on a spring; the sheet leaves with the speed that it has at the end.
TEST(Sheet, StruckByADiscIsAPlasticBlowAndThenASpring) {
  ImpactCase impact = under_sheet(20, Elastic{.modulus = 3e5});
  impact.impactor.nose = FlatDisc{0.08};
  const double area = std::numbers::pi * 0.08 * 0.08, sheet = 20 * area, mass = 4, speed = 3;
  const double stiffness = 3e5 * area / 0.03, both = mass + sheet, after = speed * mass / both;
  const Summary s = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_TRUE(s.trustworthy());
  EXPECT_NEAR(s.speed_to_sheet, speed - after, 1e-12);
  EXPECT_NEAR(*s.peak_force, mass / both * after * std::sqrt(stiffness * both), 2e-6 * *s.peak_force);
  EXPECT_NEAR(s.peak_penetration, after * std::sqrt(both / stiffness), 2e-6 * s.peak_penetration);
  EXPECT_NEAR(*s.rebound_speed, after, 2e-6 * after);
  EXPECT_NEAR(s.energy.sheet, mass * (speed * speed - after * after) / 2, 1e-5 * s.energy.impact);
}

/// Where a nose grows no wider the drag ends at once, within a step.
TEST(Sheet, MetUpToARimKeepsTheLedger) {
  ImpactCase impact = under_sheet(20, Elastic{.modulus = 3e5});
  impact.impactor.nose = Rod{.radius = 0.05, .tip_radius = 0.2};
  impact.impactor.speed = 5;
  impact.pad.thickness = 0.06;
  const Summary s = solve(impact, {.tolerance = 1e-4}).summary;
  ASSERT_TRUE(s.trustworthy());
  ASSERT_GT(s.peak_penetration, 2 * sections_of(impact.impactor.nose).depth);
  EXPECT_LT(std::abs(s.energy.residual), 1e-5 * s.energy.impact);
}

/// Nothing but the sheet slows it down: its momentum is shared with what it has met.
TEST(Sheet, OnAPadThatGivesNoForceSharesTheMomentum) {
  for (const Nose& nose : {Nose(Sphere{0.08}), Nose(Cone{0.2, 1.2, 0.02})}) {
    ImpactCase impact = under_sheet(100, Elastic{.modulus = 1});
    impact.impactor.nose = nose;
    impact.pad.thickness = 0.1;
    const Sections sections = sections_of(nose);
    const Solution at = solve(impact, {.tolerance = 1e-4, .time_limit = 0.015, .fixed_runs = 6});
    double worst = 0;
    for (std::size_t i = 0; i < at.history.size(); ++i)
      worst = std::max(
          worst,
          std::abs((4 + 100 * sections.area(at.history.penetration[i])) * at.history.velocity[i] / 12 - 1));
    EXPECT_LT(worst, 1e-4) << name_of(nose);
    EXPECT_GT(at.history.penetration.back(), 0.015) << name_of(nose);
    EXPECT_LT(at.history.velocity.back(), 2.4) << name_of(nose);
  }
}

/// A sphere on a linear pad and a spring, integrated by the classical Runge-Kutta method in small steps.
struct Other {
  double peak_force = 0, rebound = 0;
  Other(double sheet, double stiffness, double gravity) {
    using std::numbers::pi;
    constexpr double mass = 4, radius = 0.08, thickness = 0.03, modulus = 3e5;
    const auto force = [&](double y) { return modulus / thickness * pi * (radius * y * y - y * y * y / 3); };
    const auto rates = [&](const std::array<double, 2>& given) {
      const double y = given[0], area = pi * (2 * radius * y - y * y), widening = 2 * pi * (radius - y);
      const double in = given[1] / (1 + modulus / thickness * area / stiffness);
      const double drag = in > 0 ? sheet * widening * in * in : 0;
      return std::array{in, (mass * gravity - force(y) - drag) / (mass + sheet * area)};
    };
    std::array<double, 2> now{0, 3};
    constexpr double step = 2e-7;
    while (now[0] >= 0) {
      peak_force = std::max(peak_force, mass * (gravity - rates(now)[1]));
      const auto beyond = [&](const std::array<double, 2>& k, double by) {
        return std::array{now[0] + by * k[0], now[1] + by * k[1]};
      };
      const auto k1 = rates(now), k2 = rates(beyond(k1, step / 2)), k3 = rates(beyond(k2, step / 2)),
                 k4 = rates(beyond(k3, step));
      for (std::size_t i = 0; i < 2; ++i) now[i] += step / 6 * (k1[i] + 2 * k2[i] + 2 * k3[i] + k4[i]);
    }
    rebound = -now[1];
  }
};

TEST(Sheet, AgreesWithAnotherIntegration) {
  for (const double sheet : {2.0, 20.0, 200.0})
    for (const auto& [support, stiffness] :
         {std::pair{Support::rigid(), 1e15}, std::pair{Support::linear(1e5), 1e5}})
      for (const double gravity : {0.0, 9.81}) {
        ImpactCase impact = under_sheet(sheet, Elastic{.modulus = 3e5}, support);
        impact.impactor.gravity = gravity;
        const Other other(sheet, stiffness, gravity);
        const Summary s = solve(impact, {.tolerance = 1e-5}).summary;
        SCOPED_TRACE(fmt::format("{} kg/m2, {} N/m, {} m/s2: {} and {} N, {} and {} m/s", sheet, stiffness,
                                 gravity, *s.peak_force, other.peak_force, *s.rebound_speed, other.rebound));
        ASSERT_TRUE(s.trustworthy());
        EXPECT_NEAR(*s.peak_force, other.peak_force, 3e-5 * other.peak_force);
        EXPECT_NEAR(*s.rebound_speed, other.rebound, 3e-5 * 3);
      }
}

/// Without mass it is not there; the change is in proportion to it.
TEST(Sheet, VanishesWithItsMass) {
  for (const PadLaw& law :
       {PadLaw(Elastic{3e5}), PadLaw(sample_law<NineParameter>()), PadLaw(sample_law<Foam>()),
        PadLaw(sample_law<CrushableFoam>()), PadLaw(sample_law<RigidFoam>())}) {
    const auto peak = [&](double sheet) {
      return *solve(under_sheet(sheet, law), {.tolerance = 1e-6}).summary.peak_force;
    };
    const double without = peak(0), light = peak(0.01) - without, heavier = peak(0.1) - without;
    EXPECT_LT(std::abs(light), 2e-4 * without) << name_of(law);
    if (std::abs(heavier) > 1e-4 * without) {
      EXPECT_NEAR(light / heavier, 0.1, 0.03) << name_of(law);
    }
  }
}

/// On every law and on supports that yield, crush and move: figures that settle, and a ledger that closes.
TEST(Sheet, KeepsTheLedger) {
  Backing panel, crushing;
  panel.mass = 1, panel.damping = 200;
  crushing.unloading_stiffness = 4e5;
  const PadLaw laws[] = {PadLaw(Elastic{3e5}),
                         PadLaw(sample_law<LinearViscoelastic>()),
                         PadLaw(sample_law<RigidFoam>()),
                         PadLaw(sample_law<NineParameter>()),
                         PadLaw(sample_law<TwentyOneParameter>()),
                         PadLaw(sample_law<Foam>()),
                         PadLaw(sample_law<CrushableFoam>()),
                         PadLaw(sample_law<ViscoelasticFoam>())};
  for (const PadLaw& law : laws)
    for (const Backing& backing : {Backing{}, panel, crushing})
      for (const Nose& nose : {Nose(Sphere{0.08}), Nose(FlatDisc{0.05}), Nose(Cone{0.1, 1.2, 0.02})}) {
        // Shallow, and so deep that the pad closes: short steps there must not show as forces of the sheet.
        const bool deep = backing == Backing{} && std::holds_alternative<Sphere>(nose);
        ImpactCase impact = under_sheet(5, law, Support::linear(2e5));
        impact.impactor.nose = nose;
        impact.impactor.speed = deep ? 9 : 2;
        impact.backing = backing;
        ASSERT_TRUE(violations(impact).empty());
        const Summary s = solve(impact, {.tolerance = 1e-3}).summary;
        const EnergyLedger& e = s.energy;
        SCOPED_TRACE(fmt::format("{}, {}, backing {} {}: {}, residual {:.1e}", name_of(law), name_of(nose),
                                 backing.mass, backing.unloading_stiffness, to_string(s.status),
                                 e.residual / e.impact));
        EXPECT_TRUE(s.trustworthy());
        EXPECT_NEAR(e.supply(),
                    e.kinetic + e.support + e.support_loss + e.moving + e.pad + e.sheet + e.residual,
                    1e-12 * e.impact);
        EXPECT_LT(std::abs(e.residual), 1e-3 * e.impact);
        EXPECT_GT(e.sheet, 0);
        EXPECT_GE(s.energy_absorbed_fraction, 0);
        const Summary fine = solve(impact, {.tolerance = 1e-5}).summary;
        if (!s.peak_force || !fine.peak_force) continue;
        EXPECT_NEAR(*s.peak_force, *fine.peak_force, 1e-3 * *fine.peak_force);
      }
}

TEST(Sheet, OnLayersIsAsOnTheirFoam) {
  const ImpactCase whole = under_sheet(10, sample_law<CrushableFoam>(), Support::linear(2e5));
  ImpactCase layered = whole;
  PadLayer third{.thickness = 0.01, .material = whole.pad.material},
      rest{.thickness = 0.02, .material = whole.pad.material};
  set_layers(layered.pad, {third, rest});
  const Summary one = solve(whole).summary, two = solve(layered).summary;
  EXPECT_NEAR(*two.peak_force, *one.peak_force, 2e-4 * *one.peak_force);
  EXPECT_NEAR(*two.rebound_speed, *one.rebound_speed, 6e-4);
}

}  // namespace
}  // namespace dashpad::test
