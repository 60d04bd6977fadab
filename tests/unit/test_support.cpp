/// Support curves against their definition: piecewise linear, exact at the points, monotone across them.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <random>
#include <stdexcept>
#include <vector>

#include "dashpad/model/support/support.hpp"

namespace dashpad {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();

TEST(support, rigid_never_deflects) {
  const Support support;
  EXPECT_TRUE(support.is_rigid());
  EXPECT_TRUE(support.corners().empty());
  for (const double force : {-1.0, 0.0, 1.0, 1e9}) {
    EXPECT_EQ(support.deflection(force), 0);
    EXPECT_EQ(support.compliance(force), 0);
    EXPECT_EQ(support.energy(force), 0);
  }
}

TEST(support, linear_is_one_line) {
  const Support support = Support::linear(105'000);
  EXPECT_FALSE(support.is_rigid());
  EXPECT_EQ(support.points().size(), 1U);
  EXPECT_TRUE(support.corners().empty());
  EXPECT_EQ(support.force(-0.1), 0);
  EXPECT_EQ(support.deflection(-10), 0);
  EXPECT_EQ(support.energy(-10), 0);
  for (const double deflection : {0.0, 1e-12, 0.01, 0.5, 2.0, 1000.0}) {
    const double force = 105'000 * deflection;
    EXPECT_DOUBLE_EQ(support.force(deflection), force);
    EXPECT_DOUBLE_EQ(support.deflection(force), deflection);
    EXPECT_DOUBLE_EQ(support.energy(force), 0.5 * force * deflection);
    EXPECT_DOUBLE_EQ(support.compliance(force), 1.0 / 105'000);
  }
}

/// Slopes 10, 10 and 40 N/m, then 5 N/m for good.
Support four_points() { return Support::through({{1, 10}, {2, 20}, {3, 60}, {5, 70}}); }

TEST(support, curve_has_the_values_of_its_definition) {
  const Support support = four_points();
  struct Row {
    double deflection, force, compliance, energy;
  };
  for (const auto& [deflection, force, compliance, energy] : {Row{0, 0, 1 / 10.0, 0},
                                                              {0.5, 5, 1 / 10.0, 1.25},
                                                              {1, 10, 1 / 10.0, 5},
                                                              {1.5, 15, 1 / 10.0, 11.25},
                                                              {2, 20, 1 / 40.0, 20},
                                                              {2.5, 40, 1 / 40.0, 35},
                                                              {3, 60, 1 / 5.0, 60},
                                                              {4, 65, 1 / 5.0, 122.5},
                                                              {5, 70, 1 / 5.0, 190},
                                                              {7, 80, 1 / 5.0, 340}}) {
    EXPECT_DOUBLE_EQ(support.force(deflection), force);
    EXPECT_DOUBLE_EQ(support.deflection(force), deflection);
    EXPECT_DOUBLE_EQ(support.compliance(force), compliance) << "at " << force;
    EXPECT_DOUBLE_EQ(support.energy(force), energy) << "at " << force;
  }
}

TEST(support, corners_are_where_the_slope_changes) {
  EXPECT_EQ(four_points().corners(), (std::vector<double>{20, 60}));
  // Collinear up to the rounding of decimal fractions.
  EXPECT_TRUE(Support::through({{0.1, 0.3}, {0.2, 0.6}, {0.3, 0.9}, {0.7, 2.1}}).corners().empty());
}

TEST(support, force_and_deflection_are_monotone_inverses_across_points) {
  std::mt19937 generator(20240607);
  std::uniform_real_distribution<double> step(1e-6, 1);
  for (int curve = 0; curve < 50; ++curve) {
    std::vector<Support::Point> points;
    Support::Point at;
    for (int i = 0; i < 8; ++i)
      points.push_back(at = {at.deflection + step(generator), at.force + 1e4 * step(generator)});
    const Support support = Support::through(points);
    for (const auto& [deflection, force] : points) {
      EXPECT_EQ(support.force(deflection), force);
      EXPECT_EQ(support.deflection(force), deflection);
      EXPECT_LE(support.force(std::nextafter(deflection, 0)), force);
      EXPECT_GE(support.force(std::nextafter(deflection, infinity)), force);
      EXPECT_LE(support.deflection(std::nextafter(force, 0)), deflection);
      EXPECT_GE(support.deflection(std::nextafter(force, infinity)), deflection);
    }
    for (double deflection = 0; deflection < 1.2 * at.deflection; deflection += 0.01 * at.deflection)
      EXPECT_NEAR(support.deflection(support.force(deflection)), deflection, 1e-14 * at.deflection);
  }
}

TEST(support, energy_is_the_integral_of_the_force) {
  const Support support = four_points();
  for (const double deflection : {0.7, 1.6, 2.2, 4.5, 9.0}) {
    constexpr int intervals = 90'000;  // midpoint rule: exact but where an interval holds a corner
    double work = 0;
    for (int i = 0; i < intervals; ++i)
      work += support.force((i + 0.5) * deflection / intervals) * deflection / intervals;
    EXPECT_NEAR(support.energy(support.force(deflection)), work, 1e-7 * work);
  }
}

TEST(support, refuses_what_is_no_increasing_curve) {
  for (const double stiffness : {0.0, -1.0, infinity, nan})
    EXPECT_THROW(Support::linear(stiffness), std::invalid_argument) << stiffness;
  using Points = std::vector<Support::Point>;
  for (const Points& points :
       {Points{}, Points{{0, 0}, {1, 1}}, Points{{-1, 1}}, Points{{1, -1}}, Points{{1, 1}, {1, 2}},
        Points{{1, 1}, {2, 1}}, Points{{2, 1}, {1, 2}}, Points{{1, 2}, {2, 1}}, Points{{nan, 1}},
        Points{{1, infinity}}, Points{{infinity, 1}}, Points{{1, nan}}})
    EXPECT_THROW(Support::through(points), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
