#include "dashpad/model/nose/sections.hpp"

namespace dashpad {

double Sections::rate_of_shape(double s) const { return s <= depth ? shape->rate(s) : 0; }

Sections::Weights Sections::weights_of_shape(double from, double to) const {
  const double mean = to > from ? (shape->area(to) - shape->area(from)) / (2 * std::numbers::pi * (to - from))
                                : shape->rate(to);
  return {std::max(mean, 0.0), std::max(mean, 0.0)};
}

double Sections::area_of_shape(double y) const { return y >= 0 ? shape->area(std::min(y, depth)) : 0; }

double Sections::volume_of_shape(double y) const {
  const double beyond = std::max(y - depth, 0.0);
  return shape->volume(std::clamp(y, 0.0, depth)) + shape->area(depth) * beyond;
}

double Sections::volume_integral_of_shape(double y) const {
  const double beyond = std::max(y - depth, 0.0);
  return shape->volume_integral(std::clamp(y, 0.0, depth)) +
         (shape->volume(depth) + shape->area(depth) * beyond / 2) * beyond;
}

double Sections::depth_of_shape_at(double area) const {
  return area < shape->area(depth) ? shape->depth_at(area) : depth;
}

}  // namespace dashpad
