// The validation for the terminal.

#include <fmt/format.h>

#include "output/text/table.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

/// The columns that fit a terminal.
output::Table narrow(const output::Table& table, const std::vector<std::size_t>& columns) {
  output::Table result;
  for (const std::size_t column : columns) result.columns.push_back(table.columns[column]);
  for (const auto& row : table.rows) {
    result.rows.emplace_back();
    for (const std::size_t column : columns) result.rows.back().push_back(row[column]);
  }
  return result;
}

}  // namespace

std::string validation_text(const Study& study) {
  const Tally accurate = tally(study, Program::accurate);
  std::string text = fmt::format(
      "Validation tests of Crash Padding Research, Volume III (1986), {} tests, in its units.\n"
      "The accurate solver passes {} of {} rules, which were fixed before the first run.\n\n",
      study.data.measured.tests.size(), accurate.passed, accurate.all);
  text += output::plain_text(narrow(verdict_table(study), {0, 1, 3, 4, 5, 6, 7, 10}));
  text += fmt::format(
      "\nAt a nose radius of {:.2f} in, which the first of these favours{}; bias over {} to {} in.\n"
      "Bias and scatter are of predicted / measured, for strain of the difference.\n",
      study.radius.favoured_in(),
      study.radius.criteria.front().at_an_end ? " (the end of the range: a bound, no estimate)" : "",
      brief(least_radius_in), brief(greatest_radius_in));
  text += output::plain_text(narrow(radius_table(study), {0, 1, 2, 3}));
  text += fmt::format(
              "\nA foam fitted to the tests ({} numbers, nose radius {} in), each predicted by a fit without "
              "it:\n",
              fitted_numbers, brief(held_out_radius_in)) +
          output::plain_text(held_out_table(study)) + seen_data + "\n";
  text += "\nRebound on the load cell, between what was measured and what Table 3-2 admits:\n" +
          output::plain_text(rebound_table(study));
  text += "\nThe anomaly of section 4, predicted over measured force:\n" +
          output::plain_text(anomaly_table(study, study.anomaly)) + "\n" +
          output::plain_text(anomaly_rules_table(study.anomaly));
  text += fmt::format(
      "\nThe report's statements on its own simulations come back with a nose radius of {:.2f} in.\n"
      "All programs there:\n",
      study.radius.of_the_report_in());
  text += output::plain_text(narrow(reports_radius_table(study), {0, 1, 3, 4, 5, 6, 10})) + "\n" +
          output::plain_text(anomaly_table(study, study.anomaly_at_the_reports_radius)) + "\n" +
          output::plain_text(anomaly_rules_table(study.anomaly_at_the_reports_radius));
  return text;
}

}  // namespace dashpad::report1986
