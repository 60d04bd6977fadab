// What sampling, filter and calibration leave open of a pulse, against closed forms.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>

#include "dashpad/injury/hic.hpp"
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

const FigureUncertainty& figure(const MeasurementUncertainty& of, const std::string& key) {
  return *std::ranges::find_if(of.figures, [&](const auto& each) { return key == each.quantity->key; });
}

TEST(PulseUncertainty, OfSamplingHoldsTheTruePeakAndHic) {
  for (const auto& shape : {half_sine, haversine, skewed}) {
    const double hic = report_of(shape, 1e-6, 0).figures.hic15.value;
    double most_hidden = 0, most_said = 0;
    for (int k = 0; k < 10; ++k) {
      const PulseReport report = report_of(shape, 0.5e-3, k / 10.0);
      const MeasurementUncertainty of = measurement_uncertainty(report, {});
      const double hidden = top / report.figures.peak.magnitude - 1;
      const double said = figure(of, "peak_acceleration").sampling;
      EXPECT_LE(hidden, 1.01 * said) << k;
      EXPECT_LE(std::abs(hic / report.figures.hic15.value - 1), 1.01 * figure(of, "hic15").sampling) << k;
      most_hidden = std::max(most_hidden, hidden);
      most_said = std::max(most_said, said);
    }
    EXPECT_LT(most_said, 5 * most_hidden);
  }
}

TEST(PulseUncertainty, OfACalibrationIsWhatAScaleDoes) {
  const PulseReport report = report_of(skewed, 1e-4, 0.3), scaled = report_of(skewed, 1e-4, 0.3, {}, 1.02);
  const MeasurementUncertainty of = measurement_uncertainty(report, 0.02);
  EXPECT_NEAR(figure(of, "peak_acceleration").calibration.value(), 0.02, 1e-12);
  EXPECT_NEAR(figure(of, "hic15").calibration.value(),
              scaled.figures.hic15.value / report.figures.hic15.value - 1, 1e-9);
  const FigureUncertainty& peak = figure(of, "peak_acceleration");
  EXPECT_NEAR(peak.combined(), std::hypot(peak.sampling, 0.02), 1e-12);
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

}  // namespace
}  // namespace dashpad::injury
