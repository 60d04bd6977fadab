#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "quantities/text.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

namespace {

bool is_logarithmic(Quantity quantity) { return rule_of(quantity).logarithmic; }

/// Values are NaN if predictions are missing.
std::string decimals(double value) { return std::isfinite(value) ? fmt::format("{:.2f}", value) : "-"; }
std::string with_sign(double value) { return std::isfinite(value) ? fmt::format("{:+.2f}", value) : "-"; }
std::string with_signs(const Interval& interval) {
  if (!std::isfinite(interval.low) || !std::isfinite(interval.high)) return "-";
  return fmt::format("{:+.2f} to {:+.2f}", interval.low, interval.high);
}

bool is_judged(const Verdict& verdict) { return !verdict.score.errors.empty() || verdict.score.missing > 0; }

/// The predicted value and the error of a program in a test, or dashes.
std::vector<std::string> error_cells(const std::vector<Verdict>& verdicts, const MeasuredTest& test,
                                     Program program, Quantity quantity) {
  for (const auto& [score, bias, scatter, passed, radii] : verdicts) {
    if (score.program != program || score.support != test.support || score.quantity != quantity) continue;
    const auto error = std::ranges::find(score.errors, test.number, &TestError::test);
    if (error != score.errors.end())
      return {with_digits(error->predicted, quantity), bias_text(error->error, quantity)};
  }
  return {"-", "-"};
}

struct ErrorColumn {
  Program program;
  double radius_in;
  const std::vector<Verdict>& verdicts;
};
std::vector<ErrorColumn> error_columns(const Study& study) {
  const double favoured = study.radius.favoured_in(), of_the_report = study.radius.of_the_report_in();
  return {{Program::accurate, favoured, study.verdicts},
          {Program::accurate, of_the_report, study.at_the_reports_radius},
          {Program::printed_1984, of_the_report, study.at_the_reports_radius}};
}

output::Table table_of(const std::vector<Verdict>& verdicts) {
  output::Table table{.columns = {"program", "support", "projectile", "quantity", "tests", "bias", "scatter",
                                  "bias, all radii", "scatter, all radii", "radii that pass", "verdict"}};
  for (const Verdict& verdict : verdicts) {
    if (!is_judged(verdict)) continue;
    const Score& score = verdict.score;
    const Quantity quantity = score.quantity;
    const auto span = [&](const Interval& interval, auto shown) {
      return fmt::format("{} to {}", shown(interval.low, quantity), shown(interval.high, quantity));
    };
    table.rows.push_back({to_string(score.program), to_string(score.support),
                          score.projectile ? to_string(*score.projectile) : "all", to_string(quantity),
                          tests_text(score.errors.size(), score.missing),
                          score.errors.empty() ? "-" : bias_text(score.bias, quantity),
                          score.errors.size() < 2 ? "-" : scatter_text(score.scatter, quantity),
                          score.errors.empty() ? "-" : span(verdict.bias_over_radii, bias_text),
                          score.errors.size() < 2 ? "-" : span(verdict.scatter_over_radii, scatter_text),
                          fmt::format("{} of {}", verdict.radii_passed, verdict.radii),
                          passed_or_not(score.passed)});
  }
  return table;
}

output::Table placed_table(const Study& study) {
  output::Table table{.columns = {"program", "quantity", "tests", "readings", "assignments", "mean bias",
                                  "bias over all assignments", "assignments that would pass"}};
  for (const PlacedScore& placed : study.placed) {
    const UnplacedReadings& group = placed.group;
    const auto shown = [&](double bias) { return bias_text(bias, placed.quantity); };
    table.rows.push_back(
        {to_string(placed.program), to_string(placed.quantity),
         fmt::format("{} to {}", group.first_test, group.last_test), std::to_string(group.readings.size()),
         std::to_string(placed.placings), placed.placings == 0 ? "-" : shown(placed.bias),
         placed.placings == 0
             ? "-"
             : shown(placed.bias_over_placings.low) + " to " + shown(placed.bias_over_placings.high),
         std::to_string(placed.placings_passed)});
  }
  return table;
}

output::Table rebound_table(const Study& study) {
  output::Table table{
      .columns = {"program", "tests", "admissible", "too low", "too high", "without prediction", "verdict"}};
  for (const Admissible& rebound : study.rebounds)
    table.rows.push_back({to_string(rebound.program), std::to_string(rebound.tests),
                          std::to_string(rebound.admissible), std::to_string(rebound.too_low),
                          std::to_string(rebound.too_high), std::to_string(rebound.missing),
                          passed_or_not(rebound.passed)});
  return table;
}

output::Table error_table(const Study& study, Quantity quantity) {
  output::Table table{.columns = {"test", "projectile", "support", "speed (mph)", "measured"}};
  for (const ErrorColumn& column : error_columns(study)) {
    table.columns.push_back(fmt::format("{}, {:.2f} in", to_string(column.program), column.radius_in));
    table.columns.emplace_back("error");
  }
  for (const MeasuredTest& test : study.data.measured.tests) {
    const std::optional<double> value = measured(test, quantity);
    if (!value) continue;
    std::vector<std::string> row{std::to_string(test.number), to_string(test.projectile),
                                 to_string(test.support), fmt::format("{:.1f}", test.speed_mph),
                                 with_digits(*value, quantity)};
    for (const ErrorColumn& column : error_columns(study))
      for (std::string& cell : error_cells(column.verdicts, test, column.program, quantity))
        row.push_back(std::move(cell));
    table.rows.push_back(std::move(row));
  }
  return table;
}

/// Bias and verdict of the accurate solver at each radius.
output::Table score_over_radius_table(const Study& study) {
  output::Table table{.columns = {"nose radius (in)"}};
  struct Column {
    TestSupport support;
    Quantity quantity;
  };
  std::vector<Column> columns;
  for (const Verdict& verdict : study.verdicts) {
    if (verdict.score.program != Program::accurate || !is_judged(verdict)) continue;
    columns.push_back({verdict.score.support, verdict.score.quantity});
    table.columns.push_back(
        fmt::format("{}, {}", to_string(verdict.score.quantity), to_string(verdict.score.support)));
  }
  for (const double radius : study.radius.radii_in) {
    std::vector<std::string> row{fmt::format("{:.2f}", radius)};
    for (const auto& [support, quantity] : columns) {
      const Score one =
          score(study.data.measured, study.at_tests, Program::accurate, support, quantity, radius);
      row.push_back(bias_text(one.bias, quantity) + ", " + passed_or_not(one.passed));
    }
    table.rows.push_back(std::move(row));
  }
  return table;
}

output::Table anomaly_table(const Study& study, const AnomalyVerdict& anomaly) {
  output::Table table{
      .columns = {"program", "tests", "slope", "95 % interval", "slope, aluminium", "95 % interval"},
      .rows = {{"report", "-", "-", "-", "-", "-"}}};
  for (const PrintedRatio& printed : printed_ratios) {
    table.columns.push_back(fmt::format("{}, {} mph", to_string(printed.projectile), printed.speed_mph));
    table.rows.front().push_back(brief(study.data.constant(printed.constant)));
  }
  for (const ForceTrend& trend : anomaly.trends) {
    std::vector<std::string> row{
        to_string(trend.program),         std::to_string(trend.tests),
        with_sign(trend.slope),           with_signs(trend.slope_confidence),
        with_sign(trend.aluminium_slope), with_signs(trend.aluminium_slope_confidence)};
    for (const PrintedRatio& printed : printed_ratios) row.push_back(decimals(trend.*printed.ours));
    table.rows.push_back(std::move(row));
  }
  return table;
}

output::Table anomaly_rules_table(const AnomalyVerdict& anomaly) {
  const auto met = [](bool is_met) { return is_met ? "met" : "NOT MET"; };
  return {.columns = {"condition", "outcome"},
          .rows = {{"1. the first slope alone gives the report's ratios to within 25 %",
                    met(anomaly.first_slope_gives_the_fall)},
                   {"2. with the support as specified, the fall disappears and the peak forces pass",
                    met(anomaly.curve_removes_the_fall)},
                   {"the slope is at least halved", met(anomaly.slope_halves)},
                   {"the support defect therefore", words(anomaly.explanation)}}};
}

}  // namespace

