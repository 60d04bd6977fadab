// The search for turning verdicts over random curves: every change of sign that a much finer grid shows is
// found, and none that is not there.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "dashpad/quantities/constants.hpp"
#include "margin/crossings.hpp"
#include "property/draw.hpp"

namespace dashpad::test {
namespace {

/// Curves of one question: waves with corners (another limit takes over), leaps and what is beyond all
/// limits.
class RandomCurves {
 public:
  explicit RandomCurves(std::uint64_t seed) : draw_(seed) {
    const int count = 1 + draw_.choice(2);
    for (int i = 0; i < count; ++i) curves_.push_back(random_curve());
    if (draw_.choice(2) == 0) lift_to_touch();
  }
  std::vector<double> operator()(double place) const {
    std::vector<double> values;
    for (const Curve& curve : curves_) values.push_back(curve.at(place) - lift_);
    return values;
  }
  [[nodiscard]] double worst(double place) const {
    const std::vector<double> values = (*this)(place);
    return *std::ranges::max_element(values);
  }

 private:
  struct Curve {
    double constant = 0, slope = 0;
    std::vector<double> height = {}, phase = {};
    double corner = 2, bent = 0;   ///< from this place on, steeper by so much
    double leap_at = 2, leap = 0;  ///< from this place on, higher by so much
    double beyond_all_from = -1;   ///< below this place, infinite
    [[nodiscard]] double at(double x) const {
      if (x < beyond_all_from) return infinite;
      double value = constant + slope * x;
      for (std::size_t k = 0; k < height.size(); ++k)
        value += height[k] * std::cos(static_cast<double>(k + 1) * std::numbers::pi * x + phase[k]);
      return value + bent * std::max(0.0, x - corner) + (x > leap_at ? leap : 0);
    }
  };
  Curve random_curve() {
    Curve curve{.constant = draw_.uniform(-1, 1), .slope = draw_.uniform(-4, 4)};
    const int waves = draw_.choice(4);
    for (int k = 0; k < waves; ++k) {
      curve.height.push_back(draw_.uniform(-1, 1));
      curve.phase.push_back(draw_.uniform(0, 6));
    }
    if (draw_.choice(3) == 0) curve.corner = draw_.uniform(0, 1), curve.bent = draw_.uniform(-8, 8);
    if (draw_.choice(5) == 0) curve.leap_at = draw_.uniform(0, 1), curve.leap = draw_.uniform(-1, 1);
    if (draw_.choice(5) == 0) curve.beyond_all_from = draw_.uniform(0, 0.4);
    return curve;
  }
  /// Moves the limit next to a top or bottom inside, so that two crossings are closer than any first step.
  void lift_to_touch() {
    constexpr int steps = 4000;
    std::vector<double> extremes;
    for (int i = 1; i < steps; ++i) {
      const double before = worst((i - 1.0) / steps), here = worst(1.0 * i / steps),
                   after = worst((i + 1.0) / steps);
      if (std::isfinite(before) && std::isfinite(after) && (here - before) * (after - here) < 0)
        extremes.push_back(here);
    }
    if (extremes.empty()) return;
    const double extreme =
        extremes[static_cast<std::size_t>(draw_.choice(static_cast<int>(extremes.size())))];
    lift_ = extreme + (draw_.choice(2) == 0 ? -1 : 1) * draw_.decades(1e-4, 1e-1);
  }

  Draw draw_;
  std::vector<Curve> curves_;
  double lift_ = 0;
};

TEST(Crossings, NoneIsMissedAndNoneIsWrong) {
  const auto questions = static_cast<int>(environment("DASHPAD_QUESTIONS", 1000));
  constexpr int fine = 240;  // ten times finer than the first look, which has the longest steps
  int crossings = 0, close_pairs = 0, max_looks = 0;
  double looks = 0;
  for (int question = 0; question < questions; ++question) {
    SCOPED_TRACE(question);
    const RandomCurves curves(static_cast<std::uint64_t>(question));
    const margin::CrossingSearch found = margin::find_crossings(std::cref(curves), {.precision = 1e-5});
    EXPECT_TRUE(found.is_complete);
    looks += static_cast<double>(found.looks.size());
    max_looks = std::max(max_looks, static_cast<int>(found.looks.size()));
    for (const margin::Crossing& crossing : found.crossings) {
      ++crossings;
      EXPECT_LE(crossing.after - crossing.before, 1e-5);
      EXPECT_NE(curves.worst(crossing.before - 1e-9) > 0, curves.worst(crossing.after + 1e-9) > 0);
      EXPECT_EQ(crossing.rises, curves.worst(crossing.after + 1e-9) > 0);
    }
    for (std::size_t i = 1; i < found.crossings.size(); ++i)
      if (found.crossings[i].place - found.crossings[i - 1].place < 1.0 / 24) ++close_pairs;
    for (int i = 0; i < fine; ++i) {
      const double from = 1.0 * i / fine, to = (i + 1.0) / fine;
      if ((curves.worst(from) > 0) == (curves.worst(to) > 0)) continue;
      EXPECT_TRUE(std::ranges::any_of(
          found.crossings,
          [&](const margin::Crossing& crossing) { return crossing.after >= from && crossing.before <= to; }))
          << "between " << from << " and " << to;
    }
    if (HasFailure()) break;
  }
  EXPECT_GT(crossings, questions / 2);
  EXPECT_GT(close_pairs, questions / 20);
  EXPECT_LT(looks / questions, 50);
  EXPECT_LE(max_looks, 150);
  RecordProperty("crossings", crossings);
  RecordProperty("close_pairs", close_pairs);
}

TEST(Crossings, AJumpIsToldFromACrossing) {
  const auto leap = [](double place) { return std::vector{place > 0.4321 ? 0.7 : -0.3}; };
  const margin::CrossingSearch found = margin::find_crossings(leap, {});
  ASSERT_EQ(found.crossings.size(), 1u);
  EXPECT_TRUE(found.crossings.front().jumps);
  EXPECT_TRUE(found.crossings.front().rises);
  EXPECT_NEAR(found.crossings.front().place, 0.4321, 3e-5);
  const auto steep = [](double place) { return std::vector{std::tanh(50 * (place - 0.4321))}; };
  EXPECT_FALSE(margin::find_crossings(steep, {}).crossings.at(0).jumps);
}

TEST(Crossings, PlacesWithoutAValueAreGaps) {
  const auto cut = [](double place) {
    return std::vector{place > 0.3 && place < 0.5 ? no_value : place - 0.7};
  };
  const margin::CrossingSearch found = margin::find_crossings(cut, {});
  ASSERT_EQ(found.gaps.size(), 1u);
  EXPECT_NEAR(found.gaps.front().from, 0.3, 2e-3);
  EXPECT_NEAR(found.gaps.front().to, 0.5, 2e-3);
  ASSERT_EQ(found.crossings.size(), 1u);
  EXPECT_NEAR(found.crossings.front().place, 0.7, 1e-4);
}

}  // namespace
}  // namespace dashpad::test
