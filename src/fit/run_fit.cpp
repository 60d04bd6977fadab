// A fit from its starts to the report.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/fit/report.hpp"
#include "fit/card.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"

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

/// Compares the model with each test, figure and pulse.
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

constexpr int first_runs = 3, max_runs = 7;
/// Figures by a fixed number of runs may be off by this share of their deviations.
constexpr double max_off = 0.1;

/// Whether a fixed number of runs gives all fitted figures and pulses as exactly as the full tolerance.
bool runs_suffice(const Fit& fit, const Problem& problem, std::span<const double> values, int runs) {
  auto block = std::ranges::find_if(problem.blocks, &Block::is_impact);
  for (const ImpactMeasurement& impact : fitted(fit.impacts)) {
    const std::vector<double>& deviation = block->deviation;
    const std::size_t figures = impact.figures.size();
    std::vector<double> fixed(deviation.size()), full(deviation.size());
    if (!prediction_of(fit, impact, runs, block->shift)(values, fixed) ||
        !prediction_of(fit, impact, 0, block->shift)(values, full))
      return false;
    double squares = 0;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      const double off = std::abs(fixed[i] - full[i]) / deviation[i];
      if (i < figures && !(off <= max_off)) return false;
      if (i >= figures) squares += off * off;
    }
    if (!(squares <= max_off * max_off * static_cast<double>(fixed.size() - figures))) return false;
    ++block;
  }
  return true;
}

void throw_if_broken(const Fit& fit) {
  const std::vector<Violation> broken = violations(fit);
  if (broken.empty()) return;
  std::string message = "invalid fit";
  for (const Violation& v : broken) message += fmt::format("\n  {}: {}", v.key, v.rule);
  throw std::invalid_argument(message);
}

/// Puts the misfit of impacts to which the law was not fitted into the card.
void find_misfit(const Fit& fit, const Problem& problem, const Solved& solved, Session& session,
                 std::atomic<std::size_t>& evaluations, FitReport& report) {
  const std::vector<PredictedFigure> predicted =
      predicted_figures(fit, problem, solved, report.solver_runs, session, evaluations);
  std::optional<Misfit>& misfit = report.material.uncertainty.misfit;
  misfit = misfit_of(predicted, report.comparison);
  if (misfit) misfit->nose_over_pad = nose_over_pad_of(fit);
  if (report.fitted_case) report.fitted_case->impact.pad.material = report.material;
}

/// No card where the best values make none.
void judge_card(FitReport& report) {
  const std::vector<Violation> broken = violations(report.material);
  if (broken.empty()) return;
  report.converged = false;
  report.why_not = fmt::format("the best values do not give a valid card ({} = {:.6g}: {})",
                               broken.front().key, broken.front().value, broken.front().rule);
}

/// Fills the report with the minimum, its uncertainty and the measurements, but not with times.
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

}  // namespace

FitReport run_fit(const Fit& fit, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  throw_if_broken(fit);
  Session session(fit, options);
  std::atomic<std::size_t> evaluations = 0;
  FitReport report;
  report.title = fit.title;
  const auto remark = [&](const std::string& file, const std::vector<std::string>& remarks) {
    for (const std::string& each : remarks) report.remarks.push_back(fmt::format("{}: {}", file, each));
  };
  for (const MaterialMeasurement& test : fit.tests) remark(test.file, test.remarks);
  for (const ImpactMeasurement& impact : fit.impacts)
    if (impact.pulse) remark(impact.pulse->file, impact.pulse->remarks);
  Minimum minimum;
  for (int runs = has_fitted(fit.impacts) ? first_runs : 0;; ++runs) {
    report.solver_runs = runs;
    Problem problem = problem_of(fit, runs);
    const LeastSquares residuals = least_squares_of(problem, session, evaluations);
    // More runs move the minimum only a little, so that no new search is needed.
    if (runs <= first_runs) minimum = search(fit, problem, residuals, session, report);
    if (minimum.converged) minimum = minimise(residuals, minimum.x);
    session.throw_if_stopped();
    if (minimum.converged && has_fitted(fit.impacts) && runs < max_runs &&
        !runs_suffice(fit, problem, problem.values(minimum.x), runs))
      continue;
    const Solved solved = determine(problem, residuals, minimum, session, report);
    if (!report.converged) break;
    describe(fit, problem, solved, report);
    find_misfit(fit, problem, solved, session, evaluations, report);
    judge_card(report);
    if (options.posterior > 0 && report.converged)
      for (const std::vector<double>& x :
           laplace_sample(solved.minimum.x, solved.uncertainty.precision, solved.uncertainty.gradient,
                          options.posterior, fit.seed))
        report.posterior.push_back(problem.values(x));
    break;
  }
  report.evaluations = evaluations;
  report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace dashpad::fit
