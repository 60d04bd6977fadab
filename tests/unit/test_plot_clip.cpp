// What of lines and areas lies within a panel, and how few places they need.

#include <algorithm>
#include <cmath>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/plot/series_svg.hpp"

namespace dashpad {
namespace {

using output::Place;
using output::PlaceLine;

constexpr output::PlotSize size{.width = 100, .height = 50};

TEST(PlotClip, KeepsWhatIsInside) {
  const auto parts = output::line_inside({{0, 0}, {50, 25}, {100, 50}}, size);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_EQ(parts[0].size(), 3U);
}

TEST(PlotClip, CutsALineThatLeavesAndComesBack) {
  const auto parts = output::line_inside({{10, 40}, {20, 60}, {30, 40}, {200, 40}}, size);
  ASSERT_EQ(parts.size(), 2U);
  EXPECT_DOUBLE_EQ(parts[0].back().x, 15);
  EXPECT_DOUBLE_EQ(parts[0].back().y, 50);
  EXPECT_DOUBLE_EQ(parts[1].front().x, 25);
  EXPECT_DOUBLE_EQ(parts[1].back().x, 100);
}

TEST(PlotClip, ShowsALineThatOnlyCrosses) {
  const auto parts = output::line_inside({{-1e7, 25}, {1e7, 25}}, size);
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].front().x, 0, 1e-6);
  EXPECT_NEAR(parts[0].back().x, 100, 1e-6);
  EXPECT_TRUE(output::line_inside({{-10, 40}, {30, 100}}, size).empty());
}

TEST(PlotClip, CutsAnArea) {
  const PlaceLine whole = output::area_inside({{-50, -50}, {200, -50}, {200, 100}, {-50, 100}}, size);
  EXPECT_EQ(whole.size(), 4U);
  for (const Place& corner : whole) EXPECT_TRUE(output::is_inside(corner, size));
  EXPECT_TRUE(output::area_inside({{-50, 0}, {-20, 0}, {-20, 40}}, size).empty());
}

TEST(SimplifiedLine, PassesEveryPlaceCloseEnough) {
  PlaceLine line;
  for (int i = 0; i <= 4000; ++i) {
    const double angle = i * 6.283 / 4000;
    line.push_back({400 + 300 * std::sin(angle), 160 + 150 * std::sin(2 * angle)});
  }
  const PlaceLine few = output::simplified(line);
  EXPECT_LT(few.size(), 200U);
  EXPECT_EQ(few.front().x, line.front().x);
  EXPECT_EQ(few.back().x, line.back().x);
  for (const Place& place : line) {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < few.size(); ++i) {
      const Place &a = few[i - 1], &b = few[i];
      const double x = b.x - a.x, y = b.y - a.y;
      const double part = std::clamp(((place.x - a.x) * x + (place.y - a.y) * y) / (x * x + y * y), 0.0, 1.0);
      nearest = std::min(nearest, std::hypot(place.x - a.x - part * x, place.y - a.y - part * y));
    }
    EXPECT_LE(nearest, 0.0501);
  }
}

TEST(SimplifiedLine, KeepsWhereItTurnsBack) {
  const PlaceLine there_and_back{{0, 0}, {50, 0}, {100, 0}, {50, 0}, {0, 0}, {-40, 0}};
  const PlaceLine few = output::simplified(there_and_back);
  ASSERT_EQ(few.size(), 3U);
  EXPECT_EQ(few[1].x, 100);
  EXPECT_EQ(few[2].x, -40);
  EXPECT_EQ(output::simplified({{1, 1}, {1, 1}, {1, 1}}).size(), 2U);
}

}  // namespace
}  // namespace dashpad
