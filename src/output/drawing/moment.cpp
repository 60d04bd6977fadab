#include "output/drawing/moment.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "dashpad/impact/flags.hpp"
#include "output/drawing/nose_outline.hpp"

namespace dashpad::output {

namespace {

/// `value` within bounds; the lower one for what is no number.
double within(double value, double lowest, double highest) {
  return std::isfinite(value) ? std::clamp(value, lowest, highest) : lowest;
}

/// The entry of greatest penetration. A pad that is closed may stay so while its support goes on: then the
/// entry of greatest motion among those.
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

}  // namespace

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

}  // namespace dashpad::output
