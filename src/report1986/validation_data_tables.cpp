// Tables of constants, claims, nose radius, lost readings and held-out tests, and the list of all tables.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "output/layout.hpp"
#include "quantities/text.hpp"
#include "report1986/validation/placings.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

std::string short_number(double value) { return fmt::format("{:.4g}", value); }

const char* yes_or_no(bool is_so) { return is_so ? "yes" : "NO"; }

std::string span(const Interval& interval) {
  return short_number(interval.low) + " to " + short_number(interval.high);
}

output::Table constants_table(const Study& study) {
  output::Table table{.columns = {"constant", "printed", "refitted", "95 % interval",
                                  "printed value in interval", "tests", "range over all assignments",
                                  "printed value in range", "95 % intervals over all assignments"}};
  for (const FittedConstant& constant : study.constants) {
    const bool has_placings = constant.placings > 1;
    table.rows.push_back({constant.title, with_unit(brief(constant.printed), shown_unit(constant.unit)),
                          with_unit(short_number(constant.value), shown_unit(constant.unit)),
                          span(constant.confidence), yes_or_no(constant.printed_in_confidence),
                          std::to_string(constant.tests.size()),
                          has_placings ? span(constant.over_placings) : "-",
                          has_placings ? yes_or_no(constant.printed_in_placings) : "-",
                          has_placings ? span(constant.confidence_over_placings) : "-"});
  }
  return table;
}

output::Table radius_table(const Study& study) {
  output::Table table{
      .columns = {"criterion", "readings", "favoured radius (in)", "95 % range (in)", "remark"}};
  for (const RadiusCriterion& criterion : study.radius.criteria) {
    const char* bound = !criterion.at_an_end                                               ? ""
                        : criterion.favoured_in < (min_radius_in + greatest_radius_in) / 2 ? "at most "
                                                                                           : "at least ";
    const bool has_one = std::isfinite(criterion.favoured_in);
    table.rows.push_back(
        {criterion.name, std::to_string(criterion.readings),
         has_one ? fmt::format("{}{:.2f}", bound, criterion.favoured_in) : "-",
         has_one ? fmt::format("{:.2f} to {:.2f}", criterion.admitted.low, criterion.admitted.high) : "-",
         criterion.remark});
  }
  return table;
}

output::Table unplaced_table(const Study& study) {
  output::Table table{.columns = {"column", "tests", "readings, in order"}};
  for (const UnplacedReadings& group : study.data.measured.unplaced) {
    std::string readings;
    for (const double reading : group.readings) readings += (readings.empty() ? "" : ", ") + brief(reading);
    table.rows.push_back({measured_column(group.column).words,
                          fmt::format("{} to {}", group.first_test, group.last_test), readings});
  }
  return table;
}

output::Table claims_table(const Study& study) {
  output::Table table{.columns = {"where", "statement", "printed", "computed", "agrees", "remark"}};
  for (const ReportClaim& claim : check_claims(study.data)) {
    table.rows.push_back({claim.where, claim.claim, with_unit(brief(claim.printed), shown_unit(claim.unit)),
                          with_unit(short_number(claim.computed), shown_unit(claim.unit)),
                          yes_or_no(claim.agrees), claim.remark});
  }
  return table;
}

output::Table held_out_table(const Study& study) {
  output::Table table{
      .columns = {"support", "quantity", "tests", "bias", "standard error", "scatter", "verdict"}};
  for (const HeldOutScore& score : study.held_out.scores) {
    table.rows.push_back(
        {to_string(score.support), to_string(score.quantity), tests_text(score.errors.size(), score.missing),
         score.errors.empty() ? "-" : bias_text(score.bias, score.quantity),
         score.standard_error ? scatter_text(*score.standard_error, score.quantity) : "-",
         score.scatter ? scatter_text(*score.scatter, score.quantity) : "-", passed_or_not(score.passed)});
  }
  return table;
}

output::Table held_out_errors_table(const Study& study) {
  output::Table table{.columns = {"test", "projectile", "support", "speed (mph)", "quantity", "measured",
                                  "predicted", "error"}};
  for (const HeldOutScore& score : study.held_out.scores)
    for (const TestError& error : score.errors) {
      const auto test = std::ranges::find(study.data.measured.tests, error.test, &MeasuredTest::number);
      table.rows.push_back({std::to_string(error.test), to_string(test->projectile), to_string(test->support),
                            fmt::format("{:.1f}", test->speed_mph), axis_label(score.quantity),
                            with_digits(error.measured, score.quantity),
                            with_digits(error.predicted, score.quantity),
                            bias_text(error.error, score.quantity)});
    }
  return table;
}

/// The foam fitted to all readings, and the range of each number over the folds.
output::Table fitted_foam_table(const Study& study) {
  struct Number {
    const char* name;
    double FittedFoam::*of;
  };
  constexpr Number rows[] = {{"plateau stress A (psi)", &FittedFoam::plateau_stress_psi},
                             {"densification stress B (psi)", &FittedFoam::densification_stress_psi},
                             {"densification exponent n", &FittedFoam::densification_exponent},
                             {"unloading shape SHAPE", &FittedFoam::unloading_shape}};
  output::Table table{.columns = {"parameter", "all readings", "one fold left out"}};
  if (study.held_out.folds.empty()) return table;
  for (const auto& [name, number] : rows) {
    const auto [least, greatest] = std::ranges::minmax(study.held_out.folds, {}, number);
    table.rows.push_back({name, fmt::format("{:.1f}", study.held_out.foam.*number),
                          fmt::format("{:.1f} to {:.1f}", least.*number, greatest.*number)});
  }
  return table;
}

}  // namespace

Tables validation_tables(const Study& study) {
  Tables tables{{"held-out", held_out_table(study)},       {"held-out-errors", held_out_errors_table(study)},
                {"fitted-foam", fitted_foam_table(study)}, {"constants", constants_table(study)},
                {"claims", claims_table(study)},           {"nose-radius", radius_table(study)},
                {"lost-readings", unplaced_table(study)}};
  add_verdict_tables(study, tables);
  return tables;
}

std::map<std::string, std::string> validation_markdown_tables(const Study& study) {
  std::map<std::string, std::string> texts;
  for (const auto& [name, table] : validation_tables(study)) texts[name] = output::markdown(table);
  return texts;
}

}  // namespace dashpad::report1986
