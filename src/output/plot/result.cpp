#include "dashpad/output/plot/result.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/hic_bracket.hpp"
#include "output/plot/impact_figures.hpp"
#include "output/plot/result_panels.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Series line(std::string label, std::vector<double> x, std::vector<double> y) {
  Series series;
  series.label = std::move(label);
  series.style = SeriesStyle::solid_line;
  series.x = std::move(x);
  series.y = std::move(y);
  return series;
}

/// What the pad made of the energy, where that is known.
std::string energy_words(const Summary& summary, const UnitSystem& units) {
  constexpr double rounding = 1e-9;
  const double kept = summary.energy_absorbed_fraction;
  if (summary.status != Status::released || !(kept > -rounding && kept < 1 + rounding)) return {};
  return fmt::format("Of an impact energy of {} the pad keeps {:.0f} %",
                     brief_quantity(summary.energy.impact, "J", units, 3), 100 * std::max(kept, 0.0));
}

std::string bottoming_words(const Moment& bottomed, const UnitSystem& units) {
  return fmt::format("The pad bottoms out after {} with {} left",
                     brief_quantity(bottomed.time, "s", units, 3),
                     brief_quantity(bottomed.velocity, "m/s", units, 3));
}

/// Force over displacement and penetration.
Panel loop_panel(const Solution& solution, const UnitSystem& units) {
  const History& history = solution.history;
  Panel panel{"Force over displacement and penetration",
              axis_with_unit("Distance", "m", units),
              axis_of("force", units),
              {}};
  panel.x.low = panel.y.low = 0;
  panel.series.push_back(line(result_quantity("motion").title, values_in(units, history.motion, "m"),
                              values_in(units, history.force, "N")));
  panel.series.push_back(line(result_quantity("penetration").title,
                              values_in(units, history.penetration, "m"),
                              values_in(units, history.force, "N")));
  for (Series& loop : panel.series) loop.has_arrow = true;
  end_before_bottoming(panel.y, solution, panel.series.back().y);
  return panel;
}

}  // namespace

std::string peak_words(const injury::InjuryFigures& figures) {
  std::string words = fmt::format("peaks at {} g", brief(figures.peak.magnitude / standard_gravity, 3));
  // A pulse of less than 3 ms has no clip.
  if (figures.clip_3ms.level > 0)
    words += fmt::format(" and holds {} g for 3 ms", brief(figures.clip_3ms.level / standard_gravity, 3));
  return words;
}

Panel deceleration_panel(const Solution& solution, const std::optional<injury::InjuryFigures>& injury,
                         const UnitSystem& units) {
  const Summary& summary = solution.summary;
  Panel panel{bottomed_on_rigid_support(summary) ? bottoming_words(*summary.bottomed, units)
              : injury                           ? "The deceleration " + peak_words(*injury)
                                                 : result_quantity("deceleration").title,
              axis_of("time", units),
              axis_of("deceleration", units),
              {}};
  panel.y.low = 0;
  std::vector<double> deceleration;
  for (const double value : solution.history.acceleration) deceleration.push_back(-value / standard_gravity);
  end_before_bottoming(panel.y, solution, deceleration);
  mark_bottoming(panel, solution, units);
  if (injury) {
    panel.series.push_back(
        hic_bracket(fmt::format("{} {}", result_quantity("hic15").title, significant(injury->hic15.value, 4)),
                    value_in(units, injury->hic15.begin, "s"), value_in(units, injury->hic15.end, "s"),
                    injury->peak.magnitude / standard_gravity, 1));
    // A pulse may be shorter than the clip.
    if (const double level = injury->clip_3ms.level / standard_gravity; level > 0)
      panel.series.push_back(
          {.label = fmt::format("{} {} g", result_quantity("clip_3ms").title, significant(level, 4)),
           .style = SeriesStyle::horizontal_line,
           .y = {level}});
  }
  panel.series.push_back(line(result_quantity("deceleration").title,
                              values_in(units, solution.history.time, "s"), std::move(deceleration)));
  panel.series.back().turn = 0;
  return panel;
}

Plot result_plot(const ImpactCase& impact, const Solution& solution,
                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units) {
  std::string source = fmt::format("dashpad {}", version());
  for (const Flag& flag : flags(solution.summary)) source += "; " + one_line(flag.text);
  const Summary& summary = solution.summary;
  Panel deceleration = deceleration_panel(solution, injury, units);
  Panel loop = loop_panel(solution, units);
  if (std::string words = energy_words(summary, units); !words.empty()) loop.title = std::move(words);
  return {impact.title.empty() ? "Impact" : impact.title, {std::move(deceleration), std::move(loop)}, source};
}

}  // namespace dashpad::output
