#include "output/drawing/scene.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "dashpad/impact/flags.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// `value` within bounds; the lower one for what is no number.
double within(double value, double lowest, double highest) {
  return std::isfinite(value) ? std::clamp(value, lowest, highest) : lowest;
}

/// The entry of greatest penetration, or of greatest motion if a closed pad moves on with its support.
std::optional<std::size_t> deepest_entry(const History& history) {
  double deepest = -1;
  for (const double penetration : history.penetration)
    if (std::isfinite(penetration)) deepest = std::max(deepest, penetration);
  std::optional<std::size_t> entry;
  for (std::size_t i = 0; i < history.penetration.size(); ++i) {
    if (!(history.penetration[i] >= deepest * (1 - 1e-9))) continue;
    if (!entry || (i < history.motion.size() && history.motion[i] > history.motion[*entry])) entry = i;
  }
  return entry;
}

/// An entry of a column, a length; 0 where the column has none.
double length_at(const std::vector<double>& column, const std::optional<std::size_t>& entry) {
  return entry && *entry < column.size() ? within(column[*entry], 0, 1e6) : 0;
}

DrawnLayer drawn_layer(const Material& material, double thickness) {
  DrawnLayer layer{.name = material.name, .thickness = thickness, .has_curves = has_curves(material.law)};
  if (const auto range = range_of(material)) layer.tested = within(range->highest_strain, 0, 1);
  return layer;
}

/// Strains on the axis whose shortenings add up to the penetration; those of the history do to its accuracy.
void set_strains(DrawnMoments& moments, const Solution& solution, const std::optional<std::size_t>& entry) {
  double sum = 0;
  for (std::size_t i = 0; i < moments.layers.size(); ++i) {
    DrawnLayer& layer = moments.layers[i];
    const auto& strains = solution.history.layer_strain;
    if (entry && i < strains.size() && *entry < strains[i].size())
      layer.strain = within(strains[i][*entry], 0, 1);
    else if (i < solution.summary.layers.size())
      layer.strain = within(solution.summary.layers[i].peak_strain, 0, 1);
    if (i < solution.summary.layers.size())
      layer.struck_through = solution.summary.layers[i].struck_through.has_value();
    sum += layer.strain * layer.thickness;
  }
  for (DrawnLayer& layer : moments.layers)
    layer.strain = sum > 0 ? std::min(layer.strain * (moments.penetration / sum), 1.0)
                           : moments.penetration / moments.thickness;
}

DrawnMoments drawn_moments(const ImpactCase& impact, const Solution& solution) {
  const Pad& pad = impact.pad;
  const Summary& summary = solution.summary;
  const History& history = solution.history;
  const std::optional<std::size_t> entry = deepest_entry(history);
  DrawnMoments moments;
  for (const PadLayer& layer : pad.layers)
    moments.layers.push_back(drawn_layer(layer.material, layer.thickness));
  if (pad.layers.empty()) moments.layers.push_back(drawn_layer(pad.material, pad.thickness));
  moments.thickness = pad.thickness;
  moments.penetration = summary.bottomed ? pad.thickness : within(summary.peak_penetration, 0, pad.thickness);
  moments.struck_through = is_struck_through(moments.penetration, pad.thickness);
  moments.bottomed = bottomed_on_rigid_support(summary);
  moments.is_so_far = is_cut(summary) && entry && *entry + 1 == history.penetration.size();
  if (!history.penetration.empty())
    moments.crater = within(history.penetration.front(), 0, moments.penetration);
  moments.deflection = entry ? length_at(history.support_deflection, entry)
                             : within(summary.peak_motion - summary.peak_penetration, 0, 1e6);
  if (impact.support.is_rigid()) moments.deflection = 0;
  moments.body_motion = length_at(history.body_motion, entry);
  if (entry && *entry < history.time.size()) moments.time = history.time[*entry];
  if (pad.area) moments.half_width = half_width_of_face(impact.impactor.nose, *pad.area);
  set_strains(moments, solution, entry);
  return moments;
}

constexpr double picture_height = 256;
constexpr double min_nose = 60;  ///< least height of the nose above the pad
constexpr double max_nose = 130;
constexpr double min_pad = 44;         ///< least height of a pad thin against the nose
constexpr double min_nose_width = 30;  ///< half the width of a nose small against the pad
constexpr double margin = 8;
constexpr double solid_spring = 22;  ///< length of a spring at its greatest deflection

/// Heights at a scale, with the sink of the pad as given, px.
SupportHeights support_heights(const ImpactCase& impact, const DrawnMoments& moments, double scale,
                               double deflection) {
  const Backing& backing = impact.backing;
  SupportHeights heights;
  const bool has_panel = backing.mass > 0 || backing.gap > 0 || backing.preload > 0;
  heights.plate = has_panel ? 8 : 0;
  heights.base = backing.body_mass > 0 ? 30 : 12;
  if (impact.support.is_rigid() && backing.damping == 0) return heights;
  if (backing.gap > 0) {
    heights.gap = std::clamp(backing.gap * scale, 5.0, 40.0);
    // A gap is shortened like the travel, so that it is closed in the drawing if it was closed in the impact.
    if (moments.deflection > 0 && deflection < moments.deflection * scale * (1 - 1e-9))
      heights.gap = std::clamp(backing.gap / moments.deflection * deflection, 5.0, 40.0);
  }
  heights.spring = std::max(34.0, deflection - heights.gap + solid_spring);
  return heights;
}

