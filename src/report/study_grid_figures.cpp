// Curves and maps of a grid, and cushion curves.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "report/study_figures.hpp"
#include "report/study_grid.hpp"
#include "report/study_words.hpp"

namespace dashpad {

namespace {

constexpr std::size_t most_lines = 8;
constexpr std::size_t map_levels = 9;

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

Axis axis_of(const study::Factor& factor, const UnitSystem& units) {
  return {.label = label(factor.key, factor.unit, units)};
}

std::string name_of(const StudyAnswers& answers, std::size_t response) {
  return answers.study.responses[answers.responses[response]];
}

std::string note_of(const GridPlane& plane) {
  std::string note = plane.is_median ? "Medians of the draws. " : "";
  if (!plane.at.empty()) note += "At " + plane.at + ".";
  return note;
}

Plot curves(const StudyAnswers& answers, const GridPlane& plane, std::size_t response,
            const UnitSystem& units) {
  const std::string name = name_of(answers, response);
  const study::Factor& across = answers.study.factors[plane.across];
  Panel panel{.title = meaning_of(name),
              .x = axis_of(across, units),
              .y = {.label = label(name, si_unit_of(name), units)},
              .series = {}};
  const std::size_t count = plane.values.size(), lines = std::min(count, most_lines);
  for (std::size_t i = 0; i < lines; ++i) {
    const std::size_t line = lines < 2 ? 0 : i * (count - 1) / (lines - 1);
    panel.series.push_back(
        {.label = plane.lines
                      ? fmt::format("{} {}", answers.study.factors[*plane.lines].key,
                                    level_text(answers.study, *plane.lines, plane.line_levels[line], units))
                      : "",
         .style = SeriesStyle::line,
         .x = scaled(plane.across_levels, shown_as(across.unit, units).scale),
         .y = scaled(plane.values[line], shown_as(si_unit_of(name), units).scale),
         .turn = i});
  }
  for (const StudyLimit& limit : answers.limits)
    if (limit.response == name)
      panel.series.push_back({.label = "limit",
                              .style = SeriesStyle::horizontal_line,
                              .y = {shown_as(si_unit_of(name), units).scale * limit.value}});
  return {.title = fmt::format("{} over {}", name, across.key),
          .panels = {panel},
          .source = study_source(answers)};
}

/// Where the response takes a level between neighbours of the grid, by linear interpolation.
Series points_at(const GridPlane& plane, double level, double x_scale, double y_scale) {
  Series points{.style = SeriesStyle::points};
  const auto try_between = [&](double a, double b, double x1, double y1, double x2, double y2) {
    if (!(std::min(a, b) <= level && level < std::max(a, b))) return;
    const double part = (level - a) / (b - a);
    points.x.push_back(x_scale * (x1 + part * (x2 - x1)));
    points.y.push_back(y_scale * (y1 + part * (y2 - y1)));
  };
  for (std::size_t line = 0; line < plane.values.size(); ++line)
    for (std::size_t place = 0; place < plane.values[line].size(); ++place) {
      const double x = plane.across_levels[place], y = plane.line_levels[line],
                   value = plane.values[line][place];
      if (place > 0)
        try_between(plane.values[line][place - 1], value, plane.across_levels[place - 1], y, x, y);
      if (line > 0) try_between(plane.values[line - 1][place], value, x, plane.line_levels[line - 1], x, y);
    }
  return points;
}

/// Round values over the range of the responses: steps of 1, 2 or 5 times a power of ten.
std::vector<double> round_levels(const GridPlane& plane, double scale) {
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (const auto& line : plane.values)
    for (const double value : line) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, scale * value);
      greatest = std::max(greatest, scale * value);
    }
  if (!(greatest > least)) return {};
  const double rough = (greatest - least) / static_cast<double>(map_levels);
  const double power = std::pow(10, std::floor(std::log10(rough)));
  double step = 10 * power;
  for (const double part : {5.0, 2.0, 1.0})
    if (part * power >= rough) step = part * power;
  std::vector<double> levels;
  for (double count = std::ceil(least / step); count * step < greatest; ++count)
    levels.push_back(count * step);
  return levels;
}

