// A fit for the terminal.

#include "dashpad/output/fit.hpp"

#include <fmt/format.h>

#include "dashpad/version.hpp"
#include "output/text/case_toml.hpp"
#include "output/text/fit_words.hpp"
#include "output/text/table.hpp"
#include "quantities/text.hpp"

namespace dashpad::output {

std::string fit_text(const fit::FitReport& report, const UnitSystem& units) {
  std::string text = report.title.empty() ? "" : one_line(report.title) + "\n";
  if (!report.converged)
    return text + "The fit did not converge: " + one_line(report.why_not) +
           ".\nThere is no card. Start nearer (start = ...), narrow the bounds, try more starts, or leave "
           "unknowns out that the data do not show.\n";
  text += fit_answer(report);
  if (const std::string added = words_on_added(report); !added.empty()) text += wrapped(added, 2) + "\n";
  text += "\n" + plain_text(table_of_unknowns(report, units));
  if (const auto open = open_matters(report); !open.empty()) {
    text += "\n";
    for (const std::string& line : open) text += wrapped(line, 2) + "\n";
  }
  if (!report.tests.empty())
    text += "\nModel minus test, root mean square, and its share of the largest stress\n" +
            plain_text(table_of_tests(report, units));
  if (!report.comparison.empty())
    text += "\nMeasured and model\n" + plain_text(table_of_comparison(report, units));
  if (!report.figures.empty()) text += "\n" + plain_text(table_of_figures(report, units));
  if (!report.pulses.empty()) text += "\n" + plain_text(table_of_pulses(report, units));
  if (!report.material.reservations.empty()) text += "\nReservations of the card\n";
  for (const std::string& line : report.material.reservations) text += wrapped("- " + line, 2) + "\n";
  text += "\n";
  for (const std::string& line : notes_on_noise(report)) text += wrapped(line, 2) + "\n";
  return text + fmt::format("{} evaluations in {} (dashpad {})\n", report.evaluations,
                            duration_words(report.wall_time), version());
}

std::string fitted_case_toml(const fit::FitReport& report) {
  return case_toml(report.fitted_case.value().impact, report.fitted_case->options);
}

std::string posterior_csv(const fit::FitReport& report) {
  std::string text;
  for (const fit::FittedUnknown& of : report.unknowns)
    text += fmt::format("{}{}{}", text.empty() ? "" : ",", of.key,
                        of.unit == "1" ? "" : fmt::format(" [{}]", of.unit));
  text += "\n";
  for (const std::vector<double>& draw : report.posterior) {
    std::string row;
    for (const double value : draw) row += fmt::format("{}{}", row.empty() ? "" : ",", value);
    text += row + "\n";
  }
  return text;
}

}  // namespace dashpad::output
