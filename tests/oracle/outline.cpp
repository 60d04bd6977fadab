#include "oracle/outline.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "oracle/gauss.hpp"

namespace dashpad::oracle {
namespace {

constexpr double pi = std::numbers::pi;

Outline shape_of(const Sphere& sphere) {
  return {.end = sphere.radius, .widening = [r = sphere.radius](double s) { return 2 * pi * (r - s); }};
}
Outline shape_of(const FlatDisc& flat_disc) { return {.tip = pi * flat_disc.radius * flat_disc.radius}; }
Outline shape_of(const Platen& platen) { return {.tip = platen.length * platen.width}; }
Outline shape_of(const Cone& cone) {
  const double low = cone.tip_radius, slope = std::tan(cone.half_angle);
  return {.tip = pi * low * low, .end = (cone.radius - low) / slope, .widening = [=](double s) {
            return 2 * pi * (low + slope * s) * slope;
          }};
}
Outline shape_of(const Ellipsoid& ellipsoid) {
  const double b = ellipsoid.half_depth, across = ellipsoid.half_length * ellipsoid.half_width;
  return {.end = b, .widening = [=](double s) { return 2 * pi * across / b * (1 - s / b); }};
}
Outline shape_of(const Rod& rod) {
  const double dome = rod.tip_radius;
  return {.end = dome - std::sqrt(dome * dome - rod.radius * rod.radius),
          .widening = [=](double s) { return 2 * pi * (dome - s); }};
}
Outline shape_of(const Cylinder& cylinder) {
  const double r = cylinder.radius, length = cylinder.length;
  return {.end = r,
          .widening = [=](double s) { return 2 * length * (r - s) / std::sqrt(s * (2 * r - s)); },
          .is_steep_at_tip = true};
}
Outline shape_of(const Profile& profile) {
  const bool by_radius = profile.of == Profile::Of::radius;
  auto points = profile.points;
  for (auto& point : points) point = {point.depth * profile.scale, profile.scaled_size(point)};
  const double first = points.front().size;
  Outline outline{.tip = by_radius ? pi * first * first : first, .end = points.back().depth};
  for (const auto& point : points) outline.corners.push_back(point.depth);
  outline.widening = [points, by_radius](double s) {
    std::size_t i = 1;
    while (i + 1 < points.size() && points[i].depth < s) ++i;
    const double slope = (points[i].size - points[i - 1].size) / (points[i].depth - points[i - 1].depth);
    return by_radius ? 2 * pi * (points[i - 1].size + slope * (s - points[i - 1].depth)) * slope : slope;
  };
  return outline;
}

}  // namespace

double Outline::area(double depth) const {
  const double deep = std::clamp(depth, 0.0, end);
  if (deep == 0) return tip;
  // s = deep x^2: also where the widening has no bound at the tip.
  const auto part = [&](double from, double to) {
    return gauss(std::sqrt(from / deep), std::sqrt(to / deep), 4,
                 [&](double root) { return widening(deep * root * root) * 2 * deep * root; });
  };
  double sum = tip, from = 0;
  for (const double corner : corners)
    if (from < corner && corner < deep) sum += part(from, corner), from = corner;
  return sum + part(from, deep);
}

Outline outline_of(const Nose& nose, std::optional<double> face) {
  Outline outline = std::visit([](const auto& shape) { return shape_of(shape); }, nose);
  if (!face || *face >= outline.area(outline.end)) return outline;
  if (*face <= outline.tip) return {.tip = *face};
  double low = 0, high = outline.end;
  for (int i = 0; i < 100; ++i) {
    const double middle = (low + high) / 2;
    (outline.area(middle) < *face ? low : high) = middle;
  }
  outline.end = low;
  return outline;
}

}  // namespace dashpad::oracle
