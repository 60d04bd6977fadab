#pragma once
/// The tables of the validation, for the terminal, the page and the document.

#include <string>
#include <vector>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad::report1986 {

/// Each program on each support for each quantity that was measured.
output::PageTable verdict_table(const Study& study);
/// The same at the radius that the report simulated with.
output::PageTable reports_radius_table(const Study& study);
/// On the load cell for each projectile alone.
output::PageTable by_projectile_table(const Study& study);
/// Readings whose tests are lost, in all placings.
output::PageTable placed_table(const Study& study);
/// The second rule of the rebound speed.
output::PageTable rebound_table(const Study& study);
/// The accurate solver at each radius: biases, and whether they pass.
output::PageTable score_over_radius_table(const Study& study);
/// Test by test: measured, the accurate solver at both radii and the program of 1984 at the report's.
output::PageTable error_table(const Study& study, Quantity quantity);
output::PageTable anomaly_table(const Study& study, const AnomalyVerdict& anomaly);
/// The three conditions and the conclusion.
output::PageTable anomaly_rules_table(const AnomalyVerdict& anomaly);

output::PageTable constants_table(const Study& study);
output::PageTable claims_table(const Study& study);
output::PageTable radius_table(const Study& study);
/// Readings whose test is lost.
output::PageTable unplaced_table(const Study& study);

struct NamedTable {
  std::string name;  ///< of its block in docs/validation.md
  output::PageTable table;
};
/// All of them, for the document.
std::vector<NamedTable> validation_tables(const Study& study);

/// "explains it", "explains it in part", "does not explain it".
const char* words(Explanation explanation);

/// "4 of 7": the accurate solver's scores that pass.
struct Tally {
  int passed = 0, all = 0;
};
Tally tally(const Study& study, Program program);

}  // namespace dashpad::report1986
