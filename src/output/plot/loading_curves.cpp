// Foams by their own curves: of materials side by side, and how much of one an impact uses.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <map>
#include <string>
#include <utility>
#include <variant>

#include <fmt/format.h>

#include "dashpad/laboratory/material_test.hpp"
#include "dashpad/output/materials.hpp"
#include "dashpad/version.hpp"
#include "output/plot/axis_ticks.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/text/foam_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The range of a plot of one foam.
constexpr double last_drawn_strain = 0.98;
constexpr int places_of_curve = 196;  // steps of 0.005
/// The range of a plot that compares foams.
constexpr double last_compared_strain = 0.8;
constexpr int places_of_compared = 400;  // steps of 0.002
/// The largest stress in a plot over that at half the strain: a pad pressed flat would hide the rest.
constexpr double steepest = 10;

/// The stress at a strain between those of the curve.
double stress_at_strain(const laboratory::LoadingCurve& curve, double strain) {
  const auto above = std::ranges::lower_bound(curve.strain, strain);
  if (above == curve.strain.end()) return curve.stress.back();
  const auto i = static_cast<std::size_t>(above - curve.strain.begin());
  if (i == 0 || *above == strain) return curve.stress[i];
  const double part = (strain - curve.strain[i - 1]) / (curve.strain[i] - curve.strain[i - 1]);
  return std::lerp(curve.stress[i - 1], curve.stress[i], part);
}

/// The curve between two strains, with a point at each of them.
Series part_of_curve(const laboratory::LoadingCurve& curve, double from, double to, SeriesStyle style,
                     std::size_t palette_index, const UnitSystem& units) {
  Series part{.style = style, .palette_index = palette_index};
  part.add(from, stress_at_strain(curve, from));
  for (std::size_t i = 0; i < curve.strain.size(); ++i)
    if (curve.strain[i] > from && curve.strain[i] < to) part.add(curve.strain[i], curve.stress[i]);
  part.add(to, stress_at_strain(curve, to));
  part.y = values_in(units, std::move(part.y), "Pa");
  return part;
}

/// Adds the curve of a foam to a comparison: solid as far as it was tested, dashed beyond.
void add_curve(Panel& panel, const Material& material, std::size_t palette_index, const UnitSystem& units) {
  const laboratory::LoadingCurve curve = laboratory::loading_curve(
      material, laboratory::tested_rates(material).front(), last_compared_strain, places_of_compared);
  const std::optional<FittedRange> range = range_of(material);
  const auto past = std::ranges::upper_bound(curve.strain, (range ? range->highest_strain : 1) + 1e-9);
  const double border = past == curve.strain.begin() ? 0 : *(past - 1);
  panel.series.push_back(part_of_curve(curve, 0, border, SeriesStyle::solid_line, palette_index, units));
  if (past != curve.strain.end())
    panel.series.push_back(
        part_of_curve(curve, border, curve.strain.back(), SeriesStyle::dashed_line, palette_index, units));
  panel.series.back().end_label = one_line(material.name);
}

/// Sets limits from the stress of the softest foam at a small strain to the largest stress, in round numbers.
void set_stress_limits(Axis& axis, const std::vector<Series>& series) {
  constexpr double small_strain = 0.05;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Series& each : series)
    for (std::size_t i = 0; i < each.x.size(); ++i) {
      if (!std::isfinite(each.y[i]) || each.y[i] <= 0) continue;
      if (each.x[i] >= small_strain) low = std::min(low, each.y[i]);
      high = std::max(high, each.y[i]);
    }
  if (!(high > 0)) return;
  // A foam may carry the same at all strains; the axis has to have a length.
  axis.low = round_number(low / 1.01, false);
  axis.high = round_number(high * 1.01, true);
}

/// A foam of a pad and how far it was compressed.
struct UsedFoam {
  const Material& material;
  const PadCondition& condition;
  double strain = 0;
  double rate = 0;        ///< the highest, 1/s
  std::size_t layer = 0;  ///< counted from 1; 0 for a pad of one foam
};

