// An assessment as a page: the verdict first, then why.

#include "dashpad/output/assessment.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/injury/figures.hpp"
#include "dashpad/output/drawing/impact_drawing.hpp"
#include "dashpad/output/page/figures_page.hpp"
#include "dashpad/output/text/case.hpp"
#include "dashpad/result/result_quantity.hpp"
#include "output/page/key_figures.hpp"
#include "output/plot/foam_curve.hpp"
#include "output/plot/impact_figures.hpp"
#include "output/plot/result_panels.hpp"
#include "output/result_rows.hpp"
#include "output/text/assessment_words.hpp"
#include "output/text/case_toml.hpp"
#include "output/text/foam_words.hpp"
#include "output/text/interval_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Tone tone_of(injury::Verdict verdict) {
  switch (verdict) {
    case injury::Verdict::pass: return Tone::good;
    case injury::Verdict::fail: return Tone::bad;
    case injury::Verdict::undecided: break;
  }
  return Tone::doubtful;
}

KeyFigure figure_of(const injury::CriterionResult& result, const UnitSystem& units) {
  const std::string unit = injury::quantity_of(result.criterion.metric).si_unit;
  KeyFigure figure{.label = injury::title_of(result.criterion)};
  figure.value = result.value
                     ? (result.lower_bound ? "≥ " : "") + brief_quantity(*result.value, unit, units, 3)
                     : "none";
  figure.limit =
      (result.criterion.strict ? "below " : "at most ") + brief_quantity(result.criterion.limit, unit, units);
  if (result.value && result.criterion.limit > 0) figure.share = *result.value / result.criterion.limit;
  if (const auto& interval = result.interval; interval && !interval->sources.empty()) {
    figure.limit = interval_words(*interval, units) + " at 95 %, " + figure.limit;
    if (figure.share)
      figure.share_range = {interval->low / result.criterion.limit, interval->high / result.criterion.limit};
  }
  figure.tone = tone_of(result.verdict);
  return figure;
}

/// The criteria, then figures to judge the impact by whatever the standard limits.
std::vector<KeyFigure> key_figures(const AssessmentReport& report, const UnitSystem& units) {
  const injury::Assessment& assessment = report.assessment;
  std::vector<KeyFigure> figures;
  for (const injury::CriterionResult& result : assessment.results)
    figures.push_back(figure_of(result, units));
  const auto add = [&](const char* key, const injury::Figure& of, const char* remark) {
    const ResultQuantity& quantity = result_quantity(key);
    const auto has_title = [&](const KeyFigure& figure) { return figure.label == quantity.title; };
    if (!of.value || figures.size() >= most_key_figures || std::ranges::any_of(figures, has_title)) return;
    figures.push_back(
        {.label = quantity.title,
         .value = (of.lower_bound ? "≥ " : "") + brief_quantity(*of.value, quantity.si_unit, units, 3),
         .limit = remark});
  };
  for (KeyFigure& figure : bottoming_figures(report.assessed, report.solution.summary, units))
    figures.push_back(std::move(figure));
  add("peak_acceleration", assessment.figures.peak_acceleration, "");
  add("peak_strain", assessment.figures.peak_strain,
      report.assessed.pad.layers.empty() ? "1 is a pad that is fully compressed"
                                         : "of all layers together; 1 is a pad that is fully compressed");
  add("hic15", assessment.figures.hic15, "");
  add("contact_end", assessment.figures.contact_end, "");
  add("rebound_speed", assessment.figures.rebound_speed, "");
  return figures;
}

/// The deceleration with the limits that are accelerations.
Plot deciding_curve(const AssessmentReport& report, const std::optional<injury::InjuryFigures>& injury,
                    const UnitSystem& units) {
  Panel panel = deceleration_panel(report.solution, injury, units);
  for (const injury::CriterionResult& result : report.assessment.results)
    if (injury::quantity_of(result.criterion.metric).si_unit == std::string_view("m/s2"))
      panel.series.push_back({.label = fmt::format("{}, {}", injury::limit_of(result.criterion),
                                                   brief_quantity(result.criterion.limit, "m/s2", units)),
                              .style = SeriesStyle::horizontal_line,
                              .y = {result.criterion.limit / standard_gravity},
                              .turn = 1});
  return {.title = {}, .panels = {std::move(panel)}, .source = {}};
}

}  // namespace

std::string assessment_page(const AssessmentReport& report, const UnitSystem& units) {
  const injury::Assessment& assessment = report.assessment;
  const std::optional<injury::InjuryFigures> injury = injury::whole_pulse_figures(report.solution);
  ImpactCase untitled = report.assessed;
  untitled.title.clear();
  FiguresPage page;
  page.title = report.assessed.title;
  page.is_one_impact = true;
  page.lead = Lead{.answer = assessment_answer(report, units),
                   .tone = doubt_about_pass(report).empty() ? tone_of(assessment.verdict) : Tone::doubtful,
                   .subject = {report.standard.title, page.title.empty() ? "" : "The case: " + page.title},
                   .drawing = impact_drawing(report.assessed, report.solution, units),
                   .curve = deciding_curve(report, injury, units),
                   .figures = key_figures(report, units)};
  for (const Flag& reservation : assessment.reservations) page.warnings.push_back(one_line(reservation.text));
  page.lead->reservation = first_of(page.warnings);
  std::vector<std::string> basis{case_text(untitled, units)};
  for (std::string& line : foam_basis(report.assessed.pad, units)) basis.push_back(std::move(line));
  std::vector<std::string> of_standard = assessment_basis(report, units);
  page.lead->subject.push_back(of_standard.front());
  for (std::string& line : of_standard) basis.push_back(std::move(line));
  basis.push_back(numbers_text(report.solution.summary) + ".");
  basis.push_back(assessment_caveat());
  page.sections.push_back({.heading = "Criteria", .tables = {criteria_table(report, units)}});
  if (const auto& intervals = report.solution.summary.intervals; intervals && !intervals->figures.empty()) {
    std::vector<std::string> limited;
    for (const injury::CriterionResult& of : assessment.results)
      limited.emplace_back(injury::quantity_of(of.criterion.metric).key);
    page.sections.back().tables.push_back(interval_table(report.solution.summary, units, limited));
    page.sections.back().paragraphs.push_back(source_paragraph(*intervals));
  }
  page.sections.push_back({.heading = "What it rests on", .paragraphs = std::move(basis)});
  if (std::optional<Plot> foam = foam_curve_plot(report.assessed.pad, report.solution.summary, units))
    page.sections.back().figures.push_back({.name = {}, .plot = *std::move(foam), .note = {}});
  page.sections.push_back(
      {.heading = "The impact", .figures = impact_figures(report.assessed, report.solution, injury, units)});
  page.sections.push_back(
      {.heading = "The case",
       .paragraphs = {"In SI, with the impactor of the standard. Kept as a file, it is a case "
                      "that dashpad run repeats."},
       .copy = case_toml(report.assessed, {})});
  return figures_page(page);
}

}  // namespace dashpad::output
