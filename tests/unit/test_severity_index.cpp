/// Severity index: closed forms, and a line against its integral.

#include "dashpad/injury/metrics.hpp"

#include <gtest/gtest.h>

#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <stdexcept>

#include "dashpad/impact/solution.hpp"
#include "shared/gravity.hpp"

namespace dashpad::test {
namespace {

constexpr double pi = std::numbers::pi;

double of_line(double a, double b, double begin = 0, double duration = 1) {
  return injury::severity_index({{begin, begin + duration}, {a * g, b * g}});
}

TEST(SeverityIndex, RefusesWhatIsNoPulse) {
  EXPECT_THROW(injury::severity_index({{0}, {1}}), std::invalid_argument);
  EXPECT_THROW(injury::severity_index({{1, 0}, {1, 1}}), std::invalid_argument);
}

TEST(SeverityIndex, OfOneLine) {
  EXPECT_EQ(of_line(0, 0), 0);
  EXPECT_NEAR(of_line(4, 4), 32, 1e-13);
  EXPECT_NEAR(of_line(-4, -4), 32, 1e-13);
  EXPECT_NEAR(of_line(4, 0), 32 * 2.0 / 7, 1e-13);
  EXPECT_NEAR(of_line(0, -4, 1048576, 0.5), 16 * 2.0 / 7, 1e-13);
  EXPECT_NEAR(of_line(1, 4), 2.0 / 7 * (128 - 1) / 3, 1e-13);
  // Through zero after a fifth.
  EXPECT_NEAR(of_line(-1, 4), 2.0 / 7 * (0.2 + 0.8 * 32), 1e-13);
  EXPECT_NEAR(of_line(4, -1), 2.0 / 7 * (0.2 + 0.8 * 32), 1e-13);
}

/// Nothing is lost where the line is nearly level, steep, or hardly crosses zero.
TEST(SeverityIndex, OfAnyLineIsItsIntegral) {
  boost::math::quadrature::tanh_sinh<long double> quadrature;
  for (const double a : {1.0, -1.0, 1e-3, 80.0})
    for (const double ratio :
         {1.0, 1 + 1e-15, 1 + 1e-12, 1 + 1e-8, 1 - 1e-5, 0.99, 0.5, 1e-3, 1e-12, 0.0, -1e-12, -0.3, -1.0}) {
      const long double b = a * ratio;
      const auto power = [&](long double s) { return std::pow(std::abs(a + (b - a) * s), 2.5L); };
      const long double zero = ratio < 0 ? a / (a - b) : 1;
      long double expected = quadrature.integrate(power, 0.0L, zero);
      if (ratio < 0) expected += quadrature.integrate(power, zero, 1.0L);
      EXPECT_NEAR(of_line(a, a * ratio) / static_cast<double>(expected), 1, 2e-15) << a << ' ' << ratio;
    }
}

TEST(SeverityIndex, OfATriangleDoesNotDependOnItsSkew) {
  for (const double top : {0.001, 0.3, 0.5, 0.999})
    EXPECT_NEAR(injury::severity_index({{0, 0.01 * top, 0.01}, {0, 100 * g, 0}}), 1000 * 2.0 / 7, 1e-9);
}

struct Shape {
  const char* name;
  double (*level)(double);
  double index;  // over A^2.5 T
};

const Shape shapes[]{
    // Powers 5/2 and 5 of the sine: B(7/4, 1/2) / pi and B(3, 1/2) / pi = 16 / (15 pi).
    {"half_sine", [](double s) { return std::sin(pi * s); }, std::beta(1.75, 0.5) / pi},
    {"parabola", [](double s) { return 4 * s * (1 - s); }, 32 * std::beta(3.5, 3.5)},
    {"haversine", [](double s) { return std::pow(std::sin(pi * s), 2); }, std::beta(3.0, 0.5) / pi},
};

class SeverityIndexOf : public testing::TestWithParam<Shape> {
 protected:
  [[nodiscard]] double error(int steps) const {
    Pulse pulse;
    for (int i = 0; i <= steps; ++i) {
      pulse.time.push_back(0.01 * i / steps);
      pulse.acceleration.push_back(-100 * g * GetParam().level(static_cast<double>(i) / steps));
    }
    return injury::severity_index(pulse) / (1000 * GetParam().index) - 1;
  }
};

TEST_P(SeverityIndexOf, ConvergesAtOrderTwo) {
  for (const int steps : {100, 1000}) {
    const double order = std::log2(error(steps) / error(2 * steps));
    EXPECT_NEAR(order, 2, 0.02) << steps;
  }
  EXPECT_NEAR(error(100'000), 0, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(Shapes, SeverityIndexOf, testing::ValuesIn(shapes),
                         [](const auto& parameter) { return parameter.param.name; });

TEST(SeverityIndex, HasThePublishedCoefficients) {
  EXPECT_NEAR(shapes[0].index, 0.457656, 5e-7);
  EXPECT_NEAR(shapes[1].index, 0.490874, 5e-7);
  EXPECT_NEAR(shapes[2].index, 0.339531, 5e-7);
}

}  // namespace
}  // namespace dashpad::test
