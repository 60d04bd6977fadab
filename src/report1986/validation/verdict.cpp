#include "dashpad/report1986/validation/verdict.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "dashpad/report1986/validation/energy.hpp"
#include "output/text/capitals.hpp"
#include "report1986/validation/placings.hpp"

namespace dashpad::report1986 {

namespace {

constexpr double min_admissible_fraction = 0.8;
constexpr double min_of_measured = 0.95;
constexpr double max_of_bound = 1.05;

struct QuantityFacts {
  const char* name;
  const char* unit;
  int decimals;  ///< of a reading
  std::optional<double> Prediction::*prediction;
};

/// Indexed by Quantity.
constexpr QuantityFacts facts[] = {{"peak force", "lb", 0, &Prediction::peak_force_lb},
                                   {"time to peak force", "ms", 2, &Prediction::time_to_peak_ms},
                                   {"rebound speed", "mph", 2, &Prediction::rebound_mph},
                                   {"peak strain", "1", 3, &Prediction::peak_strain}};

const QuantityFacts& of(Quantity quantity) { return facts[static_cast<std::size_t>(quantity)]; }

PlacedScore placed_score(const MeasuredTests& measured_tests, const std::vector<Prediction>& predictions,
                         Program program, double radius_in, const UnplacedReadings& group,
                         Quantity quantity) {
  const MeasuredTests alone{measured_tests.tests, {group}};
  std::vector<std::optional<double>> values;
  for (const MeasuredTest& test : alone.tests)
    values.push_back(predicted(predictions, program, setup_of(test, radius_in), quantity));
  PlacedScore score{program, radius_in, group, quantity, 0, 0, 0, nowhere, nowhere};
  const Rule& rule = rule_of(quantity);
  std::vector<double> errors;
  for_each_placing(alone, group.column, [&](const std::vector<MeasuredTest>& tests) {
    errors.clear();
    for (std::size_t i = 0; i < tests.size(); ++i) {
      if (tests[i].number < group.first_test || tests[i].number > group.last_test) continue;
      // A strain by the other method is certain and not of this group.
      MeasuredTest placed = tests[i];
      (group.column == "plug_strain" ? placed.diameter_strain : placed.plug_strain).reset();
      const std::optional<double> reading = measured(placed, quantity);
      if (!reading || measured(alone.tests[i], quantity)) continue;
      if (!values[i]) return;
      errors.push_back(error_of(rule, *reading, *values[i]));
    }
    const Statistics statistics = judge(rule, errors);
    ++score.placings;
    score.placings_passed += statistics.passed ? 1 : 0;
    score.bias += statistics.bias;
    score.bias_over_placings.include(statistics.bias);
    score.scatter_over_placings.include(statistics.scatter);
  });
  if (score.placings == 0)
    score.bias_over_placings = score.scatter_over_placings = {};
  else
    score.bias /= static_cast<double>(score.placings);
  return score;
}

}  // namespace

/// Fixed before the model was run (docs/decisions/0007-validation-rules.md). Do not change.
const std::array<Rule, 4> rules{{
    {Quantity::peak_force, -0.15, 0.15, 0.25, true},
    {Quantity::time_to_peak, -0.10, 0.10, 0.15, true},
    {Quantity::rebound_speed, -0.15, 0.15, 0.15, true},
    {Quantity::peak_strain, -0.05, 0.05, 0.05, false},
}};

const Rule& rule_of(Quantity quantity) { return *std::ranges::find(rules, quantity, &Rule::quantity); }

const char* to_string(Quantity quantity) { return of(quantity).name; }

std::string axis_label(Quantity quantity) {
  return output::capitalised(of(quantity).name) + " (" + of(quantity).unit + ")";
}

std::string with_digits(double value, Quantity quantity) {
  return fmt::format("{:.{}f}", value, of(quantity).decimals);
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
  return prediction.*of(quantity).prediction;
}

std::optional<double> predicted(const std::vector<Prediction>& predictions, Program program,
                                const Setup& setup, Quantity quantity) {
  const Prediction* const prediction = find(predictions, program, setup);
  return prediction ? predicted(*prediction, quantity) : std::nullopt;
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

Statistics statistics_of(const Rule& rule, const std::vector<TestError>& errors) {
  std::vector<double> values;
  for (const TestError& error : errors) values.push_back(error_of(rule, error.measured, error.predicted));
  return judge(rule, values);
}

Score score(const MeasuredTests& measured_tests, const std::vector<Prediction>& predictions, Program program,
            TestSupport support, Quantity quantity, double radius_in, std::optional<Projectile> projectile) {
  Score score{program, support, quantity, radius_in, projectile};
  const Rule& rule = rule_of(quantity);
  for (const MeasuredTest& test : measured_tests.tests) {
    const std::optional<double> reading = measured(test, quantity);
    if (test.support != support || !reading || (projectile && test.projectile != *projectile)) continue;
    if (const auto value = predicted(predictions, program, setup_of(test, radius_in), quantity))
      score.errors.push_back(test_error(rule, test.number, *reading, *value));
    else
      ++score.missing;
  }
  const Statistics statistics = statistics_of(rule, score.errors);
  score.bias = statistics.bias;
  score.scatter = statistics.scatter;
  score.passed = statistics.passed && score.missing == 0;
  return score;
}

std::vector<PlacedScore> placed_scores(const MeasuredTests& measured_tests,
                                       const std::vector<Prediction>& predictions, Program program,
                                       double radius_in) {
  std::vector<PlacedScore> scores;
  for (const UnplacedReadings& group : measured_tests.unplaced)
    if (const auto quantity = measured_column(group.column).quantity)
      scores.push_back(placed_score(measured_tests, predictions, program, radius_in, group, *quantity));
  return scores;
}

std::optional<double> rebound_bound_mph(const ValidationData& data, const MeasuredTest& test) {
  if (test.support != TestSupport::load_cell || !test.rebound_mph || !test.peak_force_lb) return {};
  return expectation(data, test.projectile, test.speed_mph, *test.peak_force_lb,
                     *test.rebound_mph / test.speed_mph)
      .rebound_mph;
}

Admissible admissible_rebounds(const ValidationData& data, const std::vector<Prediction>& predictions,
                               Program program, double radius_in) {
  Admissible result{program, radius_in};
  for (const MeasuredTest& test : data.measured.tests) {
    const std::optional<double> bound = rebound_bound_mph(data, test);
    if (!bound) continue;
    ++result.tests;
    const auto rebound = predicted(predictions, program, setup_of(test, radius_in), Quantity::rebound_speed);
    if (!rebound)
      ++result.missing;
    else if (*rebound < min_of_measured * *test.rebound_mph)
      ++result.too_low;
    else if (*rebound > max_of_bound * *bound)
      ++result.too_high;
    else
      ++result.admissible;
  }
  result.passed = result.tests > 0 && result.admissible >= min_admissible_fraction * result.tests;
  return result;
}

}  // namespace dashpad::report1986