Plot map_of(const StudyAnswers& answers, const GridPlane& plane, std::size_t response,
            const UnitSystem& units) {
  const std::string name = name_of(answers, response);
  const study::Factor &across = answers.study.factors[plane.across],
                      &up = answers.study.factors[*plane.lines];
  const ShownUnit shown = shown_as(si_unit_of(name), units);
  Panel panel{.title = meaning_of(name), .x = axis_of(across, units), .y = axis_of(up, units), .series = {}};
  std::size_t turn = 0;
  for (const double level : round_levels(plane, shown.scale)) {
    Series points = points_at(plane, level / shown.scale, shown_as(across.unit, units).scale,
                              shown_as(up.unit, units).scale);
    points.label = four_digits(level) + (shown.unit.empty() ? "" : " " + shown.unit);
    points.turn = turn++;
    panel.series.push_back(std::move(points));
  }
  return {.title = fmt::format("Where {} has the same value", name),
          .panels = {panel},
          .source = study_source(answers)};
}

Panel cushion_panel(const study::CushionCurves::Drop& drop, const UnitSystem& units) {
  const ShownUnit height = shown_as("m", units), stress = shown_as("Pa", units),
                  speed = shown_as("m/s", units);
  Panel panel{
      .title = fmt::format("Drop height {} {} ({} {})", four_digits(height.scale * drop.height), height.unit,
                           four_digits(speed.scale * drop.speed), speed.unit),
      .x = {.label = fmt::format("Static stress: weight over contact area at the largest penetration ({})",
                                 stress.unit),
            .logarithmic = true},
      .y = {.label = "Peak deceleration (g)", .low = 0},
      .series = {}};
  for (std::size_t i = 0; i < drop.curves.size(); ++i)
    panel.series.push_back(
        {.label = fmt::format("thickness {} {}", four_digits(height.scale * drop.curves[i].thickness),
                              height.unit),
         .style = SeriesStyle::line,
         .x = scaled(drop.curves[i].static_stress, stress.scale),
         .y = scaled(drop.curves[i].peak_deceleration, shown_as("m/s2", units).scale),
         .turn = i});
  return panel;
}

}  // namespace

std::vector<PageFigure> curve_figures(const StudyAnswers& answers, const UnitSystem& units) {
  std::vector<PageFigure> figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i)
    if (const std::optional<GridPlane> plane = grid_plane(answers, i, units))
      figures.push_back({"", curves(answers, *plane, i, units), note_of(*plane)});
  return figures;
}

std::vector<PageFigure> map_figures(const StudyAnswers& answers, const UnitSystem& units) {
  std::vector<PageFigure> figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::optional<GridPlane> plane = grid_plane(answers, i, units);
    if (!plane || !plane->lines || plane->line_levels.size() < 3 || plane->across_levels.size() < 3 ||
        answers.study.factors[*plane->lines].unit.empty())
      continue;
    Plot map = map_of(answers, *plane, i, units);
    if (map.panels.front().series.empty()) continue;
    figures.push_back(
        {"", std::move(map), "Interpolated linearly between neighbours of the grid. " + note_of(*plane)});
  }
  return figures;
}

std::vector<PageFigure> cushion_figures(const StudyAnswers& answers, const UnitSystem& units) {
  if (!answers.cushion_curves) return {};
  Plot plot{.title = "Cushion curves of a sphere", .panels = {}, .source = study_source(answers)};
  for (const study::CushionCurves::Drop& drop : answers.cushion_curves->drops)
    plot.panels.push_back(cushion_panel(drop, units));
  return {{"", std::move(plot),
           "In the manner of ASTM D1596, but of a sphere, not of the standard's flat platen: the loaded area "
           "is the "
           "projected contact area at the largest penetration. Do not mix them with a maker's curves."}};
}

}  // namespace dashpad
