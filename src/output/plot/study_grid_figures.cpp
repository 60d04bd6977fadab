// Curves and maps of a grid, and cushion curves.

#include <algorithm>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "output/plot/drawing.hpp"
#include "output/plot/study_figures.hpp"
#include "output/text/study_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The largest number of bands in a plot; more would cover each other.
constexpr std::size_t max_bands = 3;

std::vector<double> scaled(std::vector<double> values, double scale) {
  for (double& value : values) value *= scale;
  return values;
}

std::string note_of(const GridPlane& plane) {
  std::string note = plane.is_median ? "Medians of the draws. " : "";
  if (!plane.at.empty()) note += "Other factors: " + plane.at + ".";
  return note;
}

std::size_t rows_in(const std::vector<Series>& lines) {
  std::size_t rows = 0;
  for (const Series& line : lines)
    if (is_line(line.style)) rows += line.x.size();
  return rows;
}

/// Rows of marks above all values, one for each line with rows that bottomed out, in its colour.
std::vector<Series> struck_through_above(const std::vector<Series>& series) {
  constexpr double between_rows = 0.05;
  const double above = above_all(series);
  const auto lines = std::ranges::count_if(series, is_line, &Series::style);
  std::vector<Series> all;
  for (const Series& line : series) {
    if (!is_line(line.style)) continue;
    Series marks = struck_through_marks();
    if (lines > 1) {
      marks = struck_through_marks(*line.palette_index);
      marks.label = line.label + ": bottomed out";
    }
    for (std::size_t place = 0; place < line.y.size(); ++place)
      if (std::isinf(line.y[place])) marks.x.push_back(line.x[place]);
    if (marks.x.empty()) continue;
    marks.y.assign(marks.x.size(), above + between_rows * double(all.size()) * (above > 0 ? above : 1));
    all.push_back(std::move(marks));
  }
  return all;
}

bool has_bands(const GridPlane& plane) { return plane.is_median && plane.values.size() <= max_bands; }

CaptionedPlot curves(const study::StudyAnswers& answers, const GridPlane& plane, std::size_t response,
                     const UnitSystem& units) {
  const std::string name = response_name(answers, response);
  const study::Factor& across = answers.study.factors[plane.across];
  Panel panel{
      .title = title_of(name), .x = axis_of_factor(across, units), .y = {.label = label(name, units)}};
  const std::size_t count = plane.values.size(), lines = std::min(count, max_lines_drawn);
  const std::vector<double> x = scaled(plane.across_levels, shown_as(across.unit, units).scale);
  const double y_scale = shown_as(si_unit_of(name), units).scale;
  for (std::size_t i = 0; i < lines; ++i) {
    const std::size_t line = lines < 2 ? 0 : i * (count - 1) / (lines - 1);
    panel.series.push_back(
        {.label = plane.lines ? factor_at(answers.study, *plane.lines, plane.line_levels[line], units) : "",
         .style = SeriesStyle::line,
         .x = x,
         .y = scaled(plane.values[line], y_scale),
         .palette_index = i});
    if (has_bands(plane))
      panel.series.push_back({.style = SeriesStyle::band,
                              .x = x,
                              .y = scaled(plane.low[line], y_scale),
                              .y2 = scaled(plane.high[line], y_scale),
                              .palette_index = i,
                              .of = panel.series.back().label});
  }
  panel.add(limit_lines(answers, name, SeriesStyle::horizontal_line, units));
  std::vector<Series> struck = struck_through_above(panel.series);
  std::size_t rows_struck = 0;
  for (const Series& marks : struck) rows_struck += marks.x.size();
  if (rows_struck == rows_in(panel.series))
    panel.y = {.label = panel.y.label, .has_numbers = false, .low = -1, .high = 0.1 * double(struck.size())};
  panel.add(std::move(struck));
  return study_figure(answers, fmt::format("{} against {}", title_of(name), factor_words(across.key)),
                      {panel},
                      (lines < count ? fmt::format("{} of {} levels are drawn. ", lines, count) : "") +
                          (has_bands(plane) ? "The bands contain 90 % of the draws. " : "") + note_of(plane));
}

