#include "output/plot/clip.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

namespace dashpad::output {

namespace {

/// One side of the rectangle: how far inside of it a place is.
struct Side {
  double PlotPlace::*coordinate;
  double at;
  double sign;

  [[nodiscard]] double depth(const PlotPlace& place) const { return sign * (place.*coordinate - at); }
};

std::array<Side, 4> sides_of(const PlotSize& size) {
  return {{{&PlotPlace::x, 0, 1},
           {&PlotPlace::x, size.width, -1},
           {&PlotPlace::y, 0, 1},
           {&PlotPlace::y, size.height, -1}}};
}

PlotPlace between(const PlotPlace& from, const PlotPlace& to, double part) {
  return {std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part)};
}

/// The part of the way from one place to another that is inside: from the first to the second share. Nothing
/// if the first is not below the second. (Liang and Barsky 1984.)
std::pair<double, double> share_inside(const PlotPlace& from, const PlotPlace& to, const PlotSize& size) {
  double begin = 0, end = 1;
  for (const Side& side : sides_of(size)) {
    const double first = side.depth(from), last = side.depth(to);
    if (first < 0 && last < 0) return {1, 0};
    if (first < 0) begin = std::max(begin, first / (first - last));
    if (last < 0) end = std::min(end, first / (first - last));
  }
  return {begin, end};
}

}  // namespace

bool is_inside(const PlotPlace& place, const PlotSize& size) {
  constexpr double off_an_edge = 0.005;  // px
  return std::ranges::all_of(sides_of(size),
                             [&](const Side& side) { return side.depth(place) >= -off_an_edge; });
}

std::vector<PlaceLine> line_inside(const PlaceLine& line, const PlotSize& size) {
  std::vector<PlaceLine> parts;
  bool goes_on = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const PlotPlace &from = line[i - 1], &to = line[i];
    const auto [begin, end] = share_inside(from, to, size);
    if (begin > end) {
      goes_on = false;
      continue;
    }
    if (!goes_on) parts.push_back({between(from, to, begin)});
    parts.back().push_back(between(from, to, end));
    goes_on = end == 1;
  }
  return parts;
}

PlaceLine area_inside(PlaceLine outline, const PlotSize& size) {
  // Side by side (Sutherland and Hodgman 1974). What is left of an area in several parts hangs together along
  // the sides, which a filling does not show.
  for (const Side& side : sides_of(size)) {
    PlaceLine kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const PlotPlace &from = outline[i], &to = outline[(i + 1) % outline.size()];
      const double first = side.depth(from), last = side.depth(to);
      if (first >= 0) kept.push_back(from);
      if ((first >= 0) != (last >= 0)) kept.push_back(between(from, to, first / (first - last)));
    }
    outline = std::move(kept);
  }
  return outline;
}

}  // namespace dashpad::output
