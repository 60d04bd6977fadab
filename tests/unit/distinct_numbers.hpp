#pragma once
/// Results made by hand in which no two numbers are equal: none can be shown in another's place unnoticed.

#include <cstdint>
#include <vector>

#include "dashpad/fit/report.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/study/answers.hpp"

namespace dashpad::test {

/// Numbers of which none comes twice.
class Distinct {
 public:
  double next() {
    count_ += 1;
    return count_ + 1 / (1.5 + count_);
  }
  study::Estimate estimate() {
    const double value = next(), low = next();
    return {value, low, next()};
  }
  std::vector<double> list(std::size_t size) {
    std::vector<double> values(size);
    for (double& value : values) value = next();
    return values;
  }

 private:
  double count_ = 0;
};

inline study::StudyAnswers answers_with_numbers() {
  Distinct made;
  study::StudyAnswers of;
  of.study.factors = {{.key = "pad.thickness", .unit = "m", .spread = study::Levels{{0.01, 0.02}}},
                      {.key = "impactor.speed", .unit = "m/s", .spread = study::Uniform{1, 3}}};
  of.study.responses = {"peak_force", "peak_acceleration"};
  of.responses = {0, 1};
  of.limits = {{"peak_acceleration", made.next()}, {"peak_force", made.next()}};
  of.rows = 1001;
  of.records.rows = {0, 1, 2};
  of.records.doubtful = 1002;
  of.records.extrapolated = 1003;
  of.records.beyond_strain = 1004;
  of.records.beyond_rate = 1005;
  of.records.bottomed = 1006;
  of.records.struck_through = 1007;
  of.records.time_limit = 1008;
  std::uint64_t count = 2000;
  for (const double level : {0.01, 0.02}) {
    study::StudyAnswers::OfGroup group;
    group.group = {.levels = {level}, .places = {0, 1, 2}, .drawn = true};
    for (int i = 0; i < 2; ++i) {
      study::Distribution distribution;
      distribution.rows = ++count;
      distribution.struck_through = ++count;
      distribution.without = ++count;
      distribution.mean = made.estimate();
      distribution.deviation = made.next();
      distribution.least = made.next();
      distribution.greatest = made.next();
      distribution.quantiles = {{0.05, made.estimate()}, {0.5, made.estimate()}, {0.95, made.estimate()}};
      group.distributions.push_back(distribution);
      study::Exceedance exceedance;
      exceedance.probability = made.estimate();
      exceedance.exceeding = ++count;
      exceedance.struck_through = ++count;
      exceedance.rows = ++count;
      exceedance.undecided = ++count;
      group.exceedances.push_back(exceedance);
      study::Sensitivity sensitivity{.indices = {{"impactor.speed", made.estimate(), made.estimate()}}};
      sensitivity.draws = ++count;
      sensitivity.left_out = ++count;
      group.sensitivities.emplace_back(sensitivity);
    }
    of.groups.push_back(group);
  }
  of.cushion_curves = study::CushionCurves{
      .drops = {{made.next(), made.next(), {{made.next(), made.list(2), made.list(2)}}}}};
  return of;
}

inline injury::InjuryFigures figures_with_numbers(Distinct& made) {
  injury::InjuryFigures of;
  of.peak = {made.next(), made.next()};
  for (injury::Hic* hic : {&of.hic15, &of.hic36, &of.hic_unlimited})
    *hic = {.value = made.next(), .begin = made.next(), .end = made.next()};
  of.hic_d = made.next();
  for (injury::Clip* clip : {&of.clip_3ms, &of.cumulative_3ms})
    *clip = {.level = made.next(), .begin = made.next(), .end = made.next()};
  of.severity_index = made.next();
  of.velocity_change = made.next();
  return of;
}

inline injury::PulseReport pulse_with_numbers() {
  Distinct made;
  injury::PulseReport of;
  of.measured.pulse = {{0.25, 0.5, 0.75}, {1, 2, 3}};
  of.measured.time = {.number = 101, .unit = "ms", .factor = made.next()};
  of.measured.acceleration = {{.number = 102, .unit = "g", .factor = made.next()}};
  of.resampled_to = made.next();
  of.filter = injury::PulseFilter{.channel_frequency_class = 600};
  of.offset = injury::OffsetEffect{
      .offset = {made.next(), made.next(), 103, {made.next(), made.next()}, {made.next(), made.next()}},
      .hic15_with = made.next(),
      .hic15_without = made.next()};
  of.pulse = {{1, 2, 3, 4}, {0, 1, 2, 0}};
  of.figures = figures_with_numbers(made);
  of.impact = injury::MeasuredImpact{made.next(), made.next(), made.next()};
  of.contact = {.begin = made.next(), .end = made.next()};
  of.contact.velocity_change =  // of a restitution of 0.4
      1.4 * of.impact->speed + of.impact->gravity * (of.contact.end - of.contact.begin);
  of.windows = {{made.next(), {.value = made.next(), .begin = made.next(), .end = made.next()}}};
  of.dwells = {{made.next(), made.next(), made.next()}};
  return of;
}

inline fit::FitReport fit_with_numbers() {
  Distinct made;
  fit::FitReport of;
  fit::FittedUnknown unknown;
  unknown.key = "pad.scale";
  unknown.value = made.next();
  unknown.lowest = made.next();
  unknown.highest = made.next();
  unknown.standard_error = made.next();
  unknown.low = made.next();
  unknown.high = made.next();
  of.unknowns = {unknown};
  of.correlations = {{"a", "b", made.next()}};
  fit::MetTest test;
  test.points = 101;
  test.largest_stress = made.next();
  test.lowest_rate = made.next();
  test.highest_rate = made.next();
  test.noise = made.next();
  test.offset = made.next();
  test.rms_loading = made.next();
  test.rms_unloading = made.next();
  test.loops = {{made.next(), made.next(), made.next()}};
  test.autocorrelation = made.next();
  test.effective_points = made.next();
  test.strain = made.list(2);
  test.measured = made.list(2);
  test.computed = made.list(2);
  test.course = {1, -1};
  of.tests = {test};
  of.figures = {{"drop.toml", fit::ImpactFigure::rebound_speed, false, made.next(), made.next(), made.next(),
                 made.next()}};
  fit::MetPulse pulse;
  pulse.samples = 102;
  pulse.deviation = made.next();
  pulse.measured_peak = made.next();
  pulse.computed_peak = made.next();
  pulse.rms = made.next();
  pulse.shift = made.next();
  pulse.autocorrelation = made.next();
  pulse.effective_points = made.next();
  pulse.time = made.list(3);
  pulse.measured = made.list(3);
  pulse.computed = made.list(3);
  of.pulses = {pulse};
  of.comparison = {{"drop.toml", fit::ImpactFigure::hic15, false, true, made.next(), made.next(), {}}};
  of.points = 103;
  of.priors = 104;
  of.degrees_of_freedom = made.next();
  of.misfit = made.next();
  of.variance_scale = made.next();
  of.largest_widening = made.next();
  of.starts = 105;
  of.starts_at_best = 106;
  of.starts_failed = 107;
  of.solver_runs = 108;
  of.evaluations = 109;
  of.wall_time = made.next();
  return of;
}

}  // namespace dashpad::test
