// Where verdicts turn: at a turn an impact of its own has the limit, the ends of intervals are where
// intervals meet the limit, and the share of draws is that of draws made by other means.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "property/draw.hpp"

namespace dashpad::test {
namespace {

ImpactCase example(const std::string& name) {
  const std::filesystem::path root(DASHPAD_SOURCE_DIR);
  return input::read_case(root / "examples" / (name + ".toml"), root / "materials").value().impact;
}

margin::Limit at_most(const char* figure, double value) {
  return {.figure = &result_quantity(figure), .value = value, .title = result_quantity(figure).title};
}

margin::Question about_thickness(const ImpactCase& impact, const margin::Limit& limit, double low,
                                 double high) {
  return {.impacts = {{.impact = impact, .limits = {limit}}},
          .key = "pad.thickness",
          .unit = "m",
          .low = low,
          .high = high,
          .logarithmic = true};
}

ImpactCase with_thickness(ImpactCase impact, double thickness) {
  impact.pad.thickness = thickness;
  return impact;
}

double peak(const ImpactCase& impact) { return *solve(impact).summary.peak_acceleration; }

TEST(Margin, TheFigureAtATurnIsItsLimit) {
  for (const char* name : {"disc-on-mat", "helmet-pad-10fps", "package-on-block", "dashboard-20mph",
                           "head-on-door-panel", "rubber-top-on-a-mat"}) {
    SCOPED_TRACE(name);
    const ImpactCase impact = example(name);
    const double given = impact.pad.thickness;
    const double limit = peak(with_thickness(impact, 1.3 * given));
    const margin::Answer answer =
        solve_for(about_thickness(impact, at_most("peak_acceleration", limit), given / 2, 3 * given));
    EXPECT_TRUE(answer.is_complete);
    ASSERT_FALSE(answer.turns.empty());
    EXPECT_LE(answer.impacts, 150u);
    for (const margin::Turn& turn : answer.turns) {
      EXPECT_FALSE(turn.jumps);
      EXPECT_NEAR(peak(with_thickness(impact, turn.value)) / limit, 1, 5e-4);
    }
    EXPECT_TRUE(std::ranges::any_of(answer.turns, [&](const margin::Turn& turn) {
      return std::abs(turn.value / (1.3 * given) - 1) < 1e-3;
    }));
  }
}

TEST(Margin, AnIntervalEndsWhereThatOfTheFigureMeetsTheLimit) {
  const ImpactCase impact = example("disc-on-mat");
  const double limit = 100 * standard_gravity;
  const margin::Answer answer =
      solve_for(about_thickness(impact, at_most("peak_acceleration", limit), 0.01, 0.08));
  ASSERT_EQ(answer.turns.size(), 1u);
  ASSERT_TRUE(answer.turns.front().interval);
  const auto interval_at = [&](double thickness) {
    const ImpactCase other = with_thickness(impact, thickness);
    Solution solution = solve(other);
    uncertainty::add_intervals(other, {}, solution);
    return *solution.summary.intervals->find("peak_acceleration");
  };
  EXPECT_NEAR(interval_at(answer.turns.front().interval->first).low / limit, 1, 0.01);
  EXPECT_NEAR(interval_at(answer.turns.front().interval->second).high / limit, 1, 0.01);
}

TEST(Margin, SoftAndHardPadsBothFail) {
  // On a rigid floor a soft pad bottoms out and a hard one is hard: two turns, found both, and nothing
  // beyond.
  const ImpactCase impact = example("disc-on-mat");
  margin::Question question = about_thickness(impact, at_most("hic15", 150), 0.1, 30);
  question.key = "pad.scale";
  question.unit = "1";
  question.intervals = false;
  const margin::Answer answer = solve_for(question);
  ASSERT_EQ(answer.turns.size(), 2u);
  EXPECT_TRUE(answer.turns[0].passes_above);
  EXPECT_FALSE(answer.turns[1].passes_above);
  ASSERT_EQ(answer.stretches.size(), 3u);
  EXPECT_EQ(answer.stretches[1].zone, margin::Zone::pass);
}

TEST(Margin, TheShareOfDrawsIsThatOfOtherDraws) {
  const ImpactCase impact = example("disc-on-mat");
  const double limit = 60 * standard_gravity;
  margin::Question question = about_thickness(impact, at_most("peak_acceleration", limit), 0.02, 0.12);
  const double speed = impact.impactor.speed;
  question.chance = {.probability = 0.9,
                     .factors = {{.key = "impactor.speed",
                                  .unit = "m/s",
                                  .spread = study::Normal{speed, 0.05 * speed},
                                  .lowest = {},
                                  .highest = {}}},
                     .draws = 1024};
  const margin::Answer answer = solve_for(question);
  ASSERT_EQ(answer.turns.size(), 1u);
  Draw draw(7);
  Solver solver;
  constexpr int draws = 2000;
  int kept = 0;
  for (int i = 0; i < draws; ++i) {
    ImpactCase other = with_thickness(impact, answer.turns.front().value);
    // Box and Muller's method.
    const double normal = std::sqrt(-2 * std::log(draw.uniform(1e-12, 1))) *
                          std::cos(2 * std::numbers::pi * draw.uniform(0, 1));
    other.impactor.speed = speed * (1 + 0.05 * normal);
    if (*solver.solve(other, {.tolerance = 1e-3}).summary.peak_acceleration <= limit) ++kept;
  }
  // Five standard errors of the second share, and as much as the first is known.
  EXPECT_NEAR(static_cast<double>(kept) / draws, 0.9, 5 * std::sqrt(0.9 * 0.1 / draws));
  // The speed alone is drawn: the turn is where the pad just passes at its 90 % quantile.
  const double fast = speed * (1 + 0.05 * 1.2815515655446004);
  ImpactCase at_quantile = with_thickness(impact, answer.turns.front().value);
  at_quantile.impactor.speed = fast;
  EXPECT_NEAR(peak(at_quantile) / limit, 1, 3e-3);
}

}  // namespace
}  // namespace dashpad::test