UsedFoam used_foam(const Pad& pad, const Summary& summary) {
  if (pad.layers.empty()) return {pad.material, pad.condition, summary.peak_strain, summary.peak_strain_rate};
  const auto most = std::ranges::max_element(summary.layers, {}, &LayerSummary::peak_strain);
  const auto i = summary.layers.size() == pad.layers.size()
                     ? static_cast<std::size_t>(most - summary.layers.begin())
                     : 0;
  const LayerSummary used = summary.layers.empty() ? LayerSummary{} : summary.layers[i];
  return {pad.layers[i].material, pad.layers[i].condition, used.peak_strain, used.peak_strain_rate, i + 1};
}

/// "The foam reaches a strain of 0.84; it was tested up to 0.6".
std::string foam_curve_title(const UsedFoam& foam, const std::optional<FittedRange>& range) {
  const std::string whose = foam.layer == 0 ? "The foam" : fmt::format("Layer {}", foam.layer);
  const std::string text = fmt::format("{} reaches a strain of {}", whose, brief(foam.strain, 3));
  if (!range) return text;
  return text +
         fmt::format("; it was {} up to {}", how_known(foam.material), brief(range->highest_strain, 3));
}

/// "at 0.01 per second"; empty where the law has no rate effect.
std::string rate_words_of(const Material& material, double rate) {
  const FoamCurves* const curves = foam_curves(material.law);
  const bool has_rate =
      curves ? !std::holds_alternative<NoRateEffect>(curves->rate_effect)
             : std::visit([]<class Law>(const Law&) { return !Law::memoryless; }, material.law);
  return has_rate ? fmt::format("at {} per second", brief(rate, 3)) : "";
}

/// A little above what was used.
double highest_shown(const laboratory::LoadingCurve& curve, double used) {
  constexpr double room = 1.25;
  return room * std::min(stress_at_strain(curve, used), steepest * stress_at_strain(curve, used / 2));
}

/// The curve at the highest rate of the impact, up to the strain that was reached. None for a foam without a
/// rate effect, or if the impact was not faster than the tests.
std::optional<Series> curve_at_rate(const Material& material, const UsedFoam& foam, double slowest,
                                    const UnitSystem& units) {
  if (rate_words_of(material, foam.rate).empty() || !(foam.rate > slowest)) return std::nullopt;
  const laboratory::LoadingCurve curve = laboratory::loading_curve(
      material, foam.rate, std::min(foam.strain, last_drawn_strain), places_of_curve);
  return Series{.label = fmt::format("at {} per second", brief(rounded_to(foam.rate, 2))),
                .style = SeriesStyle::solid_line,
                .x = curve.strain,
                .y = values_in(units, curve.stress, "Pa"),
                .palette_index = 1};
}

}  // namespace

std::optional<Series> line_of_range(const Material& material) {
  const std::optional<FittedRange> range = range_of(material);
  if (!range || !(range->highest_strain < 1)) return std::nullopt;
  return Series{.label = fmt::format("{} to {}", how_known(material), brief(range->highest_strain, 3)),
                .style = SeriesStyle::vertical_line,
                .x = {range->highest_strain}};
}

