/// Repeated blows on one pad (theory.md, Eqs. 46 to 50): closed forms, and what must hold from blow to blow.
/// The second solver's word is in test_foam_against_cvode.cpp.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <boost/math/tools/roots.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "model/contact/foam_contact.hpp"
#include "property/random_case.hpp"
#include "shared/samples.hpp"
#include "verification/order.hpp"

namespace dashpad::test {
namespace {

ImpactCase struck(const PadLaw& law, int count, double recovery, Support support = Support::rigid()) {
  ImpactCase impact = impact_on(law, std::move(support));
  impact.blows = Blows{.count = count, .recovery = recovery};
  return impact;
}

/// Without friction and rate effect, so that what counts below a flat disc is the work alone.
Foam elastic_unloading_foam(double unloading_factor, double shape) {
  Foam foam;
  foam.unloading_factor = unloading_factor;
  foam.unloading_shape = shape;
  foam.curves = {
      .base = PowerCurve{80e3, 0.675, 1.09, 0.9}, .slowest_rate = 0.01, .rate_effect = NoRateEffect{}};
  return foam;
}

double work_to(const Foam& law, double strain) {
  const auto& curve = std::get<PowerCurve>(law.curves.base);
  // The root of the strain takes the infinite slope at strain zero away.
  return boost::math::quadrature::gauss_kronrod<double, 61>::integrate(
      [&](double x) { return curve.stress(x * x) * 2 * x; }, 0.0, std::sqrt(strain), 5, 1e-12);
}
double strain_after(const Foam& law, double work) {
  std::uintmax_t most = 100;
  const auto [low, high] =
      boost::math::tools::toms748_solve([&](double strain) { return work_to(law, strain) - work; }, 1e-6, 0.9,
                                        boost::math::tools::eps_tolerance<double>(45), most);
  return (low + high) / 2;
}

/// Eq. 50: the work of the base curve at the largest strain of each blow is a geometric series.
TEST(Blows, BelowAFlatDiscFollowTheirClosedForm) {
  for (const double factor : {0.0, 0.3, 0.8})
    for (const double shape : {0.5, 2.0, 8.0}) {
      SCOPED_TRACE(fmt::format("HU {}, SHAPE {}", factor, shape));
      const Foam law = elastic_unloading_foam(factor, shape);
      ImpactCase impact = struck(law, 5, 0);
      impact.impactor = {.mass = 4, .nose = FlatDisc{0.08}, .speed = 2};
      const auto blows = solve_blows(impact, {.tolerance = 1e-5});
      ASSERT_EQ(blows.size(), 5u);
      const double area = std::numbers::pi * 0.08 * 0.08;
      const double given = 4 * 2 * 2 / 2.0 / (area * impact.pad.thickness);
      double work = 0;
      for (const Blow& blow : blows) {
        work = given + (1 - factor) * shape / (shape + 1) * work;
        const double strain = strain_after(law, work);
        const Summary& s = blow.solution.summary;
        ASSERT_EQ(s.status, Status::released);
        expect_relative(s.peak_strain, strain, 2e-5, "peak strain");
        expect_relative(*s.peak_force, std::get<PowerCurve>(law.curves.base).stress(strain) * area, 1e-4,
                        "peak force");
        const double returned = work * (factor + (1 - factor) / (shape + 1));
        EXPECT_NEAR(s.energy_absorbed_fraction, 1 - returned / given, 1e-4);
      }
    }
}

/// A blow that goes less deep than an earlier one is loaded along the way back alone: it loses nothing.
TEST(Blows, LessDeepThanAnEarlierOneFollowTheWayBack) {
  const double factor = 0.2, shape = 3;
  const Foam law = elastic_unloading_foam(factor, shape);
  ImpactCase impact = impact_on(law);
  impact.impactor = {.mass = 4, .nose = FlatDisc{0.08}, .speed = 1};
  impact.pad.earlier_penetration = 0.7 * impact.pad.thickness;
  const Summary s = solve(impact, {.tolerance = 1e-5}).summary;
  const double most = work_to(law, 0.7);
  const double given = 4 / 2.0 / (std::numbers::pi * 0.08 * 0.08 * impact.pad.thickness);
  std::uintmax_t iterations = 100;
  const auto taken = [&](double x) {
    return most * (factor * x + (1 - factor) * std::pow(x, shape + 1) / (shape + 1)) - given;
  };
  const auto [low, high] = boost::math::tools::toms748_solve(
      taken, 0.0, 1.0, boost::math::tools::eps_tolerance<double>(45), iterations);
  const double strain = strain_after(law, most * (low + high) / 2);
  ASSERT_LT(strain, 0.7);
  expect_relative(s.peak_strain, strain, 2e-5, "peak strain");
  EXPECT_NEAR(s.energy_absorbed_fraction, 0, 1e-5);
}

/// Columns of a pad that was struck before, one by one.
TEST(Blows, ForceIsTheIntegralOfColumnsThatRemember) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed)
    for (const Nose& nose : {Nose(Sphere{0.08}), Nose(FlatDisc{0.06}), Nose(Cone{0.1, 1.2})}) {
      const auto check = [&](const auto& law) {
        constexpr double thickness = 0.03;
        const Sections sections = sections_of(nose);
        FoamContact contact(law, thickness, sections, 1, ColumnMath::vector, 0.6 * thickness);
        contact.start(1e-4, thickness);
        double y = contact.crater(), time = 0, largest = 0;
        for (const double to : {0.55, 0.58, 0.5, 0.7, 0.4}) {
          if (to * thickness < y && to == 0.55) continue;
          const PadTrial trial = contact.trial(to * thickness - y, time, 1e-3);
          contact.accept(trial);
          y = to * thickness, time += 1e-3;
          largest = std::max(largest, trial.force);
          double force = sections.tip > 0 ? sections.tip * std::max(contact.column(0).stress, 0.0) : 0;
          constexpr int count = 8000;
          const double deepest = std::min(y, sections.depth);
          for (int i = 0; i < count; ++i) {
            const double inner = deepest * i / count, outer = deepest * (i + 1) / count;
            force += std::max(contact.column((inner + outer) / 2).stress, 0.0) *
                     (sections.area(outer) - sections.area(inner));
          }
          EXPECT_NEAR(trial.force, force, 1e-3 * largest)
              << law.name << ", seed " << seed << ", " << name_of(nose) << ", strain " << to;
        }
      };
      check(random_foam(seed));
      check(random_crushable_foam(seed));
    }
}

