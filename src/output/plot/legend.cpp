#include "output/plot/legend.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "output/plot/series_svg.hpp"
#include "output/plot/text_sizes.hpp"
#include "output/svg/svg.hpp"
#include "output/svg/text_fit.hpp"

namespace dashpad::output {

namespace {

constexpr double legend_line = 17, width_of_sample = 38, between_columns = 24;  // px

/// Of a column that has room for every label.
double width_of_column(const std::vector<LegendEntry>& entries) {
  double longest = 0;
  for (const LegendEntry& entry : entries) longest = std::max(longest, text_room(entry.label, axis_text));
  return width_of_sample + longest + between_columns;
}

std::vector<std::string> lines_of(const LegendEntry& entry, double width) {
  return lines_within(entry.label, axis_text, width - width_of_sample);
}

double height_of(const std::vector<std::string>& lines) {
  return Legend::row_height + legend_line * static_cast<double>(lines.size() - 1);
}

}  // namespace

void add_to(std::vector<LegendEntry>& entries, const LegendEntry& entry) {
  if (entry.label.empty() || std::ranges::find(entries, entry) != entries.end()) return;
  entries.push_back(entry);
}

std::size_t Legend::columns(double width) const {
  const auto room = static_cast<std::size_t>((width + between_columns) / width_of_column(entries));
  return std::clamp<std::size_t>(room, 1, std::max<std::size_t>(entries.size(), 1));
}

double Legend::height(double width) const {
  const std::size_t across = columns(width);
  if (across > 1) return row_height * static_cast<double>((entries.size() + across - 1) / across);
  double height = 0;
  for (const LegendEntry& entry : entries) height += height_of(lines_of(entry, width));
  return height;
}

std::string Legend::svg(double left, double top, double width) const {
  if (entries.empty()) return {};
  const std::size_t across = columns(width);
  const double column = std::min(width_of_column(entries), width);
  std::string text = "<g class=\"dp-legend\">\n";
  double row = top;
  for (std::size_t i = 0; i < entries.size(); ++i) {
    const LegendEntry& entry = entries[i];
    const double x = left + column * static_cast<double>(i % across), middle = row + row_height / 2;
    text += fmt::format("<g class=\"dp-entry\" data-label=\"{}\">{}", xml_text(entry.label),
                        sample_svg(entry.looks, x, middle, width_of_sample - 8));
    const std::vector<std::string> lines = lines_of(entry, width);
    for (std::size_t line = 0; line < lines.size(); ++line)
      text += fmt::format("<text class=\"dp-label\" x=\"{}\" y=\"{}\">{}</text>", px(x + width_of_sample),
                          px(middle + 4.5 + legend_line * static_cast<double>(line)), xml_text(lines[line]));
    text += "</g>\n";
    if ((i + 1) % across == 0) row += height_of(lines);
  }
  return text + "</g>\n";
}

}  // namespace dashpad::output
