/// The error that chords leave in a clip, on half sines whose clip is known.

#include "injury/pulse_line.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace dashpad {
namespace {

using injury::chord_error;

constexpr double length = 0.02, peak = 600, window = 3e-3;

/// Samples at uneven steps of about a hundredth, the first behind the begin by a share of a step.
Pulse half_sine(double share, double sign) {
  Pulse pulse;
  const auto add = [&](double time) {
    pulse.time.push_back(time);
    pulse.acceleration.push_back(sign * peak * std::sin(std::numbers::pi * time / length));
  };
  add(0);
  for (int i = 0; i < 99; ++i) add(length / 100 * (i + share + (i % 2 == 0 ? 0.1 : 0)));
  add(length);
  return pulse;
}

TEST(ChordError, CoversTheErrorOfTheClipAndIsNoMoreThanAFewTimesIt) {
  const double exact = peak * std::cos(std::numbers::pi * window / (2 * length));
  double largest = 0, min_bound = 1;
  for (double share = 0.05; share < 0.9; share += 0.05)
    for (const double sign : {1.0, -1.0}) {
      const Pulse pulse = half_sine(share, sign);
      for (const injury::Clip& clip :
           {injury::contiguous_clip(pulse, window), injury::cumulative_clip(pulse, window)}) {
        const double error = std::abs(clip.level / exact - 1), bound = chord_error(pulse, clip);
        EXPECT_LE(error, 1.02 * bound) << share;
        largest = std::max(largest, error), min_bound = std::min(min_bound, bound);
        EXPECT_LT(bound, 2e-4) << share;
      }
    }
  EXPECT_GT(largest, min_bound / 4);
}

TEST(ChordError, IsNoneOfStraightLinesAndOfNoClip) {
  const Pulse ramp{{0, 1e-3, 2e-3, 5e-3, 9e-3}, {0, 10, 20, 50, 90}};
  EXPECT_LT(chord_error(ramp, injury::contiguous_clip(ramp, window)), 1e-14);
  EXPECT_EQ(chord_error(ramp, injury::Clip{}), 0);
}

/// A clip over a bend that it does not cross, and over one that it does.
TEST(ChordError, IsOfTheChordsThatCrossTheLevel) {
  const Pulse spike{{0, 1e-3, 2e-3, 3e-3, 4e-3, 5e-3, 6e-3}, {0, 100, 100, 900, 100, 100, 0}};
  const injury::Clip clip{80, 0.8e-3, 5.2e-3};
  EXPECT_NEAR(chord_error(spike, clip), (1e-3 * 1e-3) * (100 / 1e-3 / 1e-3) / 8 / 80, 1e-12);
}

}  // namespace
}  // namespace dashpad
