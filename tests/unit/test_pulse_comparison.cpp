/// A measured pulse beside a computed one: shapes against closed forms, alignment, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <stdexcept>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/pulse_comparison.hpp"
#include "dashpad/injury/pulse_report.hpp"
#include "dashpad/input/case_file.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using injury::Alignment;
using injury::compare_pulses;
using injury::compared_figures;
using injury::ComparedFigure;
using injury::pulse_shape;
using injury::PulseComparison;
using injury::PulseReport;
using injury::PulseShape;

constexpr double height = 400;  // m/s2

/// A triangle from 0 to 10 ms with its peak at 4 ms, free flight before and after, times `later` by so much.
Pulse triangle(double factor = 1, double later = 0) {
  Pulse pulse{{-5e-3, 0, 4e-3, 10e-3, 30e-3}, {0, 0, height, 0, 0}};
  for (double& time : pulse.time) time += later;
  for (double& value : pulse.acceleration) value *= factor;
  return pulse;
}

PulseReport report_of(Pulse pulse) {
  PulseReport report;
  report.measured.pulse = pulse;
  report.contact = injury::contact_of(pulse);
  report.pulse = std::move(pulse);
  return report;
}

ImpactCase case_of(const char* example) {
  return input::read_case(source_folder / "examples" / example, source_folder / "materials").value().impact;
}

const Solution& computed() {
  static const Solution solution = solve(case_of("dashboard-20mph.toml"), {.tolerance = 1e-5});
  return solution;
}
injury::MeasuredImpact at(double speed) { return {.speed = speed}; }
injury::MeasuredImpact impact() { return at(case_of("dashboard-20mph.toml").impactor.speed); }

/// The history, as a sensor that is mounted the other way round and triggered 13 ms earlier sees it.
Pulse measured_alike() {
  Pulse pulse = injury::pulse_of(computed().history);
  for (double& time : pulse.time) time += 13e-3;
  for (double& value : pulse.acceleration) value = -value;
  return pulse;
}

const ComparedFigure& figure(const PulseComparison& pulse_comparison, const std::string& key) {
  for (const ComparedFigure& each : pulse_comparison.figures)
    if (each.quantity->key == key) return each;
  throw std::invalid_argument(key);
}

TEST(PulseShape, OfATriangle) {
  for (const double factor : {1.0, -1.0}) {
    const PulseShape shape = pulse_shape(triangle(factor, 50e-3), {});
    EXPECT_EQ(shape.peak.magnitude, height);
    EXPECT_EQ(shape.side, factor);
    EXPECT_NEAR(*shape.onset, 50e-3 + 0.05 * 4e-3, 1e-15);
    EXPECT_NEAR(shape.width, 5e-3, 1e-15);
    EXPECT_NEAR(shape.contact.begin, 50e-3, 1e-15);
    EXPECT_NEAR(shape.contact.end, 60e-3, 1e-15);
    EXPECT_NEAR(shape.contact.velocity_change, height * 10e-3 / 2, 1e-12);
    EXPECT_FALSE(shape.restitution);
  }
}

TEST(PulseShape, NoiseBeforeTheImpactIsNotItsLastOnset) {
  EXPECT_EQ(pulse_shape(triangle(), {}).last_onset, pulse_shape(triangle(), {}).onset);
  const PulseShape noisy = pulse_shape({{0, 1e-3, 2e-3, 20e-3, 24e-3, 30e-3}, {0, 30, 0, 0, 400, 0}}, {});
  EXPECT_NEAR(*noisy.onset, 1e-3 * 20 / 30, 1e-15);
  EXPECT_NEAR(*noisy.last_onset, 20e-3 + 0.05 * 4e-3, 1e-15);
}