std::optional<Plot> foam_curve_plot(const Pad& pad, const Summary& summary, const UnitSystem& units) {
  if (summary.status == Status::not_run) return std::nullopt;
  const UsedFoam foam = used_foam(pad, summary);
  if (!(foam.strain > 0) || !violations(foam.material).empty()) return std::nullopt;
  Material material = foam.material;
  material.law = scaled(material.law, stress_factor(foam.condition, material));
  const double rate = laboratory::tested_rates(material).front();
  const laboratory::LoadingCurve curve =
      laboratory::loading_curve(material, rate, last_drawn_strain, places_of_curve);
  const double used = std::min(foam.strain, last_drawn_strain);
  const double highest = highest_shown(curve, used);
  if (!(std::isfinite(highest) && highest > 0)) return std::nullopt;

  Panel panel{.x = {.label = "Strain", .low = 0, .high = 1}, .y = axis_with_unit("Stress", "Pa", units)};
  panel.y.low = 0;
  panel.y.high = value_in(units, highest, "Pa");
  Series part = part_of_curve(curve, 0, used, SeriesStyle::solid_line, 0, units);
  const std::string rate_words = rate_words_of(material, rate);
  part.label = rate_words.empty() ? "used by this impact" : rate_words;
  Series ground = part;
  ground.of = std::exchange(ground.label, {});
  ground.style = SeriesStyle::band;
  ground.y2.assign(ground.y.size(), 0);
  panel.series = {std::move(ground), std::move(part)};
  if (used < last_drawn_strain) {
    panel.series.push_back(part_of_curve(curve, used, last_drawn_strain, SeriesStyle::dashed_line, 0, units));
    panel.series.back().label = "not reached";
  }
  std::string source = fmt::format("{}: first loading", one_line(material.name));
  if (!rate_words.empty()) source += " " + rate_words;
  if (std::optional<Series> fast = curve_at_rate(material, foam, rate, units)) {
    const double shown = std::min(fast->y.back(), steepest * fast->y[fast->y.size() / 2]);
    panel.y.high = std::max(*panel.y.high, 1.05 * shown);
    panel.series.push_back(*std::move(fast));
  }
  if (!rate_words.empty()) {  // the energy is not the area under the slow curve
    panel.series.front().y.assign(panel.series.front().y.size(), *panel.y.high);
    source += "; the strains reached are shaded";
  }
  if (std::optional<Series> line = line_of_range(material)) panel.series.push_back(*std::move(line));
  return Plot{.title = foam_curve_title(foam, range_of(material)),
              .panels = {std::move(panel)},
              .source = std::move(source)};
}

Plot material_plot(const Material& material, const UnitSystem& units) {
  const std::optional<FittedRange> range = range_of(material);
  // A little beyond the tests: what follows is steeper by far and would make all else a line along the axis.
  const double last = std::min(last_compared_strain, 1.1 * (range ? range->highest_strain : 1));
  Panel panel{.title = "Stress in first loading",
              .x = {.label = "Strain", .low = 0, .high = last},
              .y = axis_with_unit("Stress", "Pa", units)};
  panel.y.low = 0;
  for (const double rate : laboratory::tested_rates(material)) {
    laboratory::LoadingCurve curve = laboratory::loading_curve(material, rate, last, places_of_compared);
    panel.series.push_back({.label = fmt::format("at {} per second", brief(rate)),
                            .x = std::move(curve.strain),
                            .y = values_in(units, std::move(curve.stress), "Pa")});
  }
  if (std::optional<Series> tested = line_of_range(material)) panel.series.push_back(*std::move(tested));
  return {.panels = {std::move(panel)}};
}

Plot materials_plot(const std::vector<Material>& materials, const UnitSystem& units) {
  Panel panel{.title = "Stress in first loading at the lowest tested rate",
              .x = {.label = "Strain", .low = 0, .high = last_compared_strain},
              .y = axis_with_unit("Stress", "Pa", units)};
  panel.y.logarithmic = true;
  std::map<std::string, std::size_t> turn_of_family;  // "eps" of "eps-15"
  for (const Material& material : materials) {
    const std::string family = material.name.substr(0, material.name.find('-'));
    add_curve(panel, material, turn_of_family.try_emplace(family, turn_of_family.size()).first->second,
              units);
  }
  set_stress_limits(panel.y, panel.series);
  return {
      .title = materials.size() == 1 ? one_line(materials.front().title) : "Loading curves of the materials",
      .panels = {std::move(panel)},
      .source =
          fmt::format("dashpad {}; solid lines: tested or fitted range, dashed lines: beyond it", version())};
}

}  // namespace dashpad::output
