// Which numbers readers take.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dashpad/quantities/quantity.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad {
namespace {

TEST(MagnitudeBounds, AdmitWhatIsMeasuredAndNothingBeyond) {
  const Magnitudes magnitudes = measured_magnitudes("m/s2");
  for (const double value : {0.0, -0.0, magnitudes.least, -magnitudes.most, 1.0, -500.0})
    EXPECT_TRUE(magnitudes.admit(value)) << value;
  for (const double value : {5e-324, -1e-310, magnitudes.least / 2, 2 * magnitudes.most, -1e130, std::nan(""),
                             std::numeric_limits<double>::infinity()})
    EXPECT_FALSE(magnitudes.admit(value)) << value;
}

TEST(MagnitudeBounds, StateTheRule) {
  EXPECT_EQ(rule_of(stated_magnitudes, 1, "Pa"), "");
  EXPECT_EQ(rule_of(stated_magnitudes, 1e-320, "1/s"),
            "must have a magnitude between 1e-15 and 1e+15 in 1/s");
  EXPECT_EQ(rule_of(stated_magnitudes, 5e-324, "1"), "must have a magnitude between 1e-15 and 1e+15");
}

TEST(MagnitudeBounds, HoldForWhatIsStated) {
  EXPECT_EQ(stated_si("2 kPa", "Pa"), 2000);
  EXPECT_EQ(stated_si("0 kPa", "Pa"), 0);
  for (const char* text : {"1e-300 Pa", "1e300 Pa", "-1e16 Pa"})
    EXPECT_THROW(stated_si(text, "Pa"), UnitError) << text;
}

/// No dimension is left out by a slip: the bounds of what is measured lie within those of what is stated.
TEST(MagnitudeBounds, OfMeasurementsAreTheNarrower) {
  for (const char* unit : {"m", "m/s", "m/s2", "s", "1/s", "kg", "Pa", "N", "V", "m2", "kg/m3", "N/m", "K"}) {
    const Magnitudes magnitudes = measured_magnitudes(unit);
    EXPECT_GE(magnitudes.least, stated_magnitudes.least) << unit;
    EXPECT_LE(magnitudes.most, stated_magnitudes.most) << unit;
    EXPECT_LT(magnitudes.least, magnitudes.most) << unit;
  }
}

}  // namespace
}  // namespace dashpad
