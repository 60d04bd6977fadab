#include "fit/card.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "uncertainty/line.hpp"

namespace dashpad::fit {
namespace {

/// Share of the largest strain by which a strain has to come back for a turn: less is noise.
constexpr double min_turn = 0.02;

/// 1 or -1 for each point: whether the test is on its way up or down there.
std::vector<int> courses(const std::vector<double>& strain) {
  const double least = min_turn * std::ranges::max(strain);
  std::vector<int> course(strain.size(), 1);
  std::size_t extreme = 0;  // the last place that was farthest on the present course
  int now = 1;
  for (std::size_t i = 0; i < strain.size(); ++i) {
    if (now * (strain[i] - strain[extreme]) >= 0) {
      extreme = i;
    } else if (now * (strain[extreme] - strain[i]) > least) {
      now = -now;
      for (std::size_t k = extreme + 1; k < i; ++k) course[k] = now;
      extreme = i;
    }
    course[i] = now;
  }
  return course;
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double value : values) sum += value * value;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

/// Energy over one course: the area of stress over strain between places, magnitude.
double energy(const std::vector<double>& strain, const std::vector<double>& stress, std::size_t from,
              std::size_t to) {
  double sum = 0;
  for (std::size_t i = from; i < to; ++i)
    sum += (strain[i + 1] - strain[i]) * (stress[i + 1] + stress[i]) / 2;
  return std::abs(sum);
}

/// Each way up with the way down after it, over the strains of both. Measured stresses without the offset.
std::vector<Loop> loops_of(const MetTest& test, double offset, const std::vector<int>& course) {
  std::vector<double> measured = test.measured;
  for (double& stress : measured) stress -= offset;
  std::vector<Loop> loops;
  const std::size_t n = course.size();
  for (std::size_t begin = 0; begin < n;) {
    std::size_t top = begin;
    while (top + 1 < n && course[top + 1] > 0) ++top;
    std::size_t end = top;
    while (end + 1 < n && course[end + 1] < 0) ++end;
    if (end > top && top > begin) {
      const double measured_in = energy(test.strain, measured, begin, top);
      const double computed_in = energy(test.strain, test.computed, begin, top);
      if (measured_in > 0 && computed_in > 0)
        loops.push_back({test.strain[top], energy(test.strain, measured, top, end) / measured_in,
                         energy(test.strain, test.computed, top, end) / computed_in});
    }
    begin = end > top ? end : n;
  }
  return loops;
}

/// By the velocity change less the speed, and less what gravity adds while the sensor, in free fall at zero,
/// feels the pad.
std::optional<double> rebound_of(const MeasuredDeceleration& pulse, const Impactor& impactor) {
  const double rebound = pulse.velocity_change - impactor.speed - impactor.gravity * pulse.time.back();
  return rebound > 0 && rebound <= impactor.speed ? std::optional{rebound} : std::nullopt;
}

/// What the impact computes, filtered as the measured pulse was.
struct Computed {
  std::optional<double> peak, hic, rebound;
};

Computed computed_of(const Solution& solution, const MeasuredDeceleration& measured) {
  Computed of;
  of.peak = solution.summary.peak_acceleration;
  of.rebound = solution.summary.rebound_speed;
  std::optional<Pulse> pulse = smooth_pulse(solution);
  if (pulse && measured.filter) {
    pulse = injury::filtered_like(measured.filter, measured.interval, *pulse);
    of.peak = injury::peak(*pulse).magnitude;
  }
  if (pulse) of.hic = injury::hic(*pulse, injury::unlimited_window).value;
  return of;
}

/// Formulas with few numbers meet the loops of real foams within 1 to 2 % of the largest stress (fits.md).
constexpr double surest_stress = 0.02;
constexpr double worth_of_surest = 2;  ///< impacts

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
  // What was fitted says that the law is no better than that, not that it is as good.
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

RateRange rates_of(const MaterialMeasurement& test) {
  struct Piece {
    double rate, way;
  };
  std::vector<Piece> pieces;
  double all = 0;
  for (std::size_t i = 1; i < test.strain.size(); ++i) {
    const double way = std::abs(test.strain[i] - test.strain[i - 1]);
    const double time = test.time[i] - test.time[i - 1];
    if (!(way > 0 && time > 0) || !counts(test, i)) continue;
    pieces.push_back({way / time, way});
    all += way;
  }
  if (pieces.empty()) return {};
  std::ranges::sort(pieces, {}, &Piece::rate);
  const auto at = [&](double share) {
    double way = 0;
    for (const Piece& piece : pieces)
      if ((way += piece.way) >= share * all) return piece.rate;
    return pieces.back().rate;
  };
  return {at(0.05), at(0.95)};
}

MetTest met_test(const Fit& fit, const MaterialMeasurement& test, std::span<const double> values,
                 double offset) {
  MetTest met;
  met.file = test.file;
  met.is_held_out = test.is_held_out;
  met.noise = test.noise.value_or(0);
  met.noise_is_stated = test.noise.has_value();
  if (test.has_offset && !test.is_held_out) met.offset = offset;
  for (std::size_t i = 0; i < test.strain.size(); ++i)
    if (counts(test, i)) {
      met.strain.push_back(test.strain[i]);
      met.measured.push_back(test.stress[i]);
    }
  met.points = met.strain.size();
  met.largest_stress = std::ranges::max(met.measured);
  const RateRange rates = rates_of(test);
  met.lowest_rate = rates.lowest;
  met.highest_rate = rates.highest;
  met.computed.resize(met.points);
  met.course = courses(met.strain);
  met.effective_points = static_cast<double>(met.points);
  if (!prediction_of(fit, test)(values, met.computed)) return met;
  std::vector<double> up, down;
  for (std::size_t i = 0; i < met.points; ++i)
    (met.course[i] > 0 ? up : down).push_back(met.computed[i] + offset - met.measured[i]);
  if (!up.empty()) met.rms_loading = rms(up);
  if (!down.empty()) met.rms_unloading = rms(down);
  met.loops = loops_of(met, offset, met.course);
  return met;
}

std::vector<MetFigure> met_figures(const Fit& fit, const ImpactMeasurement& impact,
                                   std::span<const double> values) {
  // Without the pulse: one that is missing must not hide the figures.
  ImpactMeasurement alone = impact;
  alone.pulse.reset();
  std::vector<double> computed(impact.figures.size());
  const bool is_solved = prediction_of(fit, alone, 0)(values, computed);
  std::vector<MetFigure> all;
  for (std::size_t i = 0; i < computed.size(); ++i) {
    const MeasuredFigure& measured = impact.figures[i];
    all.push_back(
        {impact.file, measured.figure, impact.is_held_out, measured.value, measured.deviation, {}, {}});
    if (is_solved && std::isfinite(computed[i])) all.back().computed = computed[i];
  }
  return all;
}

MetPulse met_pulse(const Fit& fit, const ImpactMeasurement& impact, std::span<const double> values,
                   std::optional<std::size_t> shift) {
  const MeasuredDeceleration& pulse = *impact.pulse;
  MetPulse met;
  met.file = impact.file;
  met.pulse_file = pulse.file;
  met.is_held_out = impact.is_held_out;
  met.samples = pulse.samples;
  met.deviation = pulse.deviation;
  met.measured_peak = pulse.peak;
  met.time = pulse.time;
  met.measured = pulse.deceleration;
  met.effective_points = static_cast<double>(pulse.time.size());
  if (shift) met.shift = values[*shift];
  ImpactMeasurement alone = impact;
  alone.figures.clear();
  std::vector<double> computed(pulse.time.size());
  if (!prediction_of(fit, alone, 0, shift)(values, computed)) return met;
  std::vector<double> off(computed.size());
  for (std::size_t i = 0; i < off.size(); ++i) off[i] = computed[i] - met.measured[i];
  met.rms = rms(off);
  met.computed_peak = std::ranges::max(computed);
  met.computed = std::move(computed);
  return met;
}

std::vector<ImpactComparison> compared(const Fit& fit, const ImpactMeasurement& impact,
                                       std::span<const double> values) {
  std::vector<ImpactComparison> all;
  const auto add = [&](ImpactFigure figure, double measured, std::optional<double> computed,
                       std::optional<double> deviation) {
    all.push_back({impact.file, figure, impact.is_held_out, !deviation, measured, computed, deviation});
  };
  if (const auto& pulse = impact.pulse) {
    Computed of;
    const ImpactCase with_values = impact_with(fit, impact, values);
    if (violations(with_values).empty()) of = computed_of(solve(with_values, impact.options), *pulse);
    add(ImpactFigure::peak_acceleration, pulse->peak, of.peak, {});
    add(ImpactFigure::hic_unlimited, pulse->hic, of.hic, {});
    if (const auto rebound = rebound_of(*pulse, with_values.impactor))
      add(ImpactFigure::rebound_speed, *rebound, of.rebound, {});
  }
  const auto is_there = [&](ImpactFigure figure) {
    return std::ranges::any_of(
        all, [&](const ImpactComparison& impact_comparison) { return impact_comparison.figure == figure; });
  };
  for (const MetFigure& met : met_figures(fit, impact, values))
    if (met.measured > 0 && kind_of(met.figure) && !is_there(met.figure))
      add(met.figure, met.measured, met.computed, met.deviation);
  return all;
}

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
    for (const ImpactComparison& impact_comparison : compared(fit, fit.impacts[i], values)) {
      found[i].push_back({impact_comparison});
      asked.figures.push_back({impact_comparison.figure, impact_comparison.measured, 1});
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
  session.begin("Leaving out each impact", groups);
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
    const double ratio = sections_of(impact).width / impact.pad.thickness;  // of the curvature at the tip
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
