#include "output/drawing/nose_outline.hpp"

#include <cmath>
#include <numbers>
#include <type_traits>

namespace dashpad::output {

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

}  // namespace dashpad::output
