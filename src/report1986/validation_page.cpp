#include <algorithm>

#include <fmt/format.h>

#include "output/layout.hpp"
#include "quantities/text.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

std::vector<output::CaptionedPlot> chosen(const std::vector<ValidationFigure>& figures,
                                          const std::vector<std::string>& slugs) {
  std::vector<output::CaptionedPlot> result;
  for (const ValidationFigure& figure : figures)
    if (std::ranges::find(slugs, figure.slug) != slugs.end())
      result.push_back({figure.name, figure.plot, figure.note});
  return result;
}

/// A table with a caption; if `columns` are given, only those, for a terminal.
output::Table captioned(std::string caption, const Tables& tables, const char* name,
                        const std::vector<std::size_t>& columns = {}) {
  const output::Table& table = tables.at(name);
  if (columns.empty()) return output::captioned(std::move(caption), table);
  output::Table result{.caption = std::move(caption)};
  for (const std::size_t column : columns) result.columns.push_back(table.columns[column]);
  for (const auto& row : table.rows) {
    result.rows.emplace_back();
    for (const std::size_t column : columns) result.rows.back().push_back(row[column]);
  }
  return result;
}

output::Section verdict_section(const Study& study, const Tables& tables,
                                const std::vector<ValidationFigure>& figures) {
  return {
      .heading = "Verdict",
      .paragraphs =
          {"The rules were fixed before the first run. The bias must be within 15 % for peak force and "
           "rebound, 10 % for time to peak and 0.05 for strain; the scatter must be at most 25 % for force, "
           "15 % for time and rebound, and 0.05 for strain. A score of fewer than two tests cannot pass.",
           "Bias is exp(mean of ln(predicted / measured)) - 1, and scatter is the standard deviation of the "
           "same logarithm; for strain, both are computed from the difference.",
           fmt::format(
               "The anomaly in section 4 is that the predicted forces fall with speed, from about 1 to 0.4 "
               "times the measured forces. According to the rules, the support defect {}.",
               words(study.anomaly.explanation))},
      .tables = {captioned("Predictions of the tests", tables, "verdict"),
                 captioned("Rebound on the load cell (at least 80 % of the tests must lie between 0.95 times "
                           "the measured speed and 1.05 times the bound from Table 3-2)",
                           tables, "rebound"),
                 captioned("On the load cell, each projectile separately", tables, "by-projectile"),
                 captioned("Anomaly: force ratio", tables, "anomaly"),
                 captioned("Anomaly: rules", tables, "anomaly-rules"),
                 captioned(fmt::format("Predictions of the tests at a nose radius of {:.2f} in, the value "
                                       "suggested by the report's own simulations",
                                       study.radius.of_the_report_in()),
                           tables, "verdict-at-the-reports-radius"),
                 captioned("Anomaly at that radius: force ratio", tables, "anomaly-at-the-reports-radius"),
                 captioned("Anomaly at that radius: rules", tables, "anomaly-rules-at-the-reports-radius"),
                 captioned("Bias of the accurate solver as a function of nose radius", tables, "over-radii")},
      .figures = chosen(figures, {"force-ratio"})};
}

output::Section held_out_section(const Tables& tables) {
  return {
      .heading = "Predictions with a fitted foam",
      .paragraphs = {fmt::format("Instead of the report's law, these predictions use the law \"foam\" "
                                 "with {} fitted parameters and a nose radius of {} in. Each fit omits "
                                 "one of five groups of speeds on the load cell or one test on the plate.",
                                 fitted_numbers, brief(held_out_radius_in)),
                     seen_data},
      .tables = {captioned("Predictions of tests left out of the fit", tables, "held-out"),
                 captioned("Fitted foam", tables, "fitted-foam"),
                 captioned("Test by test", tables, "held-out-errors")}};
}

