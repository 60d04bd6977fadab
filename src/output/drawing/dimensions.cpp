#include <algorithm>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "output/drawing/pictures.hpp"
#include "output/svg/svg.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

struct Dimension {
  std::string of;     ///< the attribute data-of: "penetration"
  double metres = 0;  ///< its value
  double from = 0;    ///< y, px
  double to = 0;
  std::string value;      ///< the text that is shown
  std::string word = {};  ///< below it; may be empty
  bool is_cut = false;    ///< drawn shorter than it is
  bool is_alarm = false;  ///< in the colour of a pad that is struck through
};

double label_height(const Dimension& dimension) { return dimension.word.empty() ? 19 : 37; }

/// A slanted stroke where a dimension ends.
std::string tick(double x, double y) { return line_element("dd-tick", {x - 4, y + 4}, {x + 4, y - 4}); }

/// A column of dimension lines at x with labels on one side that keep clear of each other.
std::string dimension_column(const Scene& scene, double column, bool labels_left,
                             const std::vector<Dimension>& dimensions) {
  std::vector<double> wanted, distance;
  for (const Dimension& dimension : dimensions) {
    wanted.push_back((dimension.from + dimension.to) / 2);
    const double before = distance.empty() ? 0 : label_height(dimensions[distance.size() - 1]);
    distance.push_back((before + label_height(dimension)) / 2);
  }
  const std::vector<double> middles = kept_apart(wanted, distance, picture_top + 8, scene.layout.bottom - 4);
  const double side = labels_left ? -1 : 1;
  const char* const anchor = labels_left ? "end" : "start";
  std::string text;
  for (std::size_t i = 0; i < dimensions.size(); ++i) {
    const Dimension& dimension = dimensions[i];
    text += fmt::format("<g class=\"dd-dimension\" data-of=\"{}\" data-metres=\"{}\" data-to-scale=\"{}\">\n",
                        dimension.of, dimension.metres, dimension.is_cut ? "no" : "yes");
    text += line_element("dd-line", {column, dimension.from}, {column, dimension.to});
    text += tick(column, dimension.from) + tick(column, dimension.to);
    const double middle = (dimension.from + dimension.to) / 2;
    if (dimension.is_cut)
      text += path_element("dd-cut",
                           {{column - 5, middle + 3},
                            {column - 1, middle - 3},
                            {column + 1, middle + 3},
                            {column + 5, middle - 3}},
                           false);
    const double x = column + 7 * side;
    if (middles[i] < dimension.from - 1 || middles[i] > dimension.to + 1)
      text += line_element("dd-leader", {column + 2 * side, middle}, {x - side, middles[i]});
    const double baseline = middles[i] + (dimension.word.empty() ? 5 : -2);
    text += text_element(dimension.is_alarm ? "dd-value dd-alarm" : "dd-value", {x, baseline}, anchor,
                         dimension.value);
    if (!dimension.word.empty()) text += text_element("dd-small", {x, baseline + 16}, anchor, dimension.word);
    text += "</g>\n";
  }
  return text;
}

/// The distance from a picture to the column of dimensions beside it, px.
constexpr double clearance = 9;
/// The length of an extension line beyond its dimension line, px.
constexpr double overshoot = 5;

/// A length with three digits, or fewer where three have no room.
std::string shown_length(const Scene& scene, double length, const std::string& before = {}) {
  constexpr double room = beside_picture - clearance - 8;
  std::string text;
  for (int digits = 3; digits > 0; --digits) {
    text = before + brief_quantity(length, "m", scene.units, digits);
    if (text_room(text, size_for_bold * text_size) <= room) break;
  }
  return text;
}

/// What is left of the pad. Below the gap of a pad that is struck through only the bound is shown.
std::string shown_rest(const Scene& scene) {
  const double left = scene.moments.left(), least = struck_through_gap * scene.moments.thickness;
  if (left == 0 || left >= least) return shown_length(scene, left);
  return shown_length(scene, least, "< ");
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
  return text + dimension_column(scene, x, false,
                                 {{.of = "penetration",
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
                                   .is_alarm = moments.struck_through}});
}

std::string way_of_support(const Scene& scene) {
  if (!(scene.moments.sink() > 0)) return "";
  const double left = scene.right.axis - scene.layout.half_width;
  const double x = left - clearance, edge = scene.right.axis - scene.pad_half_width();
  std::vector<Dimension> dimensions;
  std::string text =
      line_element("dd-rest", {x - overshoot, scene.back()}, {std::max(left + 40, edge + 16), scene.back()});
  double y = scene.back();
  const auto add = [&](const char* given, const char* word, double metres, double way) {
    if (!(metres > 0)) return;
    dimensions.push_back({.of = given,
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
  return text + dimension_column(scene, x, true, dimensions);
}

}  // namespace

std::vector<double> kept_apart(std::vector<double> wanted, const std::vector<double>& distance, double lowest,
                               double highest) {
  double least = lowest;
  for (std::size_t i = 0; i < wanted.size(); ++i) {
    wanted[i] = std::max(wanted[i], least);
    if (i + 1 < wanted.size()) least = wanted[i] + distance[i + 1];
  }
  double most = highest;
  for (std::size_t i = wanted.size(); i-- > 0;) {
    wanted[i] = std::min(wanted[i], most);
    most = wanted[i] - distance[i];
  }
  return wanted;
}

std::string dimensions_left(const Scene& scene) {
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
  return text + dimension_column(scene, x, false, dimensions);
}

std::string dimensions_right(const Scene& scene) {
  return penetration_and_rest(scene) + way_of_support(scene);
}

}  // namespace dashpad::output
