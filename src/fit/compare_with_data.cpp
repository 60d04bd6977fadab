#include "fit/card.hpp"

#include <algorithm>
#include <cmath>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "fit/problem.hpp"

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

/// The rebound speed: the velocity change less the impact speed and less what gravity adds while the sensor,
/// which reads zero in free fall, feels the pad.
std::optional<double> rebound_of(const MeasuredDeceleration& pulse, const Impactor& impactor) {
  const double rebound = pulse.velocity_change - impactor.speed - impactor.gravity * pulse.time.back();
  return rebound > 0 && rebound <= impactor.speed ? std::optional{rebound} : std::nullopt;
}

/// Figures of the computed impact, with the filter of the measured pulse.
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
  // The pulse is left out, since without a whole pulse the figures would be missing, too.
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
        all, [&](const ImpactComparison& comparison) { return comparison.figure == figure; });
  };
  for (const MetFigure& met : met_figures(fit, impact, values))
    if (met.measured > 0 && kind_of(met.figure) && !is_there(met.figure))
      add(met.figure, met.measured, met.computed, met.deviation);
  return all;
}

}  // namespace dashpad::fit