TEST(Blows, WithFullRecoveryAreTheFirstToTheLastBit) {
  for (const PadLaw& law : {PadLaw(sample_law<Foam>()), PadLaw(sample_law<Elastic>()),
                            PadLaw(sample_law<NineParameter>()), PadLaw(sample_law<ViscoelasticFoam>())}) {
    const ImpactCase impact = struck(law, 3, 1);
    ImpactCase once = impact;
    once.blows.reset();
    const Solution alone = solve(once);
    const auto blows = solve_blows(impact);
    ASSERT_EQ(blows.size(), 3u) << name_of(law);
    for (const Blow& blow : blows) {
      EXPECT_EQ(blow.solution.summary.peak_force, alone.summary.peak_force) << name_of(law);
      EXPECT_EQ(blow.solution.history.force, alone.history.force) << name_of(law);
      EXPECT_EQ(blow.solution.history.penetration, alone.history.penetration) << name_of(law);
    }
  }
}

/// A law without memory between blows is not asked how much it recovers.
TEST(Blows, OnAPadThatRecoversByItsLawAreAlike) {
  for (const PadLaw& law :
       {PadLaw(sample_law<LinearViscoelastic>()), PadLaw(sample_law<TwentyOneParameter>())}) {
    const auto blows = solve_blows(struck(law, 2, 0));
    ASSERT_EQ(blows.size(), 2u);
    EXPECT_EQ(blows[1].impact.pad.earlier_penetration, 0);
    EXPECT_EQ(blows[0].solution.history.force, blows[1].solution.history.force);
  }
}

/// solve() answers with the last.
TEST(Blows, SolveGivesTheLast) {
  const ImpactCase impact = struck(sample_law<Foam>(), 4, 0.2);
  const auto blows = solve_blows(impact);
  const Solution last = solve(impact);
  EXPECT_EQ(last.history.force, blows.back().solution.history.force);
  EXPECT_EQ(last.summary.blow, 4);
  const ImpactCase& by_hand = blows.back().impact;
  EXPECT_EQ(solve(by_hand).history.force, last.history.force);
}

/// Rigid foam, flat disc, no support: each blow takes the crater further by its energy over the force.
TEST(Blows, DeepenACraterInRigidFoamByTheirEnergy) {
  const RigidFoam law = sample_law<RigidFoam>();
  ImpactCase impact = struck(law, 3, 0);
  impact.impactor = {.mass = 4, .nose = FlatDisc{0.05}, .speed = 2};
  const double force = law.crush_stress * std::numbers::pi * 0.05 * 0.05;
  double crater = 0;
  for (const Blow& blow : solve_blows(impact)) {
    const Summary& s = blow.solution.summary;
    crater += 4 * 2 * 2 / 2.0 / force;
    EXPECT_NEAR(s.peak_penetration, crater, 1e-6 * crater);
    EXPECT_NEAR(*s.peak_force, force, 1e-9 * force);
    EXPECT_NEAR(s.peak_motion, 8 / force, 1e-6 * crater) << "since first contact";
    EXPECT_NEAR(s.energy_absorbed_fraction, 1, 1e-6);
  }
}

