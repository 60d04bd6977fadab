// The effect of temperature, from tests at several of them.

#include <algorithm>
#include <cmath>
#include <map>

#include <fmt/format.h>

#include "input/material_deck/deck_foam.hpp"
#include "model/pad/foam/foam_rules.hpp"

namespace dashpad::input {

namespace {

constexpr double same_rate = 1.1;                           // greatest ratio
constexpr double same_temperature = 0.5;                    // K, less than that
constexpr double min_plausible = 0.05, max_plausible = 20;  // factors

/// Sums of products of stresses at a temperature and at the reference, at equal strains.
struct Sums {
  double both = 0, reference = 0, own = 0;

  void add(const DeckCurve& curve, const DeckCurve& of_reference) {
    for (std::size_t i = 0; i < curve.strain.size() && curve.strain[i] <= of_reference.strain.back(); ++i) {
      const double at_reference =
          on_straight_lines(of_reference.strain, of_reference.stress, curve.strain[i]);
      both += curve.stress[i] * at_reference;
      reference += at_reference * at_reference;
      own += curve.stress[i] * curve.stress[i];
    }
  }
  [[nodiscard]] double factor() const { return both / reference; }
  /// Root mean square of what the factor leaves, over that of the stresses.
  [[nodiscard]] double misfit() const {
    return std::sqrt(std::max(0.0, 1 - both * both / (reference * own)));
  }
};

std::string celsius(double temperature) { return fmt::format("{:.4g} degC", temperature - 273.15); }

bool are_same(double temperature, double other) { return std::abs(temperature - other) < same_temperature; }

/// Gives tests at about one temperature the one that came first.
void merge_temperatures(std::vector<DeckRateCurve>& tests, double reference) {
  std::vector<double> distinct{reference};
  for (DeckRateCurve& test : tests) {
    const double own = test.temperature.value_or(reference);
    const auto same = std::ranges::find_if(distinct, [&](double each) { return are_same(each, own); });
    test.temperature = same == distinct.end() ? own : *same;
    if (same == distinct.end()) distinct.push_back(own);
  }
}

std::string words_on(const Sums& sums, double temperature, double reference) {
  const double factor = sums.factor();
  return fmt::format(
      "At {}, the stress is {:.3g} times that at {} at every strain; the test deviates from that by {:.2g} % "
      "(rms){}.",
      celsius(temperature), factor, celsius(reference), 100 * sums.misfit(),
      factor < min_plausible || factor > max_plausible ? "; check the units of the tests" : "");
}

DeckCurve loading_of(const DeckRateCurve& test) {
  std::vector<std::string> told_elsewhere;
  return curves_of_test(test.curve, false, told_elsewhere).loading;
}

}  // namespace

TemperatureTable take_temperatures(std::vector<DeckRateCurve>& tests, double reference,
                                   std::vector<std::string>& differences, MeasurementFaults& faults) {
  merge_temperatures(tests, reference);
  std::vector<DeckRateCurve> at_reference;
  std::ranges::copy_if(tests, std::back_inserter(at_reference),
                       [&](const DeckRateCurve& test) { return test.temperature == reference; });
  std::map<double, Sums> sums;
  for (const DeckRateCurve& test : tests) {
    if (test.temperature == reference) continue;
    const auto same = std::ranges::find_if(at_reference, [&](const DeckRateCurve& each) {
      return each.rate < same_rate * test.rate && test.rate < same_rate * each.rate;
    });
    if (same == at_reference.end())
      faults.add(test.line, test.curve.name, "",
                 fmt::format("was made at {}; needs a test at {} and the same rate, {:g} 1/s, to be compared "
                             "with",
                             celsius(*test.temperature), celsius(reference), test.rate));
    else
      sums[*test.temperature].add(loading_of(test), loading_of(*same));
  }
  std::erase_if(tests, [&](const DeckRateCurve& test) { return test.temperature != reference; });
  TemperatureTable table;
  if (sums.empty()) {
    differences.push_back(
        fmt::format("Tested at {}; the effect of other temperatures was not measured.", celsius(reference)));
    return table;
  }
  sums[reference] = {1, 1, 1};
  for (const auto& [temperature, of] : sums) {
    table.temperature.push_back(temperature);
    table.factor.push_back(of.factor());
    if (temperature != reference) differences.push_back(words_on(of, temperature, reference));
  }
  return table;
}

}  // namespace dashpad::input