/// The map of a response; none if no area can be filled.
std::optional<CaptionedPlot> map_of(const study::StudyAnswers& answers, const GridPlane& plane,
                                    std::size_t response, const UnitSystem& units) {
  const std::string name = response_name(answers, response);
  const study::Factor &across = answers.study.factors[plane.across],
                      &up = answers.study.factors[*plane.lines];
  const ScaledUnit shown = shown_as(si_unit_of(name), units);
  Panel panel{.title = title_of(name), .x = axis_of_factor(across, units), .y = axis_of_factor(up, units)};
  std::vector<std::vector<double>> values;
  double least = HUGE_VAL, greatest = -HUGE_VAL;
  for (const std::vector<double>& line : plane.values) {
    values.push_back(scaled(line, shown.scale));
    for (const double value : values.back()) {
      if (!std::isfinite(value)) continue;
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  }
  const std::vector<double> x = scaled(plane.across_levels, shown_as(across.unit, units).scale),
                            y = scaled(plane.line_levels, shown_as(up.unit, units).scale);
  panel.x.low = x.front();
  panel.x.high = x.back();
  panel.y.low = y.front();
  panel.y.high = y.back();
  const std::vector<double> levels = round_levels(least, greatest);
  panel.series = filled_areas(x, y, values, levels, shown.unit);
  if (panel.series.empty()) return std::nullopt;
  std::set<std::string> named;
  for (const Series& area : panel.series) named.insert(area.label);
  for (Series& dots : lone_dots(x, y, values, levels, shown.unit)) {
    // The area of the same colour has the name.
    if (named.contains(dots.label)) dots.label.clear();
    panel.series.push_back(std::move(dots));
  }
  for (const Series& limit : limit_lines(answers, name, SeriesStyle::horizontal_line, units)) {
    Series line = contour(x, y, values, limit.y.front());
    line.label = limit.label;
    if (!line.x.empty()) panel.series.push_back(std::move(line));
  }
  Series struck = struck_through_marks();
  for (std::size_t line = 0; line < y.size(); ++line)
    for (std::size_t place = 0; place < x.size(); ++place)
      if (std::isinf(values[line][place])) struck.add(x[place], y[line]);
  if (!struck.x.empty()) panel.series.push_back(std::move(struck));
  return study_figure(
      answers,
      fmt::format("{} against {} and {}", title_of(name), factor_words(across.key), factor_words(up.key)),
      {panel},
      "Interpolated linearly between neighbouring grid points; a dot is a row next to rows without a "
      "value. " +
          note_of(plane));
}

Panel cushion_panel(const study::CushionCurves::Drop& drop, bool whole_cushion, const UnitSystem& units) {
  const ScaledUnit height = shown_as("m", units), stress = shown_as("Pa", units),
                   speed = shown_as("m/s", units);
  Panel panel{.title = fmt::format("Drop height {} {} ({} {})", four_digits(height.scale * drop.height),
                                   height.unit, four_digits(speed.scale * drop.speed), speed.unit),
              .x = {.label = fmt::format("Static stress: weight divided by {} ({})",
                                         whole_cushion ? "the area of the cushion"
                                                       : "the contact area at the largest penetration",
                                         stress.unit),
                    .logarithmic = true},
              .y = {.label = "Peak acceleration (g)", .low = 0}};
  for (std::size_t i = 0; i < drop.curves.size(); ++i)
    panel.series.push_back(
        {.label = fmt::format("thickness {} {}", four_digits(height.scale * drop.curves[i].thickness),
                              height.unit),
         .style = SeriesStyle::line,
         .x = scaled(drop.curves[i].static_stress, stress.scale),
         .y = scaled(drop.curves[i].peak_deceleration, shown_as("m/s2", units).scale),
         .palette_index = i});
  return panel;
}

}  // namespace

std::vector<CaptionedPlot> curve_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::vector<CaptionedPlot> figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i)
    if (const std::optional<GridPlane> plane = grid_plane(answers, i, units))
      figures.push_back(curves(answers, *plane, i, units));
  return figures;
}

std::vector<CaptionedPlot> map_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  std::vector<CaptionedPlot> figures;
  for (std::size_t i = 0; i < answers.responses.size(); ++i) {
    const std::optional<GridPlane> plane = grid_plane(answers, i, units);
    if (!plane || !plane->lines || plane->line_levels.size() < 3 || plane->across_levels.size() < 3 ||
        answers.study.factors[*plane->lines].unit.empty())
      continue;
    if (std::optional<CaptionedPlot> map = map_of(answers, *plane, i, units))
      figures.push_back(*std::move(map));
  }
  return figures;
}

std::vector<CaptionedPlot> cushion_figures(const study::StudyAnswers& answers, const UnitSystem& units) {
  if (!answers.cushion_curves) return {};
  const bool whole_cushion = answers.cushion_curves->whole_cushion;
  const std::string nose = with_article(words_of(answers.study.base.impactor.nose));
  std::vector<Panel> panels;
  for (const study::CushionCurves::Drop& drop : answers.cushion_curves->drops) {
    panels.push_back(cushion_panel(drop, whole_cushion, units));
    panels.back().add(limit_lines(answers, "peak_acceleration", SeriesStyle::horizontal_line, units));
  }
  const std::string note = whole_cushion
                               ? fmt::format(
                                     "In the manner of ASTM D1596, for {} that covers the whole cushion. The "
                                     "curves are computed, not measured, for a cushion that does not bulge.",
                                     nose)
                               : fmt::format(
                                     "In the manner of ASTM D1596, but for {} instead of a platen wider than "
                                     "the cushion: the loaded area is the projected contact area at the "
                                     "largest penetration. Do not mix these curves with a manufacturer's.",
                                     nose);
  return {study_figure(answers, "Cushion curves for " + nose, std::move(panels), note)};
}

}  // namespace dashpad::output
