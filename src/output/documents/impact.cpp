#include "dashpad/output/impact.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

#include <fmt/format.h>

#include "dashpad/impact/flags.hpp"
#include "output/documents/basis.hpp"
#include "output/layout.hpp"
#include "output/page/html.hpp"
#include "output/plot/foam_figures.hpp"
#include "output/plot/impact_figures.hpp"
#include "output/result_rows.hpp"
#include "output/text/capitals.hpp"
#include "output/text/case_toml.hpp"
#include "output/text/foam_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

constexpr const char* plots_heading = "Plots";

bool strikes_through(const ImpactReport& report) {
  return is_struck_through(report.solution.summary.peak_penetration, report.impact.pad.thickness);
}

std::string answer(const ImpactReport& report, const UnitSystem& units) {
  const Summary& summary = report.solution.summary;
  if (!report.blows.empty()) return growth_text(report.impact, report.blows);
  if (bottomed_on_rigid_support(summary))
    return fmt::format("The pad bottoms out with the impactor still moving at {}",
                       brief_quantity(summary.bottomed->velocity, "m/s", units, 3));
  if (!summary.peak_acceleration) return outcome(summary);
  const bool is_struck = strikes_through(report);
  // Where the pad is struck through, the forces are not reliable beyond two digits.
  const auto shown = [&](double value, const char* unit) {
    const auto [scale, name] = shown_as(unit, units);
    return with_unit(brief(is_struck ? rounded_to(scale * value, 2) : scale * value, 3), name);
  };
  std::string peak = shown(*summary.peak_acceleration, result_quantity("peak_acceleration").si_unit);
  if (is_cut(summary)) return fmt::format("Peak at least {}; the run ends before the impact does", peak);
  peak = "peak " + peak + (report.injury ? ", HIC15 " + shown(report.injury->hic15.value, "1") : "");
  return is_struck ? "Less than 0.1 % of the pad thickness is left: " + peak : capitalised(peak);
}

/// Whether the peak depends on how the foam goes on beyond its tests, by more than a foam is known to.
bool is_guess(const Summary& summary) {
  const FigureInterval* const peak =
      summary.intervals ? summary.intervals->find("peak_acceleration") : nullptr;
  return peak != nullptr && 2 * peak->share_of(Source::continuation) > known_beyond_tests;
}

Tone tone_of(const ImpactReport& report) {
  const Summary& summary = report.solution.summary;
  if (bottomed_on_rigid_support(summary) || strikes_through(report)) return Tone::bad;
  return is_cut(summary) || is_guess(summary) ? Tone::doubtful : Tone::plain;
}

/// Removes the errors that need no remark from the rows, and says how large they are.
std::string take_errors(std::vector<ValueRow>& rows, const Summary& summary) {
  const double unremarkable = std::max(10 * summary.tolerance, 5e-3);  // hardly seen in four digits
  double largest = 0;
  bool some_left = false;
  for (ValueRow& row : rows) {
    if (row.error && *row.error <= unremarkable) {
      largest = std::max(largest, *row.error);
      row.error.reset();
    }
    some_left = some_left || row.error;
  }
  return fmt::format(
      "Estimated numerical error at most {}{}, energy residual {}; --all shows every figure with its error.",
      shown_error(largest), some_left ? " except where ± is shown" : "",
      percentage(std::abs(summary.energy.residual / summary.energy.impact)));
}

/// Marks the values of an interrupted run as lower bounds: the largest values may still grow.
void mark_bounds(std::vector<ValueRow>& rows) {
  for (ValueRow& row : rows)
    if (row.label.starts_with("Peak") && row.value != "none")
      row.value = "≥ " + row.value;
    else if (row.value != "none")
      row.remark = "so far" + (row.remark.empty() ? "" : ", " + row.remark);
}

/// The rows with the intervals of their figures.
std::vector<ValueRow> sure(std::vector<ValueRow> rows, const ImpactReport& report, const UnitSystem& units) {
  add_intervals(rows, report.solution.summary, units);
  return rows;
}

std::vector<ValueRow> figures_of(const ImpactReport& report, std::vector<ValueRow> rows,
                                 const UnitSystem& units) {
  const Summary& summary = report.solution.summary;
  rows = sure(std::move(rows), report, units);
  if (bottomed_on_rigid_support(summary)) {
    std::vector<ValueRow> of_bottoming = bottoming_figures(report.impact, summary, units);
    rows.insert(rows.begin(), of_bottoming.begin(), of_bottoming.end());
    // Figures without a finite value come last.
    std::stable_partition(rows.begin(), rows.end(), [](const ValueRow& row) { return row.value != "none"; });
  } else if (is_cut(summary)) {
    mark_bounds(rows);
  }
  return rows;
}

std::vector<std::string> subject_of(const ImpactReport& report) {
  std::string text = outcome(report.solution.summary);
  if (!report.blows.empty())
    text = fmt::format("Blow {}: {}", report.solution.summary.blow, uncapitalised(text));
  return {one_line(report.impact.title), text};
}

