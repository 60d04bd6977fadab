#pragma once
/// The tables of the validation, for the terminal, the page and the document.

#include <string>
#include <vector>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad {

/// Each program on each support for each quantity that was measured.
PageTable verdict_table(const validation::Study& study);
/// The same at the radius that the report simulated with.
PageTable reports_radius_table(const validation::Study& study);
/// On the load cell for each projectile alone.
PageTable by_projectile_table(const validation::Study& study);
/// Readings whose tests are lost, in all placings.
PageTable placed_table(const validation::Study& study);
/// The second rule of the rebound speed.
PageTable rebound_table(const validation::Study& study);
/// The accurate solver at each radius: biases, and whether they pass.
PageTable score_over_radius_table(const validation::Study& study);
/// Test by test: measured, the accurate solver at both radii and the program of 1984 at the report's.
PageTable error_table(const validation::Study& study, validation::Quantity quantity);
PageTable anomaly_table(const validation::Study& study, const validation::AnomalyVerdict& anomaly);
/// The three conditions and the conclusion.
PageTable anomaly_rules_table(const validation::AnomalyVerdict& anomaly);

PageTable constants_table(const validation::Study& study);
PageTable claims_table(const validation::Study& study);
PageTable radius_table(const validation::Study& study);
/// Readings whose test is lost.
PageTable unplaced_table(const validation::Study& study);

struct NamedTable {
  std::string name;  ///< of its block in docs/validation.md
  PageTable table;
};
/// All of them, for the document.
std::vector<NamedTable> validation_tables(const validation::Study& study);

/// "explains it", "explains it in part", "does not explain it".
const char* words(validation::Explanation explanation);

/// "4 of 7": the accurate solver's scores that pass.
struct Tally {
  int passed = 0, all = 0;
};
Tally tally(const validation::Study& study, validation::Program program);

}  // namespace dashpad
