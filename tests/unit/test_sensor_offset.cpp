// The offset of a sensor: where the quiet part before an impact is found, and what is taken off.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <random>
#include <stdexcept>

#include "dashpad/injury/measured_pulse.hpp"
#include "dashpad/injury/metrics.hpp"
#include "shared/gravity.hpp"

namespace dashpad {
namespace {

using injury::MeasuredPulse;
using injury::offset_before_impact;
using ::testing::DoubleNear;
using ::testing::ElementsAre;

constexpr double duration = 10e-3, sample_interval = 0.1e-3;  // s

double half_sine(double time) {
  return time > 0 && time < duration ? std::sin(std::numbers::pi * time / duration) : 0;
}

/// 100 g times the shape, from `begin` s on, with an offset and with noise of that standard deviation, in g.
MeasuredPulse pulse_of(const std::function<double(double)>& shape, double begin, double offset = 0,
                       double noise = 0) {
  std::mt19937 random(1984);
  const auto one = [&] { return static_cast<double>(random()) / 4294967296.0; };
  MeasuredPulse measured;
  for (int i = 0; i <= std::lround((15e-3 - begin) / sample_interval); ++i) {
    const double time = begin + i * sample_interval;
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += one();
    measured.pulse.time.push_back(time);
    measured.pulse.acceleration.push_back(g * (100 * shape(time) + offset + noise * sum));
  }
  return measured;
}

TEST(sensor_offset, is_the_mean_of_the_quiet_part) {
  for (const double offset : {0.0, 1.2, -30.0, 500.0}) {
    SCOPED_TRACE(offset);
    const auto found = offset_before_impact(pulse_of(half_sine, -5e-3, offset));
    ASSERT_TRUE(found);
    EXPECT_DOUBLE_EQ(found->mean.at(0), offset * g);
    EXPECT_NEAR(found->scatter.at(0), 0, 1e-12 * g);
    EXPECT_EQ(found->begin, -5e-3);
    EXPECT_LT(found->end, 0);
    EXPECT_GT(found->end, -2e-3);
    EXPECT_EQ(static_cast<double>(found->samples),
              std::round((found->end - found->begin) / sample_interval) + 1);
  }
}

/// 1 g at rest for 250 ms, then 0 g in a fall of 300 ms; with noise of 0.6 g, too.
TEST(sensor_offset, is_that_of_the_fall_and_not_of_the_rest_before) {
  for (const double noise : {0.0, 0.6}) {
    SCOPED_TRACE(noise);
    MeasuredPulse measured = pulse_of(half_sine, -550e-3, 0.2, noise);
    for (std::size_t i = 0; i < 2500; ++i) measured.pulse.acceleration[i] += g;
    const auto found = offset_before_impact(measured);
    ASSERT_TRUE(found);
    EXPECT_NEAR(found->mean.at(0), 0.2 * g, 4 * noise * g / std::sqrt(2900) + 1e-9);
    EXPECT_NEAR(found->begin, -300e-3, noise > 0 ? 20 * sample_interval : 1e-9);
    ASSERT_TRUE(found->rest);
    EXPECT_NEAR(found->rest->mean.at(0), 1.2 * g, 4 * noise * g / std::sqrt(2400) + 1e-9);
    const std::size_t before = measured.pulse.time.size();
    injury::find_offset(measured, std::nullopt, false);
    EXPECT_EQ(measured.pulse.time.front(), found->begin);
    EXPECT_EQ(measured.pulse.time.size(), measured.pulse.acceleration.size());
    EXPECT_NEAR(static_cast<double>(before - measured.pulse.time.size()), 2500, noise > 0 ? 20 : 0);
    EXPECT_EQ(measured.remarks.size(), 1U);
  }
}

/// Noise, also where neighbours are alike, and a weak hum are one level.
TEST(sensor_offset, has_no_earlier_level_without_a_step) {
  EXPECT_FALSE(offset_before_impact(pulse_of(half_sine, -550e-3, 0.2, 0.6))->rest);
  EXPECT_FALSE(offset_before_impact(pulse_of(half_sine, -550e-3, 1.2))->rest);
  MeasuredPulse humming = pulse_of(half_sine, -550e-3, 0.2, 0.2);
  for (std::size_t i = 0; i < humming.pulse.time.size(); ++i)
    humming.pulse.acceleration[i] += g * std::sin(2 * std::numbers::pi * 50 * humming.pulse.time[i]);
  EXPECT_FALSE(offset_before_impact(humming)->rest);
}

TEST(sensor_offset, is_found_in_noise_with_its_scatter) {
  const auto found = offset_before_impact(pulse_of(half_sine, -50e-3, 1.2, 0.8));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean.at(0), 1.2 * g, 4 * 0.8 * g / std::sqrt(480));  // four standard errors
  EXPECT_NEAR(found->scatter.at(0), 0.8 * g, 0.1 * g);
  EXPECT_GT(found->end, -3e-3);
}

/// The sensor may be mounted either way round.
TEST(sensor_offset, of_a_negative_pulse_is_found_too) {
  const auto found = offset_before_impact(pulse_of([](double t) { return -half_sine(t); }, -5e-3, 1.2));
  ASSERT_TRUE(found);
  EXPECT_NEAR(found->mean.at(0), 1.2 * g, 1e-9);
}

/// Pulses that begin with the first sample, however slowly, have nothing before the impact.
TEST(sensor_offset, is_not_found_where_nothing_is_quiet) {
  const auto power = [](double exponent) {
    return [=](double t) { return std::pow(std::clamp(t / duration, 0.0, 1.0), exponent); };
  };
  const std::vector<std::function<double(double)>> shapes{
      half_sine,
      [](double t) { return half_sine(t) * half_sine(t); },
      power(0.5),
      power(1),
      power(1.5),
      power(2),
      power(3),
      [](double) { return 1.0; },
      [](double t) { return std::sin(2 * std::numbers::pi * t / 1e-3); }};
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    SCOPED_TRACE(i);
    EXPECT_FALSE(offset_before_impact(pulse_of(shapes[i], 0)));
    EXPECT_FALSE(offset_before_impact(pulse_of(shapes[i], 0, 1.2)));
  }
  EXPECT_FALSE(offset_before_impact(pulse_of([](double) { return 0.0; }, -5e-3, 1.2)));  // no impact
  EXPECT_FALSE(offset_before_impact(pulse_of(half_sine, -5e-3, 0, 5)));                  // not quiet
  EXPECT_FALSE(offset_before_impact(pulse_of(half_sine, -0.5e-3)));                      // too short
}

