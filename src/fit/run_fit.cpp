// A fit from its starts to the report.

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <iterator>
#include <stdexcept>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "dashpad/fit/report.hpp"
#include "fit/card.hpp"
#include "fit/determine.hpp"
#include "fit/problem.hpp"
#include "study/sampling.hpp"
#include "uncertainty/line.hpp"

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

constexpr int first_runs = 3, max_runs = 7;
/// Figures by a fixed number of runs may be off by this share of their deviations.
constexpr double max_off = 0.1;

/// Whether the figures and pulses of all fitted impacts, by a fixed number of runs, are those of the full
/// tolerance: each figure, and pulses in the mean square.
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

/// Starts that make no valid material are replaced by further points of the design, so many for each.
constexpr std::uint64_t tries_for_a_start = 20;
/// Starts keep this far from the bounds.
constexpr double margin_of_starts = 0.02;
/// Relative difference of misfits that count as the same.
constexpr double same_misfit = 1e-3;

std::vector<double> first_start(const Problem& problem) {
  std::vector<double> x;
  for (const Coordinate& coordinate : problem.coordinates)
    x.push_back(std::clamp(coordinate.place(coordinate.start), 0.0, 1.0));
  return x;
}

/// The given start, then points of a scrambled Sobol design that make a material. Offsets start at 0.
std::vector<std::vector<double>> starts_of(const Fit& fit, const Problem& problem,
                                           const LeastSquares& residuals) {
  std::vector<std::vector<double>> starts{first_start(problem)};
  const study::Sobol design(fit.unknowns.size(), fit.seed);
  std::vector<double> r(residuals.residuals);
  const auto wanted = static_cast<std::size_t>(fit.starts);
  for (std::uint64_t k = 0; starts.size() < wanted && k < tries_for_a_start * wanted; ++k) {
    std::vector<double> x = starts.front();
    for (std::size_t i = 0; i < fit.unknowns.size(); ++i)
      x[i] = margin_of_starts + (1 - 2 * margin_of_starts) * design.at(k, i);
    if (residuals.evaluate(x, r)) starts.push_back(std::move(x));
  }
  return starts;
}

/// Rise of twice the log likelihood at the ends of a 95 % interval: that of chi-squared, one degree.
constexpr double threshold_of_95 = 3.841458820694124;
/// Better minima that profiles may meet before the search is given up.
constexpr int max_better = 5;

/// Noise that nobody stated: one share of the largest stress for all such tests, from what the fit leaves.
/// Refits where that changes the weights.
void estimate_noise(Problem& problem, const LeastSquares& residuals, Minimum& minimum) {
  std::size_t unstated = 0;
  for (const Block& block : problem.blocks) unstated += block.noise_is_stated ? 0 : block.size();
  if (unstated == 0) return;
  const auto all = static_cast<double>(problem.points() + problem.priors());
  const double share_left = 1 - static_cast<double>(problem.coordinates.size()) / all;
  const bool is_alone = unstated == problem.points() + problem.priors();
  std::vector<double> r(residuals.residuals);
  for (int pass = 0; pass < (is_alone ? 1 : 4); ++pass) {
    residuals.evaluate(minimum.x, r);
    double squares = 0;
    for (const Block& block : problem.blocks)
      if (!block.noise_is_stated)
        for (std::size_t i = 0; i < block.size(); ++i) squares += r[block.first + i] * r[block.first + i];
    const double noise = std::sqrt(squares / static_cast<double>(unstated) / std::max(share_left, 1 / all));
    for (Block& block : problem.blocks)
      if (!block.noise_is_stated)
        for (double& deviation : block.deviation) deviation *= std::max(noise, 1e-9);
    minimum = minimise(residuals, minimum.x);
  }
}

/// Of the misfit, at the ends of an interval.
double threshold_of(const FitReport& report) {
  if (report.noise_is_stated || report.degrees_of_freedom < 1) return threshold_of_95;
  const double t = uncertainty::student_95(report.degrees_of_freedom);
  return t * t;
}

void find_profiles(const LeastSquares& residuals, const FitReport& report, int round, Session& session,
                   Solved& solved) {
  const std::size_t n = residuals.unknowns;
  solved.below.assign(n, {});
  solved.above.assign(n, {});
  const Uncertainty& of = solved.uncertainty;
  session.begin("Finding intervals", 2 * n);
  tbb::parallel_for(std::size_t{0}, 2 * n, [&](std::size_t task) {
    const std::size_t i = task / 2;
    ProfileRequest request;
    request.coordinate = i;
    request.side = task % 2 == 0 ? -1 : 1;
    request.threshold = threshold_of(report) * report.variance_scale * of.widening[i];
    request.guess = of.error[i] ? std::sqrt(threshold_of(report)) * *of.error[i] : 0.2;
    if (of.error[i])
      for (std::size_t j = 0; j < n; ++j)
        request.direction.push_back(of.covariance[j * n + i] / of.covariance[i * n + i]);
    ProfileEnd& end = (task % 2 == 0 ? solved.below : solved.above)[i];
    if (residuals.settle && residuals.settles[i]) {
      // The clock of a pulse is nobody's aim: its curvature is enough.
      const double x = solved.minimum.x[i] + request.side * request.guess;
      if (of.error[i] && x > 0 && x < 1) end.x = x;
      return;
    }
    end = session.piece(fmt::format("runs {}, round {}, end {}", report.solver_runs, round, task),
                        [&] { return profile(residuals, solved.minimum, request); });
  });
}

