#include "dashpad/report1986/validation/verdict.hpp"

#include <algorithm>
#include <cmath>

#include "dashpad/report1986/validation/energy.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double least_admissible_fraction = 0.8;
constexpr double least_of_measured = 0.95;
constexpr double most_of_bound = 1.05;

}  // namespace

/// Fixed before the model was run (docs/decisions/0007-validation-rules.md): not to be touched.
const std::array<Rule, 4> rules{{
    {Quantity::peak_force, -0.15, 0.15, 0.25, true},
    {Quantity::time_to_peak, -0.10, 0.10, 0.15, true},
    {Quantity::rebound_speed, -0.15, 0.15, 0.15, true},
    {Quantity::peak_strain, -0.05, 0.05, 0.05, false},
}};

const Rule& rule_of(Quantity quantity) { return *std::ranges::find(rules, quantity, &Rule::quantity); }

const char* to_string(Quantity quantity) {
  switch (quantity) {
    case Quantity::peak_force: return "peak force";
    case Quantity::time_to_peak: return "time to peak force";
    case Quantity::rebound_speed: return "rebound speed";
    case Quantity::peak_strain: break;
  }
  return "peak strain";
}

std::optional<double> measured(const MeasuredTest& test, Quantity quantity) {
  switch (quantity) {
    case Quantity::peak_force: return test.peak_force_lb;
    case Quantity::time_to_peak: return test.time_to_peak_ms;
    case Quantity::rebound_speed: return test.rebound_mph;
    case Quantity::peak_strain: break;
  }
  return peak_strain(test);
}

std::optional<double> predicted(const Prediction& prediction, Quantity quantity) {
  switch (quantity) {
    case Quantity::peak_force: return prediction.peak_force_lb;
    case Quantity::time_to_peak: return prediction.time_to_peak_ms;
    case Quantity::rebound_speed: return prediction.rebound_mph;
    case Quantity::peak_strain: break;
  }
  return prediction.peak_strain;
}

double error_of(const Rule& rule, double measured, double predicted) {
  return rule.logarithmic ? std::log(predicted / measured) : predicted - measured;
}

TestError test_error(const Rule& rule, int test, double measured, double predicted) {
  return {test, measured, predicted, rule.logarithmic ? predicted / measured - 1 : predicted - measured};
}

Statistics judge(const Rule& rule, const std::vector<double>& errors) {
  Statistics statistics;
  if (errors.empty()) return statistics;
  const auto n = static_cast<double>(errors.size());
  double mean = 0, squares = 0;
  for (const double error : errors) mean += error / n;
  for (const double error : errors) squares += (error - mean) * (error - mean);
  statistics.bias = rule.logarithmic ? std::expm1(mean) : mean;
  if (errors.size() < 2) return statistics;
  statistics.scatter = std::sqrt(squares / (n - 1));
  statistics.passed =
      rule.low <= statistics.bias && statistics.bias <= rule.high && statistics.scatter <= rule.scatter;
  return statistics;
}

Score score(const MeasuredTests& measured_tests, const std::vector<Prediction>& predictions, Program program,
            TestSupport support, Quantity quantity, double radius_in, std::optional<Projectile> projectile) {
  Score score;
  score.program = program;
  score.support = support;
  score.quantity = quantity;
  score.radius_in = radius_in;
  score.projectile = projectile;
  const Rule& rule = rule_of(quantity);
  std::vector<double> errors;
  for (const MeasuredTest& test : measured_tests.tests) {
    const std::optional<double> reading = measured(test, quantity);
    if (test.support != support || !reading || (projectile && test.projectile != *projectile)) continue;
    const Prediction* prediction =
        find(predictions, program, {test.projectile, test.support, test.speed_mph, radius_in});
    const std::optional<double> value = prediction ? predicted(*prediction, quantity) : std::nullopt;
    if (!value) {
      ++score.missing;
      continue;
    }
    errors.push_back(error_of(rule, *reading, *value));
    score.errors.push_back(test_error(rule, test.number, *reading, *value));
  }
  const Statistics statistics = judge(rule, errors);
  score.bias = statistics.bias;
  score.scatter = statistics.scatter;
  score.passed = statistics.passed && score.missing == 0;
  return score;
}

std::optional<double> rebound_bound_mph(const ValidationData& data, const MeasuredTest& test) {
  if (test.support != TestSupport::load_cell || !test.rebound_mph || !test.peak_force_lb) return {};
  return expectation(data, test.projectile, test.speed_mph, *test.peak_force_lb,
                     *test.rebound_mph / test.speed_mph)
      .rebound_mph;
}

Admissible admissible_rebounds(const ValidationData& data, const std::vector<Prediction>& predictions,
                               Program program, double radius_in) {
  Admissible result;
  result.program = program;
  result.radius_in = radius_in;
  for (const MeasuredTest& test : data.measured.tests) {
    const std::optional<double> bound = rebound_bound_mph(data, test);
    if (!bound) continue;
    ++result.tests;
    const Prediction* prediction =
        find(predictions, program, {test.projectile, test.support, test.speed_mph, radius_in});
    if (!prediction || !prediction->rebound_mph)
      ++result.missing;
    else if (*prediction->rebound_mph < least_of_measured * *test.rebound_mph)
      ++result.too_low;
    else if (*prediction->rebound_mph > most_of_bound * *bound)
      ++result.too_high;
    else
      ++result.admissible;
  }
  result.passed = result.tests > 0 && result.admissible >= least_admissible_fraction * result.tests;
  return result;
}

}  // namespace dashpad::report1986