TEST(sensor_offset, taken_off_leaves_the_pulse_without_it) {
  const MeasuredPulse clean = pulse_of(half_sine, -5e-3);
  const MeasuredPulse measured = pulse_of(half_sine, -5e-3, 1.2);
  const MeasuredPulse back = injury::zeroed(measured, offset_before_impact(measured).value());
  for (const double window : {15e-3, injury::unlimited_window}) {
    const double truth = injury::hic(clean.pulse, window).value;
    EXPECT_NEAR(injury::hic(back.pulse, window).value, truth, 1e-12 * truth);
    EXPECT_GT(injury::hic(measured.pulse, window).value, 1.01 * truth);
  }
}

/// With an offset in each direction the length has one too, which is not their sum.
TEST(sensor_offset, of_a_resultant_is_taken_off_each_direction) {
  const MeasuredPulse x = pulse_of(half_sine, -5e-3, 3), y = pulse_of(half_sine, -5e-3, -4);
  MeasuredPulse measured = x;
  measured.resultant = true;
  measured.components = {x.pulse.acceleration, y.pulse.acceleration};
  measured.pulse.acceleration = injury::resultant_of(measured.components);
  const auto found = offset_before_impact(measured);
  ASSERT_TRUE(found);
  EXPECT_THAT(found->mean, ElementsAre(DoubleNear(3 * g, 1e-9), DoubleNear(-4 * g, 1e-9)));
  const MeasuredPulse back = injury::zeroed(measured, *found);
  const MeasuredPulse clean = pulse_of(half_sine, -5e-3);
  for (std::size_t i = 0; i < back.pulse.time.size(); ++i)
    EXPECT_NEAR(back.pulse.acceleration[i], std::sqrt(2) * clean.pulse.acceleration[i], 1e-9);
}

TEST(sensor_offset, between_two_times_includes_both) {
  MeasuredPulse measured;
  measured.pulse = {{0, 1, 2, 3, 4}, {9, 1, 2, 6, 9}};
  const injury::SensorOffset offset = injury::offset_between(measured, 1, 3);
  EXPECT_DOUBLE_EQ(offset.mean.at(0), 3);
  EXPECT_DOUBLE_EQ(offset.scatter.at(0), std::sqrt(7.0));  // (4 + 1 + 9) / 2
  EXPECT_EQ(offset.samples, 3U);
  EXPECT_EQ(offset.begin, 1);
  EXPECT_EQ(offset.end, 3);
  EXPECT_EQ(injury::offset_between(measured, -9, 1.5).end, 1);
  EXPECT_THROW(injury::offset_between(measured, 1, 1.5), std::invalid_argument);
  EXPECT_THROW(injury::offset_between(measured, 5, 9), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
