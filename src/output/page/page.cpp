#include "dashpad/output/page/page.hpp"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/output/drawing/impact_drawing.hpp"
#include "dashpad/output/page/figures_page.hpp"
#include "dashpad/output/plot/result.hpp"
#include "dashpad/output/text/case.hpp"
#include "output/blow_rows.hpp"
#include "output/page/html.hpp"
#include "output/page/key_figures.hpp"
#include "output/plot/foam_curve.hpp"
#include "output/plot/impact_figures.hpp"
#include "output/plot/result_panels.hpp"
#include "output/result_rows.hpp"
#include "output/text/capitals.hpp"
#include "output/text/case_toml.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/interval_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Table table_of(std::string caption, std::vector<ResultRow> rows, const Summary& summary,
               const UnitSystem& units) {
  add_intervals(rows, summary, units);
  Table table{.caption = std::move(caption),
              .columns = {"Figure", "Value", "95 % interval", "Numerical error", ""},
              .rows = {}};
  for (const ResultRow& row : rows)
    table.rows.push_back({row.label, shown_value(row), row.interval,
                          row.error ? "± " + shown_error(*row.error) : "", row.remark});
  return table;
}

bool strikes_through(const ImpactCase& impact, const Summary& summary) {
  return is_struck_through(summary.peak_penetration, impact.pad.thickness);
}

std::string answer(const ImpactCase& impact, const Summary& summary,
                   const std::optional<injury::InjuryFigures>& injury, const std::vector<BlowResult>& blows,
                   const UnitSystem& units) {
  if (!blows.empty()) return growth_text(impact, blows);
  if (bottomed_on_rigid_support(summary))
    return fmt::format("The pad bottoms out with {} left",
                       brief_quantity(summary.bottomed->velocity, "m/s", units, 3));
  if (!summary.peak_acceleration) return outcome(summary);
  const bool is_struck = strikes_through(impact, summary);
  // Of forces that are not to be relied on all digits but the first say nothing.
  const auto shown = [&](double value, const char* unit) {
    const auto [scale, name] = shown_as(unit, units);
    return brief(is_struck ? rounded_to(scale * value, 2) : scale * value, 3) +
           (name.empty() ? "" : " " + name);
  };
  std::string peak = shown(*summary.peak_acceleration, result_quantity("peak_acceleration").si_unit);
  if (is_cut(summary)) return fmt::format("At least {}: the run ends before the impact does", peak);
  peak = "peak " + peak + (injury ? ", HIC15 " + shown(injury->hic15.value, "1") : "");
  return is_struck ? "Strikes through the pad: " + peak : capitalised(peak);
}

/// Whether the peak depends on how the foam goes on beyond its tests, by more than a foam is known to.
bool is_guess(const Summary& summary) {
  const FigureInterval* const peak =
      summary.intervals ? summary.intervals->find("peak_acceleration") : nullptr;
  return peak != nullptr && 2 * peak->share_of(Source::continuation) > known_beyond_tests;
}

Tone tone_of(const ImpactCase& impact, const Summary& summary) {
  if (bottomed_on_rigid_support(summary) || strikes_through(impact, summary)) return Tone::bad;
  return is_cut(summary) || is_guess(summary) ? Tone::doubtful : Tone::plain;
}

/// Of an impact that is cut the largest values may be larger.
std::vector<KeyFigure> figures_of(const ImpactCase& impact, const Summary& summary,
                                  std::vector<ResultRow> rows, const UnitSystem& units) {
  if (bottomed_on_rigid_support(summary)) {
    // What has no finite value is no figure.
    std::erase_if(rows, [](const ResultRow& row) { return row.value == "none"; });
    std::vector<KeyFigure> figures = bottoming_figures(impact, summary, units);
    for (KeyFigure& figure : key_figures(rows))
      if (figures.size() < most_key_figures) figures.push_back(std::move(figure));
    return figures;
  }
  std::vector<KeyFigure> figures = key_figures(rows);
  if (!is_cut(summary)) return figures;
  for (KeyFigure& figure : figures)
    if (figure.label.starts_with("Peak"))
      figure.value = "≥ " + figure.value;
    else
      figure.limit = "so far" + (figure.limit.empty() ? "" : ", " + figure.limit);
  return figures;
}