std::string bias_text(double value, Quantity quantity) {
  return is_logarithmic(quantity) ? fmt::format("{:+.1f} %", 100 * value) : fmt::format("{:+.3f}", value);
}

std::string scatter_text(double value, Quantity quantity) {
  return is_logarithmic(quantity) ? fmt::format("{:.1f} %", 100 * value) : fmt::format("{:.3f}", value);
}

std::string tests_text(std::size_t tests, int missing) {
  return missing > 0 ? fmt::format("{}, plus {} without prediction", tests, missing) : std::to_string(tests);
}

const char* passed_or_not(bool passed) { return passed ? "pass" : "FAIL"; }

Tally tally(const Study& study, Program program) {
  Tally tally;
  for (const Verdict& verdict : study.verdicts)
    if (verdict.score.program == program && is_judged(verdict)) tally.count(verdict.score.passed);
  for (const Admissible& rebound : study.rebounds)
    if (rebound.program == program) tally.count(rebound.passed);
  return tally;
}

bool passes(const Study& study) { return tally(study, Program::accurate).passes_all(); }

const char* words(Explanation explanation) {
  switch (explanation) {
    case Explanation::explains: return "explains it";
    case Explanation::in_part: return "explains it in part";
    case Explanation::does_not: return "does not explain it";
  }
  return "";
}

void add_verdict_tables(const Study& study, Tables& tables) {
  tables["verdict"] = table_of(study.verdicts);
  tables["verdict-at-the-reports-radius"] = table_of(study.at_the_reports_radius);
  tables["by-projectile"] = table_of(study.by_projectile);
  tables["over-radii"] = score_over_radius_table(study);
  tables["placed"] = placed_table(study);
  tables["rebound"] = rebound_table(study);
  tables["anomaly"] = anomaly_table(study, study.anomaly);
  tables["anomaly-rules"] = anomaly_rules_table(study.anomaly);
  tables["anomaly-at-the-reports-radius"] = anomaly_table(study, study.anomaly_at_the_reports_radius);
  tables["anomaly-rules-at-the-reports-radius"] = anomaly_rules_table(study.anomaly_at_the_reports_radius);
  tables["errors-peak-force"] = error_table(study, Quantity::peak_force);
  tables["errors-time-to-peak"] = error_table(study, Quantity::time_to_peak);
  tables["errors-rebound-speed"] = error_table(study, Quantity::rebound_speed);
  tables["errors-peak-strain"] = error_table(study, Quantity::peak_strain);
}

}  // namespace dashpad::report1986
