#include "dashpad/output/plot/result.hpp"

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/version.hpp"
#include "output/plot/axis_with_unit.hpp"
#include "output/plot/hic_bracket.hpp"
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

}  // namespace

Panel deceleration_panel(const History& history, const std::optional<injury::InjuryFigures>& injury,
                         const UnitSystem& units) {
  Panel panel{
      result_quantity("deceleration").title, axis_of("time", units), axis_of("deceleration", units), {}};
  panel.y.low = 0;
  std::vector<double> deceleration;
  for (const double value : history.acceleration) deceleration.push_back(-value / standard_gravity);
  if (injury) {
    panel.series.push_back(
        hic_bracket(fmt::format("{} {}", result_quantity("hic15").title, significant(injury->hic15.value, 4)),
                    value_in(units, injury->hic15.begin, "s"), value_in(units, injury->hic15.end, "s"),
                    injury->peak.magnitude / standard_gravity, 1));
    Series level;
    level.label = fmt::format("{} {} g", result_quantity("clip_3ms").title,
                              significant(injury->clip_3ms.level / standard_gravity, 4));
    level.style = SeriesStyle::horizontal_line;
    level.y = {injury->clip_3ms.level / standard_gravity};
    panel.series.push_back(level);
  }
  panel.series.push_back(line(result_quantity("deceleration").title, values_in(units, history.time, "s"),
                              std::move(deceleration)));
  panel.series.back().turn = 0;
  return panel;
}

Panel loop_panel(const History& history, const UnitSystem& units) {
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
  return panel;
}

Plot result_plot(const ImpactCase& impact, const Solution& solution,
                 const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units) {
  std::string source = fmt::format("dashpad {}", version());
  for (const Flag& flag : flags(solution.summary)) source += "; " + one_line(flag.text);
  return {impact.title.empty() ? "Impact" : impact.title,
          {deceleration_panel(solution.history, injury, units), loop_panel(solution.history, units)},
          source};
}

}  // namespace dashpad::output
