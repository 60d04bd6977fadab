#include "output/drawing/pictures.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include <fmt/format.h>

namespace dashpad::output {

namespace {

/// The number of teeth on half a break.
constexpr int teeth = 16;
constexpr double max_of_sheet = 3.5;  ///< largest drawn thickness of a sheet, px

/// Two ragged lines with paper between them.
std::string break_of_pad(const Scene& scene, const Picture& picture) {
  const double reach = scene.layout.half_width + 8, middle = scene.face(picture) + 0.66 * scene.layout.pad;
  std::vector<Place> places;
  for (int i = 0; i <= 2 * teeth; ++i)
    places.push_back({picture.axis - reach + reach * i / teeth, middle - 5 + (i % 2 == 0 ? 3 : -3)});
  for (std::size_t i = places.size(); i-- > 0;) places.push_back({places[i].x, places[i].y + 10});
  return path_element("dd-break", places, true);
}

/// Data with which a script moves the picture of greatest penetration to other moments; empty for a picture
/// that is not to scale or has no history. Lengths are in m unless named px.
std::string data_for_moving(const Scene& scene, const Picture& picture) {
  const DrawnMoments& moments = scene.moments;
  const Layout& layout = scene.layout;
  if (&picture != &scene.right || layout.pad_is_cut || !moments.time || moments.penetration <= 0) return {};
  return fmt::format(
      " data-penetration=\"{}\" data-time=\"{}\" data-deflection=\"{}\" data-body=\"{}\" data-scale=\"{}\" "
      "data-axis=\"{}\" data-tip=\"{}\" data-back=\"{}\" data-half-width=\"{}\" data-deflection-px=\"{}\" "
      "data-body-px=\"{}\"",
      moments.penetration, *moments.time, moments.deflection, moments.body_motion, layout.scale,
      px(picture.axis), px(scene.tip(picture)), px(scene.face(picture) + layout.pad),
      px(layout.pad_half_width(moments)), px(picture.deflection), px(picture.body_motion));
}

/// The line where the nose touches, or nearly touches, what is behind the pad.
std::string struck_edge(const Scene& scene, const Picture& picture) {
  const double depth = std::max(0.03 * picture.penetration, 0.0);
  const double reach = std::clamp(scene.outline.radius(depth) * scene.layout.scale, 12.0,
                                  std::max(scene.pad_half_width(), 12.0));
  const double y = scene.tip(picture);
  return line_element("dd-struck-edge", {picture.axis - reach, y}, {picture.axis + reach, y});
}

NoseFrame nose_frame(const Scene& scene, const Picture& picture) {
  const double tip = scene.tip(picture);
  return {.axis = picture.axis,
          .tip = tip,
          .scale = scene.layout.scale,
          .half_width = scene.layout.half_width,
          .height = tip - picture_top,
          .is_buried = scene.moments.penetration > scene.outline.depth};
}

/// A sheet on the pad, a band along its face and the nose. Its thickness is a symbol, since it is not known.
std::string sheet_picture(const Scene& scene, const Picture& picture) {
  if (!(scene.impact.pad.sheet > 0)) return "";
  const double half = scene.pad_half_width(), face = scene.face(picture);
  // The sheet must not hide what is left of the pad.
  const double left =
      scene.layout.pad - scene.layout.below_face(scene.moments.penetration, scene.moments.thickness);
  const double thickness = std::clamp(0.3 * left, 0.8, max_of_sheet);
  const std::string name = fmt::format("{}-{}-sheet", own_name, picture.name);
  return fmt::format(
             "<clipPath id=\"{0}\">{1}</clipPath>\n<g class=\"dd-sheet\" stroke-width=\"{2}\" "
             "clip-path=\"url(#{0})\">\n",
             name, rectangle_element("dd-pad-room", picture.axis - half, face, 2 * half, scene.layout.pad),
             px(2 * thickness)) +
         rectangle_element("dd-sheet-face", picture.axis - half, face, 2 * half, thickness) +
         nose_picture(scene.impact.impactor.nose, nose_frame(scene, picture), "dd-sheet-bent") + "</g>\n";
}

}  // namespace

std::string picture_clip(const Scene& scene, const Picture& picture) {
  constexpr double step = 7, depth = 3;
  const Layout& layout = scene.layout;
  const double left = picture.axis - layout.half_width, right = picture.axis + layout.half_width;
  std::vector<Place> places;
  const auto ragged = [&](Place from, Place to, Place inwards) {
    const int count = 2 * static_cast<int>(std::hypot(to.x - from.x, to.y - from.y) / (2 * step)) + 1;
    for (int i = 0; i <= count; ++i) {
      const double share = static_cast<double>(i) / count, in = i % 2;
      places.push_back({from.x + share * (to.x - from.x) + in * inwards.x,
                        from.y + share * (to.y - from.y) + in * inwards.y});
    }
  };
  ragged({left, layout.bottom}, {left, picture_top}, {depth, 0});
  ragged({left, picture_top}, {right, picture_top}, {0, depth});
  ragged({right, picture_top}, {right, layout.bottom}, {-depth, 0});
  return fmt::format("<clipPath id=\"{}-{}\"><path d=\"{}\"/></clipPath>\n", own_name, picture.name,
                     path_data(places, true));
}

std::string picture_of(const Scene& scene, const Picture& picture) {
  const Layout& layout = scene.layout;
  std::string text = fmt::format("<g clip-path=\"url(#{}-{})\"{}>\n", own_name, picture.name,
                                 data_for_moving(scene, picture));
  text += support_picture(scene, picture) + pad_picture(scene, picture);
  text += sheet_picture(scene, picture);
  text += nose_picture(scene.impact.impactor.nose, nose_frame(scene, picture), "dd-nose");
  if (layout.pad_is_cut) text += break_of_pad(scene, picture);
  if (&picture == &scene.right && scene.moments.struck_through) text += struck_edge(scene, picture);
  return text + "</g>\n";
}

}  // namespace dashpad::output
