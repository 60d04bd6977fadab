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
#include "fit/posterior.hpp"
#include "fit/problem.hpp"
#include "fit/solve.hpp"

namespace dashpad::fit {

namespace {

constexpr int first_runs = 3, most_runs = 7;
/// Figures by a fixed number of runs may be off by this share of their deviations.
constexpr double most_off = 0.1;

LeastSquares least_squares_of(const Problem& problem, std::atomic<std::size_t>& evaluations) {
  return {problem.coordinates.size(), problem.residuals(), problem.derivative_step,
          [&problem, &evaluations](std::span<const double> x, std::span<double> residuals) {
            ++evaluations;
            return problem.evaluate(x, residuals);
          }};
}
/// Whether the figures of all fitted impacts, by a fixed number of runs, are those of the full tolerance.
bool runs_suffice(const Fit& fit, std::span<const double> values, int runs) {
  for (const ImpactMeasurement& impact : fit.impacts) {
    if (impact.is_held_out) continue;
    std::vector<double> fixed(impact.figures.size()), full(impact.figures.size());
    if (!prediction_of(fit, impact, runs)(values, fixed) || !prediction_of(fit, impact, 0)(values, full))
      return false;
    for (std::size_t i = 0; i < fixed.size(); ++i)
      if (!(std::abs(fixed[i] - full[i]) <= most_off * impact.figures[i].deviation)) return false;
  }
  return true;
}
}  // namespace

FitReport run_fit(const Fit& fit, std::size_t posterior) {
  const auto start = std::chrono::steady_clock::now();
  if (const std::vector<Violation> broken = violations(fit); !broken.empty()) {
    std::string message = "invalid fit";
    for (const Violation& v : broken) message += fmt::format("\n  {}: {}", v.key, v.rule);
    throw std::invalid_argument(message);
  }
  std::atomic<std::size_t> evaluations = 0;
  const bool has_impacts = std::ranges::any_of(fit.impacts, [](const auto& of) { return !of.is_held_out; });
  FitReport report;
  for (int runs = has_impacts ? first_runs : 0;; ++runs) {
    report = {};
    report.title = fit.title;
    report.solver_runs = runs;
    Problem problem = problem_of(fit, runs);
    const LeastSquares residuals = least_squares_of(problem, evaluations);
    const Solved solved = determine(fit, problem, residuals, report);
    if (!report.converged) break;
    if (has_impacts && runs < most_runs && !runs_suffice(fit, problem.values(solved.minimum.x), runs))
      continue;
    describe(fit, problem, solved, report);
    if (const auto broken = violations(report.material); !broken.empty()) {
      report.converged = false;
      report.why_not = fmt::format("the best values make no valid card: {} = {:.6g}: {}", broken.front().key,
                                   broken.front().value, broken.front().rule);
      break;
    }
    if (posterior > 0)
      for (const std::vector<double>& x : laplace_sample(solved.minimum.x, solved.uncertainty.precision,
                                                         solved.uncertainty.gradient, posterior, fit.seed))
        report.posterior.push_back(problem.values(x));
    break;
  }
  report.evaluations = evaluations;
  report.wall_time = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  return report;
}

}  // namespace dashpad::fit
