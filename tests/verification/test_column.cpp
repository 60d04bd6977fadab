/// One column, driven through the product step of the law contract, against closed forms and against the
/// quadrature of its memory integral.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <numbers>

#include "oracle/closed_forms.hpp"
#include "oracle/column_history.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using oracle::StrainHistory;

/// Stress after `steps` equal steps along a history.
template <class Law>
double driven(const Law& law, const StrainHistory& history, double time, int steps) {
  Column<Law> column(law, history.touched);
  for (int i = 1; i <= steps; ++i) {
    const double t = time * i / steps;
    column.go(history.strain(t), history.touched + t);
  }
  return column.stress();
}

/// From any start on at a constant rate, in steps that grow with the time since contact.
template <class Law>
double relaxed_from(const Law& law, const oracle::ColumnStart& start, double rate, double end, int steps) {
  Column<Law> column(law, start.time, start.strain, start.stress);
  for (int i = 1; i <= steps; ++i) {
    const double t = start.time * std::pow(end / start.time, static_cast<double>(i) / steps);
    column.go(start.strain + rate * (t - start.time), t);
  }
  return column.stress();
}

StrainHistory ramp(double rate, double touched = 0) {
  return {[rate](double t) { return rate * t; }, [rate](double) { return rate; }, 1e9, touched};
}

/// Up to `largest` at one rate and back at another.
StrainHistory tent(double up, double down, double largest) {
  const double turning = largest / up;
  return {[=](double t) { return t < turning ? up * t : largest - down * (t - turning); },
          [=](double t) { return t < turning ? up : -down; }, turning, 0};
}

/// Half a sine wave.
StrainHistory wave(double largest, double frequency, double touched) {
  return {[=](double t) { return largest * std::sin(frequency * t); },
          [=](double t) { return largest * frequency * std::cos(frequency * t); },
          std::numbers::pi / (2 * frequency), touched};
}

TEST(ColumnStep, OfTheNineParameterLawIsExactAtConstantRateHoweverLong) {
  const auto law = sample_law<NineParameter>();
  for (const double rate : {0.5, 30.0, 300.0})
    for (const int steps : {1, 7, 100}) {
      const double time = 0.9 / rate;
      expect_relative(driven(law, ramp(rate), time, steps),
                      oracle::nine_column_at_constant_rate(law, {}, rate, time), 1e-12,
                      fmt::format("{}", rate));
    }
}

/// Its relaxation depends on the strain, which the step takes at one place: exact from rest all the same, and
/// of second order after a jolt.
TEST(ColumnStep, OfTheTwentyOneParameterLawIsExactFromRestAndOtherwiseConverges) {
  const auto law = sample_law<TwentyOneParameter>();
  for (const double touched : {0.0, 2e-3})
    for (const double rate : {30.0, 300.0}) {
      const double time = 0.9 / rate;
      const double exact =
          oracle::twenty_one_column_at_constant_rate(law, {0, 0, touched}, rate, touched + time);
      for (const int steps : {1, 10, 160})
        expect_relative(driven(law, ramp(rate, touched), time, steps), exact, 1e-10, fmt::format("{}", rate));
      const oracle::ColumnStart jolt{1e5, 0.3, touched + 1e-6};
      const double end = jolt.time + 0.6 / rate;
      const double relaxed = oracle::twenty_one_column_at_constant_rate(law, jolt, rate, end);
      const auto error_with = [&](int steps) {
        return relative_error(relaxed_from(law, jolt, rate, end, steps), relaxed);
      };
      EXPECT_LT(error_with(10), 5e-3);
      EXPECT_LT(error_with(160), error_with(10) / 64) << "order below 1.5";
    }
}

/// After many relaxation times nothing but the envelope is left.
TEST(ColumnStep, TendsToTheEnvelopeAtConstantRate) {
  const NineParameter law = sample_law<NineParameter>();
  const double rate = 0.9 / (20 * law.relaxation_time);
  Column<NineParameter> column(law);
  column.go(0.3, 1e-6);  // a jolt first
  const double jolt = column.stress();
  column.go(0.9, 0.6 / rate);
  const double envelope = oracle::nine_column_at_constant_rate(law, {}, rate, 0.9 / rate);
  EXPECT_GT(relative_error(jolt, envelope), 0.1);
  expect_relative(column.stress(), envelope, 2e-5, "stress");
}

// --- Unloading
// -------------------------------------------------------------------------------------------------

/// The laws are exact on either side of the turning point, so few steps do if one of them ends there.
template <class Law>
void expect_tent(const Law& law, double up, double down, double tolerance, int steps_a_side) {
  const double largest = 0.7;
  const StrainHistory history = tent(up, down, largest);
  for (const double left : {0.65, 0.4, 0.2}) {
    Column<Law> column(law);
    for (int i = 1; i <= steps_a_side; ++i)
      column.go(largest * i / steps_a_side, history.turning * i / steps_a_side);
    const double time = history.turning + (largest - left) / down;
    for (int i = 1; i <= steps_a_side; ++i) {
      const double t = history.turning + (time - history.turning) * i / steps_a_side;
      column.go(history.strain(t), t);
    }
    expect_relative(column.stress(), oracle::column_stress(law, history, time), tolerance,
                    fmt::format("{} at strain {}", Law::name, left));
  }
}

TEST(ColumnStep, FollowsAColumnThatIsUnloadedAtAnotherRate) {
  for (const double down : {10.0, 80.0}) {
    expect_tent(sample_law<LinearViscoelastic>(), 60, down, 1e-9, 1);
    expect_tent(sample_law<NineParameter>(), 60, down, 1e-9, 1);
    expect_tent(sample_law<TwentyOneParameter>(), 60, down, 1e-4, 200);
  }
}

// --- A smooth history
// ------------------------------------------------------------------------------------------

template <class Law>
class SmoothHistory : public testing::Test {};
TYPED_TEST_SUITE(SmoothHistory, LawsWithMemory);

TYPED_TEST(SmoothHistory, IsFollowedOnLoadingAndUnloading) {
  const auto law = sample_law<TypeParam>();
  const StrainHistory history = wave(0.8, 200, 1e-3);
  for (const double time : {1e-4, 3e-3, 6e-3, 9e-3, 1.1e-2})  // turns at 7.85 ms
    expect_relative(driven(law, history, time, 4000), oracle::column_stress(law, history, time), 3e-4,
                    fmt::format("t = {}", time));
}

TYPED_TEST(SmoothHistory, IsFollowedWithOrderTwo) {
  const auto law = sample_law<TypeParam>();
  const StrainHistory history = wave(0.8, 200, 1e-3);
  constexpr double time = 4e-3;
  const double exact = oracle::column_stress(law, history, time);
  fmt::print("{}\n", TypeParam::name);
  double before = 0;
  for (const int steps : {20, 40, 80, 160}) {
    const double error = relative_error(driven(law, history, time, steps), exact);
    fmt::print("  {:4} steps  error {:8.1e}  order {:5.2f}\n", steps, error,
               before > 0 ? std::log2(before / error) : 0);
    if (before > 0) {
      EXPECT_GT(std::log2(before / error), 1.7);
      EXPECT_LT(std::log2(before / error), 2.3);
    }
    before = error;
  }
}

}  // namespace
}  // namespace dashpad::test
