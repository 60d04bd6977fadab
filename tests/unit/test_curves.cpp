// Curves of impacts: some made by hand, some solved.

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/output/deck/exports.hpp"
#include "example_result.hpp"

namespace dashpad {
namespace {

using output::Curve;
using output::curve;
using testing::ElementsAre;
using testing::IsEmpty;

/// Penetration and force at even times; the rest does not matter to the branches.
Solution solution_of(std::vector<double> penetration, std::vector<double> force, bool released = true) {
  Solution solution;
  History& history = solution.history;
  for (std::size_t i = 0; i < penetration.size(); ++i) history.time.push_back(1e-3 * static_cast<double>(i));
  history.penetration = std::move(penetration);
  history.force = std::move(force);
  if (released) solution.summary.release = Moment{history.time.empty() ? 0 : history.time.back(), -1};
  return solution;
}

/// By straight lines; the x must lie within the curve.
double value_at(const Curve& curve, double x) {
  const auto above = std::lower_bound(curve.x.begin(), curve.x.end(), x);
  const auto i = static_cast<std::size_t>(above - curve.x.begin());
  if (i == 0 || curve.x[i] == x) return curve.y[i];
  const double share = (x - curve.x[i - 1]) / (curve.x[i] - curve.x[i - 1]);
  return curve.y[i - 1] + share * (curve.y[i] - curve.y[i - 1]);
}

void expect_fit_for_decks(const Curve& curve) {
  ASSERT_TRUE(curve.exists()) << curve.name;
  ASSERT_EQ(curve.x.size(), curve.y.size());
  EXPECT_EQ(curve.x.front(), 0) << curve.name;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    EXPECT_TRUE(std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) << curve.name << " " << i;
    if (i > 0) {
      EXPECT_GT(static_cast<float>(curve.x[i]), static_cast<float>(curve.x[i - 1])) << curve.name << " " << i;
    }
  }
}

TEST(Curves, OverTimeAreTheHistory) {
  Solution solution;
  solution.history = {.time = {0, 1, 2},
                      .force = {0, 5, 1},
                      .acceleration = {0, -2.5, -0.5},
                      .velocity = {3, 2, 1},
                      .motion = {0, 2.5, 4},
                      .penetration = {0, 2, 3},
                      .support_deflection = {0, 0.5, 1},
                      .contact_radius = {0, 1, 1},
                      .axis_strain = {0, 0.2, 0.3}};
  const Curve force = curve("force", solution);
  EXPECT_EQ(force.abscissa.meaning, "time");
  EXPECT_EQ(force.abscissa.si_unit, "s");
  EXPECT_EQ(force.ordinate.si_unit, "N");
  EXPECT_THAT(force.x, ElementsAre(0, 1, 2));
  EXPECT_THAT(force.y, ElementsAre(0, 5, 1));
  EXPECT_THAT(curve("acceleration", solution).y, ElementsAre(0, -2.5, -0.5));
  EXPECT_THAT(curve("velocity", solution).y, ElementsAre(3, 2, 1));
  EXPECT_THAT(curve("motion", solution).y, ElementsAre(0, 2.5, 4));
  EXPECT_THAT(curve("penetration", solution).y, ElementsAre(0, 2, 3));
}

TEST(Curves, HaveNamesAndNoOthers) {
  for (const std::string& name : output::curve_names()) EXPECT_EQ(curve(name, Solution{}).name, name);
  EXPECT_THROW(curve("power", Solution{}), std::invalid_argument);
}

TEST(Curves, OfNothingDoNotExist) {
  for (const std::string& name : output::curve_names())
    EXPECT_FALSE(curve(name, Solution{}).exists()) << name;
}

TEST(Curves, OfAHistoryWithGapsAreRefused) {
  Solution solution = solution_of({0, 1, 0}, {0, 1});
  for (const char* name : {"force", "loading", "unloading"})
    EXPECT_THROW(curve(name, solution), std::invalid_argument) << name;
}

TEST(Curves, PassOverPointsThatSinglePrecisionCannotTellApart) {
  Solution solution;
  solution.history.time = {0, 1e-9, 0.5, 0.5 + 1e-8, 1 - 1e-8, 1};
  solution.history.force = {0, 1, 2, 3, 4, 5};
  const Curve force = curve("force", solution);
  EXPECT_THAT(force.x, ElementsAre(0, 0.5, 1));
  EXPECT_THAT(force.y, ElementsAre(0, 2, 5));
}

TEST(Curves, PassOverWhatIsNotFinite) {
  Solution solution;
  solution.history.time = {0, 1, 2};
  solution.history.force = {0, std::nan(""), 2};
  EXPECT_THAT(curve("force", solution).x, ElementsAre(0, 2));
}

TEST(Branches, MeetAtTheLargestPenetration) {
  const Solution solution = solution_of({0, 1, 3, 4, 2, 1}, {0, 10, 30, 35, 8, 0});
  const Curve loading = output::loading_branch(solution.history);
  EXPECT_THAT(loading.x, ElementsAre(0, 1, 3, 4));
  EXPECT_THAT(loading.y, ElementsAre(0, 10, 30, 35));
  const Curve unloading = output::unloading_branch(solution);
  EXPECT_THAT(unloading.x, ElementsAre(0, 1, 2, 4));
  EXPECT_THAT(unloading.y, ElementsAre(0, 0, 8, 35));
}

TEST(Branches, TakeTheFirstForceOnTheWayInAndTheLastOnTheWayOut) {
  //                                    held        back      on           back, and on a little, out
  const Solution solution =
      solution_of({0, 1, 1, 1, 2, 1.5, 2, 3, 4, 2, 3, 1}, {0, 10, 9, 8, 20, 12, 17, 28, 40, 11, 21, 0});
  const Curve loading = output::loading_branch(solution.history);
  EXPECT_THAT(loading.x, ElementsAre(0, 1, 2, 3, 4));
  EXPECT_THAT(loading.y, ElementsAre(0, 10, 20, 28, 40));
  const Curve unloading = output::unloading_branch(solution);
  EXPECT_THAT(unloading.x, ElementsAre(0, 1, 3, 4));
  EXPECT_THAT(unloading.y, ElementsAre(0, 0, 21, 40));
}

TEST(Branches, SpreadAFallAtTheLargestPenetration) {
  // Locked, and the support goes on: up to 50, back to 25, then out.
  const Solution solution = solution_of({0, 2, 4, 4, 4, 3.9, 0}, {0, 15, 40, 50, 25, 20, 0});
  EXPECT_THAT(output::loading_branch(solution.history).y, ElementsAre(0, 15, 40));
  const Curve unloading = output::unloading_branch(solution);
  EXPECT_THAT(unloading.x, ElementsAre(0, 3.9, 4 * (1 - output::widest_fall), 4));
  EXPECT_THAT(unloading.y, ElementsAre(0, 20, 25, 40));
}

TEST(Branches, SpreadAFallNoFurtherThanHalfTheWayBack) {
  const Solution solution = solution_of({0, 2, 4, 4, 3.999, 0}, {0, 15, 40, 25, 20, 0});
  const Curve unloading = output::unloading_branch(solution);
  ASSERT_EQ(unloading.size(), 4u);
  EXPECT_NEAR(unloading.x[2], 3.9995, 1e-12);
}

TEST(Branches, OfAFoamThatKeepsItsDentFallAtOnce) {
  const Curve unloading = output::unloading_branch(solution_of({0, 2, 4}, {0, 15, 40}));
  EXPECT_THAT(unloading.x, ElementsAre(0, 4 * (1 - output::widest_fall), 4));
  EXPECT_THAT(unloading.y, ElementsAre(0, 0, 40));
}

TEST(Branches, OfAFoamThatComesBackWhollyHaveNoPlateauAtZero) {
  const Curve unloading = output::unloading_branch(solution_of({0, 2, 4, 2, -1e-12}, {0, 15, 40, 15, 0}));
  EXPECT_THAT(unloading.x, ElementsAre(0, 2, 4));
}

TEST(Branches, WithoutReleaseHaveNoWayBack) {
  EXPECT_TRUE(output::loading_branch(solution_of({0, 2, 4, 3}, {0, 15, 40, 10}, false).history).exists());
  EXPECT_THAT(output::unloading_branch(solution_of({0, 2, 4, 3}, {0, 15, 40, 10}, false)).x, IsEmpty());
}

// ---------------------------------------------------------------- solved impacts

ImpactCase elastic_on_rigid() {
  ImpactCase impact = test::example_case();
  impact.pad.material.law = Elastic{.modulus = 3e5};
  impact.pad.material.fitted.reset();
  impact.pad.thickness = 0.05;
  impact.impactor.speed = 3;
  impact.support = Support::rigid();
  return impact;
}

TEST(SolvedBranches, OfAnElasticPadAreItsClosedForm) {
  const ImpactCase impact = elastic_on_rigid();
  const Solution solution = solve(impact, {});
  // F = 2 pi (E / L) (R y^2 / 2 - y^3 / 6): theory.md, Eq. 18, with one slope and no initial stress.
  const double stiffness = 3e5 / impact.pad.thickness, radius = std::get<Sphere>(impact.impactor.nose).radius;
  for (const char* name : {"loading", "unloading"}) {
    const Curve branch = curve(name, solution);
    expect_fit_for_decks(branch);
    for (std::size_t i = 0; i < branch.size(); ++i) {
      const double y = branch.x[i];
      const double exact = 2 * M_PI * stiffness * (radius * y * y / 2 - y * y * y / 6);
      // At release the force is called 0 where it is a rounding error.
      EXPECT_NEAR(branch.y[i], exact, 1e-6 * branch.y.back()) << name << " at " << y;
    }
  }
}

TEST(SolvedBranches, HaveTheAreaOfTheEnergyTheyTake) {
  const ImpactCase impact = test::example_case();
  const Solution solution = solve(impact, {.tolerance = 1e-5});
  const auto area = [](const Curve& curve) {
    double sum = 0;
    for (std::size_t i = 1; i < curve.size(); ++i)
      sum += (curve.y[i] + curve.y[i - 1]) / 2 * (curve.x[i] - curve.x[i - 1]);
    return sum;
  };
  const Curve loading = curve("loading", solution), unloading = curve("unloading", solution);
  expect_fit_for_decks(loading);
  expect_fit_for_decks(unloading);
  // The trapezoids of some hundred points are good to about 1e-4.
  EXPECT_NEAR(area(loading) - area(unloading), solution.summary.energy.pad, 1e-3 * area(loading));
}

TEST(SolvedBranches, OfEveryKindOfEndAreFitForDecks) {
  const RigidFoam rigid{.crush_stress = 1e5, .crush_strain = 0.6, .second_stress = 5e5, .second_strain = 0.8};
  for (const bool rigid_support : {false, true})
    for (const double speed : {1.0, 8.0, 30.0})
      for (const bool crushable : {false, true}) {
        ImpactCase impact = test::example_case();
        impact.pad.material.fitted.reset();
        impact.impactor.speed = speed;
        if (crushable) impact.pad.material.law = rigid;
        if (rigid_support) impact.support = Support::rigid();
        const Solution solution = solve(impact, {});
        for (const std::string& name : output::curve_names()) {
          const Curve of = curve(name, solution);
          if (name == "unloading" && !solution.summary.release)
            EXPECT_FALSE(of.exists());
          else
            expect_fit_for_decks(of);
        }
      }
}

// ---------------------------------------------------------------- thinning

Curve random_curve(unsigned seed, std::size_t size) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> step(0.1, 1), value(-1, 1);
  Curve of{"force", {"time", "s"}, {"force", "N"}, {}, {}};
  double x = 0;
  for (std::size_t i = 0; i < size; ++i) {
    of.x.push_back(x);
    of.y.push_back(value(random));
    x += step(random);
  }
  return of;
}

