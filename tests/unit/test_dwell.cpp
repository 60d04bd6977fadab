/// The time above a level: what can be read off a drawing, and an identity that holds for every pulse.

#include "dashpad/injury/metrics.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>
#include <vector>

namespace dashpad {
namespace {

using injury::cumulative_dwell;
using injury::longest_dwell;

TEST(Dwell, OfTwoPeaksOfEitherSign) {
  const Pulse pulse{{0, 1, 2, 4, 6}, {0, 10, 0, -10, 0}};
  EXPECT_DOUBLE_EQ(longest_dwell(pulse, 5), 2);
  EXPECT_DOUBLE_EQ(cumulative_dwell(pulse, 5), 3);
  EXPECT_NEAR(longest_dwell(pulse, 9), 0.4, 1e-15);
  EXPECT_NEAR(cumulative_dwell(pulse, 9), 0.6, 1e-15);
  EXPECT_EQ(cumulative_dwell(pulse, 10), 0);
  EXPECT_EQ(longest_dwell(pulse, 11), 0);
}

TEST(Dwell, EndsAtTheZeroBetweenTwoSamples) {
  const Pulse pulse{{0, 2}, {4, -4}};
  EXPECT_DOUBLE_EQ(longest_dwell(pulse, 2), 0.5);
  EXPECT_DOUBLE_EQ(cumulative_dwell(pulse, 2), 1);
  EXPECT_DOUBLE_EQ(longest_dwell(pulse, 0), 1);
  EXPECT_DOUBLE_EQ(cumulative_dwell(pulse, 0), 2);
}

TEST(Dwell, IsAboveNotAtTheLevel) {
  const Pulse plateau{{0, 1, 3, 4}, {0, 5, 5, 0}};
  EXPECT_EQ(cumulative_dwell(plateau, 5), 0);
  EXPECT_NEAR(cumulative_dwell(plateau, std::nextafter(5.0, 0.0)), 2, 1e-14);
  const Pulse touch{{0, 1, 2, 3, 4}, {5, 9, 5, 9, 5}};
  EXPECT_DOUBLE_EQ(cumulative_dwell(touch, 5), 4);
  EXPECT_DOUBLE_EQ(longest_dwell(touch, 5), 2);
}

TEST(Dwell, OfAPulseThatBeginsAndEndsAbove) {
  const Pulse pulse{{-1, 0, 2}, {7, 8, 7}};
  EXPECT_EQ(cumulative_dwell(pulse, 3), 3);
  EXPECT_EQ(longest_dwell(pulse, 3), 3);
}

/// The integral of the dwell over all levels is that of |a| over time. Between neighbouring values of the
/// samples the dwell is linear in the level, so that its value in the middle gives the integral.
TEST(Dwell, IntegratesToTheAreaUnderThePulse) {
  std::mt19937 random(2);
  for (int run = 0; run < 200; ++run) {
    Pulse pulse;
    double time = 0;
    double area = 0;
    std::vector<double> levels{0};
    for (int i = 0; i < 30; ++i) {
      const double a = std::round(std::normal_distribution(1.0, 4.0)(random));
      const double step = std::uniform_real_distribution(0.1, 2.0)(random);
      if (i > 0) {
        const double b = pulse.acceleration.back();
        area += step * (a * b < 0 ? (a * a + b * b) / (2 * std::abs(a - b)) : std::abs(a + b) / 2);
      }
      time += step;
      pulse.time.push_back(time);
      pulse.acceleration.push_back(a);
      levels.push_back(std::abs(a));
    }
    std::sort(levels.begin(), levels.end());
    double sum = 0;
    for (std::size_t k = 1; k < levels.size(); ++k) {
      const double middle = (levels[k - 1] + levels[k]) / 2;
      sum += (levels[k] - levels[k - 1]) * cumulative_dwell(pulse, middle);
      EXPECT_LE(longest_dwell(pulse, middle), cumulative_dwell(pulse, middle) + 1e-12);
    }
    EXPECT_NEAR(sum, area, 1e-11 * area) << run;
  }
}

TEST(Dwell, RefusesWhatHasNoMeaning) {
  EXPECT_THROW(cumulative_dwell({{0, 1}, {1, 1}}, -1), std::invalid_argument);
  EXPECT_THROW(longest_dwell({{0, 1}, {1, 1}}, std::nan("")), std::invalid_argument);
  EXPECT_THROW(cumulative_dwell({{0}, {1}}, 1), std::invalid_argument);
  EXPECT_THROW(longest_dwell({{1, 0}, {1, 1}}, 1), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