std::vector<ResultRow> rows_with_intervals(const ImpactCase& impact, const Summary& summary,
                                           const std::optional<injury::InjuryFigures>& injury,
                                           const UnitSystem& units) {
  std::vector<ResultRow> rows = main_rows(impact, summary, injury, units);
  add_intervals(rows, summary, units);
  return rows;
}

/// Where the plots belong, among the sections below.
constexpr std::size_t basis_section = 0, plots_section = 2;

/// All but the plots, which are drawn once.
FiguresPage texts_in_units(const ImpactCase& impact, const Options& options, const Solution& solution,
                           const std::optional<injury::InjuryFigures>& injury,
                           const std::vector<BlowResult>& blows, const UnitSystem& units) {
  const Summary& summary = solution.summary;
  ImpactCase untitled = impact, last = impact;
  untitled.title.clear();
  if (!blows.empty()) last.pad.earlier_penetration = blows.back().earlier_penetration;
  FiguresPage page;
  page.title = impact.title;
  page.is_one_impact = true;
  page.warnings = warnings(summary, units);
  page.lead = Lead{
      .answer = answer(impact, summary, injury, blows, units),
      .tone = tone_of(impact, summary),
      .reservation = first_of(page.warnings),
      .subject = {one_line(impact.title), outcome(summary)},
      .drawing = impact_drawing(last, solution, units),
      .figures = figures_of(impact, summary, rows_with_intervals(impact, summary, injury, units), units)};
  PageSection basis{.heading = "What it rests on", .paragraphs = {case_text(untitled, units)}};
  for (std::string& line : foam_basis(impact.pad, units)) basis.paragraphs.push_back(std::move(line));
  PageSection figures{.heading = "Figures"};
  if (summary.intervals && !summary.intervals->figures.empty()) {
    basis.tables.push_back(interval_table(summary, units));
    basis.paragraphs.push_back(source_paragraph(*summary.intervals));
  }
  if (!blows.empty()) {
    figures.paragraphs.push_back(growth_text(impact, blows));
    for (std::string& reservation : reservations(blows)) figures.paragraphs.push_back(std::move(reservation));
    figures.tables.push_back(blow_table(impact, blows, units, Detail::main));
  }
  figures.tables.push_back(table_of(blows.empty() ? "The impact" : "The last blow",
                                    summary_rows(impact, summary, units, Detail::all), summary, units));
  if (injury)
    figures.tables.push_back(
        table_of("Injury figures of this pulse", pulse_rows(*injury, units, Detail::all), summary, units));
  PageSection of_case{
      .heading = "The case",
      .paragraphs = {"In SI, as it was computed. Kept as a file, it is a case that dashpad run repeats.",
                     numbers_text(summary) + "."},
      .copy = case_toml(impact, options)};
  page.sections = {std::move(basis), std::move(figures), {.heading = "Plots"}, std::move(of_case)};
  return page;
}

void add_plots(FiguresPage& page, const ImpactCase& impact, const Solution& solution,
               const std::optional<injury::InjuryFigures>& injury,
               const std::vector<ContactSnapshot>& snapshots, const UnitSystem& units) {
  page.lead->curve = Plot{.panels = {deceleration_panel(solution, injury, units)}};
  if (std::optional<Plot> foam = foam_curve_plot(impact.pad, solution.summary, units))
    page.sections[basis_section].figures.push_back({.plot = *std::move(foam)});
  std::vector<CaptionedPlot>& plots = page.sections[plots_section].figures;
  plots = impact_figures(impact, solution, injury, units);
  for (CaptionedPlot& figure : contact_figures(snapshots, units)) plots.push_back(std::move(figure));
}

}  // namespace

std::string page(const ImpactCase& impact, const Options& options, const Solution& solution,
                 const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots,
                 const std::vector<BlowResult>& blows) {
  const std::optional<injury::InjuryFigures> injury = injury::whole_pulse_figures(solution);
  std::vector<PageInUnits> pages{{&shown, texts_in_units(impact, options, solution, injury, blows, shown)}};
  add_plots(pages.front().page, impact, solution, injury, snapshots, shown);
  for (const UnitSystem& other : unit_systems())
    if (other.name != shown.name)
      pages.push_back({&other, texts_in_units(impact, options, solution, injury, blows, other)});
  return framed(html_of(pages));
}

}  // namespace dashpad::output
