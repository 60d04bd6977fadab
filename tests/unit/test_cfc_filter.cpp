/// The class filters: published coefficients, the gain of the design, and what a filter without phase keeps.

#include "dashpad/injury/cfc_filter.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

namespace dashpad {
namespace {

using injury::cfc_filtered;
using injury::Corner;
using injury::Ends;

constexpr double pi = std::numbers::pi;
const std::vector<Corner> corners{Corner::sae_j211, Corner::iso_6487};
const std::vector<Ends> all_ends{Ends::mirrored, Ends::held, Ends::mirrored_from_mean, Ends::negated_before};

double corner_frequency(double channel_class, Corner corner) {
  return channel_class * (corner == Corner::sae_j211 ? 2.0775 : 1.25 / 0.6);
}

Pulse sampled(std::size_t size, double interval, const std::function<double(double)>& a) {
  Pulse pulse;
  for (std::size_t i = 0; i < size; ++i) {
    pulse.time.push_back(static_cast<double>(i) * interval);
    pulse.acceleration.push_back(a(pulse.time.back()));
  }
  return pulse;
}

struct Published {
  double channel_class;
  Corner corner;
  double a0, b1, b2;
};

/// At 10 kHz.
const std::vector<Published> published{{60, Corner::sae_j211, 0.001452367474, 1.889343224, -0.8951526941},
                                       {180, Corner::sae_j211, 0.0117962711, 1.670117463, -0.7173025477},
                                       {600, Corner::sae_j211, 0.09718462528, 0.9455740091, -0.3343125102},
                                       {1000, Corner::sae_j211, 0.2192314172, 0.311896545, -0.1888222139},
                                       {60, Corner::iso_6487, 0.001460316306, 1.889033079, -0.8948743446},
                                       {180, Corner::iso_6487, 0.01185768264, 1.669203143, -0.7166338735},
                                       {600, Corner::iso_6487, 0.09763107294, 0.9428090416, -0.3333333333},
                                       {1000, Corner::iso_6487, 0.2201947003, 0.3075663598, -0.1883451609}};

TEST(CfcCoefficients, AreThePublishedOnes) {
  for (const Published& row : published) {
    const injury::FilterCoefficients c = injury::cfc_coefficients(row.channel_class, 1e-4, row.corner);
    EXPECT_NEAR(c.a0, row.a0, 6e-10 * row.a0);  // ten digits are printed
    EXPECT_EQ(c.a1, 2 * c.a0);
    EXPECT_EQ(c.a2, c.a0);
    EXPECT_NEAR(c.b1, row.b1, 6e-10 * std::abs(row.b1));
    EXPECT_NEAR(c.b2, row.b2, 6e-10 * std::abs(row.b2));
    EXPECT_NEAR(1 - c.b1 - c.b2, 4 * c.a0, 1e-15);  // a constant passes
  }
}

TEST(CfcCoefficients, RefuseWhatTheClassCannotUse) {
  EXPECT_THROW(injury::cfc_coefficients(0, 1e-4, Corner::sae_j211), std::invalid_argument);
  EXPECT_THROW(injury::cfc_coefficients(std::nan(""), 1e-4, Corner::sae_j211), std::invalid_argument);
  EXPECT_THROW(injury::cfc_coefficients(INFINITY, 1e-4, Corner::sae_j211), std::invalid_argument);
  EXPECT_THROW(injury::cfc_coefficients(60, 0, Corner::sae_j211), std::invalid_argument);
  for (const Corner corner : corners) {
    const double longest = 1 / (2 * corner_frequency(1000, corner));
    EXPECT_NO_THROW(injury::cfc_coefficients(1000, 0.999 * longest, corner));
    EXPECT_THROW(injury::cfc_coefficients(1000, 1.001 * longest, corner), std::invalid_argument);
  }
}

TEST(SamplesSuffice, AtTenTimesTheClass) {
  EXPECT_TRUE(injury::samples_suffice(60, 1.0 / 600));
  EXPECT_FALSE(injury::samples_suffice(60, 1.0 / 599));
  EXPECT_TRUE(injury::samples_suffice(1000, 1.0 / 10'000));
  EXPECT_FALSE(injury::samples_suffice(1000, 1.0 / 9'990));
}

/// In the middle of a long vibration nothing is left of the ends: the output is the input times the gain, in
/// the same phase.
TEST(CfcFilter, HasTheGainOfItsDesignAndNoPhase) {
  const double interval = 5e-5;
  for (const double channel_class : injury::channel_frequency_classes)
    for (const Corner corner : corners) {
      const double fd = corner_frequency(channel_class, corner);
      for (const double ratio : {0.1, 0.5, 0.8022, 1.0, 1.5, 3.0}) {
        const double f = ratio * fd;
        const double warped = std::tan(pi * f * interval) / std::tan(pi * fd * interval);
        const double gain = 1 / (1 + std::pow(warped, 4));
        const Pulse pulse = sampled(8001, interval, [&](double t) { return std::sin(2 * pi * f * t + 0.4); });
        const Pulse filtered = cfc_filtered(pulse, channel_class, corner);
        for (std::size_t i = 3800; i < 4200; ++i)
          ASSERT_NEAR(filtered.acceleration[i], gain * pulse.acceleration[i], 1e-9)
              << channel_class << " at " << f << " Hz";
      }
      EXPECT_NEAR(1 / (1 + std::pow(0.8022, 4)), std::sqrt(0.5), 5e-5);  // -3 dB
      EXPECT_NEAR(0.8022 * fd, channel_class / 0.6, 0.003 * channel_class / 0.6);
    }
}

/// Computed by another program (SciPy 1.10, lfilter and filtfilt; for the mean a loop) from the definitions
/// in the header, at 1 kHz. Each row has the outputs 0, 1, 15, 28 and 29.
TEST(CfcFilter, TreatsTheEndsAsDefined) {
  const auto expect = [&](std::size_t size, double channel_class, Corner corner, Ends ends,
                          const std::vector<double>& expected) {
    const Pulse pulse = sampled(size, 1e-3, [](double t) {
      const auto i = std::lround(t * 1e3);
      return static_cast<double>(i * i * 7 % 23 - 5);
    });
    const Pulse filtered = cfc_filtered(pulse, channel_class, corner, ends);
    EXPECT_EQ(filtered.time, pulse.time);
    std::vector<double> found;
    for (const std::size_t place : {0U, 1U, 15U, 28U, 29U}) found.push_back(filtered.acceleration[place]);
    for (std::size_t k = 0; k < found.size(); ++k) EXPECT_NEAR(found[k], expected[k], 1e-10) << k;
  };
  expect(30, 60, Corner::sae_j211, Ends::mirrored,
         {-4.99999980123, -0.00230900634639, 11.0323405877, 14.0451232272, 16.9999994685});
  expect(30, 60, Corner::sae_j211, Ends::held,
         {-2.56775133089, 0.518704451075, 11.0331716476, 11.6487210001, 11.9313265651});
  expect(30, 60, Corner::sae_j211, Ends::negated_before,
         {-1.29895985786, 1.47023358108, 11.0313133939, 14.0504424686, 17.0111480994});
  expect(30, 60, Corner::iso_6487, Ends::mirrored_from_mean,
         {-4.99999949359, -0.00296833099875, 11.025806957, 14.0505347137, 16.9999999381});
  // So slow a class that the length of the extension is seen: 100 samples.
  expect(300, 5, Corner::sae_j211, Ends::mirrored,
         {-5.00200658214, -4.34308372697, 3.71431187972, 8.02406831211, 8.23589108719});
}

/// The number of samples in 10 ms must not hang on the rounding of the times.
TEST(CfcFilter, DoesNotDependOnWhenThePulseBegins) {
  for (const Ends ends : all_ends)
    for (const double interval : {1e-3, 5e-4, 1e-3 / 3}) {
      Pulse pulse = sampled(80, interval, [](double t) { return std::sin(9e4 * t * t) + 1; });
      const std::vector<double> expected = cfc_filtered(pulse, 30, Corner::iso_6487, ends).acceleration;
      for (double& t : pulse.time) t += 1.1;
      const std::vector<double> shifted = cfc_filtered(pulse, 30, Corner::iso_6487, ends).acceleration;
      for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(shifted[i], expected[i], 1e-11);
    }
}

TEST(CfcFilter, PassesAConstantUnchanged) {
  for (const Ends ends : {Ends::mirrored, Ends::held, Ends::mirrored_from_mean})
    for (const double interval : {1e-6, 1e-4, 1e-3})
      for (const double a :
           cfc_filtered(sampled(300, interval, [](double) { return 0.7; }), 60, Corner::sae_j211, ends)
               .acceleration)
        ASSERT_NEAR(a, 0.7, 1e-15);
}

/// Away from the ends: there the steady start has to turn into the delay that a ramp has.
TEST(CfcFilter, PassesARampUnchangedInTheInterior) {
  const Pulse ramp = sampled(4001, 1e-4, [](double t) { return 30 - 500 * t; });
  for (const Ends ends : all_ends) {
    const Pulse filtered = cfc_filtered(ramp, 60, Corner::sae_j211, ends);
    for (std::size_t i = 1000; i < 3000; ++i)
      ASSERT_NEAR(filtered.acceleration[i], ramp.acceleration[i], 1e-11);
  }
}

/// With quiet ends forwards and backwards make no difference, a symmetric pulse stays symmetric about the
/// same peak, and the area stays.
TEST(CfcFilter, HasNoDirection) {
  const double length = 0.2;
  const auto bump = [](double x) { return std::abs(x) < 1 ? std::pow(1 - x * x, 3) : 0; };
  Pulse pulse = sampled(2001, 1e-4, [&](double t) {
    return 90 * bump((t - length / 2) / 6e-3) - 20 * bump((t - 0.08) / 2e-3);
  });
  const double area = std::accumulate(pulse.acceleration.begin(), pulse.acceleration.end(), 0.0);
  for (const Ends ends : all_ends) {
    std::vector<double> filtered = cfc_filtered(pulse, 180, Corner::sae_j211, ends).acceleration;
    EXPECT_NEAR(std::accumulate(filtered.begin(), filtered.end(), 0.0), area, 1e-10 * area);
    Pulse backward = pulse;
    std::reverse(backward.acceleration.begin(), backward.acceleration.end());
    backward = cfc_filtered(backward, 180, Corner::sae_j211, ends);
    std::reverse(backward.acceleration.begin(), backward.acceleration.end());
    for (std::size_t i = 0; i < filtered.size(); ++i)
      ASSERT_NEAR(filtered[i], backward.acceleration[i], 1e-11) << i;
  }
  pulse = sampled(2001, 1e-4, [&](double t) { return 90 * bump((t - length / 2) / 6e-3); });
  const std::vector<double> filtered = cfc_filtered(pulse, 180).acceleration;
  EXPECT_EQ(std::max_element(filtered.begin(), filtered.end()) - filtered.begin(), 1000);
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_NEAR(filtered[i], filtered[2000 - i], 1e-11) << i;
}

TEST(CfcFilter, TakesTheShortestPulse) {
  for (const Ends ends : all_ends) {
    const Pulse filtered = cfc_filtered({{0, 1e-4}, {1, 2}}, 600, Corner::sae_j211, ends);
    ASSERT_EQ(filtered.acceleration.size(), 2U);
    for (const double a : filtered.acceleration) EXPECT_TRUE(std::isfinite(a));
  }
}

TEST(CfcFilter, RefusesUnevenSamples) {
  Pulse pulse = sampled(100, 1e-4, [](double t) { return t; });
  pulse.time[50] += 0.9e-7;
  EXPECT_NO_THROW(cfc_filtered(pulse, 60));
  pulse.time[50] += 0.2e-7;
  EXPECT_THROW(cfc_filtered(pulse, 60), std::invalid_argument);
  EXPECT_NO_THROW(cfc_filtered(injury::resampled(pulse, 1e-4), 60));
  EXPECT_THROW(cfc_filtered({{0}, {1}}, 60), std::invalid_argument);
}

TEST(Resampling, IsLinearBetweenTheSamples) {
  const Pulse even = injury::resampled({{1, 2, 4, 4.5}, {0, 2, -2, 8}}, 0.5);
  EXPECT_EQ(even.time, (std::vector<double>{1, 1.5, 2, 2.5, 3, 3.5, 4, 4.5}));
  EXPECT_EQ(even.acceleration, (std::vector<double>{0, 1, 2, 1, 0, -1, -2, 8}));
}

TEST(Resampling, EndsAtOrBeforeTheLastSample) {
  EXPECT_EQ(injury::resampled({{0, 0.3}, {0, 3}}, 0.1).time.size(),
            4U);  // 0.3 / 0.1 is less than 3 in doubles
  EXPECT_EQ(injury::resampled({{1000, 1000.01}, {0, 3}}, 1e-4).time.size(), 101U);
  const Pulse shorter = injury::resampled({{0, 1}, {0, 1}}, 0.4);
  EXPECT_EQ(shorter.time, (std::vector<double>{0, 0.4, 0.8}));
  EXPECT_EQ(injury::resampled({{0, 1}, {0, 1}}, 1).time, (std::vector<double>{0, 1}));
}

TEST(Resampling, RefusesWhatCannotBe) {
  const Pulse pulse{{0, 1}, {0, 1}};
  for (const double interval : {0.0, -1.0, std::nan(""), 1.1, 1e-8, 1e-300})
    EXPECT_THROW(injury::resampled(pulse, interval), std::invalid_argument) << interval;
  EXPECT_THROW(injury::resampled({{0}, {0}}, 0.1), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad
