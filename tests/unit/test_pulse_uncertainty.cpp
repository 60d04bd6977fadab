// What sampling, filter and calibration leave open of a pulse, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "dashpad/injury/metrics.hpp"
#include "dashpad/injury/pulse_report.hpp"

namespace dashpad::injury {
namespace {

constexpr double top = 800, duration = 10e-3;  // m/s2, s

PulseReport report_of(const std::function<double(double)>& shape, double step, double phase,
                      const std::optional<PulseFilter>& filter = {}, double factor = 1) {
  PulseReport report;
  for (int i = -200; i * step < 0.05; ++i) {
    report.measured.pulse.time.push_back((i + phase) * step);
    report.measured.pulse.acceleration.push_back(factor * shape((i + phase) * step));
  }
  report.filter = filter;
  report.pulse = processed_pulse(report.measured, {}, filter).pulse;
  report.contact = contact_of(report.pulse);
  report.figures = injury_figures(report.pulse);
  return report;
}

double half_sine(double time) {
  return time > 0 && time < duration ? top * std::sin(std::numbers::pi * time / duration) : 0;
}
double haversine(double time) {
  return time > 0 && time < duration ? top * (1 - std::cos(2 * std::numbers::pi * time / duration)) / 2 : 0;
}
/// Rises in 3 ms and falls in 7 ms, each along a quarter of a sine.
double skewed(double time) {
  if (!(time > 0 && time < duration)) return 0;
  return top * std::sin(std::numbers::pi / 2 * (time < 3e-3 ? time / 3e-3 : (duration - time) / 7e-3));
}

const FigureUncertainty& figure(const MeasurementUncertainty& measurement_uncertainty,
                                const std::string& key) {
  return *std::ranges::find_if(measurement_uncertainty.figures,
                               [&](const auto& each) { return key == each.quantity->key; });
}

TEST(PulseUncertainty, OfSamplingHoldsTheTruePeakAndHic) {
  for (const auto& shape : {half_sine, haversine, skewed}) {
    const double hic = report_of(shape, 1e-6, 0).figures.hic15.value;
    double max_hidden = 0, max_said = 0;
    for (int k = 0; k < 10; ++k) {
      const PulseReport report = report_of(shape, 0.5e-3, k / 10.0);
      const MeasurementUncertainty of = measurement_uncertainty(report, {});
      const double hidden = top / report.figures.peak.magnitude - 1;
      const double said = figure(of, "peak_acceleration").sampling.value();
      EXPECT_LE(hidden, 1.01 * said) << k;
      EXPECT_LE(std::abs(hic / report.figures.hic15.value - 1), 1.01 * figure(of, "hic15").sampling.value())
          << k;
      max_hidden = std::max(max_hidden, hidden);
      max_said = std::max(max_said, said);
    }
    EXPECT_LT(max_said, 5 * max_hidden);
  }
}

TEST(PulseUncertainty, OfACalibrationIsWhatAScaleDoes) {
  const PulseReport report = report_of(skewed, 1e-4, 0.3), scaled = report_of(skewed, 1e-4, 0.3, {}, 1.02);
  const MeasurementUncertainty of = measurement_uncertainty(report, 0.02);
  EXPECT_NEAR(figure(of, "peak_acceleration").calibration.value(), 0.02, 1e-12);
  EXPECT_NEAR(figure(of, "hic15").calibration.value(),
              scaled.figures.hic15.value / report.figures.hic15.value - 1, 1e-9);
  const FigureUncertainty& peak = figure(of, "peak_acceleration");
  EXPECT_NEAR(peak.combined(), std::hypot(peak.sampling.value(), 0.02), 1e-12);
  EXPECT_FALSE(peak.filter);
  EXPECT_FALSE(figure(measurement_uncertainty(report, {}), "hic15").calibration);
}

TEST(PulseUncertainty, OfAFilterIsWhatTheNextClassLeaves) {
  const PulseReport low = report_of(skewed, 1e-4, 0, PulseFilter{.channel_frequency_class = 60});
  const PulseReport next = report_of(skewed, 1e-4, 0, PulseFilter{.channel_frequency_class = 180});
  const MeasurementUncertainty of = measurement_uncertainty(low, {});
  EXPECT_EQ(of.compared_with, "CFC180");
  EXPECT_NEAR(figure(of, "peak_acceleration").filter.value(),
              2 / std::sqrt(3) * (next.figures.peak.magnitude / low.figures.peak.magnitude - 1), 1e-6);
  const PulseReport highest = report_of(skewed, 1e-4, 0, PulseFilter{.channel_frequency_class = 1000});
  EXPECT_EQ(measurement_uncertainty(highest, {}).compared_with, "no filter");
}

/// Two axes with one shape and one with none: the resultant is that shape, so that a factor on all is one on
/// it.
PulseReport resultant_of_two(double step, double phase, const std::optional<PulseFilter>& filter,
                             std::optional<double> interval = {}) {
  PulseReport report = report_of(skewed, step, phase);
  const std::vector<double> shape = report.measured.pulse.acceleration;
  for (const double share : {0.6, -0.8}) {
    report.measured.components.push_back(shape);
    for (double& value : report.measured.components.back()) value *= share;
  }
  report.measured.resultant = true;
  report.measured.pulse.acceleration = injury::resultant_of(report.measured.components);
  report.filter = filter;
  report.resampled_to = interval;
  const ProcessedPulse pulse = processed_pulse(report.measured, interval, filter);
  report.pulse = pulse.pulse;
  report.contact = contact_of(pulse.along());
  report.figures = injury_figures(report.pulse);
  return report;
}

TEST(PulseUncertainty, OfAResultantOfOneShapeIsThatOfTheShape) {
  for (const std::optional<PulseFilter>& filter :
       {std::optional<PulseFilter>{}, std::optional{PulseFilter{.channel_frequency_class = 60}}}) {
    const PulseReport alone = report_of(skewed, 5e-4, 0.3, filter);
    const MeasurementUncertainty of = measurement_uncertainty(alone, 0.02);
    const MeasurementUncertainty both = measurement_uncertainty(resultant_of_two(5e-4, 0.3, filter), 0.02);
    ASSERT_EQ(both.figures.size(), of.figures.size());
    for (const FigureUncertainty& each : of.figures) {
      const FigureUncertainty& same = figure(both, each.quantity->key);
      // A filter rings below zero, and the length of that is above: by less than a hundredth of the figure.
      const double near = filter ? 0.01 : 1e-9;
      EXPECT_NEAR(same.sampling.value(), each.sampling.value(), near) << each.quantity->key;
      EXPECT_NEAR(same.calibration.value(), each.calibration.value(), 1e-12) << each.quantity->key;
      if (filter) {
        EXPECT_NEAR(same.filter.value(), each.filter.value(), near) << each.quantity->key;
      }
    }
  }
}

/// Half a sine every 0.5 ms: the parabola through the largest sample and its neighbours is known, and so is
/// what lies above the sample. Across it, half as much in the peak and a quarter of the time later, is
/// another.
TEST(PulseUncertainty, OfTwoAxesIsTheirClosedForm) {
  constexpr double step = 5e-4;
  PulseReport report;
  std::vector<double> x, y;
  for (int i = -40; i < 100; ++i) {
    const double time = (i + 0.5) * step;
    report.measured.pulse.time.push_back(time);
    x.push_back(half_sine(time));
    y.push_back(half_sine(time - duration / 4) / 2);
  }
  report.measured.components = {x, y};
  report.pulse = processed_pulse(report.measured, {}, {}).pulse;
  report.measured.pulse.acceleration = report.pulse.acceleration;
  report.contact = contact_of(report.pulse);
  report.figures = injury_figures(report.pulse);
  const std::vector<double>& length = report.pulse.acceleration;
  const auto at = static_cast<std::size_t>(std::ranges::max_element(length) - length.begin());
  const auto squared = [&](std::size_t i) { return x[i] * x[i] + y[i] * y[i]; };
  EXPECT_NEAR(length[at], std::sqrt(squared(at)), 1e-9);
  const double second = std::sqrt(squared(at - 1)) - 2 * std::sqrt(squared(at)) + std::sqrt(squared(at + 1));
  const double said = figure(measurement_uncertainty(report, {}), "peak_acceleration").sampling.value();
  EXPECT_NEAR(said, 2 / std::sqrt(3) * std::abs(second) / 8 / length[at], 1e-9);
}

TEST(PulseUncertainty, OfAnEndOrOfThreeSamplesNothingIsKnown) {
  PulseReport report;
  report.measured.pulse = {{0, 1e-3, 2e-3, 3e-3, 4e-3}, {0, 100, 200, 300, 400}};
  report.pulse = report.measured.pulse;
  report.contact = contact_of(report.pulse);
  report.figures = injury_figures(report.pulse);
  MeasurementUncertainty of = measurement_uncertainty(report, {});
  EXPECT_TRUE(std::ranges::none_of(
      of.figures, [](const auto& each) { return each.quantity->key == std::string("peak_acceleration"); }));
  EXPECT_TRUE(figure(of, "hic15").sampling);
  of = measurement_uncertainty(report, 0.02);
  EXPECT_FALSE(figure(of, "peak_acceleration").sampling);
  EXPECT_NEAR(figure(of, "peak_acceleration").combined(), 0.02, 1e-15);

  report.measured.pulse = {{0, 1e-3, 2e-3}, {0, 100, 0}};
  report.pulse = report.measured.pulse;
  report.contact = contact_of(report.pulse);
  report.figures = injury_figures(report.pulse);
  EXPECT_TRUE(measurement_uncertainty(report, {}).figures.empty());
}

/// Samples between the given ones, on the straight lines between them, change no figure; a filter beside them
/// does what it does to the given ones.
TEST(PulseUncertainty, OfResampledAndFilteredIsThatOfTheFiltered) {
  const PulseFilter filter{.channel_frequency_class = 180};
  const PulseReport given = report_of(skewed, 1e-4, 0, filter);
  PulseReport finer = report_of(skewed, 1e-4, 0);
  finer.filter = filter;
  finer.resampled_to = 5e-5;
  finer.pulse = processed_pulse(finer.measured, finer.resampled_to, filter).pulse;
  finer.contact = contact_of(finer.pulse);
  finer.figures = injury_figures(finer.pulse);
  ASSERT_NEAR(finer.pulse.time[1] - finer.pulse.time[0], 5e-5, 1e-12);
  EXPECT_NEAR(finer.figures.hic15.value / given.figures.hic15.value, 1, 1e-3);
  const MeasurementUncertainty of = measurement_uncertainty(given, {}),
                               resampled = measurement_uncertainty(finer, {});
  EXPECT_EQ(resampled.compared_with, "CFC600");
  for (const char* key : {"peak_acceleration", "hic15", "velocity_change"}) {
    EXPECT_NEAR(figure(resampled, key).filter.value(), figure(of, key).filter.value(), 1e-3) << key;
    EXPECT_NEAR(figure(resampled, key).sampling.value(), figure(of, key).sampling.value(), 1e-3) << key;
  }
}

}  // namespace
}  // namespace dashpad::injury