TEST(Thinning, SaysTheErrorThatItMakes) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Curve all = random_curve(seed, 300);
    for (const std::size_t most : {2u, 3u, 10u, 150u, 299u}) {
      const output::ThinnedCurve few = output::thinned(all, most);
      EXPECT_EQ(few.curve.size(), most);
      EXPECT_EQ(few.curve.x.front(), all.x.front());
      EXPECT_EQ(few.curve.x.back(), all.x.back());
      double worst = 0;
      for (std::size_t i = 0; i < all.size(); ++i)
        worst = std::max(worst, std::abs(value_at(few.curve, all.x[i]) - all.y[i]));
      EXPECT_NEAR(worst, few.error, 1e-12);
      EXPECT_GT(few.error, 0);
    }
  }
}

TEST(Thinning, LeavesAShortCurveAlone) {
  const Curve all = random_curve(7, 20);
  EXPECT_EQ(output::thinned(all, 20).curve.y, all.y);
  EXPECT_EQ(output::thinned(all, 20).error, 0);
}

TEST(Thinning, OfALineNeedsItsEndsOnly) {
  Curve line{"force", {"time", "s"}, {"force", "N"}, {}, {}};
  for (int i = 0; i <= 64; ++i) line.x.push_back(i), line.y.push_back(2 * i);
  EXPECT_THAT(output::thinned(line, 10).curve.x, ElementsAre(0, 64));
}

TEST(Thinning, OfASolvedImpactGetsBetterWithMorePoints) {
  const Curve all = curve("force", solve(test::example_case(), {}));
  const double highest = *std::ranges::max_element(all.y);
  EXPECT_LT(output::thinned(all, 50).error, 5e-3 * highest);
  EXPECT_LT(output::thinned(all, 50).error, output::thinned(all, 12).error);
}

TEST(Thinning, RefusesAPoint) { EXPECT_THROW(output::thinned(random_curve(1, 9), 1), std::invalid_argument); }

}  // namespace
}  // namespace dashpad