/// An undershoot and a second impact are not of the contact; its ends lie between samples.
TEST(PulseShape, ContactKeepsTheSignOfThePeak) {
  const Pulse pulse{{0, 1e-3, 2e-3, 4e-3, 6e-3, 8e-3, 9e-3}, {-100, -100, 300, 400, -400, 100, 0}};
  const PulseShape shape = pulse_shape(pulse, {});
  EXPECT_NEAR(shape.contact.begin, 1.25e-3, 1e-15);
  EXPECT_NEAR(shape.contact.end, 5e-3, 1e-15);
  EXPECT_NEAR(shape.contact.velocity_change, 300 * 0.75e-3 / 2 + 350 * 2e-3 + 400 * 1e-3 / 2, 1e-12);
  const PulseShape all = pulse_shape({{0, 1e-3}, {100, 300}}, {});
  EXPECT_EQ(all.contact.begin, 0);
  EXPECT_EQ(all.contact.end, 1e-3);
}

TEST(PulseShape, RestitutionIsThatOfTheVelocityChange) {
  const double change = height * 10e-3 / 2;
  EXPECT_NEAR(*pulse_shape(triangle(), at(change / 1.4)).restitution, 0.4, 1e-12);
  EXPECT_TRUE(pulse_shape(triangle(), at(change / 1.999)).restitution);
  for (const double factor : {2.01, 0.99})
    EXPECT_FALSE(pulse_shape(triangle(), at(change / factor)).restitution) << factor;
}

/// A pulse counts as cut where it ends above four times the noise of its quiet part alone: 2 m/s2 here, after
/// a part with noise of 10 m/s2.
TEST(PulseFlags, NoiseIsThatOfTheQuietPart) {
  const auto flagged = [](double at_end) {
    Pulse pulse;
    const auto add = [&](double value) {
      pulse.time.push_back(1e-3 * static_cast<double>(pulse.time.size()));
      pulse.acceleration.push_back(value);
    };
    for (int i = 0; i < 20; ++i) add(i % 2 == 0 ? 10 : -10);
    for (int i = 0; i < 20; ++i) add(i % 2 == 0 ? 2 : -2);
    for (const double value : {200.0, height, 200.0, at_end}) add(value);
    PulseReport report = report_of(pulse);
    report.offset = injury::OffsetEffect{};
    report.offset->offset.begin = 20e-3;
    report.offset->offset.end = 39e-3;
    return !injury::flags(report, pulse).empty();
  };
  EXPECT_FALSE(flagged(7.9));
  EXPECT_TRUE(flagged(8.1));
}

TEST(PulseFlags, SayWhichWayAnOffsetMovesHic) {
  injury::OffsetEffect effect;
  effect.hic15_with = 110;
  effect.hic15_without = 100;
  EXPECT_EQ(injury::change_of_hic15(effect), "HIC15 is 10 % higher with the offset than without");
  effect.hic15_with = 80;
  EXPECT_EQ(injury::change_of_hic15(effect), "HIC15 is 20 % lower with the offset than without");
}

TEST(PulseShape, RefusesAPulseWithoutAcceleration) {
  try {
    pulse_shape(triangle(0), {});
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("0 throughout"));
  }
  EXPECT_THROW(pulse_shape({{0, 1}, {0, NAN}}, {}), std::invalid_argument);
}

TEST(PulseShape, WithoutAnOnsetCanBeAlignedOtherwise) {
  const PulseShape late = pulse_shape({{0, 1e-3, 2e-3}, {21, 400, 0}}, {});
  EXPECT_FALSE(late.onset);
  EXPECT_THROW(injury::check_alignment(late, Alignment::onset), std::invalid_argument);
  for (const Alignment alignment : {Alignment::peak, Alignment::none}) {
    EXPECT_NO_THROW(injury::check_alignment(late, alignment));
    EXPECT_EQ(compared_figures(late, late, alignment)[1].measured.has_value(), alignment == Alignment::none);
  }
  EXPECT_NEAR(*pulse_shape({{0, 1e-3, 2e-3}, {19, 400, 0}}, {}).onset, 1e-3 / 381, 1e-15);
}

