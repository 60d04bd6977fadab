#pragma once
/// The pictures of nose, pad and support, the texts beside them, and the colours of strains.

#include <string>
#include <string_view>
#include <vector>

#include "output/drawing/scene.hpp"
#include "output/svg/svg.hpp"

namespace dashpad::output {

/// The `<clipPath>` of a picture, ragged where what is drawn goes on.
std::string picture_clip(const Scene& scene, const Picture& picture);
/// The `<pattern>`s by which layers are told apart; none for a pad of one foam.
std::string hatchings(const DrawnMoments& moments);
std::string picture_of(const Scene& scene, const Picture& picture);

// The parts of a picture.

/// The geometry in which a nose is drawn.
struct NoseFrame {
  double axis = 0;         ///< x, px
  double tip = 0;          ///< y, px
  double scale = 0;        ///< px/m
  double half_width = 0;   ///< half the width of the picture, px; the nose may reach slightly beyond
  double height = 0;       ///< height of the picture above the tip, px; likewise
  bool is_buried = false;  ///< deeper than its widest section: its side goes on, as in the model
};

/// Depths of the corners of an outline behind its tip, m, rising from 0, as dense as a smooth curve needs.
std::vector<double> outline_depths(const Sections& outline, const NoseFrame& frame);

/// The right half of an outline, x from the axis on, with its mirror image before it.
std::vector<Place> both_halves(const std::vector<Place>& right, double axis);

/// The nose as one closed path.
std::string nose_picture(const Nose& nose, const NoseFrame& frame, std::string_view style);

/// The pad under the nose, columns shaded by strain, layers hatched. For several layers only the axis is
/// computed; elsewhere the strain of each layer falls like the whole column's shortening: the sum is kept.
std::string pad_picture(const Scene& scene, const Picture& picture);

/// The support below the pad as symbols: panel, gap, springs, damper, ground or a free body.
std::string support_picture(const Scene& scene, const Picture& picture);

/// The colours of strains are of equal steps from 0 to 1.
inline constexpr int shades_of_strain = 20;
/// The class of a shade, from 0 up: "dd-s0".
std::string shade_class(int shade);

/// The scale of strains from 0 to 1, `width` px wide, with the tested and the greatest strains on the axis.
std::string strain_legend(const DrawnMoments& moments, Place corner, double width);
/// px, of the legend.
inline constexpr double strain_legend_height = 80;

/// The title: that of the case, or what strikes what.
std::string drawing_title(const ImpactCase& impact);
/// The whole drawing for who does not see it, and what in it is not to scale.
std::string drawing_description(const Scene& scene);

/// Heading, mass, speed and drop height above the left picture.
std::string text_above_left(const Scene& scene);
/// Heading, what is struck through and strain above the right one.
std::string text_above_right(const Scene& scene);

/// Thickness of each layer.
std::string dimensions_left(const Scene& scene);
/// Penetration and what is left, way of the support.
std::string dimensions_right(const Scene& scene);

/// The names of the layers on the pad of the left picture, if each layer has room for its name; else none.
std::string names_on_pad(const Scene& scene);

/// Nose, pad and support in words, for below the left picture.
std::vector<std::string> caption_lines(const Scene& scene);

/// Places near the wanted ones, each at least its distance below the one before, if possible in the range.
std::vector<double> kept_apart(std::vector<double> wanted, const std::vector<double>& distance, double lowest,
                               double highest);

}  // namespace dashpad::output
