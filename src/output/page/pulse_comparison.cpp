// A measured pulse over the computed one, as a page.

#include "dashpad/output/pulse_comparison.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/drawing/impact_drawing.hpp"
#include "dashpad/output/page/figures_page.hpp"
#include "dashpad/output/text/case.hpp"
#include "output/page/key_figures.hpp"
#include "output/result_rows.hpp"
#include "output/text/pulse_comparison_words.hpp"
#include "output/text/pulse_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

std::string pulse_comparison_page(const PulseComparisonReport& report, const UnitSystem& units) {
  FiguresPage page;
  page.title = comparison_answer(report);
  page.warnings = comparison_reservations(report, units);
  const Table table = comparison_table(report, units);
  Lead lead{.answer = page.title,
            .tone = !report.comparison.computed ? Tone::bad
                    : page.warnings.empty()     ? Tone::plain
                                                : Tone::doubtful,
            .subject = {fmt::format("{} over {}", report.pulse.file, report.case_file)}};
  lead.reservation = first_of(page.warnings);
  lead.drawing = impact_drawing(report.impact, report.solution, units);
  lead.curve = pulse_comparison_plot(report, units);
  lead.curve->title.clear();
  lead.curve->source.clear();
  for (const auto& row : table.rows) {
    if (!report.comparison.computed) break;
    const std::string &title = row[0], &unit = row[1], &measured = row[2], &computed = row[3],
                      &share = row[5];
    lead.figures.push_back(
        {.label = title,
         .value = share,
         .limit = fmt::format("{} for {} measured{}{}", computed, measured, unit.empty() ? "" : ", ", unit)});
  }
  page.lead = std::move(lead);
  std::vector<std::string> basis = comparison_notes(report, units);
  ImpactCase untitled = report.impact;
  untitled.title.clear();
  basis.push_back(case_text(untitled, units) + numbers_text(report.solution.summary) + ".");
  basis.push_back(pulse_source_sentence(report.pulse, units));
  page.sections = {
      {.heading = "Figures", .paragraphs = {}, .tables = {table}, .figures = {}},
      {.heading = "What it rests on", .paragraphs = std::move(basis), .tables = {}, .figures = {}}};
  return figures_page(page);
}

}  // namespace dashpad::output
