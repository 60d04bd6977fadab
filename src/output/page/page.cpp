#include "dashpad/output/page/page.hpp"

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
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Table table_of(std::string caption, const std::vector<ResultRow>& rows) {
  Table table{
      .caption = std::move(caption), .columns = {"Figure", "Value", "Estimated error", ""}, .rows = {}};
  for (const ResultRow& row : rows)
    table.rows.push_back(
        {row.label, shown_value(row), row.error ? "± " + shown_error(*row.error) : "", row.remark});
  return table;
}

bool strikes_through(const ImpactCase& impact, const Summary& summary) {
  return is_struck_through(summary.peak_penetration, impact.pad.thickness);
}

std::string answer(const ImpactCase& impact, const Summary& summary,
                   const std::optional<injury::InjuryFigures>& injury, const std::vector<BlowResult>& blows,
                   const UnitSystem& units) {
  if (!blows.empty()) {
    const std::string growth = growth_text(impact, blows);
    return growth.substr(0, growth.find_last_not_of('.') + 1);
  }
  if (bottomed_on_rigid_support(summary))
    return fmt::format("The pad bottoms out with {} left",
                       brief_quantity(summary.bottomed->velocity, "m/s", units, 3));
  if (!summary.peak_acceleration) return outcome(summary);
  std::string peak =
      brief_quantity(*summary.peak_acceleration, result_quantity("peak_acceleration").si_unit, units, 3);
  if (is_cut(summary)) return fmt::format("At least {}: the run ends before the impact does", peak);
  peak = "peak " + peak + (injury ? ", HIC15 " + brief(injury->hic15.value, 3) : "");
  return strikes_through(impact, summary) ? "Strikes through the pad: " + peak : capitalised(peak);
}

Tone tone_of(const ImpactCase& impact, const Summary& summary) {
  if (bottomed_on_rigid_support(summary) || strikes_through(impact, summary)) return Tone::bad;
  return is_cut(summary) ? Tone::doubtful : Tone::plain;
}

/// Of an impact that is cut the largest values may be larger.
std::vector<KeyFigure> figures_of(const Summary& summary, const std::vector<ResultRow>& rows) {
  std::vector<KeyFigure> figures = key_figures(rows);
  if (!is_cut(summary)) return figures;
  for (KeyFigure& figure : figures)
    if (figure.label.starts_with("Peak"))
      figure.value = "≥ " + figure.value;
    else
      figure.limit = "so far" + (figure.limit.empty() ? "" : ", " + figure.limit);
  return figures;
}

FiguresPage in_units(const ImpactCase& impact, const Options& options, const Solution& solution,
                     const UnitSystem& units, const std::vector<ContactSnapshot>& snapshots,
                     const std::vector<BlowResult>& blows) {
  const Summary& summary = solution.summary;
  const std::optional<injury::InjuryFigures> injury = injury::whole_pulse_figures(solution);
  ImpactCase untitled = impact;
  untitled.title.clear();
  FiguresPage page;
  page.title = impact.title;
  page.is_one_impact = true;
  page.warnings = warnings(summary, units);
  Lead lead{.answer = answer(impact, summary, injury, blows, units),
            .tone = tone_of(impact, summary),
            .subject = {one_line(impact.title), outcome(summary)}};
  lead.reservation = first_of(page.warnings);
  ImpactCase last = impact;
  if (!blows.empty()) last.pad.earlier_penetration = blows.back().earlier_penetration;
  lead.drawing = impact_drawing(last, solution, units);
  Panel deceleration = deceleration_panel(solution, injury, units);
  lead.curve = Plot{.title = {}, .panels = {std::move(deceleration)}, .source = {}};
  lead.figures = figures_of(summary, main_rows(impact, summary, injury, units));
  page.lead = std::move(lead);
  page.sections.push_back({.heading = "What it rests on", .paragraphs = {case_text(untitled, units)}});
  for (std::string& line : foam_basis(impact.pad, units))
    page.sections.back().paragraphs.push_back(std::move(line));
  if (std::optional<Plot> foam = foam_curve_plot(impact.pad, summary, units))
    page.sections.back().figures.push_back({.name = {}, .plot = *std::move(foam), .note = {}});
  PageSection figures{.heading = "Figures"};
  if (!blows.empty()) {
    figures.paragraphs.push_back(growth_text(impact, blows));
    for (std::string& reservation : reservations(blows)) figures.paragraphs.push_back(std::move(reservation));
    figures.tables.push_back(blow_table(impact, blows, units, Detail::main));
  }
  figures.tables.push_back(table_of(blows.empty() ? "The impact" : "The last blow",
                                    summary_rows(impact, summary, units, Detail::all)));
  if (injury)
    figures.tables.push_back(
        table_of("Injury figures of this pulse", pulse_rows(*injury, units, Detail::all)));
  page.sections.push_back(std::move(figures));
  PageSection plots{.heading = "Plots", .figures = impact_figures(impact, solution, injury, units)};
  for (CaptionedPlot& figure : contact_figures(snapshots, units)) plots.figures.push_back(std::move(figure));
  page.sections.push_back(std::move(plots));
  page.sections.push_back(
      {.heading = "The case",
       .paragraphs = {"In SI, as it was computed. Kept as a file, it is a case that dashpad run repeats.",
                      numbers_text(summary) + "."},
       .copy = case_toml(impact, options)});
  return page;
}

}  // namespace

std::string page(const ImpactCase& impact, const Options& options, const Solution& solution,
                 const UnitSystem& shown, const std::vector<ContactSnapshot>& snapshots,
                 const std::vector<BlowResult>& blows) {
  std::vector<PageInUnits> pages{{&shown, in_units(impact, options, solution, shown, snapshots, blows)}};
  for (const UnitSystem& other : unit_systems())
    if (other.name != shown.name)
      pages.push_back({&other, in_units(impact, options, solution, other, snapshots, blows)});
  return framed(html_of(pages));
}

}  // namespace dashpad::output
