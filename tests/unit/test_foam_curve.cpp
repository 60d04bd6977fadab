// The foam's own curve beside one impact: against the closed form of an elastic foam.

#include <cmath>
#include <optional>
#include <string>
#include <variant>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "dashpad/quantities/unit_system.hpp"
#include "output/plot/foam_figures.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

using ::testing::Each;
using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::Not;

constexpr double modulus = 300e3;

Pad spring_pad() {
  Pad pad;
  pad.thickness = 0.05;
  pad.material = {.name = "spring",
                  .title = "A spring",
                  .source = "a test",
                  .law = Elastic{.modulus = modulus},
                  .fitted = FittedRange{0.6, 1, 10}};
  return pad;
}

Summary used_to(double strain) {
  Summary summary;
  summary.status = Status::released;
  summary.peak_strain = strain;
  return summary;
}

std::optional<output::Plot> plot_of(const Pad& pad, const Summary& summary) {
  return output::foam_curve_plot(pad, summary, unit_system("si"));
}

const output::Series* series_of(const output::Plot& plot, const std::string& label) {
  for (const output::Series& series : plot.panels.at(0).series)
    if (series.label == label) return &series;
  return nullptr;
}

TEST(FoamCurve, TheUsedPartEndsAtTheLargestStrainAndTheRestBeginsThere) {
  const auto plot = plot_of(spring_pad(), used_to(0.403));
  ASSERT_TRUE(plot);
  const output::Series* const used = series_of(*plot, "used by this impact");
  ASSERT_NE(used, nullptr);
  EXPECT_EQ(used->x.front(), 0);
  EXPECT_DOUBLE_EQ(used->x.back(), 0.403);
  for (std::size_t i = 0; i < used->x.size(); ++i)
    EXPECT_NEAR(used->y[i], 1e-3 * modulus * used->x[i], 1e-6) << used->x[i];
  const output::Series* const rest = series_of(*plot, "not reached");
  ASSERT_NE(rest, nullptr);
  EXPECT_DOUBLE_EQ(rest->x.front(), 0.403);
  EXPECT_DOUBLE_EQ(rest->y.front(), used->y.back());
  EXPECT_GT(rest->x.back(), 0.95);
  // A quarter above what was used.
  EXPECT_NEAR(*plot->panels[0].y.high, 1.25e-3 * modulus * 0.403, 1e-6);
}

TEST(FoamCurve, SaysHowFarTheFoamWasKnown) {
  const auto within = plot_of(spring_pad(), used_to(0.4)), beyond = plot_of(spring_pad(), used_to(0.7));
  ASSERT_TRUE(within && beyond);
  EXPECT_EQ(within->title, "The foam reaches a strain of 0.4; it was fitted up to 0.6");
  EXPECT_EQ(beyond->title, "The foam reaches a strain of 0.7; it was fitted up to 0.6");
  ASSERT_NE(series_of(*within, "fitted to 0.6"), nullptr);
  EXPECT_THAT(series_of(*within, "fitted to 0.6")->x, ElementsAre(0.6));
  // An elastic foam knows no rate.
  EXPECT_EQ(within->source, "spring: first loading");
}

TEST(FoamCurve, OfAnUnknownRangeNothingIsSaid) {
  Pad pad = spring_pad();
  pad.material.fitted.reset();
  const auto plot = plot_of(pad, used_to(0.4));
  ASSERT_TRUE(plot);
  EXPECT_EQ(plot->title, "The foam reaches a strain of 0.4");
  EXPECT_EQ(series_of(*plot, "fitted to 0.6"), nullptr);
}

TEST(FoamCurve, IsUnderTheConditionOfThePad) {
  Pad pad = spring_pad();
  pad.condition.scale = 2;
  const auto plot = plot_of(pad, used_to(0.4));
  ASSERT_TRUE(plot);
  EXPECT_NEAR(series_of(*plot, "used by this impact")->y.back(), 2e-3 * modulus * 0.4, 1e-6);
}

TEST(FoamCurve, OfLayersTheOneThatIsCompressedMost) {
  Pad pad;
  PadLayer soft{.thickness = 0.02, .material = spring_pad().material}, hard = soft;
  soft.condition.scale = 1.5;  // of its own
  std::get<Elastic>(hard.material.law).modulus = 2 * modulus;
  set_layers(pad, {hard, soft});
  Summary summary = used_to(0.2);
  summary.layers = {{.peak_strain = 0.3}, {.peak_strain = 0.5}};
  const auto plot = plot_of(pad, summary);
  ASSERT_TRUE(plot);
  EXPECT_THAT(plot->title, HasSubstr("Layer 2 reaches a strain of 0.5"));
  EXPECT_NEAR(series_of(*plot, "used by this impact")->y.back(), 1.5e-3 * modulus * 0.5, 1e-6);
}

TEST(FoamCurve, OfAPadThatIsPressedFlatTheCurveStaysLegible) {
  Pad pad = spring_pad();
  pad.material.law = test::sample_law<NineParameter>();
  const auto plot = plot_of(pad, used_to(1));
  ASSERT_TRUE(plot);
  EXPECT_EQ(series_of(*plot, "not reached"), nullptr);
  // Its law has a rate effect: the area under one curve is not the energy, and the curve has its rate as
  // name.
  EXPECT_EQ(series_of(*plot, "used by this impact"), nullptr);
  const output::Series* const used = series_of(*plot, "at 1 per second");
  ASSERT_NE(used, nullptr);
  const output::Series& shaded = plot->panels.front().series.front();
  EXPECT_EQ(shaded.style, output::SeriesStyle::band);
  EXPECT_THAT(shaded.y, Each(*plot->panels.front().y.high));
  EXPECT_THAT(shaded.y2, Each(0));
  const double at_half = used->y[used->y.size() / 2];
  EXPECT_LT(*plot->panels.front().y.high, 20 * at_half);
  EXPECT_GT(used->y.back(), *plot->panels.front().y.high);
  EXPECT_THAT(used->y, Each(::testing::Truly([](double stress) { return std::isfinite(stress); })));
  EXPECT_THAT(plot->source, HasSubstr("at 1 per second"));
}

TEST(FoamCurve, IsNotThereWithoutAnImpactOrALaw) {
  EXPECT_FALSE(plot_of(spring_pad(), Summary{}));
  EXPECT_FALSE(plot_of(spring_pad(), used_to(0)));
  Pad pad = spring_pad();
  pad.material.law = Elastic{.modulus = -1};
  EXPECT_FALSE(plot_of(pad, used_to(0.4)));
  Summary without_layers = used_to(0.4);
  pad = {};
  set_layers(pad, {{.thickness = 0.02, .material = spring_pad().material}});
  EXPECT_FALSE(plot_of(pad, without_layers));
}

}  // namespace
}  // namespace dashpad
