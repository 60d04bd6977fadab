#include "margin/sampled_curve.hpp"

#include <algorithm>
#include <cmath>

namespace dashpad::margin {

namespace {

/// What the parabola through a, b and a third point has above the chord from a to b.
double above_chord(const Point& a, const Point& b, const Point& third, double place) {
  const double slope = (b.height - a.height) / (b.place - a.place);
  const double other_slope = (third.height - b.height) / (third.place - b.place);
  return (other_slope - slope) / (third.place - a.place) * (place - a.place) * (place - b.place);
}

}  // namespace

double height_at(const std::vector<Point>& points, double place) {
  const auto after = std::ranges::lower_bound(points, place, {}, &Point::place);
  if (after == points.end()) return points.back().height;
  if (after == points.begin() || after->place == place) return after->height;
  const Point &a = *std::prev(after), &b = *after;
  const double share = (place - a.place) / (b.place - a.place);
  if (!std::isfinite(a.height) || !std::isfinite(b.height)) return share < 0.5 ? a.height : b.height;
  const bool has_before = std::prev(after) != points.begin() && std::isfinite(std::prev(after, 2)->height);
  const bool has_behind = std::next(after) != points.end() && std::isfinite(std::next(after)->height);
  const double weight_before = !has_before ? 0 : has_behind ? 1 - share : 1;
  const double weight_behind = !has_behind ? 0 : 1 - weight_before;
  double height = std::lerp(a.height, b.height, share);
  if (has_before) height += weight_before * above_chord(a, b, *std::prev(after, 2), place);
  if (has_behind) height += weight_behind * above_chord(a, b, *std::next(after), place);
  return std::clamp(height, std::min(a.height, b.height), std::max(a.height, b.height));
}

}  // namespace dashpad::margin
