// The line of a map along which its value is the same.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <utility>
#include <vector>

#include "output/plot/filled_map.hpp"

namespace dashpad::output {

namespace {

/// Between two corners of the grid, by their numbers, the lower first.
using Edge = std::pair<std::size_t, std::size_t>;
/// Which edges the line joins to an edge: at most two.
using Neighbours = std::map<Edge, std::vector<Edge>>;

/// The grid whose corners are counted line by line.
struct Grid {
  const std::vector<double>&across, &up;
  const std::vector<std::vector<double>>& values;

  [[nodiscard]] double value(std::size_t corner) const {
    return values[corner / across.size()][corner % across.size()];
  }
  [[nodiscard]] std::pair<double, double> place(const Edge& edge, double level) const {
    const auto [a, b] = edge;
    const double part = (level - value(a)) / (value(b) - value(a));
    return {std::lerp(across[a % across.size()], across[b % across.size()], part),
            std::lerp(up[a / across.size()], up[b / across.size()], part)};
  }
};

/// A triangle is crossed from one edge to another, or not at all.
void add_triangle(const Grid& grid, const std::array<std::size_t, 3>& corners, double level,
                  Neighbours& neighbours) {
  std::vector<Edge> crossed;
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t a = corners[i], b = corners[(i + 1) % 3];
    if ((grid.value(a) >= level) != (grid.value(b) >= level))
      crossed.emplace_back(std::min(a, b), std::max(a, b));
  }
  if (crossed.size() != 2) return;
  neighbours[crossed[0]].push_back(crossed[1]);
  neighbours[crossed[1]].push_back(crossed[0]);
}

/// On the same triangles as filled_areas().
Neighbours crossings(const Grid& grid, double level) {
  Neighbours neighbours;
  const std::size_t width = grid.across.size();
  for (std::size_t line = 0; line + 1 < grid.up.size(); ++line) {
    for (std::size_t place = 0; place + 1 < width; ++place) {
      const std::size_t a = line * width + place, b = a + 1, c = b + width, d = a + width;
      const auto has_value = [&](std::size_t corner) { return std::isfinite(grid.value(corner)); };
      if (!has_value(a) || !has_value(b) || !has_value(c) || !has_value(d)) continue;
      add_triangle(grid, {a, b, c}, level, neighbours);
      add_triangle(grid, {a, c, d}, level, neighbours);
    }
  }
  return neighbours;
}

/// One line from that edge on, taken out of what is left. A ring ends where it began.
std::vector<Edge> taken_from(Neighbours& left, Edge at) {
  std::vector<Edge> line{at};
  while (!left[at].empty()) {
    const Edge next = left[at].back();
    left[at].pop_back();
    std::erase(left[next], at);
    line.push_back(at = next);
  }
  return line;
}

}  // namespace

Series contour(const std::vector<double>& across, const std::vector<double>& up,
               const std::vector<std::vector<double>>& values, double level) {
  constexpr std::size_t black = 6;  // a turn
  constexpr double gap = std::numeric_limits<double>::quiet_NaN();
  Series series{
      .style = SeriesStyle::solid_line, .turn = black, .label_place = LabelPlace::middle, .is_cased = true};
  const Grid grid{across, up, values};
  Neighbours left = crossings(grid, level);
  const auto add = [&](const Edge& from) {
    if (!series.x.empty()) {
      series.x.push_back(gap);
      series.y.push_back(gap);
    }
    for (const Edge& edge : taken_from(left, from)) {
      const auto [x, y] = grid.place(edge, level);
      series.x.push_back(x);
      series.y.push_back(y);
    }
  };
  // Lines from border to border first: from there on, what is left are rings.
  for (const std::size_t ends : {1U, 2U})
    for (const auto& [edge, others] : left)
      if (others.size() == ends) add(edge);
  return series;
}

}  // namespace dashpad::output
