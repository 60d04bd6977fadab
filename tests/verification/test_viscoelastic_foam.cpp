/// Slow foam (theory.md, Eq. 40) against its limits and closed forms.

#include <gtest/gtest.h>
#include <boost/math/quadrature/gauss.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/laboratory/column_test.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

ViscoelasticFoam slow_foam() { return sample_law<ViscoelasticFoam>(); }

/// p, written anew.
double lasting(const ViscoelasticFoam& law, double e) {
  const auto term = [e](double mu, double a) { return 2 * mu / a * (1 - std::pow(1 - e, a)) / (1 - e); };
  return term(law.first_modulus, law.first_exponent) + term(law.second_modulus, law.second_exponent);
}

/// Straight pieces of a duration to a strain.
laboratory::ColumnTest driven(const ViscoelasticFoam& law,
                              const std::vector<std::pair<double, double>>& pieces, int places = 200) {
  std::vector<double> times{0};
  std::vector<double> strains{0};
  for (const auto& [duration, to] : pieces) {
    times.push_back(times.back() + duration);
    strains.push_back(to);
  }
  return laboratory::drive(PadLaw(law), laboratory::measured_test(times, strains), places);
}

TEST(ViscoelasticFoam, RelaxesFromASuddenStrain) {
  const ViscoelasticFoam law = slow_foam();
  const double ramp = 1e-6;
  const auto test = driven(law, {{ramp, 0.4}, {0.5, 0.4}});
  for (std::size_t i = 0; i < test.time.size(); ++i) {
    if (test.time[i] <= ramp) continue;
    const double since = test.time[i] - ramp / 2;
    const double expected = lasting(law, 0.4) * (1 + law.first_share * std::exp(-since / law.first_time) +
                                                 law.second_share * std::exp(-since / law.second_time));
    EXPECT_NEAR(test.stress[i] / expected, 1, 1e-4) << test.time[i];
  }
}

TEST(ViscoelasticFoam, FastAndSlowTestsAreTheTwoCurves) {
  const ViscoelasticFoam law = slow_foam();
  const auto fast = driven(law, {{1e-7, 0.6}});
  const auto slow = driven(law, {{1e5, 0.6}});
  const double all = 1 + law.first_share + law.second_share;
  for (std::size_t i = 0; i < fast.time.size(); ++i)
    EXPECT_NEAR(fast.stress[i], all * lasting(law, fast.strain[i]), 1e-4 * fast.stress[i] + 1e-9);
  for (std::size_t i = 0; i < slow.time.size(); ++i)
    EXPECT_NEAR(slow.stress[i], lasting(law, slow.strain[i]), 1e-3 * slow.stress[i] + 1e-9);
}

/// Through many relaxation times in one stretch: each branch is the integral of what was added, as far as it
/// is left (Eq. 40), by another quadrature.
TEST(ViscoelasticFoam, AtAConstantRateRemembersAllThatIsLeft) {
  const ViscoelasticFoam law = slow_foam();
  const auto slope = [&](double e) {
    const auto term = [e](double mu, double a) {
      return 2 * mu / a * (1 / ((1 - e) * (1 - e)) + (a - 1) * std::pow(1 - e, a - 2));
    };
    return term(law.first_modulus, law.first_exponent) + term(law.second_modulus, law.second_exponent);
  };
  for (const double rate : {0.05, 0.3}) {  // 54 and 9 times the longer relaxation time
    const auto test = driven(law, {{0.8 / rate, 0.8}}, 20);
    for (std::size_t i = 1; i < test.time.size(); ++i) {
      const double end = test.time[i];
      const auto branch = [&](double share, double time) {
        const auto left = [&](double before) {
          return slope(rate * (end - before)) * rate * std::exp(-before / time);
        };
        double sum = 0;
        for (double from = 0; from < std::min(end, 60 * time); from += time)
          sum +=
              boost::math::quadrature::gauss<double, 20>::integrate(left, from, std::min(from + time, end));
        return share * sum;
      };
      const double expected = lasting(law, test.strain[i]) + branch(law.first_share, law.first_time) +
                              branch(law.second_share, law.second_time);
      EXPECT_NEAR(test.stress[i], expected, 1e-9 * expected + 1e-9) << rate << " per second, at " << end;
    }
  }
}

TEST(ViscoelasticFoam, CreepEndsAtTheLastingStrain) {
  const ViscoelasticFoam law = slow_foam();
  const double stress = lasting(law, 0.3);
  const auto crept = laboratory::creep(PadLaw(law), {stress, 10, 1000});
  ASSERT_TRUE(crept);
  EXPECT_NEAR(crept->strain.back(), 0.3, 1e-4);
  EXPECT_LT(crept->strain.front(), 0.3);
}

TEST(ViscoelasticFoam, WithoutTimeToRelaxItIsElastic) {
  ViscoelasticFoam law = slow_foam();
  law.first_time = law.second_time = 1e9;
  for (const Nose& nose : {Nose(Sphere{0.08}), Nose(FlatDisc{0.05})}) {
    ImpactCase impact = impact_on(law, Support::linear(3e5));
    impact.impactor.nose = nose;
    const Summary summary = solve(impact, {}).summary;
    ASSERT_TRUE(summary.trustworthy());
    EXPECT_NEAR(*summary.restitution, 1, 3e-4);
  }
}

