// Proposed fits to made-up tests whose law is known, computed here in closed form or by a fine quadrature of
// their own.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <functional>
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

/// Theory.md, Eq. 40, along strains over time: dq/dt = g dp/dt - q / tau, by `steps` steps, of which 200 are
/// kept.
Points relaxing(double share, double tau, double seconds, const std::function<double(double)>& strain_at,
                std::vector<double>* times = nullptr) {
  const auto lasting = [](double e) {
    return 2 * 8 / (10 * (1 - e)) * (1 - std::pow(1 - e, 10)) +
           2 * 2 / (-1 * (1 - e)) * (1 - std::pow(1 - e, -1));
  };
  constexpr int steps = 100'000;
  const double dt = seconds / steps;
  Points points;
  double q = 0;
  for (int i = 0; i <= steps; ++i) {
    const double e = strain_at(i * dt);
    if (i % (steps / 200) == 0) {
      points.emplace_back(e, lasting(e) + q);
      if (times != nullptr) times->push_back(i * dt);
    }
    q = q * std::exp(-dt / tau) + share * (lasting(strain_at(std::min((i + 1) * dt, seconds))) - lasting(e));
  }
  return points;
}

std::filesystem::path timed_table(const std::filesystem::path& file, const std::vector<double>& times,
                                  const Points& points) {
  std::ofstream out(file);
  out << "time [s],strain,stress_kPa\n";
  for (std::size_t i = 0; i < points.size(); ++i)
    out << fmt::format("{},{},{}\n", times[i], points[i].first, points[i].second);
  return file;
}

TEST_F(Proposals, AHoldGivesTheTimesOfRelaxation) {
  std::vector<double> times;
  const Points points = relaxing(
      1.5, 0.8, 5, [](double t) { return 0.5 * std::min(t, 1.0); }, &times);
  const AutoFit result = proposed({timed_table(path("held.csv"), times, points)}, {});
  EXPECT_EQ(result.candidate().law, "viscoelastic-foam");
  EXPECT_NEAR(value_of(result, "pad.parameters.first_time"), 0.8, 2e-3);
  EXPECT_NEAR(value_of(result, "pad.parameters.first_share"), 1.5, 2e-2);
  EXPECT_NEAR(value_of(result, "pad.parameters.first_modulus"), 8e3, 100);
  EXPECT_NEAR(result.proposal.tests.front().rate, 0.5, 1e-3);
}

/// Without a hold, ways back at two rates show it: no foam returns more of its energy the faster it is.
TEST_F(Proposals, WaysBackAtTwoRatesTellARelaxingFoam) {
  const auto loop_in = [](double seconds) {
    return relaxing(1.5, 2, seconds,
                    [seconds](double t) { return 0.5 * (1 - std::abs(2 * t / seconds - 1)); });
  };
  const AutoFit result = proposed({table("slow.csv", loop_in(50)), table("fast.csv", loop_in(1))}, {0.02, 1});
  EXPECT_EQ(result.candidate().law, "viscoelastic-foam");
  EXPECT_NEAR(value_of(result, "pad.parameters.first_time"), 2, 0.05);
  EXPECT_THAT(result.proposal.reasons, Contains(HasSubstr("viscoelastic-foam was tried too")));
}

/// A hold in which the stress hardly falls does not make a crushed foam relax.
TEST_F(Proposals, AHoldOfACrushedFoamLeavesItsLaw) {
  Points points = loading(0.6, curve);
  std::vector<double> times;
  for (const auto& [strain, stress] : points) times.push_back(strain / 0.01);
  for (int i = 1; i <= 10; ++i) {
    points.emplace_back(0.6, curve(0.6) * (1 - 0.004 * i));
    times.push_back(60 + 3 * i);
  }
  for (int i = 1; i <= 40; ++i) {
    points.emplace_back(0.6 - 0.005 * i, std::max(0.96 * curve(0.6) - 4000 * 0.005 * i, 0.0));
    times.push_back(90 + 0.5 * i);
  }
  const AutoFit result = proposed({timed_table(path("held.csv"), times, points)}, {});
  EXPECT_EQ(result.candidate().law, "crushable-foam");
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
