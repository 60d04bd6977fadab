#include "dashpad/output/materials.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "laboratory/loading_curve.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/foam_curve.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr double drawn_strain = 0.8;
constexpr int steps = 400;  // of 0.002

/// "eps" of "eps-15".
std::string family_of(const Material& material) { return material.name.substr(0, material.name.find('-')); }

double tested_strain_of(const Material& material) {
  const auto range = range_of(material);
  return range ? range->highest_strain : 1;
}

/// The part of a curve between two strains.
Series part_of(const laboratory::LoadingCurve& curve, double from, double to) {
  constexpr double rounding = 1e-9;
  Series part;
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    if (curve.strain[i] < from - rounding || curve.strain[i] > to + rounding) continue;
    part.x.push_back(curve.strain[i]);
    part.y.push_back(curve.stress[i]);
  }
  return part;
}

void add_curve(Panel& panel, const Material& material, std::size_t turn) {
  const laboratory::LoadingCurve curve =
      laboratory::loading_curve(material, laboratory::tested_rates(material).front(), drawn_strain, steps);
  // Where the tested part ends and the other begins; a point of both.
  const auto past = std::ranges::upper_bound(curve.strain, tested_strain_of(material) + 1e-9);
  const double border = past == curve.strain.begin() ? 0 : *(past - 1);
  Series tested = part_of(curve, 0, border);
  tested.style = SeriesStyle::solid_line;
  Series beyond = part_of(curve, border, drawn_strain);
  beyond.style = SeriesStyle::dashed_line;
  tested.turn = beyond.turn = turn;
  (beyond.x.size() > 1 ? beyond : tested).end_label = one_line(material.name);
  panel.series.push_back(std::move(tested));
  if (beyond.x.size() > 1) panel.series.push_back(std::move(beyond));
}

/// The next of 1, 2, 5, 10, ... at or below a positive value.
double round_below(double value) {
  const double decade = std::pow(10, std::floor(std::log10(value)));
  if (5 * decade <= value) return 5 * decade;
  return 2 * decade <= value ? 2 * decade : decade;
}
/// At or above it.
double round_above(double value) { return 1 / round_below(1 / value); }

/// From what the softest foam carries at a small strain to the most that any carries, in round numbers.
void set_stress_limits(Axis& axis, const std::vector<Series>& series) {
  constexpr double small_strain = 0.05;
  double low = std::numeric_limits<double>::infinity(), high = 0;
  for (const Series& of : series)
    for (std::size_t i = 0; i < of.x.size(); ++i) {
      if (!std::isfinite(of.y[i]) || of.y[i] <= 0) continue;
      if (of.x[i] >= small_strain) low = std::min(low, of.y[i]);
      high = std::max(high, of.y[i]);
    }
  if (!(high > 0)) return;
  // A foam may carry the same at all strains; the axis has to have a length.
  axis.low = round_below(low / 1.01);
  axis.high = round_above(high * 1.01);
}

}  // namespace

Plot material_plot(const Material& material, const UnitSystem& units) {
  // A little beyond the tests: what follows is steeper by far and would make all else a line along the axis.
  const double last = std::min(drawn_strain, 1.1 * tested_strain_of(material));
  Panel panel{.title = "Stress in a first loading",
              .x = {.label = "Strain", .low = 0, .high = last},
              .y = axis_with_unit("Stress", "Pa", units)};
  panel.y.low = 0;
  for (const double rate : laboratory::tested_rates(material)) {
    laboratory::LoadingCurve curve = laboratory::loading_curve(material, rate, last, steps);
    panel.series.push_back({.label = fmt::format("at {} per second", brief(rate)),
                            .x = std::move(curve.strain),
                            .y = values_in(units, std::move(curve.stress), "Pa")});
  }
  if (std::optional<Series> tested = line_of_range(material)) panel.series.push_back(*std::move(tested));
  return {.panels = {std::move(panel)}};
}

Plot materials_plot(const std::vector<Material>& materials, const UnitSystem& units) {
  Panel panel{
      "Stress in a first loading at the slowest tested rate", {}, axis_with_unit("Stress", "Pa", units), {}};
  panel.x.label = "Strain";
  panel.x.low = 0;
  panel.x.high = drawn_strain;
  panel.y.logarithmic = true;
  std::map<std::string, std::size_t> turn_of_family;
  for (const Material& material : materials)
    add_curve(panel, material,
              turn_of_family.try_emplace(family_of(material), turn_of_family.size()).first->second);
  for (Series& series : panel.series) series.y = values_in(units, std::move(series.y), "Pa");
  set_stress_limits(panel.y, panel.series);
  return {
      materials.size() == 1 ? one_line(materials.front().title) : "Loading curves of the materials",
      {std::move(panel)},
      fmt::format("dashpad {}; solid: as far as the foam was tested or fitted, dashed: beyond", version())};
}

}  // namespace dashpad::output
