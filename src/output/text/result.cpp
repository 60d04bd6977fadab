#include "dashpad/output/text/result.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <vector>

#include <fmt/format.h>

#include "dashpad/output/text/case.hpp"
#include "output/blow_rows.hpp"
#include "output/result_rows.hpp"
#include "output/text/interval_words.hpp"
#include "output/text/table.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

namespace {

/// The largest error that needs no remark beside its figure: ten times the tolerance, or half a percent, of
/// which four digits show next to nothing.
double unremarkable(double tolerance) { return std::max(10 * tolerance, 5e-3); }

/// Takes the errors off the rows that they do not matter to; returns the largest of them.
double take_errors(std::vector<ResultRow>& rows, double tolerance) {
  double largest = 0;
  for (ResultRow& row : rows)
    if (row.error && *row.error <= unremarkable(tolerance)) {
      largest = std::max(largest, *row.error);
      row.error.reset();
    }
  return largest;
}

std::string intervals_text(const Summary& summary, const UnitSystem& units, Detail detail) {
  std::string text;
  for (const std::string& paragraph : interval_paragraphs(summary, units, detail))
    text += wrapped(paragraph, 2) + "\n";
  return text;
}

std::string main_text(const ImpactCase& impact, const Summary& summary,
                      const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units) {
  std::vector<ResultRow> rows = main_rows(impact, summary, injury, units);
  const double error = take_errors(rows, summary.tolerance);
  const bool some_left =
      std::ranges::any_of(rows, [](const ResultRow& row) { return row.error.has_value(); });
  add_intervals(rows, summary, units);
  std::string text = laid_out(rows);
  ImpactCase untitled = impact;
  untitled.title.clear();
  text += "\n" + intervals_text(summary, units, Detail::main) + wrapped_lines(case_text(untitled, units));
  return text +
         wrapped(fmt::format("Estimated numerical error at most {}{}, energy residual {}; "
                             "--all has every figure with its error.",
                             shown_error(error), some_left ? " except where ± is shown" : "",
                             percentage(std::abs(summary.energy.residual / summary.energy.impact))),
                 2) +
         "\n";
}

std::string full_text(const ImpactCase& impact, const Summary& summary,
                      const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units) {
  std::vector<ResultRow> rows = summary_rows(impact, summary, units, Detail::all);
  add_intervals(rows, summary, units);
  std::string text = laid_out(rows);
  if (injury) {
    rows = pulse_rows(*injury, units, Detail::all);
    add_intervals(rows, summary, units);
    text += "\nThe pulse:\n" + laid_out(rows);
  }
  ImpactCase untitled = impact;
  untitled.title.clear();
  return text + "\n" + intervals_text(summary, units, Detail::all) +
         wrapped_lines(case_text(untitled, units)) + wrapped(numbers_text(summary), 2) + "\n";
}

/// The answer to what a series is asked for, and its table.
std::string series_text(const ImpactCase& impact, const std::vector<BlowResult>& blows,
                        const UnitSystem& units, Detail detail) {
  if (blows.empty()) return "";
  std::string text = wrapped(growth_text(impact, blows), 2) + "\n\n";
  text += plain_text(blow_table(impact, blows, units, detail));
  for (const std::string& line : reservations(blows)) text += wrapped(line, 2) + "\n";
  return text + fmt::format("\nBlow {}:\n", blows.back().summary.blow);
}

}  // namespace

std::string result_text(const ImpactCase& impact, const Summary& summary,
                        const std::optional<injury::InjuryFigures>& injury, const UnitSystem& units,
                        Detail detail, const std::vector<BlowResult>& blows) {
  std::string text = impact.title.empty() ? "" : wrapped(one_line(impact.title), 2) + "\n";
  text += series_text(impact, blows, units, detail);
  text += outcome(summary) + "\n";
  for (const std::string& warning : warnings(summary, units)) text += wrapped(warning, 2) + "\n";
  if (summary.status == Status::not_run) return text;
  return text + "\n" + (detail == Detail::all ? full_text : main_text)(impact, summary, injury, units);
}

}  // namespace dashpad::output
