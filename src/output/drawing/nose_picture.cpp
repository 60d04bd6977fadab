#include "output/drawing/nose_picture.hpp"

#include <algorithm>
#include <cstddef>

#include "output/drawing/nose_outline.hpp"

namespace dashpad::output {

namespace {

/// How far the path goes on outside the picture, px; what is cut off there has no edge.
constexpr double beyond = 12;
constexpr int corners = 40;

}  // namespace

std::vector<double> outline_depths(const Sections& outline, const NoseFrame& frame) {
  const double deepest = std::min(outline.depth, (frame.height + beyond) / frame.scale);
  const double widest = std::min(outline.radius(deepest), (frame.half_width + beyond) / frame.scale);
  const double last = std::min(deepest, outline.depth_at(widest));
  const double tip = outline.radius(0);
  // By equal steps of the depth where the side is steep, of the radius where it is flat.
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

std::string nose_picture(const Nose& nose, const NoseFrame& frame, std::string_view style) {
  const Sections outline = outline_of(nose);
  const double farthest = frame.half_width + beyond;
  std::vector<Place> right;  // from the tip on; x from the axis
  for (const double depth : outline_depths(outline, frame)) {
    const double half_width = std::min(outline.radius(depth) * frame.scale, farthest);
    if (right.empty() && half_width > 0) right.push_back({0, frame.tip});
    right.push_back({half_width, frame.tip - depth * frame.scale});
  }
  const double top = frame.tip - frame.height - beyond;
  // Where half a ball is seen its other half is its mirror image. Of a larger one that half is out of sight.
  const double seen = right.front().y - right.back().y;
  if (is_ball(nose) && !frame.is_buried && seen >= outline.depth * frame.scale * (1 - 1e-9)) {
    const double middle = frame.tip - outline.depth * frame.scale;
    for (std::size_t i = right.size(); i-- > 0;) right.push_back({right[i].x, 2 * middle - right[i].y});
  } else {
    right.push_back({right.back().x, std::min(top, right.back().y)});
  }
  std::vector<Place> places;
  for (std::size_t i = right.size(); i-- > 0;) places.push_back({frame.axis - right[i].x, right[i].y});
  for (const Place& place : right) places.push_back({frame.axis + place.x, place.y});
  return path_element(style, places, true);
}

}  // namespace dashpad::output
