// [[impacts]] of a fit file.

#include <algorithm>
#include <cmath>
#include <iterator>
#include <string>
#include <utility>

#include "dashpad/input/case_file.hpp"
#include "fit/fit_tables.hpp"
#include "quantities/magnitude_bounds.hpp"

namespace dashpad::fit {

using input::Presence;
using input::TableReader;

namespace {

MeasuredFigure read_figure(TableReader& table, const ImpactFigureName& name) {
  MeasuredFigure figure{name.figure, 0, 0};
  figure.value = value_in(table, "value", name.unit);
  if (figure.value < 0)
    table.fault("value", "must not be below 0: all figures are magnitudes");
  else if (std::isfinite(figure.value))
    if (std::string rule = rule_of(measured_magnitudes(name.unit), figure.value, name.unit); !rule.empty())
      table.fault("value", std::move(rule));
  figure.deviation = value_or_share(table, "deviation", name.unit, figure.value);
  table.refuse_others();
  return figure;
}

}  // namespace

ImpactMeasurement read_impact(TableReader& table, const FitFolders& folders,
                              std::vector<input::InputFile>& files) {
  ImpactMeasurement impact;
  impact.file = table.text("case");
  if (!impact.file.empty()) {
    if (auto read = table.faults().take(input::read_case(folders.of_fit / impact.file, folders.materials))) {
      impact.impact = std::move(read->impact);
      impact.options = read->options;
      impact.states_neighbours = read->states_neighbours;
      std::ranges::move(read->files, std::back_inserter(files));
    }
  }
  for (const ImpactFigureName& name : impact_figure_names())
    if (auto figure = table.table(name.key, Presence::optional))
      impact.figures.push_back(read_figure(*figure, name));
  if (auto pulse = table.table("pulse", Presence::optional))
    impact.pulse = read_pulse(*pulse, folders, files);
  impact.is_held_out = flag_in(table, "hold_out");
  table.refuse_others();
  return impact;
}

}  // namespace dashpad::fit
