#pragma once
/// The tables of the validation, for the terminal, the page and the document.

#include <string>
#include <vector>

#include "dashpad/report1986/validation_report.hpp"

namespace dashpad::report1986 {

/// Each program on each support for each quantity that was measured.
output::Table verdict_table(const Study& study);
/// The same at the radius that the report simulated with.
output::Table reports_radius_table(const Study& study);
/// On the load cell for each projectile alone.
output::Table by_projectile_table(const Study& study);
/// Readings whose tests are lost, in all placings.
output::Table placed_table(const Study& study);
/// The second rule of the rebound speed.
output::Table rebound_table(const Study& study);
/// The accurate solver at each radius: biases, and whether they pass.
output::Table score_over_radius_table(const Study& study);
/// Test by test: measured, the accurate solver at both radii and the program of 1984 at the report's.
output::Table error_table(const Study& study, Quantity quantity);
output::Table anomaly_table(const Study& study, const AnomalyVerdict& anomaly);
/// The three conditions and the conclusion.
output::Table anomaly_rules_table(const AnomalyVerdict& anomaly);

/// Each quantity of each support as predicted by a foam that has not seen the test.
output::Table held_out_table(const Study& study);
/// What stands beside these scores.
inline constexpr const char* seen_data =
    "Seen data, no blind test: each test is predicted by a foam that was fitted without it, but the form of "
    "the foam was chosen with all tests in sight.";
/// The same test by test.
output::Table held_out_errors_table(const Study& study);
/// The fitted foam: by all readings, and from which to which value without those of a fold.
output::Table fitted_foam_table(const Study& study);

output::Table constants_table(const Study& study);
output::Table claims_table(const Study& study);
output::Table radius_table(const Study& study);
/// Readings whose test is lost.
output::Table unplaced_table(const Study& study);

/// "+12.3 %"; of strains the difference, "+0.012".
std::string bias_text(double value, Quantity quantity);
std::string scatter_text(double value, Quantity quantity);
/// With the digits that a reading of the quantity has.
std::string with_digits(double value, Quantity quantity);
const char* passed_or_not(bool passed);

struct NamedTable {
  std::string name;  ///< of its block in docs/validation.md
  output::Table table;
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

/// Whether Dashpad meets the tests, by the verdicts, and with which biases.
output::Lead validation_lead(const Study& study, output::Pictures pictures);

}  // namespace dashpad::report1986
