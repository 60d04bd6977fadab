// The nose: its outline and its picture, to scale.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <type_traits>

#include "output/drawing/pictures.hpp"

namespace dashpad::output {

namespace {

/// How far the path continues outside the picture, px, so that no edge shows where it is cut off.
constexpr double outside_frame = 12;
constexpr int corners = 40;

}  // namespace

Sections outline_of(const Nose& nose) {
  return std::visit(
      []<class Shape>(const Shape& shape) {
        if constexpr (std::is_same_v<Shape, Ellipsoid>)
          return Ellipsoid{shape.half_depth, shape.half_length, shape.half_length}.sections();
        else if constexpr (std::is_same_v<Shape, Platen>)
          return FlatDisc{shape.length / 2}.sections();
        else if constexpr (std::is_same_v<Shape, Cylinder>)
          return Sphere{shape.radius}.sections();
        else
          return shape.sections();
      },
      nose);
}

bool is_ball(const Nose& nose) {
  return std::holds_alternative<Sphere>(nose) || std::holds_alternative<Ellipsoid>(nose) ||
         std::holds_alternative<Cylinder>(nose);
}

double half_width_of_face(const Nose& nose, double area) {
  const double round = std::sqrt(area * std::numbers::inv_pi);
  if (const auto* ellipsoid = std::get_if<Ellipsoid>(&nose))
    return round * std::sqrt(ellipsoid->half_length / ellipsoid->half_width);
  if (const auto* platen = std::get_if<Platen>(&nose))
    return std::sqrt(area * (platen->length / platen->width)) / 2;
  if (const auto* cylinder = std::get_if<Cylinder>(&nose)) return area / cylinder->length / 2;
  return round;
}

std::vector<double> outline_depths(const Sections& outline, const NoseFrame& frame) {
  const double deepest = std::min(outline.depth, (frame.height + outside_frame) / frame.scale);
  const double widest = std::min(outline.radius(deepest), (frame.half_width + outside_frame) / frame.scale);
  const double last = std::min(deepest, outline.depth_at(widest));
  const double tip = outline.radius(0);
  // Equal steps of the depth resolve steep sides, equal steps of the radius flat ones.
  std::vector<double> depths{0};
  for (int i = 1; i <= corners; ++i) {
    const double share = static_cast<double>(i) / corners;
    depths.push_back(last * share);
    depths.push_back(std::min(outline.depth_at(tip + (widest - tip) * share), last));
  }
  std::ranges::sort(depths);
  depths.erase(std::unique(depths.begin(), depths.end()), depths.end());
  return depths;
}

std::vector<Place> both_halves(const std::vector<Place>& right, double axis) {
  std::vector<Place> places;
  for (std::size_t i = right.size(); i-- > 0;) places.push_back({axis - right[i].x, right[i].y});
  for (const Place& place : right) places.push_back({axis + place.x, place.y});
  return places;
}

std::string nose_picture(const Nose& nose, const NoseFrame& frame, std::string_view style) {
  const Sections outline = outline_of(nose);
  const double farthest = frame.half_width + outside_frame;
  std::vector<Place> right;  // from the tip upwards; x counts from the axis
  for (const double depth : outline_depths(outline, frame)) {
    const double half_width = std::min(outline.radius(depth) * frame.scale, farthest);
    if (right.empty() && half_width > 0) right.push_back({0, frame.tip});
    right.push_back({half_width, frame.tip - depth * frame.scale});
  }
  const double top = frame.tip - frame.height - outside_frame;
  // If half of a ball is visible, its other half is the mirror image; that of a larger ball is out of sight.
  const double seen = right.front().y - right.back().y;
  if (is_ball(nose) && !frame.is_buried && seen >= outline.depth * frame.scale * (1 - 1e-9)) {
    const double middle = frame.tip - outline.depth * frame.scale;
    for (std::size_t i = right.size(); i-- > 0;) right.push_back({right[i].x, 2 * middle - right[i].y});
  } else {
    right.push_back({right.back().x, std::min(top, right.back().y)});
  }
  return path_element(style, both_halves(right, frame.axis), true);
}

}  // namespace dashpad::output
