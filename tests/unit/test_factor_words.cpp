// What factors of studies are called.

#include <gtest/gtest.h>

#include "output/text/study_words.hpp"

namespace dashpad {
namespace {

using output::factor_words;

TEST(FactorWords, AreWords) {
  EXPECT_EQ(factor_words("pad.thickness"), "thickness of the pad");
  EXPECT_EQ(factor_words("impactor.speed"), "impact speed");
  EXPECT_EQ(factor_words("impactor.half_depth"), "half depth of the nose");
  EXPECT_EQ(factor_words("pad.curve.plateau_stress"), "plateau stress of the foam");
  EXPECT_EQ(factor_words("pad.rate.exponent"), "exponent of the foam's rate effect");
  EXPECT_EQ(factor_words("pad.layers[2].thickness"), "thickness of layer 2");
  EXPECT_EQ(factor_words("pad.layers[2].density"), "density of the foam in layer 2");
  EXPECT_EQ(factor_words("support.panel_mass"), "panel mass of the support");
  EXPECT_EQ(factor_words("something.else"), "something.else");
}

TEST(FactorWords, BeginATextWithACapital) {
  EXPECT_EQ(output::factor_title("pad.thickness"), "Thickness of the pad");
  EXPECT_EQ(output::factor_title("something.else"), "something.else");
}

}  // namespace
}  // namespace dashpad
