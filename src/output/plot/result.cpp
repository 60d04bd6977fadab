#include "dashpad/output/impact.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/impact_figures.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The share of the energy that the pad keeps, or the name of the plot where that is not known.
std::string title_of_loops(const Summary& summary, const UnitSystem& units) {
  constexpr double rounding = 1e-9;
  const double kept = summary.energy_absorbed_fraction;
  if (summary.status != Status::released || !(kept > -rounding && kept < 1 + rounding))
    return "Force against displacement and penetration";
  return fmt::format("The pad absorbs {:.0f} % of the impact energy of {}", 100 * std::max(kept, 0.0),
                     brief_quantity(summary.energy.impact, "J", units, 3));
}

/// Force against displacement and penetration.
Panel loop_panel(const Solution& solution, const UnitSystem& units) {
  Panel panel{.title = title_of_loops(solution.summary, units),
              .x = axis_with_unit("Distance", "m", units),
              .y = axis_of("force", units)};
  panel.x.low = panel.y.low = 0;
  const auto add = [&](const char* key, const std::vector<double>& way) {
    panel.series.push_back({.label = result_quantity(key).title,
                            .style = SeriesStyle::solid_line,
                            .x = values_in(units, way, "m"),
                            .y = values_in(units, solution.history.force, "N"),
                            .has_arrow = true});
  };
  add("motion", solution.history.motion);
  add("penetration", solution.history.penetration);
  end_before_bottoming(panel.y, solution, panel.series.back().y);
  return panel;
}

}  // namespace

std::string peak_words(const injury::InjuryFigures& figures) {
  std::string words = fmt::format("peaks at {} g", brief(figures.peak.magnitude / standard_gravity, 3));
  // A pulse of less than 3 ms has no clip.
  if (figures.clip_3ms.level > 0)
    words += fmt::format(" and exceeds {} g for 3 ms", brief(figures.clip_3ms.level / standard_gravity, 3));
  return words;
}

Series hic_bracket(const char* key, const injury::Hic& hic, const std::string& value, double peak,
                   std::size_t palette_index, const UnitSystem& units, int row) {
  const double foot = (0.02 + 0.11 * row) * peak, arm = foot + 0.05 * peak;
  const double begin = value_in(units, hic.begin, "s"), end = value_in(units, hic.end, "s");
  return {.label = fmt::format("{} {}", result_quantity(key).title, value),
          .style = SeriesStyle::solid_line,
          .x = {begin, begin, end, end},
          .y = {arm, foot, foot, arm},
          .palette_index = palette_index,
          .label_place = LabelPlace::middle};
}

void add_clip(Panel& panel, double level, const std::string& value) {
  if (level != 0)
    panel.series.push_back({.label = fmt::format("{} {} g", result_quantity("clip_3ms").title, value),
                            .style = SeriesStyle::horizontal_line,
                            .y = {level}});
}

void end_before_bottoming(Axis& axis, const Solution& solution, const std::vector<double>& column) {
  if (!bottomed_on_rigid_support(solution.summary)) return;
  const std::vector<double>& penetration = solution.history.penetration;
  const double end = 0.99 * std::ranges::max(penetration);
  double highest = 0;
  for (std::size_t i = 0; i < column.size(); ++i)
    if (penetration[i] < end) highest = std::max(highest, column[i]);
  if (highest > 0) axis.high = 1.06 * highest;
}

void show_bottoming(Panel& panel, const Solution& solution, const std::vector<double>& column,
                    const UnitSystem& units) {
  panel.y.low = 0;
  end_before_bottoming(panel.y, solution, column);
  if (bottomed_on_rigid_support(solution.summary))
    panel.series.push_back({.label = "bottoms out",
                            .style = SeriesStyle::vertical_line,
                            .x = {value_in(units, solution.summary.bottomed->time, "s")}});
}

Panel deceleration_panel(const Solution& solution, const std::optional<injury::InjuryFigures>& injury,
                         const UnitSystem& units) {
  const std::string name = result_quantity("deceleration").title;
  Panel panel{.title = name, .x = axis_of("time", units), .y = axis_of("deceleration", units)};
  if (const auto& bottomed = solution.summary.bottomed; bottomed_on_rigid_support(solution.summary))
    panel.title = fmt::format("The pad bottoms out after {} at a remaining speed of {}",
                              brief_quantity(bottomed->time, "s", units, 3),
                              brief_quantity(bottomed->velocity, "m/s", units, 3));
  else if (injury)
    panel.title = "The deceleration " + peak_words(*injury);
  std::vector<double> deceleration;
  for (const double value : solution.history.acceleration) deceleration.push_back(-value / standard_gravity);
  show_bottoming(panel, solution, deceleration, units);
  if (injury) {
    const double clip = injury->clip_3ms.level / standard_gravity;
    panel.series.push_back(hic_bracket("hic15", injury->hic15, significant(injury->hic15.value, 4),
                                       injury->peak.magnitude / standard_gravity, 1, units));
    add_clip(panel, clip, significant(clip, 4));
  }
  panel.series.push_back({.label = name,
                          .style = SeriesStyle::solid_line,
                          .x = values_in(units, solution.history.time, "s"),
                          .y = std::move(deceleration),
                          .palette_index = 0});
  return panel;
}

Plot result_plot(const ImpactCase& impact, const Solution& solution,
                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units) {
  std::string source = fmt::format("dashpad {}", version());
  for (const Flag& flag : flags(solution.summary)) source += "; " + one_line(flag.text);
  return {.title = impact.title.empty() ? "Impact" : impact.title,
          .panels = {deceleration_panel(solution, injury, units), loop_panel(solution, units)},
          .source = source};
}

}  // namespace dashpad::output
