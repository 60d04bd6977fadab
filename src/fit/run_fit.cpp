// A fit from its starts to the report.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include <fmt/format.h>

#include "dashpad/fit/report.hpp"
#include "fit/describe.hpp"
#include "fit/determine.hpp"
#include "fit/discrepancy.hpp"
#include "fit/posterior.hpp"
#include "fit/problem.hpp"
#include "fit/search.hpp"
#include "fit/session.hpp"
#include "fit/solve.hpp"

namespace dashpad::fit {

namespace {

constexpr int first_runs = 3, most_runs = 7;
/// Figures by a fixed number of runs may be off by this share of their deviations.
constexpr double most_off = 0.1;

/// Whether the figures and pulses of all fitted impacts, by a fixed number of runs, are those of the full
/// tolerance: each figure, and pulses in the mean square.
bool runs_suffice(const Fit& fit, const Problem& problem, std::span<const double> values, int runs) {
  auto block = std::ranges::find_if(problem.blocks, &Block::is_impact);
  for (const ImpactMeasurement& impact : fit.impacts) {
    if (impact.is_held_out) continue;
    const std::vector<double>& deviation = block->deviation;
    const std::size_t figures = impact.figures.size();
    std::vector<double> fixed(deviation.size()), full(deviation.size());
    if (!prediction_of(fit, impact, runs, block->shift)(values, fixed) ||
        !prediction_of(fit, impact, 0, block->shift)(values, full))
      return false;
    double squares = 0;
    for (std::size_t i = 0; i < fixed.size(); ++i) {
      const double off = std::abs(fixed[i] - full[i]) / deviation[i];
      if (i < figures && !(off <= most_off)) return false;
      if (i >= figures) squares += off * off;
    }
    if (!(squares <= most_off * most_off * static_cast<double>(fixed.size() - figures))) return false;
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

/// What a card says of impacts that the law was not fitted to.
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
  report.why_not = fmt::format("the best values make no valid card: {} = {:.6g}: {}", broken.front().key,
                               broken.front().value, broken.front().rule);
}

}  // namespace

FitReport run_fit(const Fit& fit, const RunOptions& options) {
  const auto start = std::chrono::steady_clock::now();
  throw_if_broken(fit);
  Session session(fit, options);
  std::atomic<std::size_t> evaluations = 0;
  FitReport report;
  report.title = fit.title;
  Minimum minimum;
  for (int runs = has_fitted(fit.impacts) ? first_runs : 0;; ++runs) {
    report.solver_runs = runs;
    Problem problem = problem_of(fit, runs);
    const LeastSquares residuals = least_squares_of(problem, session, evaluations);
    // More runs move the minimum a little: there is no need to search again.
    if (runs <= first_runs) minimum = search(fit, problem, residuals, session, report);
    if (minimum.converged) minimum = minimise(residuals, minimum.x);
    session.throw_if_stopped();
    if (minimum.converged && has_fitted(fit.impacts) && runs < most_runs &&
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
