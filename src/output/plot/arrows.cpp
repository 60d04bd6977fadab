#include "output/plot/arrows.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include <fmt/format.h>

#include "output/plot/line_places.hpp"
#include "output/svg/svg.hpp"

namespace dashpad::output {

namespace {

constexpr double half_length = 5.5, half_width = 4;  // px
/// Of the way along a line. A loop that begins and ends at nothing is on its way back there.
constexpr double share_before = 0.7;

/// Empty on lines that are shorter than two arrows.
std::string arrow_path(const std::vector<PlaceLine>& parts) {
  if (parts.empty()) return {};
  const PlaceLine& line = *std::ranges::max_element(parts, {}, length_of);
  const double middle = share_before * length_of(line);
  if (length_of(line) < 4 * half_length) return {};
  const PlotPlace tail = place_on(line, middle - half_length), tip = place_on(line, middle + half_length);
  const double x = tip.x - tail.x, y = tip.y - tail.y, length = std::hypot(x, y);
  if (!(length > half_length)) return {};  // round a corner
  const double across = half_width / length;
  return fmt::format("M{} {}L{} {}L{} {}z", px(tip.x), px(tip.y), px(tail.x - across * y),
                     px(tail.y + across * x), px(tail.x + across * y), px(tail.y - across * x));
}

}  // namespace

std::string arrows_svg(const PanelDrawing& panel, const PanelScale& scale) {
  std::string arrows;
  for (const SeriesDrawing& series : panel.series) {
    if (!series.has_arrow) continue;
    const std::string path = arrow_path(parts_inside(series, scale));
    if (path.empty()) continue;
    arrows += fmt::format("<g{} data-of=\"{}\"><path class=\"dp-shape\" d=\"{}\"/></g>\n",
                          colour_attributes(series.looks.colour, "dp-arrow"),
                          xml_text(series.label.empty() ? series.of : series.label), path);
  }
  return arrows.empty() ? arrows : "<g class=\"dp-marks\">\n" + arrows + "</g>\n";
}

}  // namespace dashpad::output
