// Proposed fits to made-up tests whose law is known, computed here in closed form or by a fine quadrature of
// their own.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
#include <numbers>
#include <vector>

#include "dashpad/fit/proposal.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::test {
namespace {

using fit::AutoFit;
using testing::Contains;
using testing::HasSubstr;

class Proposals : public testing::Test {
 protected:
  /// Writes a table of strains and stresses, kPa.
  std::filesystem::path table(const std::string& name, const std::vector<std::pair<double, double>>& points) {
    std::ofstream out(folder_.path() / name);
    out << "strain,stress_kPa\n";
    for (const auto& [strain, stress] : points) out << fmt::format("{},{}\n", strain, stress);
    return folder_.path() / name;
  }
  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return folder_.path() / name; }

 private:
  TemporaryFolder folder_;
};

AutoFit proposed(const std::vector<std::filesystem::path>& files, const std::vector<double>& rates) {
  auto proposal = fit::propose(files, rates, {});
  EXPECT_TRUE(proposal);
  return fit::run_proposal(*std::move(proposal));
}

double value_of(const AutoFit& result, const std::string& key) {
  for (const fit::FittedUnknown& unknown : result.report.unknowns)
    if (unknown.key == key) return unknown.value;
  ADD_FAILURE() << key << " is no unknown";
  return 0;
}

/// A curve with a plateau, kPa.
double curve(double e) { return 80 * (1 - std::exp(-30 * e)) + 60 * std::pow(e / (1 - e), 1.7); }

double area(double to) {
  constexpr int steps = 2000;
  double sum = 0;
  for (int i = 0; i < steps; ++i) sum += curve(to * (i + 0.5) / steps) * to / steps;
  return sum;
}

using Points = std::vector<std::pair<double, double>>;

Points loading(double highest, const std::function<double(double)>& stress) {
  Points points;
  for (int i = 0; i <= 70; ++i) points.emplace_back(highest * i / 70, stress(highest * i / 70));
  return points;
}

/// Loading, and the way back by theory.md, Eq. 32.
Points loop(double highest, double factor, double shape) {
  Points points = loading(highest, curve);
  for (int i = 69; i >= 0; --i) {
    const double e = highest * i / 70;
    const double damage = 1 - (1 - factor) * (1 - std::pow(area(e) / area(highest), shape));
    points.emplace_back(e, curve(e) * damage);
  }
  return points;
}

TEST_F(Proposals, ALoopAndAFastLoadingGiveTheWayBackAndTheExponent) {
  const AutoFit result =
      proposed({table("slow.csv", loop(0.7, 0.3, 1.4)),
                table("fast.csv", loading(0.7, [](double e) { return curve(e) * std::pow(1e4, 0.06); }))},
               {0.01, 100});
  EXPECT_EQ(result.candidate().law, "foam");
  EXPECT_EQ(result.candidate().base, "table");
  EXPECT_EQ(result.candidate().rate, "power");
  EXPECT_NEAR(value_of(result, "pad.parameters.unloading_factor"), 0.3, 0.003);
  EXPECT_NEAR(value_of(result, "pad.parameters.unloading_shape"), 1.4, 0.02);
  EXPECT_NEAR(value_of(result, "pad.rate.exponent"), 0.06, 5e-4);
  EXPECT_LT(*result.tried[result.chosen].misfit, 0.003);
  EXPECT_THAT(result.open, Contains(HasSubstr("recoil")));
}

TEST_F(Proposals, AnExponentThatFallsWithTheStrainNeedsItsSlope) {
  const AutoFit result = proposed(
      {table("slow.csv", loop(0.6, 0.2, 1)),
       table("fast.csv", loading(0.6, [](double e) { return curve(e) * std::pow(1e3, 0.12 - 0.15 * e); }))},
      {0.01, 10});
  EXPECT_EQ(result.candidate().rate, "power with slope");
  EXPECT_NEAR(value_of(result, "pad.rate.exponent"), 0.12, 1e-3);
  EXPECT_NEAR(value_of(result, "pad.rate.exponent_slope"), -0.15, 3e-3);
}

