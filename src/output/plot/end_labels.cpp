#include "output/plot/panel_svg.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "output/plot/svg_plot.hpp"

namespace dashpad::output {

namespace {

constexpr std::size_t longest_end_label = 40;
/// The largest number of labels, and of their lines, beside a plot; beyond it a legend is easier to read.
constexpr std::size_t max_lines_named_at_ends = 4, max_lines_of_text = 2;
constexpr double max_of_width = 0.29;
/// The share of the width for labels that identify the rows of a plot, such as the names of bars.
constexpr double max_of_width_for_rows = 0.36;
constexpr double end_label_line = 16;  // px

/// Lines with a label, one of those that have the same.
std::vector<const SeriesDrawing*> lines_to_name(const PanelDrawing& panel) {
  std::vector<const SeriesDrawing*> lines;
  for (const SeriesDrawing& series : panel.series) {
    if (!is_line(series.looks.style) || series.label.empty() || !series.end_label.empty() ||
        series.label_place != LabelPlace::by_style)
      continue;
    const auto is_same = [&](const SeriesDrawing* other) { return entry_of(*other) == entry_of(series); };
    if (std::ranges::none_of(lines, is_same)) lines.push_back(&series);
  }
  return lines;
}

/// The text in as few lines as have room; empty where a word or the whole does not.
std::vector<std::string> in_few_lines(const std::string& text, double width) {
  std::vector<std::string> lines = lines_within(text, label_text, width);
  if (lines.size() > max_lines_of_text) return {};
  std::size_t size = lines.size() - 1;  // the blanks between them
  for (const std::string& line : lines) size += line.size();
  return size == readable(text).size() ? lines : std::vector<std::string>{};
}

/// The right end of a line, or where it turns if it comes back.
Place end_of(const SeriesDrawing& series, const PanelScale& scale) {
  Place last{scale.size.width, scale.size.height}, farthest{-1, 0};
  for (const PlaceLine& part : parts_inside(series, scale)) {
    for (const Place& at : part)
      if (at.x > farthest.x) farthest = at;
    last = part.back();
  }
  const double as_far = 0.02 * scale.size.width;
  return last.x < farthest.x - as_far ? farthest : last;
}

double height_of(const EndLabel& label) { return end_label_line * static_cast<double>(label.lines.size()); }

/// Neighbours that have been pushed together, at their common mean.
struct Block {
  double sum = 0;
  std::size_t size = 0;
  [[nodiscard]] double mean() const { return sum / static_cast<double>(size); }
};

/// A leader from the line to its label, unless the label is right beside the end of the line.
std::string leader(const EndLabel& label, double width) {
  const bool is_beside = label.line_end.x > width - 1 && std::abs(label.line_end.y - label.height) < 1;
  if (is_beside) return {};
  return fmt::format("<path class=\"dp-leader\" d=\"M{} {}L{} {}\"/>", px(label.line_end.x),
                     px(label.line_end.y), px(width + beside_axes - 4), px(label.height));
}

}  // namespace

std::vector<EndLabel> end_labels_of(const PanelDrawing& panel, double plot_width) {
  std::vector<EndLabel> labels;
  for (const SeriesDrawing& series : panel.series)
    if (!series.end_label.empty() && !series.runs.empty())
      labels.push_back({.series = &series,
                        .lines = lines_within(shortened(series.end_label, longest_end_label), label_text,
                                              max_of_width_for_rows * plot_width)});
  const std::vector<const SeriesDrawing*> lines = lines_to_name(panel);
  if (lines.size() > max_lines_named_at_ends) return labels;
  std::vector<EndLabel> all = labels;
  for (const SeriesDrawing* line : lines) {
    all.push_back({.series = line,
                   .lines = in_few_lines(entry_of(*line).label, max_of_width * plot_width - beside_axes)});
    if (all.back().lines.empty()) return labels;
  }
  return all;
}

void place(std::vector<EndLabel>& labels, const PanelScale& scale) {
  for (EndLabel& label : labels) label.line_end = end_of(*label.series, scale);
  make_room(labels, scale.size.height);
}

void make_room(std::vector<EndLabel>& labels, double height) {
  if (labels.empty()) return;
  std::ranges::stable_sort(labels, {}, [](const EndLabel& label) { return label.line_end.y; });
  // The distance of each label below the first if they are packed without gaps.
  std::vector<double> below{0};
  for (std::size_t i = 1; i < labels.size(); ++i)
    below.push_back(below.back() + (height_of(labels[i - 1]) + height_of(labels[i])) / 2);
  const double shrunk = std::min(1.0, height / std::max(below.back(), 1.0));
  for (double& distance : below) distance *= shrunk;
  // Less these distances, heights must only not fall: pool adjacent violators.
  std::vector<Block> blocks;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    blocks.push_back({labels[i].line_end.y - below[i], 1});
    while (blocks.size() > 1 && blocks[blocks.size() - 2].mean() > blocks.back().mean()) {
      const Block last = blocks.back();
      blocks.pop_back();
      blocks.back().sum += last.sum;
      blocks.back().size += last.size;
    }
  }
  std::size_t i = 0;
  for (const Block& block : blocks) {
    const double first = std::clamp(block.mean(), 0.0, std::max(height - below.back(), 0.0));
    for (const std::size_t end = i + block.size; i < end; ++i) labels[i].height = first + below[i];
  }
}

double width_beside_axes(const std::vector<EndLabel>& labels) {
  double longest = 0;
  for (const EndLabel& label : labels)
    for (const std::string& line : label.lines) longest = std::max(longest, text_room(line, label_text));
  return labels.empty() ? 0 : beside_axes + longest;
}

std::string end_labels_svg(const std::vector<EndLabel>& labels, const PanelScale& scale) {
  if (labels.empty()) return {};
  std::string svg = "<g class=\"dp-ends\">\n";
  for (const EndLabel& label : labels) {
    svg += fmt::format("<g{} data-label=\"{}\">{}", colour_attributes(label.series->looks.colour, "dp-end"),
                       xml_text(entry_of(*label.series).label), leader(label, scale.size.width));
    double y = label.height - (height_of(label) - end_label_line) / 2 + 4;
    for (const std::string& line : label.lines) {
      svg += fmt::format("<text class=\"dp-end-label\" x=\"{}\" y=\"{}\">{}</text>",
                         px(scale.size.width + beside_axes), px(y), xml_text(line));
      y += end_label_line;
    }
    svg += "</g>\n";
  }
  return svg + "</g>\n";
}

}  // namespace dashpad::output