TEST(PulseComparison, OfAPulseWithItselfIsZero) {
  const PulseShape shape = pulse_shape(triangle(), at(1.5));
  for (const Alignment alignment : injury::all_alignments)
    for (const ComparedFigure& each : compared_figures(shape, shape, alignment)) {
      EXPECT_EQ(each.difference(), 0.0) << each.quantity->key;
      EXPECT_EQ(each.share(), 0.0) << each.quantity->key;
    }
}

TEST(PulseComparison, NamesTheDifferences) {
  Pulse longer = triangle(1.5, 2e-3);
  longer.time[2] += 1e-3;  // the peak 5 ms after the beginning
  for (const Alignment alignment : {Alignment::onset, Alignment::none}) {
    const auto figures = compared_figures(pulse_shape(triangle(), {}), pulse_shape(longer, {}), alignment);
    EXPECT_NEAR(*figures[0].difference(), 0.5 * height, 1e-9);
    EXPECT_NEAR(*figures[0].share(), 0.5, 1e-12);
    EXPECT_NEAR(*figures[1].difference(), alignment == Alignment::onset ? 0.95e-3 : 3e-3, 1e-15);
    EXPECT_NEAR(*figures[2].difference(), 0, 1e-15);
    EXPECT_NEAR(*figures[3].share(), 0.5, 1e-12);
    EXPECT_NEAR(*figures[4].share(), std::pow(1.5, 2.5) - 1, 1e-3);
    EXPECT_FALSE(figures[5].difference());
  }
}

/// But for the peak, which lies between two samples of the history.
TEST(PulseComparison, AlignsAMeasuredPulseWithTheComputedOne) {
  constexpr double half_a_step = 5e-5;
  for (const auto& [alignment, shift] :
       {std::pair{Alignment::onset, -13e-3}, {Alignment::peak, -13e-3}, {Alignment::none, 0.0}}) {
    const PulseComparison pulse_comparison =
        compare_pulses(report_of(measured_alike()), computed(), impact(), alignment);
    EXPECT_NEAR(pulse_comparison.shift, shift, alignment == Alignment::peak ? half_a_step : 1e-7)
        << injury::to_string(alignment);
    EXPECT_NEAR(*figure(pulse_comparison, "time_to_peak").difference(),
                alignment == Alignment::none ? -13e-3 : 0, half_a_step);
    for (const char* key : {"peak_acceleration", "half_peak_width", "velocity_change", "hic15"})
      EXPECT_NEAR(*figure(pulse_comparison, key).share(), 0, 1e-4) << key;
    EXPECT_EQ(figure(pulse_comparison, "peak_acceleration").computed, computed().summary.peak_acceleration);
    EXPECT_NEAR(*figure(pulse_comparison, "restitution").computed, *computed().summary.restitution, 1e-3);
  }
}

/// Against a run 1,000 times as accurate.
TEST(PulseComparison, ComputedFiguresAreWithinTheirErrors) {
  Options options;
  const auto at = [&](double tolerance) {
    options.tolerance = tolerance;
    return compare_pulses(report_of(triangle()), solve(case_of("dashboard-20mph.toml"), options), impact(),
                          Alignment::onset);
  };
  const PulseComparison exact = at(1e-6);
  for (const double tolerance : {1e-3, 1e-4}) {
    const PulseComparison now = at(tolerance);
    for (std::size_t i = 0; i < now.figures.size(); ++i) {
      const ComparedFigure& compared_figure = now.figures[i];
      const double off = std::abs(*compared_figure.computed / *exact.figures[i].computed - 1);
      EXPECT_LE(off, compared_figure.error) << compared_figure.quantity->key << " at " << tolerance;
      EXPECT_LE(compared_figure.error, 100 * tolerance)
          << compared_figure.quantity->key << " at " << tolerance;
    }
  }
}

