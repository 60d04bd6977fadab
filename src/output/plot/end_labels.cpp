#include "output/plot/end_labels.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "output/plot/text.hpp"
#include "output/svg/text_fit.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t longest_end_label = 40;
/// Of a line of text, as a share of the axis.
constexpr double line_spacing = 15.0 / panel_height;

double share_of(double value, const Axis& axis) {
  const auto scale = [&axis](double x) { return axis.logarithmic ? std::log(x) : x; };
  const double share = (scale(value) - scale(*axis.low)) / (scale(*axis.high) - scale(*axis.low));
  return std::clamp(share, 0.0, 1.0);
}

/// Neighbours that have been pushed together, at their common mean.
struct Block {
  double sum = 0;
  std::size_t size = 0;
  [[nodiscard]] double mean() const { return sum / static_cast<double>(size); }
};

}  // namespace

EndLabel end_label_of(const Series& series, const SeriesColour& colour, const PlotRow& end, const Axis& y) {
  const double height = share_of(end.y, y);
  return {shortened(series.end_label, longest_end_label), colour, end.x, height, height};
}

void make_room(std::vector<EndLabel>& labels) {
  if (labels.empty()) return;
  std::ranges::stable_sort(labels, {}, &EndLabel::line_height);
  const auto most_steps = static_cast<double>(labels.size() - 1);
  const double gap = std::min(line_spacing, 1 / std::max(most_steps, 1.0));
  // Less a gap for each label below, heights must only not fall: pool adjacent violators.
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    blocks.push_back({labels[i].line_height - static_cast<double>(i) * gap, 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().size += last.size;
    }
  }
  std::size_t i = 0;
  for (const Block& block : blocks) {
    const double lowest = std::clamp(block.mean(), 0.0, std::max(1 - most_steps * gap, 0.0));
    for (const std::size_t end = i + block.size; i < end; ++i)
      labels[i].height = lowest + static_cast<double>(i) * gap;
  }
}

double width_beside_axes(const std::vector<EndLabel>& labels) {
  double longest = 0;
  for (const EndLabel& label : labels) longest = std::max(longest, text_room(label.text, end_label_text));
  return labels.empty() ? 0 : beside_axes + longest;
}

}  // namespace dashpad::output
