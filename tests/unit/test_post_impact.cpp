/// Two bodies after an impact: what every impact keeps, its limits, and the formulas as the report prints
/// them.

#include "dashpad/impact/post_impact.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <string>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {
namespace {

/// The report's Eqs. 1, 2 and 4 term by term, with conservation beside them.
TEST(PostImpact, KeepsMomentumAndAccountsForEnergy) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> exponent(-2, 4);
  std::uniform_real_distribution<double> speed(-30, 30);
  for (int run = 0; run < 1000; ++run) {
    Body first{std::pow(10, exponent(random)), speed(random)};
    Body second{std::pow(10, exponent(random)), speed(random)};
    if (first.velocity <= second.velocity) std::swap(first.velocity, second.velocity);
    const double absorbed = std::uniform_real_distribution<double>(0, 1)(random);
    const PostImpact after = post_impact(first, second, absorbed);

    const double m1 = first.mass;
    const double m2 = second.mass;
    const double v1 = first.velocity;
    const double v2 = second.velocity;
    const double e = std::sqrt(1 - absorbed);
    EXPECT_NEAR(after.first_velocity, ((m1 - m2 * e) * v1 + (1 + e) * m2 * v2) / (m1 + m2), 1e-12);
    EXPECT_NEAR(after.second_velocity, ((1 + e) * m1 * v1 + (m2 - m1 * e) * v2) / (m1 + m2), 1e-12);
    EXPECT_EQ(after.restitution, e);
    EXPECT_EQ(after.energy_coefficient, 1 - absorbed);

    const double momentum = m1 * std::abs(v1) + m2 * std::abs(v2);
    EXPECT_NEAR(m1 * after.first_velocity + m2 * after.second_velocity, m1 * v1 + m2 * v2, 1e-13 * momentum);
    const auto energy = [&](double v, double w) { return m1 * v * v / 2 + m2 * w * w / 2; };
    EXPECT_NEAR(energy(v1, v2) - energy(after.first_velocity, after.second_velocity),
                absorbed * after.available_energy, 1e-12 * energy(v1, v2));
    EXPECT_NEAR(after.available_energy, m1 * m2 * (v1 - v2) * (v1 - v2) / (2 * (m1 + m2)),
                1e-13 * after.available_energy);
    EXPECT_NEAR(after.second_velocity - after.first_velocity, e * (v1 - v2), 1e-12);
  }
}

TEST(PostImpact, OnABodyThatNothingMoves) {
  const PostImpact still = post_impact({5, 8}, {infinite, 0}, 0.75);
  EXPECT_EQ(still.first_velocity, -4);
  EXPECT_EQ(still.second_velocity, 0);
  EXPECT_EQ(still.available_energy, 160);
  const PostImpact moving = post_impact({5, 8}, {infinite, -2}, 0.75);
  EXPECT_EQ(moving.first_velocity, -2 - 5);
  EXPECT_EQ(moving.second_velocity, -2);
  const PostImpact struck = post_impact({infinite, 3}, {2, -1}, 0.75);
  EXPECT_EQ(struck.first_velocity, 3);
  EXPECT_EQ(struck.second_velocity, 3 + 2);
  EXPECT_EQ(struck.available_energy, 16);
}

TEST(PostImpact, AtItsLimits) {
  const PostImpact elastic = post_impact({2, 6}, {2, 1}, 0);
  EXPECT_EQ(elastic.first_velocity, 1);
  EXPECT_EQ(elastic.second_velocity, 6);
  EXPECT_EQ(elastic.restitution, 1);
  const PostImpact plastic = post_impact({3, 4}, {1, 0}, 1);
  EXPECT_EQ(plastic.first_velocity, 3);
  EXPECT_EQ(plastic.second_velocity, 3);
  EXPECT_EQ(plastic.restitution, 0);
}

TEST(PostImpact, NamesWhatIsWrong) {
  const auto message = [](Body first, Body second, double absorbed) -> std::string {
    try {
      post_impact(first, second, absorbed);
    } catch (const std::invalid_argument& fault) {
      return fault.what();
    }
    return "accepted";
  };
  const double unknown = std::nan("");
  EXPECT_EQ(message({0, 1}, {1, 0}, 0.5), "post impact: the mass of the first body is not positive");
  EXPECT_EQ(message({1, 1}, {unknown, 0}, 0.5), "post impact: the mass of the second body is not positive");
  EXPECT_EQ(message({1, unknown}, {1, 0}, 0.5), "post impact: the velocity of the first body is not finite");
  EXPECT_EQ(message({1, 1}, {1, -infinite}, 0.5),
            "post impact: the velocity of the second body is not finite");
  EXPECT_EQ(message({infinite, 1}, {infinite, 0}, 0.5), "post impact: both masses are infinite");
  EXPECT_EQ(message({1, 1}, {1, 1}, 0.5), "post impact: the bodies do not approach each other");
  for (const double absorbed : {-0.01, 1.01, unknown})
    EXPECT_EQ(message({1, 1}, {1, 0}, absorbed), "post impact: the absorbed fraction is not between 0 and 1");
}

/// The velocities move by what the error makes of sqrt(C), within the linear range and at C = 0.
TEST(PostImpact, TheErrorOfTheEnergyBecomesThatOfTheVelocities) {
  const Body first{5, 3}, second{7, -1};
  for (const double absorbed : {0.1, 0.5, 0.99, 1.0}) {
    const double error = 1e-3;
    const PostImpact now = post_impact(first, second, absorbed, error);
    const PostImpact less = post_impact(first, second, std::min(1.0, absorbed + error));
    EXPECT_GE(now.errors.first_velocity * (1 + 1e-9), std::abs(now.first_velocity - less.first_velocity));
    EXPECT_GE(now.errors.second_velocity * (1 + 1e-9), std::abs(now.second_velocity - less.second_velocity));
    EXPECT_GT(now.errors.restitution, 0) << absorbed;
  }
  EXPECT_NEAR(post_impact(first, second, 1, 1e-4).errors.restitution, 1e-2, 1e-12);
  EXPECT_EQ(post_impact(first, second, 0.5).errors.restitution, 0);
  EXPECT_THROW(post_impact(first, second, 0.5, -1), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
