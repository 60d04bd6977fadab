#include <algorithm>
#include <cstddef>
#include <vector>

#include "output/drawing/annotations.hpp"
#include "output/drawing/dimensions.hpp"
#include "output/drawing/elements.hpp"
#include "output/svg/text_fit.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Between a picture and the column of dimensions beside it, px.
constexpr double clearance = 9;
/// How far the line that leads to a dimension goes beyond it.
constexpr double overshoot = 5;

/// With three digits, or fewer where there is no room for more.
std::string shown_length(const Scene& scene, double length, const std::string& before = {}) {
  constexpr double room = beside_picture - clearance - 8;
  std::string text;
  for (int digits = 3; digits > 0; --digits) {
    text = before + brief_quantity(length, "m", scene.units, digits);
    if (text_room(text, size_for_bold * text_size) <= room) break;
  }
  return text;
}

/// What is left of the pad. Digits of next to nothing say nothing.
std::string shown_rest(const Scene& scene) {
  const double left = scene.moments.left(), least = struck_through_gap * scene.moments.thickness;
  if (left == 0 || left >= least) return shown_length(scene, left);
  return shown_length(scene, least, "< ");
}

DimensionColumn column_at(const Scene& scene, double x, bool labels_left) {
  return {.x = x, .labels_left = labels_left, .top = picture_top + 8, .bottom = scene.layout.bottom - 4};
}

std::string thicknesses(const Scene& scene) {
  const Layout& layout = scene.layout;
  const double edge = scene.left.axis + scene.pad_half_width();
  const double x = scene.left.axis + layout.half_width + clearance;
  std::vector<Dimension> dimensions;
  std::string text = line_element("dd-extension", {edge, layout.face}, {x + overshoot, layout.face});
  for (std::size_t i = 0; i < scene.moments.layers.size(); ++i) {
    const double thickness = scene.moments.layers[i].thickness;
    const double to = layout.face + scene.front_of_layer(i + 1);
    dimensions.push_back({.of = "thickness",
                          .metres = thickness,
                          .from = layout.face + scene.front_of_layer(i),
                          .to = to,
                          .value = shown_length(scene, thickness),
                          .is_cut = layout.pad_is_cut});
    text += line_element("dd-extension", {edge, to}, {x + overshoot, to});
  }
  return text + dimension_column(dimensions, column_at(scene, x, false));
}

std::string penetration_and_rest(const Scene& scene) {
  const DrawnMoments& moments = scene.moments;
  const Layout& layout = scene.layout;
  const double axis = scene.right.axis;
  const double x = axis + layout.half_width + clearance;
  const double face = scene.face(scene.right), tip = scene.tip(scene.right);
  const double back = scene.back() + scene.right.sink();
  // The lines to the dimensions begin at what they touch: the pad, or a nose that hides its edge.
  const double pad = scene.pad_half_width();
  const double nose = scene.outline.radius(moments.penetration) * layout.scale;
  const double seen = std::clamp(nose, pad, layout.half_width);
  std::string text = line_element("dd-extension", {axis + seen, face}, {x + overshoot, face});
  if (!moments.struck_through) text += line_element("dd-extension", {axis, tip}, {x + overshoot, tip});
  text += line_element("dd-extension", {axis + pad, back}, {x + overshoot, back});
  return text + dimension_column({{.of = "penetration",
                                   .metres = moments.penetration,
                                   .from = face,
                                   .to = tip,
                                   .value = shown_length(scene, moments.penetration),
                                   .word = "penetration"},
                                  {.of = "left",
                                   .metres = moments.left(),
                                   .from = tip,
                                   .to = back,
                                   .value = shown_rest(scene),
                                   .word = "left",
                                   .is_cut = layout.pad_is_cut,
                                   .is_alarm = moments.struck_through}},
                                 column_at(scene, x, false));
}

std::string way_of_support(const Scene& scene) {
  if (!(scene.moments.sink() > 0)) return "";
  const double left = scene.right.axis - scene.layout.half_width;
  const double x = left - clearance, edge = scene.right.axis - scene.pad_half_width();
  std::vector<Dimension> dimensions;
  std::string text =
      line_element("dd-rest", {x - overshoot, scene.back()}, {std::max(left + 40, edge + 16), scene.back()});
  double y = scene.back();
  const auto add = [&](const char* of, const char* word, double metres, double way) {
    if (!(metres > 0)) return;
    dimensions.push_back({.of = of,
                          .metres = metres,
                          .from = y,
                          .to = y + way,
                          .value = shown_length(scene, metres),
                          .word = word,
                          .is_cut = scene.layout.sink_is_cut});
    y += way;
    text += line_element("dd-extension", {x - overshoot, y}, {edge, y});
  };
  add("deflection", "deflection", scene.moments.deflection, scene.right.deflection);
  add("body-motion", "body moved", scene.moments.body_motion, scene.right.body_motion);
  return text + dimension_column(dimensions, column_at(scene, x, true));
}

}  // namespace

std::string dimensions_left(const Scene& scene) { return thicknesses(scene); }

std::string dimensions_right(const Scene& scene) {
  return penetration_and_rest(scene) + way_of_support(scene);
}

}  // namespace dashpad::output