/// What each error of the solver adds to those of the figures.
TEST(PulseComparison, ErrorsOfTheSolverCountAsTheyEnterTheFigures) {
  const auto errors = [](const ErrorEstimates& error_estimates) {
    Solution solution = computed();
    solution.summary.errors = error_estimates;
    const PulseComparison now = compare_pulses(report_of(triangle()), solution, impact(), Alignment::onset);
    std::map<std::string, double> all;
    for (const ComparedFigure& each : now.figures) all[each.quantity->key] = each.error;
    return all;
  };
  const PulseComparison now = compare_pulses(report_of(triangle()), computed(), impact(), Alignment::onset);
  const double end = computed().summary.contact_end->time / *figure(now, "time_to_peak").computed;
  const double rebound = 1 / *figure(now, "restitution").computed;
  ASSERT_GT(end, 1.5);
  const auto none = errors({});
  const auto expect_added = [&](const ErrorEstimates& error_estimates,
                                const std::map<std::string, double>& expected) {
    auto added = errors(error_estimates);
    for (auto& [key, error] : added) {
      const auto found = expected.find(key);
      EXPECT_NEAR(error - none.at(key), found == expected.end() ? 0 : found->second, 1e-12) << key;
    }
  };
  expect_added({.time_of_peak_force = 0.01}, {{"time_to_peak", 0.01 * end}});
  expect_added({.contact_end = 0.01}, {{"time_to_peak", 0.01 * end}, {"half_peak_width", 0.01}});
  expect_added({.peak_force = 0.01}, {{"peak_acceleration", 0.01},
                                      {"velocity_change", 0.01},
                                      {"hic15", 0.025},
                                      {"restitution", 0.01 * (1 + rebound)}});
}

/// Both pulses get the filter: the history as a sensor sees it, in free flight before and after, agrees with
/// it, and the peak is lower than without.
TEST(PulseComparison, FiltersBothPulsesAlike) {
  Pulse flight = measured_alike();
  flight.time.insert(flight.time.begin(), {-20e-3, 13e-3 - 1e-6});
  flight.acceleration.insert(flight.acceleration.begin(), {0, 0});
  flight.time.insert(flight.time.end(), {flight.time.back() + 1e-6, flight.time.back() + 50e-3});
  flight.acceleration.insert(flight.acceleration.end(), {0, 0});
  PulseReport report = report_of(flight);
  report.filter = injury::PulseFilter{.channel_frequency_class = 60};
  report.pulse = injury::processed_pulse(report.measured, 1e-5, report.filter).pulse;
  report.contact = injury::contact_of(report.pulse);
  const PulseComparison pulse_comparison = compare_pulses(report, computed(), impact(), Alignment::onset);
  for (const ComparedFigure& each : pulse_comparison.figures)
    EXPECT_NEAR(each.share().value_or(0), 0, 1e-3) << each.quantity->key;
  EXPECT_LT(*figure(pulse_comparison, "peak_acceleration").computed,
            0.999 * *computed().summary.peak_acceleration);
  EXPECT_NEAR(pulse_comparison.shift, -13e-3, 1e-5);
}

TEST(PulseComparison, WithoutAWholeComputedPulseComparesNothing) {
  const ImpactCase bottoming = case_of("rigid-floor-bottoming.toml");
  const PulseComparison pulse_comparison = compare_pulses(report_of(triangle(1, 7e-3)), solve(bottoming, {}),
                                                          at(bottoming.impactor.speed), Alignment::onset);
  EXPECT_FALSE(pulse_comparison.computed);
  EXPECT_NEAR(pulse_comparison.shift, -7.2e-3, 1e-12);  // the onset is where the computed times begin
  EXPECT_GT(pulse_comparison.computed_pulse.time.size(), 2U);
  for (const ComparedFigure& each : pulse_comparison.figures)
    EXPECT_FALSE(each.computed) << each.quantity->key;
  EXPECT_EQ(pulse_comparison.figures[0].measured, height);
}

}  // namespace
}  // namespace dashpad::test
