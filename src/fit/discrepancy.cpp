#include "fit/card.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "fit/determine.hpp"
#include "uncertainty/open_sources.hpp"

namespace dashpad::fit {
namespace {

/// Formulas with few numbers meet the loops of real foams within 1 to 2 % of the largest stress (fits.md).
constexpr double surest_stress = 0.02;
constexpr std::size_t max_left_out = 8;  ///< groups of fitted impacts that are left out in turn
constexpr double worth_of_surest = 2;    ///< impacts

/// Shares by which figures of a kind were missed, without what their measurement and the unknowns explain.
struct Missed {
  double squares = 0;
  double count = 0;
};

Missed missed(std::span<const PredictedFigure> all, FigureKind kind) {
  Missed of;
  for (const PredictedFigure& each : all) {
    const std::optional<double> share = each.of.share();
    if (kind_of(each.of.figure) != kind || !share) continue;
    const double noise = each.of.deviation.value_or(0) / each.of.measured;
    of.squares += std::max(*share * *share - noise * noise - each.by_unknowns * each.by_unknowns, 0.0);
    ++of.count;
  }
  return of;
}

double deviation_of(const Missed& missed, double surest, bool is_predicted) {
  const double all = worth_of_surest + missed.count;
  const double mean = (worth_of_surest * surest * surest + missed.squares) / all;
  // Fitted impacts show that the law is no better than this, not that it is as good.
  const double square = is_predicted ? mean : std::max(mean, surest * surest);
  const double t = uncertainty::student_95(is_predicted ? all : worth_of_surest);
  return std::min(std::sqrt(square) * t / uncertainty::two_sided_95, 1.0);
}

/// The problem without the impacts that are held out now, and the place to start from.
Problem problem_without(const Fit& fit, const Problem& whole, std::span<const double> x, int runs,
                        std::vector<double>& start) {
  Problem problem = problem_of(fit, runs);
  // Noise that was estimated stays; tests come first in both.
  for (std::size_t i = 0; i < problem.blocks.size() && !problem.blocks[i].is_impact; ++i)
    if (problem.blocks[i].size() == whole.blocks[i].size())
      problem.blocks[i].deviation = whole.blocks[i].deviation;
  for (const Coordinate& coordinate : problem.coordinates) {
    const auto same = std::ranges::find(whole.coordinates, coordinate.key, &Coordinate::key);
    start.push_back(x[static_cast<std::size_t>(same - whole.coordinates.begin())]);
  }
  return problem;
}

}  // namespace

std::optional<FigureKind> kind_of(ImpactFigure figure) {
  switch (figure) {
    case ImpactFigure::peak_force:
    case ImpactFigure::peak_acceleration: return FigureKind::acceleration;
    case ImpactFigure::hic15:
    case ImpactFigure::hic36:
    case ImpactFigure::hic_unlimited: return FigureKind::hic;
    case ImpactFigure::rebound_speed: return FigureKind::rebound;
    case ImpactFigure::peak_penetration: return FigureKind::penetration;
    default: return std::nullopt;
  }
}

std::vector<PredictedFigure> predicted_figures(const Fit& fit, const Problem& problem, const Solved& solved,
                                               int runs, Session& session,
                                               std::atomic<std::size_t>& evaluations) {
  const std::vector<double>& x = solved.minimum.x;
  std::vector<std::vector<PredictedFigure>> found(fit.impacts.size());
  const auto take = [&](std::size_t i, std::span<const double> values) {
    ImpactMeasurement asked = fit.impacts[i];
    asked.figures.clear();
    for (const ImpactComparison& comparison : compared(fit, fit.impacts[i], values)) {
      found[i].push_back({comparison});
      asked.figures.push_back({comparison.figure, comparison.measured, 1});
    }
    const auto own = prediction_deviations(fit, asked, problem, x, solved.uncertainty);
    for (std::size_t k = 0; k < own.size(); ++k)
      found[i][k].by_unknowns = own[k].value_or(0) / asked.figures[k].value;
  };
  std::vector<std::size_t> fitted;
  for (std::size_t i = 0; i < fit.impacts.size(); ++i)
    if (fit.impacts[i].is_held_out)
      take(i, problem.values(x));
    else
      fitted.push_back(i);
  const std::size_t groups = fitted.size() < 2 ? 0 : std::min(fitted.size(), max_left_out);
  session.begin("Leaving out one impact at a time", groups);
  tbb::parallel_for(std::size_t{0}, groups, [&](std::size_t group) {
    Fit rest = fit;
    for (std::size_t k = group; k < fitted.size(); k += groups) rest.impacts[fitted[k]].is_held_out = true;
    std::vector<double> start;
    const Problem without = problem_without(rest, problem, x, runs, start);
    if (without.points() + without.priors() < without.coordinates.size()) return;
    const LeastSquares residuals = least_squares_of(without, session, evaluations);
    const Minimum minimum = session.piece(fmt::format("runs {}, left out {}", runs, group),
                                          [&] { return minimise(residuals, start, coarse); });
    if (!minimum.is_sound || minimum.x.size() != start.size()) return;
    for (std::size_t k = group; k < fitted.size(); k += groups) take(fitted[k], without.values(minimum.x));
  });
  std::vector<PredictedFigure> all;
  for (auto& each : found) std::ranges::move(each, std::back_inserter(all));
  return all;
}

std::optional<double> nose_over_pad_of(const Fit& fit, double alike) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const ImpactMeasurement& measured : fit.impacts) {
    const ImpactCase& impact = measured.impact;
    const bool is_round = std::holds_alternative<Sphere>(impact.impactor.nose) ||
                          std::holds_alternative<Ellipsoid>(impact.impactor.nose) ||
                          std::holds_alternative<Rod>(impact.impactor.nose);
    if (!is_round || !impact.pad.layers.empty() || impact.pad.area) return std::nullopt;
    const double ratio =
        sections_of(impact).width / impact.pad.thickness;  // ratio for the radius of curvature at the tip
    least = std::min(least, ratio);
    most = std::max(most, ratio);
  }
  if (!(most > 0 && most <= alike * least)) return std::nullopt;
  return std::sqrt(least * most);
}

std::optional<Misfit> misfit_of(std::span<const PredictedFigure> predicted,
                                std::span<const ImpactComparison> fitted) {
  const bool is_predicted = !predicted.empty();
  std::vector<PredictedFigure> of(predicted.begin(), predicted.end());
  if (!is_predicted)
    for (const ImpactComparison& each : fitted) of.push_back({each});
  double impacts = 0;
  for (const FigureKind kind :
       {FigureKind::acceleration, FigureKind::hic, FigureKind::rebound, FigureKind::penetration})
    impacts = std::max(impacts, missed(of, kind).count);
  if (impacts == 0) return std::nullopt;
  const auto deviation = [&](FigureKind kind, double surest) {
    return deviation_of(missed(of, kind), surest, is_predicted);
  };
  Misfit misfit{.peak_acceleration = deviation(FigureKind::acceleration, surest_stress),
                .hic = deviation(FigureKind::hic, injury::hic_power * surest_stress),
                .rebound_speed = deviation(FigureKind::rebound, surest_stress),
                .penetration = deviation(FigureKind::penetration, surest_stress),
                .impacts = static_cast<int>(impacts),
                .is_held_out = is_predicted};
  // The energy says what way goes with a force.
  if (missed(of, FigureKind::penetration).count == 0) misfit.penetration = misfit.peak_acceleration;
  return misfit;
}

}  // namespace dashpad::fit
