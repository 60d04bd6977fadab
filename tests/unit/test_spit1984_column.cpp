/// Subroutine PAD alone, under prescribed strains.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "dashpad/spit1984/run.hpp"

namespace dashpad::test {
namespace {

using namespace spit1984;

constexpr std::array<double, 21> nine{7.96, 0.675, 1.09, 8.81e-3, 5.45, 0.166, 9.76e-6, 0.0987, 22.127};
constexpr std::array<double, 21> twenty_one{7.96,    0.675,  1.09, 0.13,  0.156, 3.08, 4.153,
                                            0.19,    3.17,   0.58, 2.57,  0.296, 2.23, 1.64e-3,
                                            9.76e-6, 0.0987, 66.0, 10.12, 0.279, 1.94, 0.029};

void expect_near_relative(double value, double expected, double tolerance) {
  EXPECT_NEAR(value, expected, tolerance * std::abs(expected));
}

TEST(Spit1984Column, TakesTheElasticAndTheLinearLawAsPrinted) {
  const auto elastic = column_stresses(PadKey::elastic, {60}, {0, 0.1, 0.3, 0.2}, 1e-3, Arithmetic::binary64);
  ASSERT_EQ(elastic.size(), 4u);
  EXPECT_EQ(elastic[0], 0);
  EXPECT_DOUBLE_EQ(elastic[1], 6);
  EXPECT_DOUBLE_EQ(elastic[2], 18);
  EXPECT_DOUBLE_EQ(elastic[3], 12);
  // S(k+1) = (1 - dt/tau) S(k) + E0 e(k+1) - (E0 - Einf dt/tau) e(k)
  const auto linear = column_stresses(PadKey::linear_viscoelastic, {40, 120, 8e-3}, {0, 0.1, 0.2}, 1e-3,
                                      Arithmetic::binary64);
  EXPECT_DOUBLE_EQ(linear[1], 12);
  EXPECT_DOUBLE_EQ(linear[2], 0.875 * 12 + 24 - (120 - 5) * 0.1);
}

TEST(Spit1984Column, CrushesARigidFoamAndHoldsNothingOnUnloading) {
  const auto stresses = column_stresses(PadKey::rigid_foam, {60, 0.6, 90, 0.8}, {0, 0.5, 0.7, 0.9, 0.8}, 1e-3,
                                        Arithmetic::binary64);
  EXPECT_DOUBLE_EQ(stresses[1], 60);
  EXPECT_NEAR(stresses[2], 75, 1e-12);
  EXPECT_NEAR(stresses[3], 90 + 9 * 90 / 0.2 * 0.1, 1e-9);
  EXPECT_EQ(stresses[4], 0);
}

/// The first step, written by hand: from strain zero PAD takes half of the new strain; the second takes the
/// strain at its start.
TEST(Spit1984Column, TakesTheFirstStepsOfLaw4) {
  const double step = 1e-3, rate = 20;
  const auto stresses =
      column_stresses(PadKey::nine_parameter, nine, {0, 0.02, 0.04, 0.02}, step, Arithmetic::binary64);
  const double B = 7.96 + 5.45 * std::pow(rate, 0.166), tau = 8.81e-3;
  const auto driving = [&](double e) {
    return std::pow(e, 0.675) / std::pow(1 - e, 1.09) * B * ((0.675 / e + 1.09 / (1 - e)) * rate + 1 / tau);
  };
  const double first = driving(0.01) * step;
  const double second = first + (driving(0.02) - first / tau) * step;
  expect_near_relative(stresses[1], first, 1e-13);
  expect_near_relative(stresses[2], second, 1e-13);
  // Unloading from the largest strain 0.04, where E = 1 and dE/dt = rate D/(0.04 (1 - D)).
  const double e = 0.04, D = std::pow(9.76e-6 * rate, 0.0987);
  const double A = std::pow(e, 0.675) / std::pow(1 - e, 1.09);
  const double unloading =
      A * B * (-rate * D / (e * (1 - D)) + (0.675 / e + 1.09 / (1 - e)) * -rate + 1 / tau);
  expect_near_relative(stresses[3], second + (unloading - second / tau) * step, 1e-12);
}

/// Law 5 takes the time at the end of the step, as SPIT passes it.
TEST(Spit1984Column, TakesTheFirstStepOfLaw5) {
  const double step = 1e-3, rate = 20, e = 0.01;
  const auto stresses =
      column_stresses(PadKey::twenty_one_parameter, twenty_one, {0, 0.02}, step, Arithmetic::binary64);
  const double lasting = 7.96 * std::pow(e, 0.675) / std::pow(1 - e, 1.09);
  const double h = 0.13 * std::pow(step, 0.13 - 1) / (0.156 * std::pow(3.08, e));
  const double u = std::pow(e, 3.17), w = std::pow(e, 2.57), y = std::pow(e, 2.23);
  const double decline = std::exp(-u / 0.58), growth = std::exp(w / 0.296), onset = std::exp(-y / 1.64e-3);
  const double rate_stress = 4.153 * std::pow(rate, 0.19 * decline);
  const double change = rate * (2.57 * w * growth / 0.296 + 2.23 * y * onset / 1.64e-3) / e;
  const double fading = rate * 0.19 * 3.17 * u * decline * std::log(rate) / (0.58 * e);
  const double driving = ((0.675 / e + 1.09 / (1 - e)) * rate + h) * lasting +
                         rate_stress * (change + (h - fading) * (growth - onset));
  expect_near_relative(stresses[1], driving * step, 1e-12);
}

TEST(Spit1984Column, IsTheSameInEveryArithmeticButForRounding) {
  const std::vector<double> strains{0, 0.1, 0.2, 0.3, 0.4, 0.35, 0.3};
  for (const auto& [key, parameters] :
       {std::pair{PadKey::nine_parameter, nine}, {PadKey::twenty_one_parameter, twenty_one}}) {
    const auto exact = column_stresses(key, parameters, strains, 1e-3, Arithmetic::binary64);
    const auto pdp10 = column_stresses(key, parameters, strains, 1e-3);
    const auto single = column_stresses(key, parameters, strains, 1e-3, Arithmetic::binary32);
    for (std::size_t i = 1; i < strains.size(); ++i) {
      expect_near_relative(pdp10[i], exact[i], 1e-6);
      expect_near_relative(single[i], exact[i], 1e-5);
    }
    EXPECT_NE(pdp10, exact);
    EXPECT_NE(single, pdp10);
  }
}

TEST(Spit1984Column, RefusesWhatIsNoTest) {
  const auto refused = [](const std::array<double, 21>& parameters, const std::vector<double>& strains,
                          double step) {
    EXPECT_THROW((void)column_stresses(PadKey::nine_parameter, parameters, strains, step),
                 std::invalid_argument);
  };
  auto infinite = nine;
  infinite[3] = std::numeric_limits<double>::infinity();
  refused(infinite, {0, 0.1}, 1e-3);
  refused(nine, {0}, 1e-3);
  refused(nine, {0.1, 0.2}, 1e-3);
  refused(nine, {0, 1}, 1e-3);
  refused(nine, {0, -0.1}, 1e-3);
  refused(nine, {0, 0.1}, 0);
  EXPECT_THROW((void)column_stresses(static_cast<PadKey>(6), nine, {0, 0.1}, 1e-3), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad::test
