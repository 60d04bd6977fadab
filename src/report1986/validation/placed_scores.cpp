#include <algorithm>
#include <cmath>
#include <limits>

#include "dashpad/report1986/validation/verdict.hpp"
#include "report1986/validation/placings.hpp"

namespace dashpad::report1986 {

namespace {

std::optional<Quantity> quantity_of(const std::string& column) {
  if (column == "peak_force_lb") return Quantity::peak_force;
  if (column == "time_to_peak_ms") return Quantity::time_to_peak;
  if (column == "rebound_mph") return Quantity::rebound_speed;
  if (column == "plug_strain" || column == "diameter_strain") return Quantity::peak_strain;
  return {};
}

/// Widens an interval to hold a value.
void include(Interval& interval, double value) {
  interval.low = std::min(interval.low, value);
  interval.high = std::max(interval.high, value);
}

}  // namespace

std::vector<PlacedScore> placed_scores(const MeasuredTests& measured_tests,
                                       const std::vector<Prediction>& predictions, Program program,
                                       double radius_in) {
  std::vector<std::optional<double>> values;
  std::vector<PlacedScore> scores;
  for (const UnplacedReadings& group : measured_tests.unplaced) {
    const std::optional<Quantity> quantity = quantity_of(group.column);
    if (!quantity) continue;
    values.clear();
    MeasuredTests alone{measured_tests.tests, {group}};
    for (MeasuredTest& test : alone.tests) {
      const Prediction* prediction =
          find(predictions, program, {test.projectile, test.support, test.speed_mph, radius_in});
      values.push_back(prediction ? predicted(*prediction, *quantity) : std::nullopt);
    }
    const double infinite = std::numeric_limits<double>::infinity();
    PlacedScore score{
        program, radius_in, group, *quantity, 0, 0, 0, {infinite, -infinite}, {infinite, -infinite}};
    const Rule& rule = rule_of(*quantity);
    std::vector<double> errors;
    for_each_placing(alone, group.column, [&](const std::vector<MeasuredTest>& tests) {
      errors.clear();
      for (std::size_t i = 0; i < tests.size(); ++i) {
        if (tests[i].number < group.first_test || tests[i].number > group.last_test) continue;
        // A test's strain by the other method is certain, and none of this group.
        MeasuredTest placed = tests[i];
        (group.column == "plug_strain" ? placed.diameter_strain : placed.plug_strain).reset();
        const std::optional<double> reading = measured(placed, *quantity);
        if (!reading || measured(alone.tests[i], *quantity)) continue;
        if (!values[i]) return;
        errors.push_back(error_of(rule, *reading, *values[i]));
      }
      const Statistics statistics = judge(rule, errors);
      ++score.placings;
      score.placings_passed += statistics.passed ? 1 : 0;
      score.bias += statistics.bias;
      include(score.bias_over_placings, statistics.bias);
      include(score.scatter_over_placings, statistics.scatter);
    });
    if (score.placings == 0)
      score.bias_over_placings = score.scatter_over_placings = {};
    else
      score.bias /= static_cast<double>(score.placings);
    scores.push_back(std::move(score));
  }
  return scores;
}

}  // namespace dashpad::report1986