/// A better minimum that a profile met.
std::optional<Minimum> better_of(const Solved& solved) {
  std::optional<Minimum> best;
  for (const auto* ends : {&solved.below, &solved.above})
    for (const ProfileEnd& end : *ends)
      if (end.better && (!best || end.better->misfit < best->misfit)) best = end.better;
  return best;
}

void weigh(const Problem& problem, const Minimum& minimum, FitReport& report) {
  report.points = problem.points();
  report.priors = problem.priors();
  report.degrees_of_freedom = static_cast<double>(problem.points() + problem.priors()) -
                              static_cast<double>(problem.coordinates.size());
  report.misfit = minimum.misfit;
  report.noise_is_stated = std::ranges::all_of(problem.blocks, &Block::noise_is_stated);
  report.variance_scale = report.noise_is_stated ? std::max(report.misfit_per_degree(), 1.0) : 1;
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

LeastSquares least_squares_of(const Problem& problem, const Session& session,
                              std::atomic<std::size_t>& evaluations) {
  LeastSquares of{problem.coordinates.size(), problem.residuals(), problem.derivative_step,
                  [&problem, &session, &evaluations](std::span<const double> x, std::span<double> residuals) {
                    // A search whose model cannot be evaluated any more ends soon.
                    if (session.is_stopped()) return false;
                    ++evaluations;
                    return problem.evaluate(x, residuals);
                  }};
  of.takes_impacts = std::ranges::any_of(problem.blocks, &Block::is_impact);
  of.settles = problem.shifts();
  if (std::ranges::any_of(of.settles, std::identity{}))
    of.settle = [&problem, &session, &evaluations](std::span<double> x, const std::vector<bool>& held,
                                                   std::span<double> residuals) {
      if (session.is_stopped()) return false;
      ++evaluations;
      return problem.settle(x, held, residuals);
    };
  return of;
}

Minimum search(const Fit& fit, const Problem& problem, const LeastSquares& residuals, Session& session,
               FitReport& report) {
  const std::vector<std::vector<double>> starts = starts_of(fit, problem, residuals);
  std::vector<Minimum> found(starts.size());
  session.begin("Searching from several starts", starts.size());
  tbb::parallel_for(std::size_t{0}, starts.size(), [&](std::size_t i) {
    found[i] =
        session.piece(fmt::format("start {}", i), [&] { return minimise(residuals, starts[i], coarse); });
  });
  const auto better = [](const Minimum& a, const Minimum& b) {
    if (a.converged != b.converged) return a.converged;
    if (a.x.empty() || b.x.empty()) return !a.x.empty();
    return a.misfit < b.misfit;
  };
  const Minimum best = *std::ranges::min_element(found, better);
  report.starts = fit.starts;
  report.starts_at_best = 0;
  report.starts_failed = fit.starts - static_cast<int>(found.size());
  for (const Minimum& each : found) {
    if (!each.converged)
      ++report.starts_failed;
    else if (each.misfit <= best.misfit * (1 + same_misfit) + 1e-12)
      ++report.starts_at_best;
  }
  return best;
}

Solved determine(Problem& problem, const LeastSquares& residuals, Minimum minimum, Session& session,
                 FitReport& report) {
  Solved solved;
  solved.minimum = std::move(minimum);
  for (int round = 0;; ++round) {
    if (solved.minimum.converged) estimate_noise(problem, residuals, solved.minimum);
    report.converged = solved.minimum.converged;
    report.why_not = solved.minimum.why_not;
    weigh(problem, solved.minimum, report);
    session.throw_if_stopped();
    if (!report.converged) return solved;
    const bool has_derivatives =
        find_uncertainty(problem, residuals, solved.minimum.x, report.variance_scale, solved.uncertainty);
    session.throw_if_stopped();
    if (!has_derivatives) {
      report.converged = false;
      report.why_not = "the best values lie where the model ends, and a step beside them makes no material";
      return solved;
    }
    find_profiles(residuals, report, round, session, solved);
    const std::optional<Minimum> better = better_of(solved);
    if (!better || round == max_better) return solved;
    report.starts_at_best = 0;
    solved.minimum = minimise(residuals, better->x);
  }
}

}  // namespace dashpad::fit
