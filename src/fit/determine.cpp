#include "fit/determine.hpp"

#include <algorithm>
#include <cmath>
#include <functional>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "study/sampling.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::fit {
namespace {

/// Starts that make no valid material are replaced by further points of the design, so many for each.
constexpr std::uint64_t tries_for_a_start = 20;
/// Starts keep this far from the bounds.
constexpr double margin_of_starts = 0.02;
/// Relative difference of misfits that count as the same.
constexpr double same_misfit = 1e-3;

/// The given start, then points of a scrambled Sobol design that make a material. Offsets start at 0.
std::vector<std::vector<double>> starts_of(const Fit& fit, const Problem& problem,
                                           const LeastSquares& residuals) {
  std::vector<std::vector<double>> starts(1);
  for (const Coordinate& coordinate : problem.coordinates)
    starts.front().push_back(std::clamp(coordinate.place(coordinate.start), 0.0, 1.0));
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

/// Estimates the noise that nobody stated, one share of the largest stress for all such tests, from the
/// misfit; refits if that changes the weights.
void estimate_noise(Problem& problem, const LeastSquares& residuals, Minimum& minimum) {
  std::size_t unstated = 0;
  for (const Block& block : problem.blocks) unstated += block.noise_is_stated ? 0 : block.size() - block.idle;
  if (unstated == 0) return;
  const std::size_t telling = problem.points() + problem.priors() - problem.idle();
  const auto all = static_cast<double>(telling);
  const double share_left = 1 - static_cast<double>(problem.coordinates.size()) / all;
  const bool is_alone = unstated == telling;
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

/// The rise of the misfit at the ends of an interval.
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
  report.degrees_of_freedom = static_cast<double>(problem.points() + problem.priors() - problem.idle()) -
                              static_cast<double>(problem.coordinates.size());
  report.misfit = minimum.misfit;
  report.noise_is_stated = std::ranges::all_of(problem.blocks, &Block::noise_is_stated);
  report.variance_scale = report.noise_is_stated ? std::max(report.misfit_per_degree(), 1.0) : 1;
}

}  // namespace

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
  session.begin("Searching from several starting points", starts.size());
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
      report.why_not =
          "the best values lie at a limit of the model, and a step from them does not give a valid material";
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
