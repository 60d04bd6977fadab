// The tests held out, as tables.

#include <algorithm>

#include <fmt/format.h>

#include "report1986/validation_series.hpp"
#include "report1986/validation_tables.hpp"

namespace dashpad::report1986 {

output::Table held_out_table(const Study& study) {
  output::Table table{
      .columns = {"support", "quantity", "tests", "bias", "standard error", "scatter", "verdict"}};
  for (const HeldOutScore& score : study.held_out.scores) {
    std::string tests = fmt::format("{}", score.errors.size());
    if (score.missing > 0) tests += fmt::format(", {} without prediction", score.missing);
    table.rows.push_back({to_string(score.support), to_string(score.quantity), tests,
                          score.errors.empty() ? "-" : bias_text(score.bias, score.quantity),
                          score.standard_error ? scatter_text(*score.standard_error, score.quantity) : "-",
                          score.scatter ? scatter_text(*score.scatter, score.quantity) : "-",
                          passed_or_not(score.passed)});
  }
  return table;
}

output::Table held_out_errors_table(const Study& study) {
  output::Table table{.columns = {"test", "projectile", "support", "speed (mph)", "quantity", "measured",
                                  "predicted", "error"}};
  for (const HeldOutScore& score : study.held_out.scores)
    for (const TestError& error : score.errors) {
      const auto test = std::ranges::find(study.data.measured.tests, error.test, &MeasuredTest::number);
      table.rows.push_back({fmt::format("{}", error.test), to_string(test->projectile),
                            to_string(test->support), fmt::format("{:.1f}", test->speed_mph),
                            axis_label(score.quantity), with_digits(error.measured, score.quantity),
                            with_digits(error.predicted, score.quantity),
                            bias_text(error.error, score.quantity)});
    }
  return table;
}

output::Table fitted_foam_table(const Study& study) {
  struct Row {
    const char* name;
    double FittedFoam::*of;
  };
  constexpr Row rows[] = {{"plateau stress A (psi)", &FittedFoam::plateau_stress_psi},
                          {"densification stress B (psi)", &FittedFoam::densification_stress_psi},
                          {"densification exponent n", &FittedFoam::densification_exponent},
                          {"unloading shape SHAPE", &FittedFoam::unloading_shape}};
  output::Table table{.columns = {"number", "all readings", "without a fold"}};
  if (study.held_out.folds.empty()) return table;
  for (const auto& [name, of] : rows) {
    const auto [least, greatest] = std::ranges::minmax(study.held_out.folds, {}, of);
    table.rows.push_back({name, fmt::format("{:.1f}", study.held_out.foam.*of),
                          fmt::format("{:.1f} to {:.1f}", least.*of, greatest.*of)});
  }
  return table;
}

}  // namespace dashpad::report1986