/// The part of the verdict for which a terminal has room.
output::Section brief_section(const Study& study, const Tables& tables) {
  return {
      .heading = "Verdict",
      .seen = output::Seen::in_brief,
      .paragraphs = {"Bias and scatter refer to predicted / measured or, for strain, to the difference.",
                     seen_data},
      .tables = {
          captioned(fmt::format("At a nose radius of {:.2f} in", study.radius.favoured_in()), tables,
                    "verdict", {0, 1, 3, 4, 5, 6, 10}),
          captioned("Nose radius favoured by each criterion", tables, "nose-radius", {0, 1, 2, 3}),
          captioned(
              fmt::format("Foam with {} fitted parameters, nose radius {} in, each test held out of its fit",
                          fitted_numbers, brief(held_out_radius_in)),
              tables, "held-out"),
          captioned("Rebound on the load cell: between the measured speed and the bound from Table 3-2",
                    tables, "rebound"),
          captioned("The anomaly in section 4: ratio of predicted to measured force", tables, "anomaly"),
          captioned("Anomaly: rules", tables, "anomaly-rules"),
          captioned(fmt::format("At a nose radius of {:.2f} in, as the report's own simulations suggest",
                                study.radius.of_the_report_in()),
                    tables, "verdict-at-the-reports-radius", {0, 1, 3, 4, 5, 6, 10}),
          captioned("Anomaly at that radius: force ratio", tables, "anomaly-at-the-reports-radius"),
          captioned("Anomaly at that radius: rules", tables, "anomaly-rules-at-the-reports-radius")}};
}

std::vector<std::string> warnings(const Study& study) {
  std::vector<std::string> texts;
  texts.push_back(fmt::format(
      "UNKNOWN RADIUS: the nose radius of the projectiles is not known. Scores are given at {:.2f} in, "
      "which the strains on the plate favour{}, and at {:.2f} in, which the report's own simulations "
      "suggest; ranges cover radii of {} to {} in.",
      study.radius.favoured_in(),
      study.radius.criteria.front().at_an_end ? " (the end of the range, so a bound, not an estimate)" : "",
      study.radius.of_the_report_in(), brief(min_radius_in), brief(greatest_radius_in)));
  texts.emplace_back(
      "RECONSTRUCTED: the static curve of the load cell (Figure 3-3) is lost; the curve used here is derived "
      "from slopes and energies in the report. All tests were known when the form of the foam was chosen.");
  return texts;
}

}  // namespace

output::Document validation_document(const Study& study, output::Pictures pictures) {
  const std::vector<ValidationFigure> figures =
      pictures == output::Pictures::drawn ? validation_figures(study) : std::vector<ValidationFigure>{};
  const Tables tables = validation_tables(study);
  output::Document page{
      .title = "Validation against the 1986 tests",
      .lead = validation_lead(study, pictures),
      .summary = {"The tests are compared with the accurate solver and the 1984 program. Units are those of "
                  "the report: lb, in, mph, ms."},
      .warnings = warnings(study)};
  page.sections = {
      brief_section(study, tables),
      verdict_section(study, tables, figures),
      held_out_section(tables),
      {.heading = "Errors test by test",
       .tables = {captioned(axis_label(Quantity::peak_force), tables, "errors-peak-force"),
                  captioned(axis_label(Quantity::time_to_peak), tables, "errors-time-to-peak"),
                  captioned(axis_label(Quantity::rebound_speed), tables, "errors-rebound-speed"),
                  captioned(axis_label(Quantity::peak_strain), tables, "errors-peak-strain")}},
      {.heading = "Measurements", .figures = chosen(figures, {"figure-3-3", "figure-3-6", "figure-3-7"})},
      {.heading = "Regressions",
       .paragraphs = {"The constants of the report's trend lines are refitted to the readings whose test is "
                      "known. \"Range over all assignments\" gives the smallest and largest values when the "
                      "other readings are assigned to tests in every way that the scan allows."},
       .tables = {captioned("Constants of the trend lines", tables, "constants")},
       .figures = chosen(figures, {"figure-3-4", "figure-3-5"})},
      {.heading = "Energy balance and statements in the report",
       .tables = {captioned("Statements that can be checked by calculation", tables, "claims")},
       .figures = chosen(figures, {"figure-3-8", "figure-3-9"})},
      {.heading = "Simulations",
       .figures = chosen(figures, {"figure-4-1", "figure-4-2", "figure-4-3", "figure-4-4", "figure-4-5"})},
      {.heading = "Nose radius",
       .tables = {captioned("Nose radius favoured by each criterion", tables, "nose-radius")},
       .figures = chosen(figures, {"nose-radius"})},
      {.heading = "What remains uncertain",
       .paragraphs =
           {"For some readings, the scan shows their order in a column but not the tests to which they "
            "belong. They are neither scored nor plotted."},
       .tables = {captioned("Readings whose test is unknown", tables, "lost-readings"),
                  captioned("Bias over all assignments that keep the order", tables, "placed")}}};
  return page;
}

}  // namespace dashpad::report1986
