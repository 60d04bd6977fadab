#include "output/plot/series_svg.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

namespace dashpad::output {

namespace {

/// A side of the rectangle, from which the depth of a place inside is measured.
struct Side {
  double Place::*coordinate;
  double at;
  double sign;

  [[nodiscard]] double depth(const Place& place) const { return sign * (place.*coordinate - at); }
};

std::array<Side, 4> sides_of(const PlotSize& size) {
  return {{{&Place::x, 0, 1}, {&Place::x, size.width, -1}, {&Place::y, 0, 1}, {&Place::y, size.height, -1}}};
}

Place between(const Place& from, const Place& to, double part) {
  return {std::lerp(from.x, to.x, part), std::lerp(from.y, to.y, part)};
}

/// The shares of a segment between which it is inside; not rising if no part is (Liang and Barsky 1984).
std::pair<double, double> share_inside(const Place& from, const Place& to, const PlotSize& size) {
  double begin = 0, end = 1;
  for (const Side& side : sides_of(size)) {
    const double first = side.depth(from), last = side.depth(to);
    if (first < 0 && last < 0) return {1, 0};
    if (first < 0) begin = std::max(begin, first / (first - last));
    if (last < 0) end = std::min(end, first / (first - last));
  }
  return {begin, end};
}

double distance(const Place& a, const Place& b) { return std::hypot(a.x - b.x, a.y - b.y); }

constexpr double unseen = 0.05;  // px

/// The directions in which a line passes all later places closely enough (wedges of Williams, 1978).
class Wedge {
 public:
  explicit Wedge(const Place& tip) : tip_(tip) {}

  /// Whether the line may go to that place; if so, the wedge becomes as narrow as it demands.
  bool takes(const Place& place) {
    const double x = place.x - tip_.x, y = place.y - tip_.y, distance = std::hypot(x, y);
    if (distance < farthest_) return false;
    if (distance <= unseen) return true;
    if (farthest_ == 0) {
      along_x_ = x / distance;
      along_y_ = y / distance;
    }
    const double angle = std::atan2(along_x_ * y - along_y_ * x, along_x_ * x + along_y_ * y);
    if (angle < low_ || angle > high_) return false;
    const double half_width = std::asin(unseen / distance);
    low_ = std::max(low_, angle - half_width);
    high_ = std::min(high_, angle + half_width);
    farthest_ = distance;
    return true;
  }

 private:
  Place tip_;
  double along_x_ = 1, along_y_ = 0;
  double low_ = -std::numeric_limits<double>::infinity(), high_ = std::numeric_limits<double>::infinity();
  double farthest_ = 0;
};

}  // namespace

bool is_inside(const Place& place, const PlotSize& size) {
  constexpr double off_an_edge = 0.005;  // px
  return std::ranges::all_of(sides_of(size),
                             [&](const Side& side) { return side.depth(place) >= -off_an_edge; });
}

std::vector<PlaceLine> line_inside(const PlaceLine& line, const PlotSize& size) {
  std::vector<PlaceLine> parts;
  bool goes_on = false;
  for (std::size_t i = 1; i < line.size(); ++i) {
    const Place &from = line[i - 1], &to = line[i];
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
  // Clipping (Sutherland and Hodgman 1974) connects separate parts along the sides, unseen in a filling.
  for (const Side& side : sides_of(size)) {
    PlaceLine kept;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Place &from = outline[i], &to = outline[(i + 1) % outline.size()];
      const double first = side.depth(from), last = side.depth(to);
      if (first >= 0) kept.push_back(from);
      if ((first >= 0) != (last >= 0)) kept.push_back(between(from, to, first / (first - last)));
    }
    outline = std::move(kept);
  }
  return outline;
}

double length_of(const PlaceLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.size(); ++i) length += distance(line[i - 1], line[i]);
  return length;
}

Place place_on(const PlaceLine& line, double length) {
  for (std::size_t i = 1; i < line.size(); ++i) {
    const double step = distance(line[i - 1], line[i]);
    if (step > 0 && length <= step) return between(line[i - 1], line[i], length / step);
    length -= step;
  }
  return line.back();
}

PlaceLine simplified(const PlaceLine& line) {
  if (line.size() < 3) return line;
  PlaceLine kept{line.front()};
  Wedge wedge{line.front()};
  for (std::size_t i = 1; i < line.size(); ++i) {
    if (wedge.takes(line[i])) continue;
    kept.push_back(line[i - 1]);
    wedge = Wedge{line[i - 1]};
    wedge.takes(line[i]);
  }
  kept.push_back(line.back());
  return kept;
}

}  // namespace dashpad::output