void add_blows(Document& document, const ImpactReport& report, const UnitSystem& units) {
  if (report.blows.empty()) return;
  for (const auto& [seen, detail] : {std::pair{Seen::in_brief, Detail::main}, {Seen::in_full, Detail::all}})
    document.sections.push_back({.heading = "The blows",
                                 .seen = seen,
                                 .paragraphs = reservations(report.blows),
                                 .tables = {blow_table(report.impact, report.blows, units, detail)}});
}

void add_plots(Document& document, const ImpactReport& report, const UnitSystem& units) {
  const Solution& solution = report.solution;
  for (Section& section : document.sections) {
    if (section.heading == basis_heading)
      if (std::optional<Plot> foam = foam_curve_plot(report.impact.pad, solution.summary, units))
        section.figures.push_back({.plot = *std::move(foam)});
    if (section.heading != plots_heading) continue;
    section.figures = impact_figures(report.impact, solution, report.injury, units);
    for (CaptionedPlot& figure : contact_figures(report.snapshots, units))
      section.figures.push_back(std::move(figure));
  }
}

/// The document without plots, which a page in several units draws only once.
Document texts_of(const ImpactReport& report, const UnitSystem& units) {
  const Summary& summary = report.solution.summary;
  const ImpactCase& impact = report.impact;
  std::vector<ValueRow> rows = main_rows(impact, summary, report.injury, units);
  const std::string errors = take_errors(rows, summary);
  Document document{.title = impact.title,
                    .lead = Lead{.answer = answer(report, units),
                                 .tone = tone_of(report),
                                 .subject = subject_of(report),
                                 .figures = figures_of(report, std::move(rows), units)},
                    .warnings = warnings(summary, units),
                    .is_one_impact = true};
  if (summary.status == Status::not_run) return document;
  add_blows(document, report, units);
  Section figures{.heading = "Figures",
                  .rows = {{report.blows.empty() ? "The impact" : "The last blow",
                            sure(summary_rows(impact, summary, units, Detail::all), report, units)}}};
  if (report.injury)
    figures.rows.push_back({"Injury metrics of this pulse",
                            sure(pulse_rows(*report.injury, units, Detail::all), report, units)});
  document.sections.push_back(std::move(figures));
  if (summary.intervals && !summary.intervals->figures.empty()) {
    document.sections.push_back({.seen = Seen::in_brief, .paragraphs = interval_paragraphs(summary, units)});
    document.sections.push_back({.heading = "Uncertainty of the figures",
                                 .paragraphs = interval_paragraphs(summary, units),
                                 .tables = {interval_table(summary, units)}});
  }
  std::vector<std::string> brief = case_lines(impact, units);
  brief.push_back(errors);
  document.sections.push_back({.seen = Seen::in_brief, .paragraphs = std::move(brief)});
  std::vector<Basis> basis = case_basis(impact, units);
  std::ranges::move(method_basis(impact, {report.injury.has_value(), summary.intervals.has_value()}),
                    std::back_inserter(basis));
  basis.push_back(solver_basis(summary));
  document.sections.push_back({.heading = basis_heading, .tables = {basis_table(basis)}});
  return document;
}

void add_case(Document& document, const ImpactReport& report) {
  document.sections.push_back({.heading = plots_heading, .seen = Seen::on_pages});
  document.sections.push_back(
      {.heading = "The case",
       .seen = Seen::on_pages,
       .paragraphs = {"This case, in SI units as computed, can be saved and solved with dashpad run."},
       .copy = case_toml(report.impact, report.options)});
}

std::string drawing_of(const ImpactReport& report, const UnitSystem& units) {
  ImpactCase last = report.impact;
  if (!report.blows.empty()) last.pad.earlier_penetration = report.blows.back().earlier_penetration;
  return impact_drawing(last, report.solution, units);
}

}  // namespace

Document impact_document(const ImpactReport& report, const UnitSystem& units, Pictures pictures) {
  Document document = texts_of(report, units);
  if (report.solution.summary.status == Status::not_run) return document;
  add_case(document, report);
  if (pictures == Pictures::left_out) return document;
  document.lead->drawing = drawing_of(report, units);
  document.lead->curve = Plot{.panels = {deceleration_panel(report.solution, report.injury, units)}};
  if (pictures == Pictures::drawn) add_plots(document, report, units);
  return document;
}

std::string impact_page(const ImpactReport& report, const UnitSystem& shown) {
  std::vector<DocumentInUnits> documents{{&shown, impact_document(report, shown, Pictures::drawn)}};
  for (const UnitSystem& other : unit_systems()) {
    if (other.name == shown.name) continue;
    documents.push_back({&other, texts_of(report, other)});
    documents.back().document.lead->drawing = drawing_of(report, other);
  }
  return to_html(std::move(documents));
}

}  // namespace dashpad::output
