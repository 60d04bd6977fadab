/// HIC against closed forms.
///
/// A pulse of peak A and duration T whose level falls off on both sides of its top: the best window of
/// length w T has one common level c(w) at both ends and the area I(w), in units of A and T. It is the best
/// of all where c = 0.6 I / w, or as long as it may be, and then HIC = A^2.5 T w (I / w)^2.5.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/metrics.hpp"

namespace dashpad::test {
namespace {

using injury::hic;

constexpr double g = standard_gravity;
using std::numbers::pi;

struct Shape {
  const char* name;
  double (*level)(double);  // at 0 <= s <= 1
  double (*area)(double w);
  double (*level_at_ends)(double w);
  double published;  // HIC / (A^2.5 T), to its six digits; 0 for none
};

const Shape half_sine{"half_sine", [](double s) { return std::sin(pi * s); },
                      [](double w) { return 2 / pi * std::sin(pi * w / 2); },
                      [](double w) { return std::cos(pi * w / 2); }, 0.414646};
const Shape parabola{"parabola", [](double s) { return 4 * s * (1 - s); },
                     [](double w) { return w - w * w * w / 3; }, [](double w) { return 1 - w * w; },
                     0.448262};
const Shape haversine{"haversine", [](double s) { return std::pow(std::sin(pi * s), 2); },
                      [](double w) { return w / 2 + std::sin(pi * w) / (2 * pi); },
                      [](double w) { return (1 + std::cos(pi * w)) / 2; }, 0.302939};
const Shape triangle{"triangle", nullptr, [](double w) { return w - w * w / 2; },
                     [](double w) { return 1 - w; }, 0.246401};
/// The plateau is a quarter, the flanks together three quarters.
const Shape trapezoid{"trapezoid", nullptr,
                      [](double w) { return w - std::pow(std::max(w - 0.25, 0.0), 2) / 1.5; },
                      [](double w) { return 1 - std::max(w - 0.25, 0.0) / 0.75; }, 0};

double best_window(const Shape& shape) {
  double low = 0;
  double high = 1;
  while (true) {
    const double w = (low + high) / 2;
    if (w <= low || w >= high) return w;
    (shape.level_at_ends(w) > 0.6 * shape.area(w) / w ? low : high) = w;
  }
}

/// HIC / (A^2.5 T) if no window is longer than `longest` T.
double exact(const Shape& shape, double longest) {
  const double w = std::min(best_window(shape), longest);
  return w * std::pow(shape.area(w) / w, 2.5);
}

Pulse sampled(const Shape& shape, double peak_g, double duration, int steps) {
  Pulse pulse;
  for (int i = 0; i <= steps; ++i) {
    pulse.time.push_back(duration * i / steps);
    pulse.acceleration.push_back(peak_g * g * shape.level(static_cast<double>(i) / steps));
  }
  return pulse;
}

TEST(ExactHic, OfTheShapesIsThePublished) {
  for (const Shape& shape : {half_sine, parabola, haversine, triangle})
    EXPECT_NEAR(exact(shape, 1), shape.published, 5e-7) << shape.name;
  EXPECT_NEAR(best_window(triangle), 4.0 / 7, 1e-15);
  EXPECT_NEAR(best_window(parabola), std::sqrt(0.5), 1e-15);
}

class CurvedPulses : public testing::TestWithParam<Shape> {};

TEST_P(CurvedPulses, ConvergeAtOrderTwo) {
  for (const double longest : {0.2, 0.5, 2.0}) {
    const auto error = [&](int steps) {
      const Pulse pulse = sampled(GetParam(), 100, 0.01, steps);
      return hic(pulse, longest * 0.01).value / (1000 * exact(GetParam(), longest)) - 1;
    };
    for (const int steps : {250, 1000})
      EXPECT_NEAR(std::log2(error(steps) / error(2 * steps)), 2, 0.05) << longest << ' ' << steps;
    EXPECT_NEAR(error(100'000), 0, 1e-9) << longest;
  }
}

TEST_P(CurvedPulses, HaveTheirWindowInTheMiddle) {
  const injury::Hic found = hic(sampled(GetParam(), 100, 0.01, 9999), injury::unlimited_window);
  EXPECT_NEAR(found.begin + found.end, 0.01, 1e-8);
  EXPECT_NEAR(found.end - found.begin, 0.01 * best_window(GetParam()), 1e-8);
}

INSTANTIATE_TEST_SUITE_P(Shapes, CurvedPulses, testing::Values(half_sine, parabola, haversine),
                         [](const auto& parameter) { return parameter.param.name; });

/// Linear between their corners: exact, whatever the skew.
TEST(ExactHic, OfTrianglesAndTrapezoids) {
  for (const double skew : {0.0, 1e-9, 0.1, 0.5, 0.7, 1 - 1e-9, 1.0})
    for (const double longest : {1e-6, 0.1, 0.25, 0.3, 0.5, 4.0 / 7, 0.9, 2.0})
      for (const double sign : {1.0, -1.0}) {
        Pulse pulse;
        const auto corner = [&](double s, double level) {
          if (!pulse.time.empty() && 0.02 * s <= pulse.time.back()) {
            pulse.time.pop_back();
            pulse.acceleration.pop_back();
          }
          pulse.time.push_back(0.02 * s);
          pulse.acceleration.push_back(sign * 80 * g * level);
        };
        const auto expect = [&](const Shape& shape) {
          const double expected = std::pow(80, 2.5) * 0.02 * exact(shape, longest);
          EXPECT_NEAR(hic(pulse, longest * 0.02).value, expected, 1e-13 * expected)
              << shape.name << ' ' << skew << ' ' << longest;
        };
        corner(0, 0);
        corner(skew, 1);
        if (skew < 1) corner(1, 0);
        expect(triangle);
        pulse = {};
        corner(0, 0);
        corner(0.75 * skew, 1);
        corner(0.75 * skew + 0.25, 1);
        if (skew < 1) corner(1, 0);
        expect(trapezoid);
      }
}

TEST(ExactHic, OfSamplePulses) {
  struct Sample {
    const Shape& shape;
    double peak_g, duration, hic15, hic36;
  };
  for (const Sample& sample :
       {Sample{half_sine, 100, 0.01, 414.6456, 414.6456}, Sample{half_sine, 100, 0.02, 829.2913, 829.2913},
        Sample{half_sine, 80, 0.03, 660.3954, 712.0711}, Sample{half_sine, 60, 0.05, 381.0513, 578.1297},
        Sample{haversine, 100, 0.01, 302.9389, 302.9389}}) {
    const Pulse pulse = sampled(sample.shape, sample.peak_g, sample.duration, 20'000);
    EXPECT_NEAR(hic(pulse, 0.015).value, sample.hic15, 6e-5);
    EXPECT_NEAR(hic(pulse, 0.036).value, sample.hic36, 6e-5);
  }
  EXPECT_NEAR(hic({{0, 0.002, 0.01}, {0, 100 * g, 0}}, 0.015).value, 246.4007, 5e-5);
  EXPECT_NEAR(hic({{0, 0.05}, {60 * g, 60 * g}}, 0.036).value, 1003.8773, 5e-5);
}

/// Altair HyperMesh help, injury criteria: a = sin(20 pi t) g every 0.1 ms up to 50 ms: HIC 0.02048 in the
/// window from 0.01 to 0.04 s.
TEST(ExactHic, OfTheSineOfAltair) {
  Pulse pulse;
  for (int i = 0; i <= 500; ++i) {
    pulse.time.push_back(1e-4 * i);
    pulse.acceleration.push_back(std::sin(20 * pi * pulse.time.back()) * g);
  }
  const injury::Hic found = hic(pulse, 0.03);
  EXPECT_NEAR(found.value, 0.02048, 5e-6);
  EXPECT_NEAR(found.begin, 0.01, 1e-9);
  EXPECT_NEAR(found.end, 0.04, 1e-9);
}

/// a = 10 sin(t) g up to 4 s, window 36 ms: 11.382663, in a window about pi / 2.
TEST(ExactHic, OfASlowSineOfEitherSign) {
  constexpr double w = 0.036;
  const double expected = w * std::pow(2 * 10 * std::cos(pi / 2 - w / 2) / w, 2.5);
  EXPECT_NEAR(expected, 11.382663, 5e-7);
  for (const double sign : {1.0, -1.0}) {
    Pulse pulse;
    for (int i = 0; i < 10'000; ++i) {
      pulse.time.push_back(4.0 * i / 9999);
      pulse.acceleration.push_back(sign * 10 * std::sin(pulse.time.back()) * g);
    }
    const injury::Hic found = hic(pulse, w);
    EXPECT_NEAR(found.value, expected, 1e-6);
    EXPECT_NEAR((found.begin + found.end) / 2, pi / 2, 1e-3);
    EXPECT_NEAR(found.end - found.begin, w, 1e-15);
  }
}

}  // namespace
}  // namespace dashpad::test
