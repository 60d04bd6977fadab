#include <algorithm>
#include <array>
#include <cstddef>
#include <vector>

#include <fmt/format.h>

#include "output/drawing/pictures.hpp"

namespace dashpad::output {

namespace {

class PadPicture {
 public:
  PadPicture(const Scene& scene, const Picture& picture)
      : moments_(scene.moments),
        layout_(scene.layout),
        outline_(scene.outline),
        picture_(picture),
        face_(scene.face(picture)),
        half_width_(layout_.pad_half_width(moments_)),
        share_(moments_.penetration > 0 ? picture.penetration / moments_.penetration : 0) {}

  [[nodiscard]] std::string all() const {
    std::string text;
    for (std::size_t i = 0; i < moments_.layers.size(); ++i)
      text += i == 0 ? shades(i) + hatching(i) : within_layer(i, shades(i) + hatching(i));
    for (std::size_t i = 0; i + 1 < moments_.layers.size(); ++i)
      text += fmt::format("<path class=\"dd-layer-edge\"{} d=\"{}\"/>\n", data_of_back(i),
                          path_data(back_of(i), false));
    text += column("dd-pad-edge", half_width_);
    return "<g class=\"dd-pad\">\n" + text + "</g>\n";
  }

 private:
  /// The pad as far as this from the axis, px.
  [[nodiscard]] std::string column(const std::string& style, double radius) const {
    return rectangle_element(style, picture_.axis - radius, face_, 2 * radius, layout_.pad);
  }

  /// The pad's area in the colours of one layer: one rectangle in another, from small strains to large ones.
  [[nodiscard]] std::string shades(std::size_t layer) const {
    std::string text = fmt::format("<g data-strain=\"{}\" data-shades=\"{}\">\n",
                                   moments_.layers[layer].strain, shades_of_strain);
    text += column(shade_class(0), half_width_);
    const double strain = moments_.layers[layer].strain * share_;
    for (int shade = 1; shade < shades_of_strain; ++shade) {
      const double least = static_cast<double>(shade) / shades_of_strain;
      if (strain < least) break;
      // The depth behind the tip at which a column of this layer has that strain.
      const double depth = picture_.penetration * (1 - least / strain);
      const double radius = std::min(outline_.radius(depth) * layout_.scale, half_width_);
      text += column(shade_class(shade), radius);
    }
    return text + "</g>\n";
  }

  /// Data for scripts, px: the original thickness behind a layer and its shortening on the axis.
  [[nodiscard]] std::string data_of_back(std::size_t layer) const {
    double behind = 0, shortened = 0;
    for (std::size_t j = layer + 1; j < moments_.layers.size(); ++j) {
      behind += moments_.layers[j].thickness * layout_.scale;
      shortened += moments_.layers[j].thickness * moments_.layers[j].strain * layout_.scale;
    }
    return fmt::format(" data-behind=\"{}\" data-shortened=\"{}\"", px(behind), px(shortened));
  }

  [[nodiscard]] std::string hatching(std::size_t layer) const {
    if (moments_.layers.size() == 1) return "";
    return fmt::format("<rect x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" fill=\"url(#{}-hatching-{})\"/>\n",
                       px(picture_.axis - half_width_), px(face_), px(2 * half_width_), px(layout_.pad),
                       own_name, layer + 1);
  }

  /// `content` only behind the layer in front of this one.
  [[nodiscard]] std::string within_layer(std::size_t layer, const std::string& content) const {
    const std::string name = fmt::format("{}-{}-layer-{}", own_name, picture_.name, layer + 1);
    std::vector<Place> region = back_of(layer - 1);
    const double bottom = face_ + layout_.pad;
    region.push_back({picture_.axis + half_width_, bottom});
    region.push_back({picture_.axis - half_width_, bottom});
    return fmt::format(
        "<clipPath id=\"{0}\"><path{1} d=\"{2}\"/></clipPath>\n<g clip-path=\"url(#{0})\">\n{3}</g>\n", name,
        data_of_back(layer - 1), path_data(region, true), content);
  }

  /// The back of a layer, from the left edge of the pad to its right one.
  [[nodiscard]] std::vector<Place> back_of(std::size_t layer) const {
    const NoseFrame frame{
        .scale = layout_.scale, .half_width = half_width_, .height = picture_.penetration * layout_.scale};
    std::vector<Place> right;
    for (const double depth : outline_depths(outline_, frame)) {
      if (depth > picture_.penetration) break;
      const double x = std::min(outline_.radius(depth) * layout_.scale, half_width_);
      if (right.empty() && x > 0) right.push_back({0, depth_of_back(layer, 1)});
      right.push_back(
          {x, depth_of_back(layer, picture_.penetration > 0 ? 1 - depth / picture_.penetration : 0)});
    }
    // The edge of the contact, where the side of a nose deep in the pad stands upright.
    const double edge = std::min(outline_.radius(picture_.penetration) * layout_.scale, half_width_);
    const double deepest = std::min(outline_.depth, picture_.penetration);
    if (picture_.penetration > 0) {
      if (edge < half_width_)
        right.push_back({edge, depth_of_back(layer, 1 - deepest / picture_.penetration)});
      right.push_back({edge, edge < half_width_ ? depth_of_back(layer, 0) : right.back().y});
    } else {
      right.push_back({0, depth_of_back(layer, 0)});
    }
    if (edge < half_width_) right.push_back({half_width_, depth_of_back(layer, 0)});
    return both_halves(right, picture_.axis);
  }

  /// y of the back of a layer in a column that is shortened by this share of the penetration.
  [[nodiscard]] double depth_of_back(std::size_t layer, double shortening) const {
    double behind = 0;
    for (std::size_t j = layer + 1; j < moments_.layers.size(); ++j)
      behind += moments_.layers[j].thickness * (1 - moments_.layers[j].strain * share_ * shortening);
    return face_ + layout_.below_face(moments_.thickness - behind, moments_.thickness);
  }

  const DrawnMoments& moments_;
  const Layout& layout_;
  const Sections& outline_;
  const Picture& picture_;
  double face_;        ///< y of the new pad's face, px
  double half_width_;  ///< px
  double share_;       ///< share of the strains at greatest penetration
};

}  // namespace

std::string pad_picture(const Scene& scene, const Picture& picture) {
  return PadPicture(scene, picture).all();
}

std::string hatchings(const DrawnMoments& moments) {
  constexpr std::array patterns{"M-1 1L1-1M0 8L8 0M7 9L9 7",
                                "M0 4H4",
                                "M-1 7L1 9M0 0L8 8M7-1L9 1",
                                "M4 0V8",
                                "M0 4H8",
                                "M0 8L8 0M0 0L8 8",
                                "M4 3V5M3 4H5",
                                "M0 4H8M4 0V8"};
  std::string text;
  if (moments.layers.size() == 1) return text;
  for (std::size_t i = 0; i < moments.layers.size(); ++i)
    text += fmt::format(
        "<pattern id=\"{}-hatching-{}\" patternUnits=\"userSpaceOnUse\" width=\"8\" height=\"8\">"
        "<path class=\"dd-hatching\" d=\"{}\"/></pattern>\n",
        own_name, i + 1, patterns[i % patterns.size()]);
  return text;
}

}  // namespace dashpad::output
