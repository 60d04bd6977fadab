// Figures as shares of their limits over the range of a key.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/output/margin.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/version.hpp"
#include "output/plot/study_figures.hpp"
#include "output/text/capitals.hpp"
#include "output/text/margin_words.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// Shares above it are left out, in per cent: where the pad bottoms out they are beyond any axis.
constexpr double max_share = 250;

Axis key_axis(const margin::Answer& answer, const UnitSystem& units) {
  const study::Factor factor{
      .key = answer.question.key, .unit = answer.question.unit, .lowest = {}, .highest = {}};
  Axis axis = axis_of_factor(factor, units);
  axis.logarithmic = answer.question.logarithmic;
  const double scale = shown_as(answer.question.unit, units).scale;
  axis.low = scale * answer.question.low;
  axis.high = scale * answer.question.high;
  return axis;
}

double in_axis(double share) { return share <= max_share ? share : no_value; }

Panel margin_panel(const margin::Answer& answer, const UnitSystem& units) {
  const double scale = shown_as(answer.question.unit, units).scale;
  Panel panel{.title = answer.question.chance ? fmt::format("Not exceeded in {} of the draws",
                                                            per_cent(answer.question.chance->probability))
                                              : "Figures over their limits",
              .x = key_axis(answer, units),
              .y = {.label = "Share of the limit (%)", .low = 0}};
  Series band{.label = "95 % interval", .style = SeriesStyle::band, .palette_index = 0};
  for (const margin::Place& place : answer.places) {
    if (!std::isfinite(place.low) || !(place.high > place.low)) continue;
    band.x.push_back(scale * place.value);
    band.y.push_back(in_axis(100 * share_of_limit(answer.limits[place.worst], place.low)));
    band.y2.push_back(std::min(100 * share_of_limit(answer.limits[place.worst], place.high), max_share));
  }
  if (band.x.size() > 1) panel.add(std::move(band));
  for (std::size_t i = 0; i < answer.limits.size(); ++i) {
    Series line{.label = capitalised(limit_title(answer, i)), .style = SeriesStyle::line, .palette_index = i};
    for (const margin::Place& place : answer.places)
      line.add(scale * place.value, in_axis(100 * place.figures[i] / answer.limits[i].value));
    panel.add(std::move(line));
  }
  panel.add(Series{.label = "limit", .style = SeriesStyle::horizontal_line, .y = {100}});
  Series turns{.label = "", .style = SeriesStyle::vertical_line};
  for (const margin::Turn& turn : answer.turns) turns.x.push_back(scale * turn.value);
  turns.y.assign(turns.x.size(), 0);
  if (!turns.x.empty()) panel.add(std::move(turns));
  return panel;
}

Panel share_panel(const margin::Answer& answer, const UnitSystem& units) {
  const double scale = shown_as(answer.question.unit, units).scale;
  Panel panel{.title = "Draws that keep all limits",
              .x = key_axis(answer, units),
              .y = {.label = "Share (%)", .low = 0, .high = 100}};
  Series line{.label = "draws that pass", .style = SeriesStyle::line, .palette_index = 0};
  for (const margin::Place& place : answer.places) line.add(scale * place.value, 100 * place.share);
  panel.add(std::move(line));
  panel.add(Series{.label = per_cent(answer.question.chance->probability),
                   .style = SeriesStyle::horizontal_line,
                   .y = {100 * answer.question.chance->probability}});
  return panel;
}

}  // namespace

Plot margin_plot(const margin::Answer& answer, const UnitSystem& units) {
  Plot plot{.title = margin_answer(answer, units),
            .panels = {margin_panel(answer, units)},
            .source = fmt::format("dashpad {}; {} impacts; {}", version(), answer.impacts,
                                  one_line(answer.question.impacts.front().impact.title))};
  if (answer.question.chance) plot.panels.push_back(share_panel(answer, units));
  return plot;
}

}  // namespace dashpad::output
