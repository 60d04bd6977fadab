// A measured pulse as a page: its figures first, then the curve, and what was done to it.

#include "dashpad/output/pulse.hpp"

#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/page/figures_page.hpp"
#include "output/page/key_figures.hpp"
#include "output/result_rows.hpp"
#include "output/text/pulse_words.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

Table table_of(const std::vector<ResultRow>& rows) {
  Table table{.caption = {}, .columns = {"Figure", "Value", "Where"}, .rows = {}};
  for (const ResultRow& row : rows) table.rows.push_back({row.label, shown_value(row), row.remark});
  return table;
}

}  // namespace

std::string pulse_page(const injury::PulseReport& report, const UnitSystem& units) {
  FiguresPage page;
  page.title = report.file;
  Lead lead{.subject = {report.file,
                        report.filter ? "Filter: " + filter_words(*report.filter) : "No filter applied"}};
  lead.figures = key_figures(report_rows(report, units, Detail::main));
  lead.answer = fmt::format(
      "Peak {}, HIC15 {}",
      brief_quantity(report.figures.peak.magnitude, result_quantity("peak_acceleration").si_unit, units, 3),
      brief(report.figures.hic15.value, 3));
  page.warnings = reservations(report);
  if (!page.warnings.empty()) {
    lead.tone = Tone::doubtful;
    lead.reservation = first_of(page.warnings);
  }
  lead.curve = pulse_plot(report, units);
  lead.curve->title.clear();
  lead.curve->source.clear();
  page.lead = std::move(lead);
  page.sections = {{.heading = "Figures", .tables = {table_of(report_rows(report, units, Detail::all))}},
                   {.heading = "What it rests on", .paragraphs = {pulse_source_sentence(report, units)}}};
  if (const std::string words = uncertainty_words(report.uncertainty, Detail::all); !words.empty())
    page.sections.front().paragraphs.push_back(words);
  if (const auto check = injury::speed_check(report))
    page.sections.back().paragraphs.insert(page.sections.back().paragraphs.begin(), check->text);
  return figures_page(page);
}

}  // namespace dashpad::output
