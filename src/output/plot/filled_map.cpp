#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "output/plot/study_figures.hpp"
#include "output/text/study_words.hpp"

namespace dashpad::output {

namespace {

struct Vertex {
  double x = 0, y = 0, value = 0;
};
using Outline = std::vector<Vertex>;

/// The part of a convex outline where sign * (value - level) >= 0 (Sutherland and Hodgman).
Outline clipped(const Outline& outline, double level, double sign) {
  Outline kept;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vertex &from = outline[i], &to = outline[(i + 1) % outline.size()];
    const bool from_in = sign * (from.value - level) >= 0, to_in = sign * (to.value - level) >= 0;
    if (from_in) kept.push_back(from);
    if (from_in == to_in) continue;
    const double part = (level - from.value) / (to.value - from.value);
    kept.push_back({std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part), level});
  }
  return kept;
}

/// An outline of its own; none without an area.
void add_outline(const Outline& outline, Series& area) {
  if (outline.size() < 3) return;
  area.add_gap();
  for (const Vertex& corner : outline) area.add(corner.x, corner.y);
}

using CellCorners = std::array<Vertex, 4>;  ///< around the cell

bool is_whole(const CellCorners& cell) {
  return std::ranges::all_of(cell, [](const Vertex& corner) { return std::isfinite(corner.value); });
}

/// Cells side by side that are all within the class become one rectangle.
class Areas {
 public:
  Areas(double low, double high, Series& area) : low_(low), high_(high), area_(area) {}

  void add_cell(const CellCorners& cell) {
    const auto is_within = [&](const Vertex& corner) {
      return low_ <= corner.value && corner.value <= high_;
    };
    if (is_whole(cell) && std::ranges::all_of(cell, is_within)) {
      if (pending_.empty()) pending_.assign(cell.begin(), cell.end());
      pending_[1] = cell[1];
      pending_[2] = cell[2];
      return;
    }
    flush();
    if (!is_whole(cell)) return;
    for (const std::size_t i : {1U, 2U})
      add_outline(clipped(clipped({cell[0], cell[i], cell[i + 1]}, low_, 1), high_, -1), area_);
  }
  void flush() {
    add_outline(pending_, area_);
    pending_.clear();
  }

 private:
  double low_, high_;
  Series& area_;
  Outline pending_;
};

/// An edge by the numbers of its two grid corners, the lower first.
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

/// The edges crossed by a level, on the same triangles as filled_areas().
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

/// Takes one line, beginning at an edge, out of the remaining crossings. A ring ends where it began.
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

/// 1, 2, 5, 10, ... about values over decades; over more than three only the powers of ten.
std::vector<double> levels_over_decades(double least, double greatest) {
  constexpr double many = 1e3;
  std::vector<double> levels;
  for (double power = std::pow(10, std::floor(std::log10(least)));; power *= 10)
    for (const double part : {1.0, 2.0, 5.0}) {
      if (part > 1 && greatest > many * least) break;
      if (part * power <= least) levels.clear();
      levels.push_back(part * power);
      if (levels.back() >= greatest) return levels;
    }
}

}  // namespace

std::vector<double> round_levels(double least, double greatest) {
  constexpr double about = 9;
  constexpr double rounding = 1e-9;  // relative difference below which numbers count as equal
  const double range = greatest - least;
  if (!std::isfinite(range) || !(range > rounding * std::max(std::abs(least), std::abs(greatest)))) return {};
  constexpr double over_decades = 100;
  if (least > 0 && greatest > over_decades * least) return levels_over_decades(least, greatest);
  const double rough = range / about;
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double part : {5.0, 2.0, 1.0})
    if (part * power >= rough) step = part * power;
  const double first = std::floor(least / step);
  std::vector<double> levels{first * step};
  while (levels.back() < greatest) levels.push_back((first + static_cast<double>(levels.size())) * step);
  return levels;
}

Series class_of_levels(const std::vector<double>& levels, std::size_t i, const std::string& unit) {
  const std::size_t classes = levels.size() - 1;
  return {
      .label = with_unit(fmt::format("{} to {}", four_digits(levels[i]), four_digits(levels[i + 1])), unit),
      .style = SeriesStyle::area,
      .palette_index = 0,
      .shade = classes < 2 ? 0 : static_cast<double>(i) / static_cast<double>(classes - 1)};
}

std::vector<Series> lone_dots(const std::vector<double>& across, const std::vector<double>& up,
                              const std::vector<std::vector<double>>& values,
                              const std::vector<double>& levels, const std::string& unit) {
  const auto is_finite = [&](std::size_t line, std::size_t place) {
    return line < up.size() && place < across.size() && std::isfinite(values[line][place]);
  };
  /// Whether the cell whose last corner this is has all its values.
  const auto is_whole_before = [&](std::size_t line, std::size_t place) {
    return line > 0 && place > 0 && is_finite(line, place) && is_finite(line - 1, place) &&
           is_finite(line, place - 1) && is_finite(line - 1, place - 1);
  };
  std::vector<Series> list;
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    Series dots = class_of_levels(levels, i, unit);
    dots.style = SeriesStyle::points;
    const bool is_last = i + 2 == levels.size();
    for (std::size_t line = 0; line < up.size(); ++line)
      for (std::size_t place = 0; place < across.size(); ++place) {
        const double value = values[line][place];
        if (!(value >= levels[i] && (value < levels[i + 1] || (is_last && value == levels[i + 1])))) continue;
        if (is_whole_before(line, place) || is_whole_before(line, place + 1) ||
            is_whole_before(line + 1, place) || is_whole_before(line + 1, place + 1))
          continue;
        dots.add(across[place], up[line]);
      }
    if (!dots.x.empty()) list.push_back(std::move(dots));
  }
  return list;
}

std::vector<Series> filled_areas(const std::vector<double>& across, const std::vector<double>& up,
                                 const std::vector<std::vector<double>>& values,
                                 const std::vector<double>& levels, const std::string& unit) {
  std::vector<Series> list;
  const auto corner = [&](std::size_t line, std::size_t place) {
    return Vertex{across[place], up[line], values[line][place]};
  };
  for (std::size_t i = 0; i + 1 < levels.size(); ++i) {
    Series area = class_of_levels(levels, i, unit);
    for (std::size_t line = 0; line + 1 < up.size(); ++line) {
      Areas row{levels[i], levels[i + 1], area};
      for (std::size_t place = 0; place + 1 < across.size(); ++place)
        row.add_cell({corner(line, place), corner(line, place + 1), corner(line + 1, place + 1),
                      corner(line + 1, place)});
      row.flush();
    }
    if (!area.x.empty()) list.push_back(std::move(area));
  }
  return list;
}

Series contour(const std::vector<double>& across, const std::vector<double>& up,
               const std::vector<std::vector<double>>& values, double level) {
  constexpr std::size_t black = 6;  // a turn
  Series series{.style = SeriesStyle::solid_line,
                .palette_index = black,
                .label_place = LabelPlace::middle,
                .is_cased = true};
  const Grid grid{across, up, values};
  Neighbours left = crossings(grid, level);
  const auto add = [&](const Edge& from) {
    series.add_gap();
    for (const Edge& edge : taken_from(left, from)) {
      const auto [x, y] = grid.place(edge, level);
      series.add(x, y);
    }
  };
  // Lines from border to border first: from there on, what is left are rings.
  for (const std::size_t ends : {1U, 2U})
    for (const auto& [edge, others] : left)
      if (others.size() == ends) add(edge);
  return series;
}

}  // namespace dashpad::output
