#include "fit/describe.hpp"

#include <algorithm>
#include <cmath>
#include <iterator>

#include "fit/card.hpp"
#include "fit/card_uncertainty.hpp"
#include "fit/comparison.hpp"
#include "fit/met.hpp"
#include "fit/prediction.hpp"

namespace dashpad::fit {

namespace {

FittedUnknown unknown_of(const Fit& fit, const Problem& problem, const Solved& solved, std::size_t i) {
  const Coordinate& coordinate = problem.coordinates[i];
  const double x = solved.minimum.x[i];
  FittedUnknown found;
  found.key = coordinate.key;
  found.unit = coordinate.unit;
  found.value = coordinate.value(x);
  found.lowest = coordinate.lowest;
  found.highest = coordinate.highest;
  found.is_logarithmic = coordinate.is_logarithmic;
  found.is_nuisance = coordinate.is_nuisance;
  if (i < fit.unknowns.size()) {
    found.is_added = fit.unknowns[i].is_added;
    found.lowest_is_natural = is_natural_bound(fit, fit.unknowns[i], coordinate.lowest);
    found.highest_is_natural = is_natural_bound(fit, fit.unknowns[i], coordinate.highest);
  }
  found.is_at_lowest = is_at_bound(x) && x < 0.5;
  found.is_at_highest = is_at_bound(x) && x > 0.5;
  if (solved.uncertainty.error[i])
    found.standard_error = *solved.uncertainty.error[i] * std::abs(coordinate.slope(x));
  if (i < fit.unknowns.size() && fit.unknowns[i].prior)
    found.prior_deviation = fit.unknowns[i].prior->deviation;
  if (const auto& low = solved.below[i].x) found.low = coordinate.value(*low);
  if (const auto& high = solved.above[i].x) found.high = coordinate.value(*high);
  return found;
}

/// How each test, figure and pulse is met.
void describe_measurements(const Fit& fit, const Problem& problem, const Solved& solved, FitReport& report) {
  const Uncertainty& uncertainty = solved.uncertainty;
  const std::vector<double> values = problem.values(solved.minimum.x);
  std::size_t next = 0;  // block: those of fitted tests, then those of fitted impacts
  for (const MaterialMeasurement& test : fit.tests) {
    const Block* const block = test.is_held_out ? nullptr : &problem.blocks[next];
    MetTest met = met_test(fit, test, values, block && block->offset ? values[*block->offset] : 0);
    if (block) {
      met.noise = block->deviation.front();
      met.autocorrelation = uncertainty.blocks[next].rho;
      met.effective_points = uncertainty.blocks[next].effective_points;
      ++next;
    }
    report.tests.push_back(std::move(met));
  }
  for (const ImpactMeasurement& impact : fit.impacts) {
    const Block* const block = impact.is_held_out ? nullptr : &problem.blocks[next];
    std::vector<MetFigure> figures = met_figures(fit, impact, values);
    const std::vector<std::optional<double>> deviations =
        prediction_deviations(fit, impact, problem, solved.minimum.x, uncertainty);
    for (std::size_t i = 0; i < figures.size(); ++i)
      if (figures[i].computed) figures[i].prediction_deviation = deviations[i];
    std::ranges::move(figures, std::back_inserter(report.figures));
    std::ranges::move(compared(fit, impact, values), std::back_inserter(report.comparison));
    if (impact.pulse) {
      MetPulse met = met_pulse(fit, impact, values, block ? block->shift : std::nullopt);
      if (block) {
        met.autocorrelation = uncertainty.blocks[next].rho;
        met.effective_points = uncertainty.blocks[next].effective_points;
      }
      report.pulses.push_back(std::move(met));
    }
    next += block ? 1 : 0;
  }
}

}  // namespace

void describe(const Fit& fit, const Problem& problem, const Solved& solved, FitReport& report) {
  const Uncertainty& uncertainty = solved.uncertainty;
  for (std::size_t i = 0; i < problem.coordinates.size(); ++i)
    report.unknowns.push_back(unknown_of(fit, problem, solved, i));
  const auto key = [&](std::size_t i) { return problem.coordinates[i].key; };
  for (std::size_t i = 0; i < problem.coordinates.size(); ++i) {
    if (solved.below[i].is_rough) report.rough_ends.push_back(key(i) + ", below");
    if (solved.above[i].is_rough) report.rough_ends.push_back(key(i) + ", above");
  }
  for (std::size_t k = 0; k < uncertainty.correlations.size(); ++k) {
    const auto& [i, j] = uncertainty.strongly_correlated[k];
    report.correlations.push_back({key(i), key(j), uncertainty.correlations[k]});
  }
  for (const std::vector<std::size_t>& members : uncertainty.flat_directions) {
    std::vector<std::string> keys;
    for (const std::size_t i : members) keys.push_back(key(i));
    if (!keys.empty()) report.flat_directions.push_back(keys);
  }
  for (std::size_t i = 0; i < problem.coordinates.size(); ++i)
    if (uncertainty.error[i])
      report.largest_widening = std::max(report.largest_widening, std::sqrt(uncertainty.widening[i]));
  describe_measurements(fit, problem, solved, report);
  const std::vector<double> values = problem.values(solved.minimum.x);
  report.material = card_of(fit, values, report);
  report.material.uncertainty = uncertainty_of(fit, problem, solved, report, report.material);
  report.fitted_case = fitted_case_of(fit, values);
}

}  // namespace dashpad::fit
