/// The clips against closed forms, against a slow second way, and on the pulses where a measure jumps.

#include "dashpad/injury/metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>
#include <string>

namespace dashpad {
namespace {

using injury::contiguous_clip;
using injury::cumulative_clip;

Pulse sampled(double length, int pieces, const std::function<double(double)>& a) {
  Pulse pulse;
  for (int i = 0; i <= pieces; ++i) {
    pulse.time.push_back(length * i / pieces);
    pulse.acceleration.push_back(a(pulse.time.back()));
  }
  return pulse;
}

/// The second way. In each piece |a| < level holds on one open interval, found from -level < a < level; what
/// the intervals leave is at the level or above. No corner at zero, no magnitude, no sweep.
struct TimeAtLevel {
  double longest = 0;
  double total = 0;
};
TimeAtLevel time_at(const Pulse& pulse, double level) {
  TimeAtLevel found;
  double free_since = pulse.time.front();
  const auto stretch_until = [&](double end) {
    found.longest = std::max(found.longest, end - free_since);
    found.total += end - free_since;
  };
  for (std::size_t i = 1; i < pulse.time.size(); ++i) {
    const double t = pulse.time[i - 1];
    const double length = pulse.time[i] - t;
    const double a = pulse.acceleration[i - 1];
    const double slope = (pulse.acceleration[i] - a) / length;
    double low = 0;
    double high = std::abs(a) < level ? length : 0;
    if (slope != 0) {
      const auto [first, second] = std::minmax({(-level - a) / slope, (level - a) / slope});
      low = std::clamp(first, 0.0, length);
      high = std::clamp(second, 0.0, length);
    }
    if (high > low) {
      stretch_until(t + low);
      free_since = t + high;
    }
  }
  stretch_until(pulse.time.back());
  return found;
}

double highest_level(const Pulse& pulse, double duration, double TimeAtLevel::*time) {
  double low = 0;
  double high = 100;
  if (time_at(pulse, low).*time < duration - 1e-12) return 0;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (time_at(pulse, middle).*time >= duration - 1e-12 ? low : high) = middle;
  }
  return low;
}

TEST(Clips, TheSecondWayIsRight) {
  const Pulse pulse{{0, 1, 2, 4}, {0, 3, -3, -3}};
  EXPECT_DOUBLE_EQ(time_at(pulse, 3).longest, 2);
  EXPECT_DOUBLE_EQ(time_at(pulse, 3).total, 2);
  EXPECT_DOUBLE_EQ(time_at(pulse, 1.5).longest, 2.25);
  EXPECT_DOUBLE_EQ(time_at(pulse, 1.5).total, 3);
  EXPECT_DOUBLE_EQ(time_at(pulse, 0).longest, 4);
}

/// Small whole numbers, so that levels are equal, touched and held, and durations fit exactly.
TEST(Clips, AgreeWithTheSecondWayOnRandomPulses) {
  std::mt19937 random(1);
  for (int run = 0; run < 4000; ++run) {
    const bool whole = run % 2 == 0;
    Pulse pulse;
    double time = std::uniform_int_distribution(-5, 5)(random);
    const int size = std::uniform_int_distribution(2, 25)(random);
    for (int i = 0; i < size; ++i) {
      pulse.time.push_back(time);
      pulse.acceleration.push_back(whole ? std::uniform_int_distribution(-4, 4)(random)
                                         : std::normal_distribution(0.5, 3.0)(random));
      time += whole ? std::uniform_int_distribution(1, 3)(random)
                    : std::uniform_real_distribution(0.01, 2.0)(random);
    }
    for (const double duration : {1e-6, 0.3, 1.0, 2.0, 2.5, 3.0, 7.0, 20.0}) {
      const std::string where = "run " + std::to_string(run) + ", duration " + std::to_string(duration);
      const injury::Clip one = contiguous_clip(pulse, duration);
      const injury::Clip all = cumulative_clip(pulse, duration);
      ASSERT_NEAR(one.level, highest_level(pulse, duration, &TimeAtLevel::longest), 1e-8) << where;
      ASSERT_NEAR(all.level, highest_level(pulse, duration, &TimeAtLevel::total), 1e-8) << where;
      ASSERT_LE(one.level, all.level + 1e-10) << where;  // rounding of times on steep pieces
      if (duration > pulse.time.back() - pulse.time.front()) continue;
      EXPECT_NEAR(one.end - one.begin, duration, 1e-12) << where;
      EXPECT_GE(one.begin, pulse.time.front()) << where;
      EXPECT_LE(one.end, pulse.time.back() + 1e-12) << where;
      EXPECT_GE(all.end - all.begin, duration - 1e-9) << where;
    }
  }
}

/// A half-sine of 10 ms and 1 m/s2. The window ends meet samples, so that the chords do no harm.
TEST(Clips, OfAPublishedHalfSine) {
  const Pulse pulse = sampled(0.01, 100, [](double t) { return std::sin(100 * std::numbers::pi * t); });
  for (const injury::Clip& clip : {contiguous_clip(pulse, 3e-3), cumulative_clip(pulse, 3e-3)}) {
    EXPECT_NEAR(clip.level, std::sin(0.35 * std::numbers::pi), 1e-14);
    EXPECT_NEAR(clip.begin, 0.0035, 1e-12);
    EXPECT_NEAR(clip.end, 0.0065, 1e-12);
  }
}

/// For 100 g; contiguous and cumulative are the same for a pulse with one rise and one fall. With 20 000
/// pieces a chord is off by at most 2e-7 g.
TEST(Clips, AreTheClosedFormsOfSmoothPulses) {
  using std::numbers::pi;
  const auto expect = [](double length, const std::function<double(double)>& shape, double expected) {
    const Pulse pulse = sampled(length, 20000, [&](double t) { return 100 * shape(t / length); });
    EXPECT_NEAR(contiguous_clip(pulse, 3e-3).level, expected, 1e-6);
    EXPECT_NEAR(cumulative_clip(pulse, 3e-3).level, expected, 1e-6);
  };
  const auto half_sine = [&](double x) { return std::sin(pi * x); };
  const auto triangle = [](double x) { return 1 - std::abs(2 * x - 1); };
  const auto haversine = [&](double x) { return std::sin(pi * x) * std::sin(pi * x); };
  expect(0.01, half_sine, 89.100652);
  expect(0.02, half_sine, 97.236992);
  expect(0.01, triangle, 70);
  expect(0.02, triangle, 85);
  expect(0.01, haversine, 79.389263);
}

/// |a| has a kink at zero inside the piece: the stretch ends there.
TEST(Clips, SeeTheZeroBetweenTwoSamples) {
  const Pulse pulse{{0, 2}, {4, -4}};
  EXPECT_NEAR(contiguous_clip(pulse, 0.5).level, 2, 1e-13);
  EXPECT_DOUBLE_EQ(cumulative_clip(pulse, 0.5).level, 3);
  EXPECT_NEAR(contiguous_clip(pulse, 2).level, 0, 1e-14);
  EXPECT_NEAR(cumulative_clip(pulse, 2).level, 0, 1e-14);
}

TEST(Clips, AddTheStretchesOfTwoPeaks) {
  const Pulse pulse{{0, 1, 2, 3, 4}, {0, 10, 0, -10, 0}};
  EXPECT_NEAR(contiguous_clip(pulse, 1).level, 5, 1e-13);
  const injury::Clip all = cumulative_clip(pulse, 1);
  EXPECT_DOUBLE_EQ(all.level, 7.5);
  EXPECT_DOUBLE_EQ(all.begin, 0.75);
  EXPECT_DOUBLE_EQ(all.end, 3.25);
}

/// Thirty samples of 0.1 ms: the difference of the doubles at its ends is often below 0.003.
TEST(Clips, OfAPlateauThatLastsExactlyAsLong) {
  int shorter = 0;
  for (std::size_t begin = 0; begin <= 970; ++begin) {
    Pulse pulse = sampled(0.1, 1000, [](double) { return 0; });
    std::fill_n(pulse.acceleration.begin() + static_cast<std::ptrdiff_t>(begin), 31, 50);
    if (pulse.time[begin + 30] - pulse.time[begin] < 3e-3) ++shorter;
    ASSERT_EQ(contiguous_clip(pulse, 3e-3).level, 50) << begin;
    ASSERT_EQ(cumulative_clip(pulse, 3e-3).level, 50) << begin;
    ASSERT_LT(contiguous_clip(pulse, 3.001e-3).level, 50) << begin;
    ASSERT_LT(cumulative_clip(pulse, 3.001e-3).level, 50) << begin;
  }
  EXPECT_GT(shorter, 100);
}

/// A touch of the level from above does not interrupt what "meets or exceeds" it.
TEST(Clips, LastOverATouchFromAbove) {
  EXPECT_DOUBLE_EQ(contiguous_clip({{0, 1, 2, 3, 4}, {5, 9, 5, 9, 5}}, 4).level, 5);
  EXPECT_DOUBLE_EQ(contiguous_clip({{0, 1, 2, 3, 4}, {5, 9, 4, 9, 5}}, 4).level, 4);
}

TEST(Clips, OfDurationsNearTheLengthOfThePulse) {
  const Pulse pulse = sampled(0.01, 77, [](double t) { return 20 + t; });
  EXPECT_EQ(contiguous_clip(pulse, 0.01).level, 20);
  EXPECT_EQ(cumulative_clip(pulse, 0.01).level, 20);
  for (const double duration : {0.0100001, 1.0, 1e300})
    for (const injury::Clip& clip : {contiguous_clip(pulse, duration), cumulative_clip(pulse, duration)}) {
      EXPECT_EQ(clip.level, 0);
      EXPECT_EQ(clip.end, 0);
    }
}

TEST(Clips, ApproachThePeakAsTheDurationVanishes) {
  const Pulse pulse{{0, 1, 3}, {0, -8, 0}};
  EXPECT_EQ(contiguous_clip(pulse, 1e-300).level, 8);
  EXPECT_EQ(cumulative_clip(pulse, 1e-300).level, 8);
  EXPECT_EQ(contiguous_clip(pulse, 1e-300).begin, 1);
  EXPECT_EQ(cumulative_clip(pulse, 1e-300).begin, 1);
}

TEST(Clips, OfSeveralWindowsTakeTheEarliest) {
  const injury::Clip clip = contiguous_clip({{0, 1, 2, 3, 4, 5, 9}, {0, 6, 0, 0, 6, 6, 6}}, 2);
  EXPECT_DOUBLE_EQ(clip.level, 6);
  EXPECT_DOUBLE_EQ(clip.begin, 4);
  EXPECT_DOUBLE_EQ(clip.end, 6);
}

TEST(Clips, GrowWithThePulseAndFallWithTheDuration) {
  Pulse pulse = sampled(0.03, 300, [](double t) { return std::sin(400 * t) * std::exp(-30 * t); });
  double contiguous = 1;
  double cumulative = 1;
  for (const double duration : {1e-4, 1e-3, 3e-3, 5e-3, 0.02}) {
    EXPECT_LT(contiguous_clip(pulse, duration).level, contiguous);
    EXPECT_LT(cumulative_clip(pulse, duration).level, cumulative);
    contiguous = contiguous_clip(pulse, duration).level;
    cumulative = cumulative_clip(pulse, duration).level;
  }
  for (double& a : pulse.acceleration) a *= -8;
  EXPECT_DOUBLE_EQ(contiguous_clip(pulse, 0.02).level, 8 * contiguous);
  EXPECT_DOUBLE_EQ(cumulative_clip(pulse, 0.02).level, 8 * cumulative);
}

TEST(Clips, RefuseWhatHasNoMeaning) {
  const Pulse pulse{{0, 1}, {1, 1}};
  for (const double duration : {0.0, -1.0, std::nan("")}) {
    EXPECT_THROW(contiguous_clip(pulse, duration), std::invalid_argument);
    EXPECT_THROW(cumulative_clip(pulse, duration), std::invalid_argument);
  }
  EXPECT_THROW(contiguous_clip({{0}, {1}}, 1), std::invalid_argument);
  EXPECT_THROW(cumulative_clip({{0, 0}, {1, 1}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
