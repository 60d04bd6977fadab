#include "output/drawing/dimensions.hpp"

#include <algorithm>
#include <cstddef>

#include <fmt/format.h>

#include "output/drawing/elements.hpp"
#include "output/svg/svg.hpp"

namespace dashpad::output {

namespace {

double label_height(const Dimension& dimension) { return dimension.word.empty() ? 19 : 37; }

/// A slanted stroke where a dimension ends.
std::string tick(double x, double y) { return line_element("dd-tick", {x - 4, y + 4}, {x + 4, y - 4}); }

}  // namespace

std::vector<double> kept_apart(std::vector<double> wanted, const std::vector<double>& distance, double lowest,
                               double highest) {
  double least = lowest;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = std::max(wanted[i], least);
    if (i + 1 < wanted.size()) least = wanted[i] + distance[i + 1];
  }
  double most = highest;
  for (std::size_t i = wanted.size(); i-- > 0;) {
    wanted[i] = std::min(wanted[i], most);
    most = wanted[i] - distance[i];
  }
  return wanted;
}

std::string dimension_column(const std::vector<Dimension>& dimensions, const DimensionColumn& column) {
  std::vector<double> wanted, distance;
  for (const Dimension& dimension : dimensions) {
    wanted.push_back((dimension.from + dimension.to) / 2);
    const double before = distance.empty() ? 0 : label_height(dimensions[distance.size() - 1]);
    distance.push_back((before + label_height(dimension)) / 2);
  }
  const std::vector<double> middles = kept_apart(wanted, distance, column.top, column.bottom);
  const double side = column.labels_left ? -1 : 1;
  const char* const anchor = column.labels_left ? "end" : "start";
  std::string text;
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const Dimension& dimension = dimensions[i];
    text += fmt::format("<g class=\"dd-dimension\" data-of=\"{}\" data-metres=\"{}\" data-to-scale=\"{}\">\n",
                        dimension.of, dimension.metres, dimension.is_cut ? "no" : "yes");
    text += line_element("dd-line", {column.x, dimension.from}, {column.x, dimension.to});
    text += tick(column.x, dimension.from) + tick(column.x, dimension.to);
    const double middle = (dimension.from + dimension.to) / 2;
    if (dimension.is_cut)
      text += path_element("dd-cut",
                           {{column.x - 5, middle + 3},
                            {column.x - 1, middle - 3},
                            {column.x + 1, middle + 3},
                            {column.x + 5, middle - 3}},
                           false);
    const double x = column.x + 7 * side;
    if (middles[i] < dimension.from - 1 || middles[i] > dimension.to + 1)
      text += line_element("dd-leader", {column.x + 2 * side, middle}, {x - side, middles[i]});
    const double baseline = middles[i] + (dimension.word.empty() ? 5 : -2);
    text += text_element(dimension.is_alarm ? "dd-value dd-alarm" : "dd-value", {x, baseline}, anchor,
                         dimension.value);
    if (!dimension.word.empty()) text += text_element("dd-small", {x, baseline + 16}, anchor, dimension.word);
    text += "</g>\n";
  }
  return text;
}

}  // namespace dashpad::output