double sum_of(const SupportHeights& heights) {
  return heights.plate + heights.gap + heights.spring + heights.base;
}

/// The largest scale at which everything along the motion has room.
double scale_by_height(const ImpactCase& impact, const DrawnMoments& moments) {
  double low = -30, high = 30;  // logarithms
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    const double scale = std::exp(middle);
    const double height = min_nose + moments.thickness * scale + moments.body_motion * scale +
                          sum_of(support_heights(impact, moments, scale, moments.deflection * scale));
    (height <= picture_height ? low : high) = middle;
  }
  return std::exp(low);
}

double chosen_scale(const ImpactCase& impact, const DrawnMoments& moments, double half_width) {
  const Sections outline = outline_of(impact.impactor.nose);
  const double widest = outline.radius(outline.depth);
  double contact = outline.radius(moments.penetration);
  if (moments.half_width) contact = std::min(contact, *moments.half_width);
  double scale = scale_by_height(impact, moments);
  if (contact > 0) scale = std::min(scale, 0.82 * half_width / contact);
  if (moments.half_width) scale = std::min(scale, 0.92 * half_width / *moments.half_width);
  return std::max(
      {scale, min_pad / moments.thickness, min_nose_width / std::max(widest, moments.penetration)});
}

Layout layout_of(const ImpactCase& impact, const DrawnMoments& moments) {
  Layout layout;
  const bool sinks = moments.sink() > 0;
  const double between = sinks ? 2 * beside_picture : beside_picture;
  layout.half_width = (drawing_width - margin - between - beside_picture) / 4;
  layout.left = margin + layout.half_width;
  layout.right = drawing_width - beside_picture - layout.half_width;
  layout.captions_width = layout.right - layout.left - 28;
  layout.left_end = std::max(layout.left + layout.half_width + beside_picture,
                             layout.left - layout.half_width + layout.captions_width);
  layout.right_begin = layout.right - layout.half_width - (sinks ? beside_picture : margin);
  layout.scale = chosen_scale(impact, moments, layout.half_width);

  const SupportHeights at_rest = support_heights(impact, moments, layout.scale, 0);
  const double room = picture_height - min_nose - sum_of(at_rest);
  layout.pad = moments.thickness * layout.scale;
  layout.pad_is_cut = layout.pad > std::max(room, min_pad) * (1 + 1e-9);
  if (layout.pad_is_cut) layout.pad = std::max(room, 2 * min_pad);
  const double travel = moments.sink() * layout.scale;
  const double whole =
      min_nose + layout.pad + moments.body_motion * layout.scale +
      sum_of(support_heights(impact, moments, layout.scale, moments.deflection * layout.scale));
  const double room_to_sink = std::max(
      picture_height - min_nose - layout.pad - at_rest.plate - at_rest.base - at_rest.gap - solid_spring,
      24.0);
  layout.sink_is_cut = whole > picture_height * (1 + 1e-6) && travel > room_to_sink;
  const double share = layout.sink_is_cut ? room_to_sink / travel : 1;
  layout.deflection = moments.deflection * layout.scale * share;
  layout.body_motion = moments.body_motion * layout.scale * share;
  layout.support = support_heights(impact, moments, layout.scale, layout.deflection);

  const double below = layout.pad + layout.body_motion + sum_of(layout.support);
  const Sections outline = outline_of(impact.impactor.nose);
  const double ball = is_ball(impact.impactor.nose) ? 2 * outline.depth * layout.scale + 4
                                                    : std::numeric_limits<double>::infinity();
  const double nose = std::clamp(std::min(ball, picture_height - below), std::min(ball, min_nose), max_nose);
  layout.face = picture_top + nose;
  layout.bottom = layout.face + below;
  return layout;
}

}  // namespace

double Layout::below_face(double depth, double thickness) const {
  if (!pad_is_cut) return std::clamp(depth / thickness, 0.0, 1.0) * pad;
  // True to scale from both faces; what lies between is squeezed into the break.
  const double from_face = depth * scale, from_back = (thickness - depth) * scale;
  const double upper = 0.6 * pad, lower = 0.3 * pad;
  if (from_face <= upper) return std::max(from_face, 0.0);
  if (from_back <= lower) return pad - std::max(from_back, 0.0);
  return 0.65 * pad;
}

double Layout::pad_half_width(const DrawnMoments& moments) const {
  const double beyond = half_width + 20;
  return moments.half_width ? std::min(*moments.half_width * scale, beyond) : beyond;
}

Scene::Scene(const ImpactCase& impact_case, const Solution& solution, const UnitSystem& shown_units)
    : impact(impact_case),
      summary(solution.summary),
      units(shown_units),
      outline(outline_of(impact_case.impactor.nose)),
      moments(drawn_moments(impact_case, solution)),
      layout(layout_of(impact_case, moments)),
      left{.name = "left", .axis = layout.left, .penetration = moments.crater},
      right{.name = "right",
            .axis = layout.right,
            .penetration = moments.penetration,
            .deflection = layout.deflection,
            .body_motion = layout.body_motion} {}

double Scene::pad_half_width() const { return std::min(layout.pad_half_width(moments), layout.half_width); }

double Scene::front_of_layer(std::size_t layer) const {
  double depth = 0;
  for (std::size_t i = 0; i < layer; ++i) depth += moments.layers[i].thickness;
  return layout.below_face(depth, moments.thickness);
}

std::string Scene::shown(double value, const char* si_unit) const {
  return brief_quantity(value, si_unit, units, 3);
}

}  // namespace dashpad::output