/// On a yielding support a crater gives way at the force that made it; below that only the support moves.
TEST(Blows, TooWeakToDeepenACraterLeaveItAsItIs) {
  ImpactCase impact = impact_on(sample_law<RigidFoam>(), Support::linear(2e5));
  impact.pad.earlier_penetration = 0.01;
  impact.impactor.speed = 0.5;
  const Solution weak = solve(impact, {.tolerance = 1e-6});
  EXPECT_EQ(weak.summary.status, Status::released);
  EXPECT_EQ(weak.summary.peak_penetration, 0.01);
  EXPECT_NEAR(weak.summary.energy_absorbed_fraction, 0, 1e-9);
  expect_relative(*weak.summary.peak_force, 0.5 * std::sqrt(4 * 2e5), 1e-6, "peak force");
  impact.impactor.speed = 3;
  const Solution strong = solve(impact, {.tolerance = 1e-6});
  EXPECT_EQ(strong.summary.status, Status::released);
  EXPECT_GT(strong.summary.peak_penetration, 0.01);
  EXPECT_LT(std::abs(strong.summary.energy.residual), 1e-6 * strong.summary.energy.impact);
}

/// Crushed foam is met where it has sprung back to, without force, and carries what it carried where the nose
/// is as deep as before.
TEST(Blows, MeetCrushedFoamInItsCrater) {
  CrushableFoam law = sample_law<CrushableFoam>();
  law.curves.rate_effect = NoRateEffect{};
  for (const Nose& nose : {Nose(Sphere{0.08}), Nose(FlatDisc{0.05})}) {
    ImpactCase impact = struck(law, 2, 0);
    impact.impactor.nose = nose;
    impact.impactor.speed = 2;
    const auto blows = solve_blows(impact, {.tolerance = 1e-5});
    ASSERT_EQ(blows.size(), 2u);
    const Summary& first = blows[0].solution.summary;
    const History& again = blows[1].solution.history;
    const double stress = std::get<TableCurve>(law.curves.base).stress.back();
    EXPECT_LT(again.penetration.front(), first.peak_penetration);
    EXPECT_GT(again.penetration.front(),
              first.peak_penetration - impact.pad.thickness * stress / law.unloading_modulus);
    EXPECT_EQ(again.force.front(), 0);
    EXPECT_EQ(again.motion.front(), 0);
    const auto joint = std::ranges::find_if(
        again.penetration, [&](double y) { return y >= first.peak_penetration * (1 - 1e-9); });
    ASSERT_NE(joint, again.penetration.end());
    const auto entry = static_cast<std::size_t>(joint - again.penetration.begin());
    expect_relative(again.penetration[entry], first.peak_penetration, 1e-9, "a step ends there");
    expect_relative(again.force[entry], *first.peak_force, 2e-3, "force there");
  }
}

/// Runs at halved resolution, all figures of the second blow.
TEST(Blows, ConvergeWithSecondOrder) {
  for (const PadLaw& law : {PadLaw(elastic_unloading_foam(0.2, 2)), PadLaw(sample_law<Foam>()),
                            PadLaw(sample_law<CrushableFoam>())}) {
    ImpactCase impact = impact_on(law, Support::linear(2e5));
    impact.impactor.speed = 2.5;
    impact.pad.earlier_penetration = 0.5 * impact.pad.thickness;
    const auto peak_with = [&](int runs) { return *solve(impact, {.fixed_runs = runs}).summary.peak_force; };
    const double fine = peak_with(9);
    std::string text;
    double last = 0;
    for (int runs = 3; runs <= 6; ++runs) {
      last = relative_error(peak_with(runs), fine);
      text += fmt::format(" {:.1e}", last);
    }
    fmt::print("{:18}{}\n", name_of(law), text);
    EXPECT_LT(last, 2e-5) << name_of(law) << text;
  }
}

/// The error of what one blow leaves behind is below the estimates of the next.
TEST(Blows, KeepTheirToleranceFromBlowToBlow) {
  for (const PadLaw& law : {PadLaw(sample_law<Foam>()), PadLaw(elastic_unloading_foam(0.1, 4)),
                            PadLaw(sample_law<CrushableFoam>())}) {
    ImpactCase impact = struck(law, 5, 0, Support::linear(1e5));
    impact.impactor.speed = 2;
    const Summary coarse = solve(impact, {.tolerance = 1e-3}).summary;
    const Summary fine = solve(impact, {.tolerance = 1e-6}).summary;
    ASSERT_EQ(coarse.blow, 5);
    ASSERT_EQ(fine.blow, 5);
    expect_relative(*coarse.peak_force, *fine.peak_force, 1e-3, "peak force");
    expect_relative(coarse.peak_penetration, fine.peak_penetration, 1e-3, "peak penetration");
    EXPECT_LE(std::abs(fine.energy.residual), 1e-6 * fine.energy.impact);
  }
}

TEST(Blows, EndWithOneThatClosesThePad) {
  ImpactCase impact = struck(sample_law<Foam>(), 4, 0);
  impact.impactor.mass = 400;
  impact.impactor.speed = 20;
  const auto blows = solve_blows(impact);
  ASSERT_LT(blows.size(), 4u);
  const Summary& last = blows.back().solution.summary;
  EXPECT_TRUE(is_series_cut(last));
  EXPECT_FALSE(leaves_a_known_pad(last));
}

}  // namespace
}  // namespace dashpad::test