TEST_F(Proposals, AFastTestThatGoesFurtherIsCarriedByAFormula) {
  const AutoFit result =
      proposed({table("slow.csv", loading(0.5, curve)),
                table("fast.csv", loading(0.7, [](double e) { return curve(e) * std::pow(1e4, 0.05); }))},
               {0.01, 100});
  EXPECT_EQ(result.candidate().base, "avalle");
  EXPECT_EQ(result.tried.size(), 6);
  EXPECT_NEAR(value_of(result, "pad.rate.exponent"), 0.05, 2e-3);
  EXPECT_NEAR(value_of(result, "pad.curve.densification_exponent"), 1.7, 0.1);
  EXPECT_THAT(result.open, Contains(HasSubstr("no test unloads")));
}

/// Theory.md, Eq. 38: back along a straight line.
TEST_F(Proposals, AFoamThatStaysCrushedIsToldByItsShape) {
  Points points = loading(0.6, curve);
  const double modulus = 4000;  // kPa
  for (double e = 0.6; e > 0.4; e -= 0.005)
    points.emplace_back(e, std::max(curve(0.6) - modulus * (0.6 - e), 0.0));
  const AutoFit result = proposed({table("crushed.csv", points)}, {0.01});
  EXPECT_EQ(result.candidate().law, "crushable-foam");
  EXPECT_NEAR(value_of(result, "pad.parameters.unloading_modulus"), 4e6, 4e4);
  EXPECT_EQ(result.tried.size(), 2);
}

/// Theory.md, Eq. 40: q' = g p' - q / tau over a ramp of 1 s and a hold of 4 s, by 20,000 steps a second.
TEST_F(Proposals, AHoldGivesTheTimesOfRelaxation) {
  constexpr double share = 1.5, tau = 0.8, highest = 0.5;
  const auto lasting = [](double e) {
    return 2 * 8 / (10 * (1 - e)) * (1 - std::pow(1 - e, 10)) +
           2 * 2 / (-1 * (1 - e)) * (1 - std::pow(1 - e, -1));
  };
  std::ofstream out(path("held.csv"));
  out << "time [s],strain,stress_kPa\n";
  constexpr int per_second = 20'000;
  double q = 0;
  for (int i = 0; i <= 5 * per_second; ++i) {
    const double t = double(i) / per_second, e = highest * std::min(t, 1.0);
    if (i % 400 == 0) out << fmt::format("{},{},{}\n", t, e, lasting(e) + q);
    const double rise = lasting(highest * std::min(t + 1.0 / per_second, 1.0)) - lasting(e);
    q = q * std::exp(-1 / (tau * per_second)) + share * rise;
  }
  out.close();
  const AutoFit result = proposed({path("held.csv")}, {});
  EXPECT_EQ(result.candidate().law, "viscoelastic-foam");
  EXPECT_NEAR(value_of(result, "pad.parameters.first_time"), tau, 2e-3);
  EXPECT_NEAR(value_of(result, "pad.parameters.first_share"), share, 2e-2);
  EXPECT_NEAR(value_of(result, "pad.parameters.first_modulus"), 8e3, 100);
  EXPECT_NEAR(result.proposal.tests.front().rate, 0.5, 1e-3);
}

TEST_F(Proposals, SeveralSamplesAtOneRateShareAFormula) {
  const AutoFit result = proposed({table("a.csv", loading(0.6, [](double e) { return 0.95 * curve(e); })),
                                   table("b.csv", loading(0.6, curve)),
                                   table("c.csv", loading(0.6, [](double e) { return 1.05 * curve(e); }))},
                                  {0.01, 0.01, 0.011});
  EXPECT_EQ(result.candidate().base, "avalle");
  EXPECT_EQ(result.candidate().rate, "none");
  EXPECT_THAT(result.open, testing::Not(Contains(HasSubstr("scatter"))));
}

}  // namespace
}  // namespace dashpad::test
