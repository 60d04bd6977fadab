#include "dashpad/report1986/validation/study.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace dashpad::report1986 {

namespace {

constexpr std::size_t folds_on_load_cell = 5;

struct ScoreName {
  const char* name;
  TestSupport support;
  Quantity quantity;
};
constexpr ScoreName score_names[] = {
    {"peak_force", TestSupport::load_cell, Quantity::peak_force},
    {"time_to_peak", TestSupport::load_cell, Quantity::time_to_peak},
    {"rebound_load_cell", TestSupport::load_cell, Quantity::rebound_speed},
    {"rebound_plate", TestSupport::plate, Quantity::rebound_speed},
    {"strain_plate", TestSupport::plate, Quantity::peak_strain},
};

/// The readings at `places`, or all others if `without`.
std::vector<Reading> chosen(const std::vector<Reading>& readings, const std::vector<std::size_t>& places,
                            bool without) {
  std::vector<Reading> result;
  for (std::size_t i = 0; i < readings.size(); ++i)
    if ((std::ranges::count(places, i) == 0) == without) result.push_back(readings[i]);
  return result;
}

/// A reading with the value that its fit predicts.
struct Predicted {
  Reading reading;
  std::optional<double> value;
};
std::vector<Predicted> predict_fold(const ValidationData& data, const std::vector<Reading>& held,
                                    const FittedFoam& foam) {
  std::vector<Predicted> result;
  std::optional<Prediction> last;  // readings of a test are adjacent
  for (const Reading& reading : held) {
    if (foam.converged && !(last && last->setup == reading.setup))
      last = predict(data, material_of(foam), Program::accurate, reading.setup);
    result.push_back({reading, last ? predicted(*last, reading.quantity) : std::nullopt});
  }
  return result;
}

HeldOutScore score_of(const ScoreName& wanted, const std::vector<Predicted>& all) {
  HeldOutScore score{wanted.name, wanted.support, wanted.quantity};
  const Rule& rule = rule_of(wanted.quantity);
  for (const auto& [reading, value] : all) {
    if (reading.setup.support != wanted.support || reading.quantity != wanted.quantity) continue;
    if (value)
      score.errors.push_back(test_error(rule, reading.test, reading.value, *value));
    else
      ++score.missing;
  }
  const Statistics statistics = statistics_of(rule, score.errors);
  score.bias = statistics.bias;
  score.passed = statistics.passed && score.missing == 0;
  if (score.errors.size() < 2) return score;
  score.scatter = statistics.scatter;
  const double of_mean = statistics.scatter / std::sqrt(static_cast<double>(score.errors.size()));
  score.standard_error = rule.logarithmic ? (1 + score.bias) * of_mean : of_mean;
  return score;
}

}  // namespace

std::vector<Reading> certain_readings(const MeasuredTests& measured_tests) {
  std::vector<Reading> readings;
  for (const MeasuredTest& test : measured_tests.tests)
    for (const auto& [name, support, quantity] : score_names)
      if (const auto value = measured(test, quantity); value && test.support == support)
        readings.push_back({test.number, setup_of(test, held_out_radius_in), quantity, *value});
  return readings;
}

std::vector<std::vector<std::size_t>> folds_of(const std::vector<Reading>& readings) {
  std::map<Projectile, std::set<double>> speeds;
  std::set<int> on_plate;
  for (const auto& [test, setup, quantity, value] : readings) {
    if (setup.support == TestSupport::plate)
      on_plate.insert(test);
    else
      speeds[setup.projectile].insert(setup.speed_mph);
  }
  std::vector<std::vector<std::size_t>> folds(folds_on_load_cell + on_plate.size());
  const auto rank = [](const auto& set, auto value) {
    return static_cast<std::size_t>(std::distance(set.begin(), set.find(value)));
  };
  for (std::size_t i = 0; i < readings.size(); ++i) {
    const auto& [test, setup, quantity, value] = readings[i];
    const std::size_t fold = setup.support == TestSupport::plate
                                 ? folds_on_load_cell + rank(on_plate, test)
                                 : rank(speeds[setup.projectile], setup.speed_mph) % folds_on_load_cell;
    folds[fold].push_back(i);
  }
  std::erase_if(folds, [](const auto& fold) { return fold.empty(); });
  return folds;
}

HeldOut hold_out(const ValidationData& data, const Progress& progress) {
  const std::vector<Reading> readings = certain_readings(data.measured);
  const std::vector<std::vector<std::size_t>> folds = folds_of(readings);
  HeldOut result;
  result.folds.resize(folds.size());
  std::vector<std::vector<Predicted>> predicted_by(folds.size());
  const auto fit = [&](std::size_t i) {
    if (i == folds.size()) {
      result.foam = fit_foam(data, readings);
    } else {
      result.folds[i] = fit_foam(data, chosen(readings, folds[i], true));
      predicted_by[i] = predict_fold(data, chosen(readings, folds[i], false), result.folds[i]);
    }
  };
  on_all_cores(folds.size() + 1, fit, progress);
  std::vector<Predicted> all;
  for (const auto& fold : predicted_by) all.insert(all.end(), fold.begin(), fold.end());
  std::ranges::stable_sort(all, {}, [](const Predicted& predicted) { return predicted.reading.test; });
  for (const ScoreName& name : score_names) result.scores.push_back(score_of(name, all));
  return result;
}

}  // namespace dashpad::report1986
