/// Contact in a pulse: a resultant, which is a length, and a record that rings.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <stdexcept>

#include "dashpad/injury/pulse_report.hpp"

namespace dashpad::injury {
namespace {

constexpr double duration = 10e-3, step = 5e-5, top = 1500;  // s, s, m/s2
constexpr double exact_change = 2 / std::numbers::pi * top * duration;

double half_sine(double time) {
  return time > 0 && time < duration ? top * std::sin(std::numbers::pi * time / duration) : 0;
}

/// From -20 to 60 ms, mostly along z, with noise of 6 m/s2 in each direction.
injury::MeasuredPulse noisy_resultant() {
  std::mt19937 random(1984);
  const auto noise = [&] {
    double sum = -6;
    for (int k = 0; k < 12; ++k) sum += static_cast<double>(random()) / 4294967296.0;
    return 6 * sum;
  };
  injury::MeasuredPulse measured;
  measured.components.resize(3);
  for (int i = -400; i <= 1200; ++i) {
    const double time = i * step, a = half_sine(time);
    measured.pulse.time.push_back(time);
    measured.components[0].push_back(0.06 * a + noise());
    measured.components[1].push_back(noise());
    measured.components[2].push_back(-std::sqrt(1 - 0.06 * 0.06) * a + noise());
  }
  measured.pulse.acceleration = injury::resultant_of(measured.components);
  return measured;
}

TEST(Contact, OfAResultantEndsWhereItsMainAxisDoes) {
  const ProcessedPulse pulse = processed_pulse(noisy_resultant(), {}, {});
  for (const auto& quiet : {std::optional<Stretch>{}, std::optional{Stretch{-20e-3, -1e-3}}}) {
    const Contact contact = contact_of(pulse.along(), quiet);
    EXPECT_NEAR(contact.begin, 0, 4 * step);
    EXPECT_NEAR(contact.end, duration, 4 * step);
    EXPECT_NEAR(contact.velocity_change, exact_change, 2e-3 * exact_change);
  }
}

/// A table may hold the resultant alone. Its noise is never below zero: the quiet part tells how high it is.
TEST(Contact, OfALengthAloneEndsAtTheLevelOfItsQuietPart) {
  const Pulse length = noisy_resultant().pulse;
  const Contact contact = contact_of(length, Stretch{-20e-3, -1e-3});
  EXPECT_NEAR(contact.begin, 0, 4 * step);
  EXPECT_NEAR(contact.end, duration, 4 * step);
  EXPECT_NEAR(contact.velocity_change, exact_change, 2e-3 * exact_change);
}

/// An offset that was not taken off: the contact ends where it is reached again, on either side of zero.
TEST(Contact, EndsAtAnOffset) {
  for (const double offset : {50.0, -50.0, 0.0}) {
    Pulse pulse;
    for (int i = -400; i <= 1200; ++i) {
      pulse.time.push_back(i * step);
      pulse.acceleration.push_back(half_sine(i * step) + offset);
    }
    const Contact contact = contact_of(pulse, Stretch{-20e-3, -1e-3});
    EXPECT_NEAR(contact.begin, 0, 1e-6) << offset;
    EXPECT_NEAR(contact.end, duration, 1e-6) << offset;
    EXPECT_NEAR(contact.velocity_change, exact_change + offset * duration, 1e-3 * exact_change) << offset;
  }
}

/// A vibration of 2 kHz that changes the sign within the contact, and goes on after it.
TEST(Contact, GoesOnOverRinging) {
  Pulse pulse;
  for (int i = -400; i <= 1200; ++i) {
    const double time = i * step;
    const double ring = 0.4 * top * std::sin(2 * std::numbers::pi * 2000 * time);
    pulse.time.push_back(time);
    pulse.acceleration.push_back(half_sine(time) + (time > 0 ? ring * std::exp(-time / 4e-3) : 0));
  }
  const Contact contact = contact_of(pulse);
  EXPECT_NEAR(contact.begin, 0, 0.5e-3);
  EXPECT_NEAR(contact.end, duration, 0.5e-3);
  EXPECT_NEAR(contact.velocity_change, exact_change, 0.01 * exact_change);
}

/// The peak is one ring of 2 kHz alone, and the dips beside it are below half of it.
TEST(Contact, GoesOnOverRingingThatLastsAsLongAsTheImpact) {
  Pulse pulse;
  for (int i = -400; i <= 1200; ++i) {
    const double time = i * step;
    const bool touches = time > 0 && time < duration;
    pulse.time.push_back(time);
    pulse.acceleration.push_back(half_sine(time) +
                                 (touches ? 0.36 * top * std::sin(2 * std::numbers::pi * 2000 * time) : 0));
  }
  const Contact contact = contact_of(pulse);
  EXPECT_NEAR(contact.begin, 0, 2 * step);
  EXPECT_NEAR(contact.end, duration, 0.4e-3);
  EXPECT_NEAR(contact.velocity_change, exact_change, 0.01 * exact_change);
}

/// Two half sines, the second as high as the first or a little higher, 2 ms apart: the contact is that of the
/// highest alone. Half a millisecond apart they cannot be told from ringing.
TEST(Contact, OfTwoBlowsIsThatOfTheHigherOne) {
  const auto contact_of_two = [](double second, double apart) {
    Pulse pulse;
    for (int i = -400; i <= 1200; ++i) {
      pulse.time.push_back(i * step);
      pulse.acceleration.push_back(half_sine(i * step) + second * half_sine(i * step - duration - apart));
    }
    return contact_of(pulse);
  };
  for (const double second : {1.0, 1.1}) {
    SCOPED_TRACE(second);
    const Contact contact = contact_of_two(second, 2e-3);
    const double begin = second > 1 ? duration + 2e-3 : 0;
    EXPECT_NEAR(contact.begin, begin, 1e-9);
    EXPECT_NEAR(contact.end, begin + duration, 1e-9);
    EXPECT_NEAR(contact.velocity_change, second * exact_change, 1e-4 * exact_change);
  }
  EXPECT_NEAR(contact_of_two(1, 0.5e-3).velocity_change, 2 * exact_change, 1e-3 * exact_change);
}

TEST(Contact, OfNothingIsNothing) {
  const Contact contact = contact_of({{1, 2, 3}, {0, 0, 0}});
  EXPECT_EQ(contact.begin, 1);
  EXPECT_EQ(contact.end, 1);
  EXPECT_EQ(contact.velocity_change, 0);
  // A quiet part as high as the peak is none.
  const Contact all = contact_of({{0, 1, 2, 3}, {9, 9, 1, 1}}, Stretch{0, 1});
  EXPECT_EQ(all.begin, 0);
  EXPECT_EQ(all.end, 3);
  EXPECT_THROW(contact_of({{0, 1}, {0, NAN}}), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad::injury
