#include <algorithm>
#include <vector>

#include <fmt/format.h>

#include "output/drawing/pictures.hpp"

namespace dashpad::output {

namespace {

/// A coil spring from one height to another.
std::string spring(double x, double top, double bottom, double width) {
  constexpr int turns = 10;
  std::vector<Place> places{{x, top}, {x, top + 4}};
  const double pitch = (bottom - top - 8) / turns;
  for (int i = 0; i < turns; ++i)
    places.push_back({x + (i % 2 == 0 ? width : -width), top + 4 + pitch * (i + 0.5)});
  places.push_back({x, bottom - 4});
  places.push_back({x, bottom});
  return path_element("dd-part", places, false);
}

/// A tube with folded sides, which crushes.
std::string folded_tube(double x, double top, double bottom, double width) {
  constexpr int folds = 5;
  std::vector<Place> left, right;
  for (int i = 0; i <= 2 * folds; ++i) {
    const double half = i % 2 == 0 ? width : width * 0.6;
    const double y = top + (bottom - top) * i / (2 * folds);
    left.push_back({x - half, y});
    right.push_back({x + half, y});
  }
  return path_element("dd-part", left, false) + path_element("dd-part", right, false);
}

/// A piston in a cup, which stands on the bottom.
std::string damper(double x, double top, double bottom, double width) {
  const double height = bottom - top;
  const double cup = bottom - 0.65 * height;
  const double piston = bottom - 0.4 * height;
  return line_element("dd-part", {x, top}, {x, piston}) +
         line_element("dd-part", {x - 0.7 * width, piston}, {x + 0.7 * width, piston}) +
         path_element("dd-part",
                      {{x - width, cup}, {x - width, bottom - 4}, {x + width, bottom - 4}, {x + width, cup}},
                      false) +
         line_element("dd-part", {x, bottom - 4}, {x, bottom});
}

std::string ground(double x, double top, double half_width, double height) {
  std::string text = line_element("dd-ground", {x - half_width, top}, {x + half_width, top});
  const int strokes = static_cast<int>((2 * half_width - height) / 10);
  std::string path;
  for (int i = 0; i <= strokes; ++i) {
    const double from = x - half_width + height + 10 * i;
    path += path_data({{from, top}, {from - height + 2, top + height - 2}}, false);
  }
  return text + path_element("dd-part", path);
}

}  // namespace

std::string support_picture(const Scene& scene, const Picture& picture) {
  const Backing& backing = scene.impact.backing;
  const SupportHeights& heights = scene.layout.support;
  const double half = scene.pad_half_width();
  const double back = scene.back() + picture.deflection + picture.body_motion;
  std::string text;
  if (heights.plate > 0)
    text += rectangle_element("dd-panel", picture.axis - half, back, 2 * half, heights.plate);
  const double at_rest = scene.back() + heights.plate + heights.gap + picture.body_motion;
  const double base = at_rest + heights.spring;
  if (heights.spring > 0) {
    const double top = std::max(at_rest, back + heights.plate);
    const double width = std::min(11.0, half / 4);
    // For scripts: the upper end of the springs now, when unloaded, and when pressed by the back of the pad.
    text += fmt::format(
        "<g class=\"dd-springs\" data-top=\"{}\" data-base=\"{}\" data-free=\"{}\" data-touching=\"{}\">\n",
        px(top), px(base), px(at_rest), px(back + heights.plate));
    const bool is_damped = backing.damping > 0 || backing.loss_factor > 0;
    for (const double side : {-1.0, 1.0}) {
      const double x = picture.axis + side * half * 0.6;
      text +=
          backing.unloading_stiffness > 0 ? folded_tube(x, top, base, width) : spring(x, top, base, width);
    }
    if (is_damped) text += damper(picture.axis, top, base, width);
    if (heights.gap > 0)
      text += line_element("dd-ground", {picture.axis - 0.75 * half, top}, {picture.axis + 0.75 * half, top});
    text += "</g>\n";
  }
  if (backing.body_mass == 0) return text + ground(picture.axis, base, scene.layout.half_width, heights.base);
  text += "<g class=\"dd-behind\">\n" +
          rectangle_element("dd-body", picture.axis - half, base, 2 * half, heights.base - 4);
  const double room = 2 * half - 8;
  const std::string mass = scene.shown(backing.body_mass, "kg");
  // A label that does not fit is left to the caption.
  for (const std::string& label : {"free body " + mass, mass})
    if (fitting(label, text_size, room) == label)
      return text + text_element("dd-text", {picture.axis, base + heights.base / 2 + 2}, "middle", label) +
             "</g>\n";
  return text + "</g>\n";
}

}  // namespace dashpad::output
