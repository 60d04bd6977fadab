// Names at the ends of lines.

#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "output/plot/end_labels.hpp"

namespace dashpad {
namespace {

std::vector<output::EndLabel> labels_at(const std::vector<double>& heights) {
  std::vector<output::EndLabel> labels;
  for (const double height : heights)
    labels.push_back({.text = std::to_string(labels.size()),
                      .colour = {},
                      .line_end = 1,
                      .line_height = height,
                      .height = height});
  output::make_room(labels);
  return labels;
}

TEST(EndLabels, StayWhereThereIsRoom) {
  const auto labels = labels_at({0.9, 0.1, 0.5});
  EXPECT_EQ(labels[0].text, "1");  // from low to high
  for (const auto& label : labels) EXPECT_DOUBLE_EQ(label.height, label.line_height);
}

TEST(EndLabels, MakeRoomOnEitherSide) {
  const auto labels = labels_at({0.5, 0.5, 0.5});
  EXPECT_DOUBLE_EQ(labels[1].height, 0.5);
  EXPECT_NEAR(labels[1].height - labels[0].height, labels[2].height - labels[1].height, 1e-12);
  EXPECT_GT(labels[1].height - labels[0].height, 0.04);
}

TEST(EndLabels, StayBesideTheAxis) {
  for (const double height : {0.0, 1.0}) {
    const auto labels = labels_at(std::vector<double>(40, height));
    EXPECT_GE(labels.front().height, 0);
    EXPECT_LE(labels.back().height, 1 + 1e-12);
    for (std::size_t i = 1; i < labels.size(); ++i)
      EXPECT_NEAR(labels[i].height - labels[i - 1].height, 1.0 / 39, 1e-12);
  }
}

}  // namespace
}  // namespace dashpad
