#include "fit/search.hpp"

#include <algorithm>
#include <functional>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "study/sobol.hpp"

namespace dashpad::fit {

namespace {

/// Starts that make no valid material are replaced by further points of the design, so many for each.
constexpr std::uint64_t tries_for_a_start = 20;
/// Starts keep this far from the bounds.
constexpr double margin_of_starts = 0.02;
/// Relative difference of misfits that count as the same.
constexpr double same_misfit = 1e-3;

std::vector<double> first_start(const Problem& problem) {
  std::vector<double> x;
  for (const Coordinate& of : problem.coordinates) x.push_back(std::clamp(of.place(of.start), 0.0, 1.0));
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

}  // namespace dashpad::fit
