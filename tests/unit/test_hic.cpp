/// HIC: what its header promises.

#include "dashpad/injury/metrics.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "dashpad/impact/solution.hpp"
#include "shared/gravity.hpp"

namespace dashpad::test {
namespace {

using injury::Hic;
using injury::hic;

constexpr double forever = injury::unlimited_window;

Pulse in_g(std::vector<double> time, std::vector<double> levels) {
  for (double& level : levels) level *= g;
  return {std::move(time), std::move(levels)};
}

template <class F>
Pulse sampled(F&& f, double begin, double step, std::size_t size) {
  Pulse pulse;
  for (std::size_t i = 0; i < size; ++i) {
    pulse.time.push_back(begin + step * static_cast<double>(i));
    pulse.acceleration.push_back(g * f(static_cast<double>(i)));
  }
  return pulse;
}

void expect_hic(const Hic& found, double value, double begin, double end) {
  EXPECT_NEAR(found.value, value, 1e-12 * value);
  EXPECT_NEAR(found.begin, begin, 1e-12 + 1e-7 * (end - begin));
  EXPECT_NEAR(found.end, end, 1e-12 + 1e-7 * (end - begin));
}

TEST(HeadInjuryCriterion, RefusesWhatIsNoPulseAndNoWindow) {
  EXPECT_THROW(hic({{0}, {1}}, 1), std::invalid_argument);
  EXPECT_THROW(hic({{0, 1}, {1}}, 1), std::invalid_argument);
  EXPECT_THROW(hic({{0, 0}, {1, 1}}, 1), std::invalid_argument);
  EXPECT_THROW(hic({{0, 1}, {1, NAN}}, 1), std::invalid_argument);
  for (const double window : {0.0, -1.0, std::nan("")})
    EXPECT_THROW(hic({{0, 1}, {1, 1}}, window), std::invalid_argument) << window;
}

TEST(HeadInjuryCriterion, IsZeroForNoAcceleration) { expect_hic(hic({{3, 4, 6}, {0, 0, 0}}, 1), 0, 3, 3); }

TEST(HeadInjuryCriterion, TakesTwoSamples) {
  expect_hic(hic(in_g({2, 3}, {4, 4}), forever), 32, 2, 3);
  expect_hic(hic(in_g({2, 3}, {4, 4}), 0.25), 8, 2, 2.25);
  // The falling triangle: 4/7 of it, with the mean 5/7.
  const double triangle = 4.0 / 7 * std::pow(5.0 / 7, 2.5);
  expect_hic(hic(in_g({2, 3}, {1, 0}), forever), triangle, 2, 2 + 4.0 / 7);
  expect_hic(hic(in_g({2, 3}, {0, 1}), forever), triangle, 3 - 4.0 / 7, 3);
  expect_hic(hic(in_g({2, 3}, {0, 1}), 0.5), 0.5 * std::pow(0.75, 2.5), 2.5, 3);
  // From one sign to the other: the better of two triangles, and the earlier of two equal ones.
  expect_hic(hic(in_g({0, 3}, {-1, 2}), forever), 2 * std::pow(2, 2.5) * triangle, 3 - 8.0 / 7, 3);
  expect_hic(hic(in_g({0, 2}, {-1, 1}), forever), triangle, 0, 4.0 / 7);
  expect_hic(hic(in_g({0, 2}, {1, -1}), forever), triangle, 0, 4.0 / 7);
}

TEST(HeadInjuryCriterion, TakesAWindowAsLongAsThePulseOrLonger) {
  const Pulse flat = in_g({0, 0.01, 0.03}, {50, 50, 50});
  for (const double window : {0.03, 0.036, 1.0, 1e9, forever})
    expect_hic(hic(flat, window), std::pow(50, 2.5) * 0.03, 0, 0.03);
  expect_hic(hic(flat, 0.015), std::pow(50, 2.5) * 0.015, 0, 0.015);
}

TEST(HeadInjuryCriterion, TakesAWindowMuchShorterThanAStep) {
  const Hic found = hic(in_g({0, 1, 2}, {0, 3, 1}), 1e-9);
  EXPECT_NEAR(found.value, std::pow(3, 2.5) * 1e-9, 1e-8 * found.value);
  EXPECT_NEAR(found.begin, 1, 1e-9);
  EXPECT_NEAR(found.end - found.begin, 1e-9, 1e-15);
}

TEST(HeadInjuryCriterion, IsTheSameForTheSensorTurnedRound) {
  const Pulse pulse = in_g({0, 1, 2, 3, 5, 6}, {1, 7, -2, -9, -1, 4});
  Pulse turned = pulse;
  for (double& a : turned.acceleration) a = -a;
  for (const double window : {0.3, 1.0, 2.5, forever}) {
    const Hic one = hic(pulse, window);
    const Hic other = hic(turned, window);
    EXPECT_EQ(one.value, other.value);
    EXPECT_EQ(one.begin, other.begin);
    EXPECT_EQ(one.end, other.end);
  }
}

/// Not over |a|: a window over both halves of a full sine gains nothing.
TEST(HeadInjuryCriterion, TakesTheMagnitudeOfTheMean) {
  const Hic found = hic(in_g({0, 1, 1.001, 2}, {5, 5, -6, -6}), forever);
  EXPECT_NEAR(found.value, std::pow(6, 2.5) * 0.9995, 1e-3 * found.value);
  EXPECT_GT(found.begin, 1);
}

TEST(HeadInjuryCriterion, IsOfTheEarliestOfEqualWindows) {
  const auto peaks = [](double i) { return static_cast<int>(i) % 20 == 7 ? 3.0 : 0.5; };
  // Steps that are no binary fraction would make peaks of slightly different lengths.
  const double step = std::ldexp(1, -10);
  const Pulse equal = sampled(peaks, 5, step, 20 * 50);
  for (const double window : {0.4 * step, 1.5 * step, 4 * step}) {
    const Hic found = hic(equal, window);
    EXPECT_NEAR((found.begin + found.end) / 2, 5 + 7 * step, 1e-9) << window;
  }
  // One positive, one negative of the same size.
  EXPECT_NEAR(hic(in_g({0, 1, 2, 3, 4}, {0, -1, 0, 1, 0}), forever).begin, 3.0 / 7, 1e-7);
  EXPECT_NEAR(hic(in_g({0, 1, 2, 3, 4}, {0, 1, 0, -1, 0}), forever).begin, 3.0 / 7, 1e-7);
  // Every window of the full length.
  for (const double begin : {0.0, 0.1, 1e6})
    EXPECT_EQ(hic(sampled([](double) { return 0.1; }, begin, 1e-3, 1000), 0.0153).begin, begin);
}

TEST(HeadInjuryCriterion, ScalesWithAccelerationAndTime) {
  const Pulse pulse = in_g({0, 1, 2, 3, 5, 6}, {1, 7, -2, -9, -1, 4});
  const Hic one = hic(pulse, 1.5);
  for (const double factor : {1e-100, 1e-3, 3.0, 1e100}) {
    Pulse stronger = pulse;
    for (double& a : stronger.acceleration) a *= factor;
    EXPECT_NEAR(hic(stronger, 1.5).value / std::pow(factor, 2.5), one.value, 1e-12 * one.value) << factor;
    Pulse longer = pulse;
    for (double& t : longer.time) t *= factor;
    EXPECT_NEAR(hic(longer, 1.5 * factor).value / factor, one.value, 1e-12 * one.value) << factor;
  }
}

/// Neither a late clock nor a long pulse costs digits: steps of 2^-20 s are exact in both clocks.
TEST(HeadInjuryCriterion, DoesNotLoseDigitsLateOrInLongPulses) {
  const double step = std::ldexp(1, -20);
  std::mt19937 random(7);
  std::uniform_real_distribution<double> level(-1, 3);
  Pulse pulse = sampled([&](double) { return level(random); }, 0, step, 100'000);
  for (const double window : {150 * step, 0.015, forever}) {
    const Hic early = hic(pulse, window);
    Pulse late = pulse;
    for (double& t : late.time) t += 1048576;
    const Hic found = hic(late, window);
    EXPECT_NEAR(found.value, early.value, 1e-14 * early.value);
    EXPECT_NEAR(found.begin - 1048576, early.begin, 1e-9);
  }
  // A small pulse after a million times its velocity has gone by.
  Pulse after = in_g({0, 1e6, 1e6 + 1, 2e6, 2e6 + 1, 2e6 + 2}, {1, 1, 0, 0, 2, 0});
  expect_hic(hic(after, 1), std::pow(1.5, 2.5), 2e6 + 0.5, 2e6 + 1.5);
}

/// Bumps of either sign in a long quiet record, whose rest cannot hold the best window.
TEST(HeadInjuryCriterion, OfALongRecordIsThatOfItsPart) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> level(-1, 1);
  constexpr std::size_t size = 150'000, begin = 70'000, count = 6'000;
  for (int trial = 0; trial < 6; ++trial) {
    double walk = 0;
    const Pulse record = sampled(
        [&](double i) {
          const bool is_part = i >= begin && i < begin + count;
          walk = is_part ? 0.99 * walk + 5 * level(random) : 0;
          return is_part ? walk : 0.01 * level(random);
        },
        -0.3, 1e-5, size);
    const auto cut = [](const std::vector<double>& all) {
      return std::vector<double>(all.begin() + begin - 5'000, all.begin() + begin + count + 5'000);
    };
    for (const double window : {0.003, 0.015, 0.036, forever}) {
      const Hic found = hic(record, window), part = hic({cut(record.time), cut(record.acceleration)}, window);
      EXPECT_NEAR(found.value, part.value, 1e-12 * part.value) << trial << ' ' << window;
      EXPECT_NEAR(found.begin, part.begin, 1e-9) << trial << ' ' << window;
      EXPECT_NEAR(found.end, part.end, 1e-9) << trial << ' ' << window;
    }
  }
}

/// Long pulses of every kind end soon: a bound that fails here takes hours.
TEST(HeadInjuryCriterion, IsQuickForLongPulses) {
  constexpr std::size_t size = 100'000;
  constexpr double step = 1e-5;
  std::mt19937 random(1);
  std::normal_distribution<double> noise;
  const auto turn = [](double i, double turns) { return 2 * std::numbers::pi * turns * i / (size - 1); };
  double walk = 0;
  for (const double window : {0.015, 0.9, forever}) {
    const double longest = std::min(window, (size - 1) * step);
    EXPECT_NEAR(hic(sampled([](double) { return 1; }, 0, step, size), window).value, longest, 1e-12);
    const Hic ramp = hic(sampled([](double i) { return 1 - 1e-12 * i; }, 0, step, size), window);
    EXPECT_NEAR(ramp.value, longest, 1e-6);
    EXPECT_NEAR(ramp.begin, 0, 1e-15);
    EXPECT_GT(hic(sampled([&](double i) { return std::sin(turn(i, 0.5)); }, 0, step, size), window).value, 0);
    EXPECT_GT(hic(sampled([&](double i) { return std::sin(turn(i, 99)); }, 0, step, size), window).value, 0);
    EXPECT_GT(hic(sampled([&](double) { return noise(random); }, 0, step, size), window).value, 0);
    EXPECT_GT(hic(sampled([&](double) { return walk += noise(random); }, 0, step, size), window).value, 0);
    EXPECT_NEAR(hic(sampled([](double i) { return i == 777; }, 0, step, size), window).begin,
                777 * step - step * 4 / 7, 1e-12);
  }
}

TEST(HeadInjuryCriterion, OfTheFreeMotionHeadform) {
  EXPECT_DOUBLE_EQ(injury::hic_d(0), 166.4);
  EXPECT_DOUBLE_EQ(injury::hic_d(1000), 920.86);
}

}  // namespace
}  // namespace dashpad::test
