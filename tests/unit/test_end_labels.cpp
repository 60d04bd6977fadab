// Names at the ends of lines.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "output/plot/panel_svg.hpp"

namespace dashpad {
namespace {

constexpr double height_of_axes = 300;

std::vector<output::EndLabel> labels_at(const std::vector<double>& heights, std::size_t lines = 1) {
  std::vector<output::EndLabel> labels;
  for (const double height : heights)
    labels.push_back({.series = nullptr,
                      .lines = std::vector<std::string>(lines, std::to_string(labels.size())),
                      .line_end = {.x = 100, .y = height}});
  output::make_room(labels, height_of_axes);
  return labels;
}

using output::SeriesStyle;

output::SeriesDrawing line(const std::string& label, std::size_t turn = 0) {
  output::SeriesDrawing series;
  series.label = label;
  series.looks = output::looks_of({.label = label, .style = SeriesStyle::line}, turn);
  series.runs = {{{0, 0, 0}, {1, 1, 1}}};
  return series;
}

output::PanelDrawing lines(const std::vector<std::string>& labels) {
  output::PanelDrawing panel;
  for (const std::string& label : labels) panel.series.push_back(line(label, panel.series.size()));
  return panel;
}

TEST(EndLabels, StayWhereThereIsRoom) {
  const auto labels = labels_at({270, 30, 150});
  EXPECT_EQ(labels[0].lines.front(), "1");  // on the way down
  for (const auto& label : labels) EXPECT_DOUBLE_EQ(label.height, label.line_end.y);
}

TEST(EndLabels, MakeRoomOnEitherSide) {
  const auto labels = labels_at({150, 150, 150});
  EXPECT_DOUBLE_EQ(labels[1].height, 150);
  EXPECT_NEAR(labels[1].height - labels[0].height, labels[2].height - labels[1].height, 1e-12);
  EXPECT_GT(labels[1].height - labels[0].height, 12);
}

TEST(EndLabels, StayBesideTheAxis) {
  for (const double height : {0.0, height_of_axes}) {
    const auto labels = labels_at(std::vector<double>(40, height));
    EXPECT_GE(labels.front().height, 0);
    EXPECT_LE(labels.back().height, height_of_axes + 1e-9);
    for (std::size_t i = 1; i < labels.size(); ++i)
      EXPECT_NEAR(labels[i].height - labels[i - 1].height, height_of_axes / 39, 1e-9);
  }
}

TEST(EndLabels, OfTwoLinesTakeTwiceTheRoom) {
  const auto one = labels_at({150, 150}), two = labels_at({150, 150}, 2);
  EXPECT_DOUBLE_EQ(two[1].height - two[0].height, 2 * (one[1].height - one[0].height));
}

TEST(EndLabels, AreForFewAndShortNames) {
  EXPECT_EQ(output::end_labels_of(lines({"a", "b", "c", "d"}), 900).size(), 4U);
  EXPECT_EQ(output::end_labels_of(lines({"a", "b", "c", "d", "e"}), 900).size(), 0U);
  const std::string words = "a name of more than forty characters, or so";
  EXPECT_EQ(output::end_labels_of(lines({words, "b"}), 900).size(), 2U);
  EXPECT_EQ(output::end_labels_of(lines({words, "b"}), 480).size(), 0U);
  EXPECT_EQ(output::end_labels_of(lines({std::string(60, 'm')}), 900).size(), 0U);  // no word is cut
}

TEST(EndLabels, GoOnInASecondLine) {
  const auto labels = output::end_labels_of(lines({"thickness of 25.4 mm"}), 480);
  ASSERT_EQ(labels.size(), 1U);
  EXPECT_EQ(labels[0].lines.size(), 2U);
  EXPECT_LE(output::width_beside_axes(labels), 480.0 / 4);
}

TEST(EndLabels, OfTheSameLooksAreOne) {
  output::PanelDrawing panel;
  panel.series = {line("a"), line("a"), line("a", 1)};
  EXPECT_EQ(output::end_labels_of(panel, 900).size(), 2U);
}

TEST(EndLabels, StandWhereALoopTurns) {
  output::SeriesDrawing loop = line("loop");
  loop.runs = {{{0, 0, 0}, {4, 3, 3}, {1, 0, 0}}};
  output::PanelDrawing panel;
  panel.series = {loop};
  auto labels = output::end_labels_of(panel, 900);
  const output::PanelScale scale{
      .x = {.low = 0, .high = 5}, .y = {.low = 0, .high = 6}, .size = {.width = 500, .height = 300}};
  output::place(labels, scale);
  EXPECT_DOUBLE_EQ(labels.at(0).line_end.x, 400);
  EXPECT_DOUBLE_EQ(labels.at(0).line_end.y, 150);
}

}  // namespace
}  // namespace dashpad
