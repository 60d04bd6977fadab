/// Areas of a map: what they cover, in which class, and how they are drawn.

#include "output/plot/study_figures.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "output/plot/drawing.hpp"

namespace dashpad {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

/// The area of all outlines of a series (shoelace formula).
double area_of(const output::Series& series) {
  double sum = 0;
  for (std::size_t begin = 0, end = 0; begin < series.x.size(); begin = end + 1) {
    for (end = begin; end < series.x.size() && std::isfinite(series.x[end]); ++end) {
    }
    double doubled = 0;
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t next = i + 1 == end ? begin : i + 1;
      doubled += series.x[i] * series.y[next] - series.x[next] * series.y[i];
    }
    sum += std::abs(doubled) / 2;
  }
  return sum;
}

TEST(FilledMap, LevelsOverDecadesGoByFactors) {
  EXPECT_EQ(output::round_levels(300, 2e6), (std::vector<double>{100, 1000, 1e4, 1e5, 1e6, 1e7}));
  EXPECT_EQ(output::round_levels(30, 9000),
            (std::vector<double>{20, 50, 100, 200, 500, 1000, 2000, 5000, 1e4}));
  EXPECT_EQ(output::round_levels(1, 5), (std::vector<double>{1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5}))
      << "as before";
}

TEST(FilledMap, LevelsAreRoundAndCoverTheRange) {
  EXPECT_THAT(output::round_levels(0.3, 8.9), ElementsAre(0, 1, 2, 3, 4, 5, 6, 7, 8, 9));
  EXPECT_THAT(output::round_levels(-12, 31), ElementsAre(-15, -10, -5, 0, 5, 10, 15, 20, 25, 30, 35));
  EXPECT_THAT(output::round_levels(2, 2), IsEmpty());
  EXPECT_THAT(output::round_levels(50, std::nextafter(50, 51)), IsEmpty()) << "rounding";
  EXPECT_THAT(output::round_levels(1, 1 + 1e-8),
              testing::SizeIs(testing::AllOf(testing::Gt(5U), testing::Lt(20U))));
  EXPECT_THAT(output::round_levels(2, std::numeric_limits<double>::infinity()), IsEmpty());
}

/// A plane over a grid of uneven steps: the area of each class is known.
TEST(FilledMap, EachClassCoversItsPart) {
  const std::vector<double> across{0, 1, 3, 10}, up{0, 0.5, 4};
  std::vector<std::vector<double>> values;
  for (std::size_t line = 0; line < up.size(); ++line) values.push_back(across);
  const std::vector<output::Series> areas = output::filled_areas(across, up, values, {0, 2, 7, 10}, "g");
  ASSERT_EQ(areas.size(), 3U);
  EXPECT_NEAR(area_of(areas[0]), 2 * 4, 1e-12);
  EXPECT_NEAR(area_of(areas[1]), 5 * 4, 1e-12);
  EXPECT_NEAR(area_of(areas[2]), 3 * 4, 1e-12);
  EXPECT_EQ(areas[1].label, "2 to 7 g");
  EXPECT_EQ(areas[0].shade, 0);
  EXPECT_EQ(areas[2].shade, 1);
}

TEST(FilledMap, ACellWithoutAValueStaysEmpty) {
  const double none = std::numeric_limits<double>::quiet_NaN();
  const std::vector<output::Series> areas =
      output::filled_areas({0, 1, 2}, {0, 1}, {{1, 1.5, none}, {1, 1.5, 2}}, {0, 5, 10}, "");
  ASSERT_EQ(areas.size(), 1U);
  EXPECT_NEAR(area_of(areas[0]), 1, 1e-12);
  EXPECT_EQ(areas[0].label, "0 to 5");
}

TEST(FilledMap, WhatNoWholeCellShowsIsADot) {
  const double none = std::numeric_limits<double>::infinity();
  const std::vector<std::vector<double>> values{{1, 1.5, none, 4}, {1, 1.5, 2, none}};
  const std::vector<output::Series> dots = output::lone_dots({0, 1, 2, 3}, {0, 1}, values, {0, 3, 4}, "");
  ASSERT_EQ(dots.size(), 2U);
  EXPECT_THAT(dots[0].x, ElementsAre(2));
  EXPECT_THAT(dots[0].y, ElementsAre(1));
  EXPECT_THAT(dots[1].x, ElementsAre(3));
  EXPECT_EQ(dots[1].shade, 1);
  EXPECT_EQ(dots[1].style, output::SeriesStyle::points);
}

TEST(FilledMap, IsDrawnInTheColourOfItsShade) {
  EXPECT_EQ(output::colour_of_shade(0), "#440154");
  EXPECT_EQ(output::colour_of_shade(1), "#fde725");
  EXPECT_EQ(output::colour_of_shade(-3), output::colour_of_shade(0));
  const output::Plot plot{
      .title = "Map",
      .panels = {{.series = output::filled_areas({0, 1}, {0, 1}, {{0, 1}, {1, 2}}, {0, 1, 2}, "g")}}};
  const std::string svg = output::picture(plot, output::PictureFormat::svg);
  EXPECT_THAT(
      svg,
      HasSubstr("<g class=\"dp-series\" color=\"#440154\" data-label=\"0 to 1 g\" data-style=\"area\">"));
  EXPECT_THAT(svg, HasSubstr(">1 to 2 g</text>"));
}

/// Distances from the middle of a grid: the contour is a ring.
TEST(FilledMap, AContourIsWhereTheValueIsTheLevel) {
  std::vector<double> places;
  for (int i = -20; i <= 20; ++i) places.push_back(0.1 * i);
  std::vector<std::vector<double>> distance;
  for (const double y : places) {
    distance.emplace_back();
    for (const double x : places) distance.back().push_back(std::hypot(x, y));
  }
  const output::Series ring = output::contour(places, places, distance, 1.03);
  ASSERT_GT(ring.x.size(), 50U);
  for (std::size_t i = 0; i < ring.x.size(); ++i) EXPECT_NEAR(std::hypot(ring.x[i], ring.y[i]), 1.03, 0.005);
  EXPECT_EQ(ring.x.front(), ring.x.back());
  EXPECT_THAT(output::contour(places, places, distance, 9).x, IsEmpty());
}

TEST(FilledMap, AContourLeavesCellsWithoutAValueOut) {
  const double no_value = std::numeric_limits<double>::infinity();
  const std::vector<double> across{0, 1, 2, 3}, up{0, 1, 2};
  const std::vector<std::vector<double>> values{{0, 1, 2, 3}, {0, 1, 2, 3}, {0, no_value, 2, 3}};
  const output::Series line = output::contour(across, up, values, 1.5);
  ASSERT_FALSE(line.x.empty());
  EXPECT_THAT(line.x, testing::Each(1.5));
  EXPECT_THAT(line.y, testing::Each(testing::Le(1)));
}

}  // namespace
}  // namespace dashpad
