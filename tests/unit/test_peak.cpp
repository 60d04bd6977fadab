/// Peak and velocity change of a pulse.

#include "dashpad/injury/metrics.hpp"

#include <gtest/gtest.h>

#include <stdexcept>

namespace dashpad {
namespace {

TEST(Peak, IsTheLargestMagnitudeOfEitherSign) {
  const injury::Peak peak = injury::peak({{0, 1, 2, 3}, {1, -7, 3, 6}});
  EXPECT_EQ(peak.magnitude, 7);
  EXPECT_EQ(peak.time, 1);
}

TEST(Peak, OfSeveralIsTheFirst) {
  EXPECT_EQ(injury::peak({{0, 1, 2, 3}, {1, 5, -5, 5}}).time, 1);
  EXPECT_EQ(injury::peak({{2, 3}, {-4, 4}}).time, 2);
  EXPECT_EQ(injury::peak({{2, 3}, {0, 0}}).time, 2);
}

TEST(VelocityChange, IsTheAreaWithItsSign) {
  EXPECT_DOUBLE_EQ(injury::velocity_change({{0, 1, 3}, {0, 4, -2}}), 4);
  EXPECT_DOUBLE_EQ(injury::velocity_change({{0, 1, 3}, {0, -4, 2}}), 4);
  EXPECT_EQ(injury::velocity_change({{0, 1, 2}, {1, -1, 1}}), 0);
}

/// A million samples of which each gain is rounded: a plain sum is off by about 1e-11 of the result.
TEST(VelocityChange, DoesNotCollectRounding) {
  Pulse pulse;
  for (int i = 0; i <= 1'000'000; ++i) {
    pulse.time.push_back(i / 1048576.0);  // steps without rounding
    pulse.acceleration.push_back(0.1);
  }
  const double expected = 0.1 * (1'000'000 / 1048576.0);
  EXPECT_NEAR(injury::velocity_change(pulse), expected, 2e-16 * expected);
}

/// A large gain that is taken back must not swallow the small one between.
TEST(VelocityChange, KeepsTheSmallBesideTheLarge) {
  EXPECT_EQ(injury::velocity_change({{0, 1, 2, 3, 4, 5}, {2e17, 0, 2, 0, 0, -2e17}}), 2);
}

TEST(PeakAndVelocityChange, RefuseABadPulse) {
  EXPECT_THROW(injury::peak({{0}, {1}}), std::invalid_argument);
  EXPECT_THROW(injury::velocity_change({{0, 1}, {1}}), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