TEST(ViscoelasticFoam, WithBranchesThatRelaxAtOnceOnlyTheLastingCurveIsLeft) {
  ViscoelasticFoam law = slow_foam();
  law.first_time = law.second_time = 1e-9;
  ViscoelasticFoam lasting_only = slow_foam();
  lasting_only.first_share = lasting_only.second_share = 0;
  const Summary a = solve(impact_on(law), {}).summary;
  const Summary b = solve(impact_on(lasting_only), {}).summary;
  ASSERT_TRUE(a.trustworthy() && b.trustworthy());
  EXPECT_NEAR(*a.peak_force / *b.peak_force, 1, 3e-4);
  EXPECT_NEAR(*a.rebound_speed / *b.rebound_speed, 1, 3e-4);
}

/// One column below a disc, by an integration of its own: M dV/dt = -a (p + q1 + q2).
TEST(ViscoelasticFoam, ADiscFollowsItsOrdinaryEquations) {
  const ViscoelasticFoam law = slow_foam();
  ImpactCase impact = impact_on(law);
  impact.impactor.nose = FlatDisc{0.06};
  const double area = std::numbers::pi * 0.06 * 0.06;
  double X = 0, V = impact.impactor.speed, first = 0, second = 0, peak = 0, deepest = 0;
  const double step = 2e-7;
  const auto force = [&](double x) {
    return area * (lasting(law, x / impact.pad.thickness) + first + second);
  };
  double p = 0;
  while (X > 0 || V > 0) {
    const double F = force(X);
    if (F <= 0 && V < 0) break;
    peak = std::max(peak, F);
    V -= F / impact.impactor.mass * step;
    X += V * step;
    if (X <= 0) break;
    deepest = std::max(deepest, X);
    const double next = lasting(law, X / impact.pad.thickness);
    const auto go = [&](double& q, double share, double time) {
      q = q * std::exp(-step / time) + share * (next - p) * std::exp(-step / (2 * time));
    };
    go(first, law.first_share, law.first_time);
    go(second, law.second_share, law.second_time);
    p = next;
  }
  const Summary summary = solve(impact, {}).summary;
  ASSERT_TRUE(summary.trustworthy());
  EXPECT_NEAR(*summary.peak_force / peak, 1, 3e-4);
  EXPECT_NEAR(summary.peak_penetration / deepest, 1, 3e-4);
  EXPECT_NEAR(*summary.rebound_speed / -V, 1, 1e-3);
}

TEST(ViscoelasticFoam, ColumnsByVectorsAndOneByOneAgree) {
  for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
    const ImpactCase impact = impact_on(slow_foam(), support);
    Options plain;
    plain.plain = true;
    const Summary a = solve(impact, {}).summary;
    const Summary b = solve(impact, plain).summary;
    EXPECT_NEAR(*a.peak_force / *b.peak_force, 1, 1e-10);
    EXPECT_NEAR(*a.rebound_speed / *b.rebound_speed, 1, 1e-8);
  }
}

TEST(ViscoelasticFoam, MeetsItsEstimates) {
  for (const Support& support : {Support::rigid(), Support::linear(2e5)})
    for (const double tolerance : {1e-3, 1e-4}) {
      const ImpactCase impact = impact_on(slow_foam(), support);
      const Summary coarse = solve(impact, {.tolerance = tolerance}).summary;
      const Summary fine = solve(impact, {.tolerance = tolerance / 20}).summary;
      ASSERT_TRUE(coarse.trustworthy() && fine.trustworthy());
      EXPECT_NEAR(*coarse.peak_force / *fine.peak_force, 1, tolerance);
      EXPECT_NEAR(*coarse.rebound_speed / *fine.rebound_speed, 1, tolerance);
      EXPECT_FALSE(gained_energy(coarse));
    }
}

/// On any path from rest a column gives back no more than it took.
TEST(ViscoelasticFoam, NoPathGivesEnergyBack) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform;
  for (int i = 0; i < 200; ++i) {
    ViscoelasticFoam law = slow_foam();
    law.first_exponent = -3 + 20 * uniform(random);
    if (std::abs(law.first_exponent) < 0.1) law.first_exponent = 1;
    law.first_time = std::pow(10, -4 + 4 * uniform(random));
    law.second_time = std::pow(10, -4 + 4 * uniform(random));
    std::vector<std::pair<double, double>> pieces;
    for (int k = 0; k < 12; ++k)
      pieces.emplace_back(std::pow(10, -4 + 3 * uniform(random)), 0.02 + 0.8 * uniform(random));
    pieces.emplace_back(1e-3, 0);
    const auto test = driven(law, pieces, 20);
    const double most = *std::max_element(test.work.begin(), test.work.end());
    EXPECT_GE(test.work.back(), -test.work_error - 1e-9 * most) << i;
  }
}

}  // namespace
}  // namespace dashpad::test
