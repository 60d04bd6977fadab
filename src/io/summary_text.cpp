#include "dashpad/io/summary_text.hpp"

#include <fmt/format.h>

#include "dashpad/io/case_text.hpp"
#include "io/summary_rows.hpp"

namespace dashpad {

namespace {

/// Figures right-aligned one below the other, each with its unit, error and a remark.
std::string laid_out(const SummaryRow& row) {
  std::string line = fmt::format("  {:<19}{:>11} {:<7} {:<12} {}", row.label, row.value, row.unit,
                                 row.error.empty() ? "" : "± " + row.error, row.remark);
  line.erase(line.find_last_not_of(' ') + 1);
  return line + "\n";
}

}  // namespace

std::string summary_text(const ImpactCase& impact, const Summary& summary, const UnitSystem& units) {
  std::string text = case_text(impact, units) + "\n" + outcome(summary) + "\n";
  for (const std::string& warning : warnings(summary, units)) text += warning + "\n";
  if (summary.status == Status::not_run) return text;
  text += "\n";
  for (const SummaryRow& row : summary_rows(impact, summary, units)) text += laid_out(row);
  return text + "\n" + numbers_text(summary) + "\n";
}

}  // namespace dashpad
