// Questions about random impacts: where limits turn by a grid ten times finer than the longest step of the
// search, the search has a turn, and where it has one, the limit turns.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "dashpad/margin/margin.hpp"
#include "dashpad/quantities/constants.hpp"
#include "margin/evaluation.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

/// A limit within what the figure is over the range, half of the time next to a top or bottom.
double random_limit(const std::vector<double>& figures, Draw& draw) {
  std::vector<double> finite, extremes;
  for (std::size_t i = 0; i < figures.size(); ++i) {
    if (!std::isfinite(figures[i]) || figures[i] == 0) continue;
    finite.push_back(figures[i]);
    if (i > 0 && i + 1 < figures.size() && (figures[i] - figures[i - 1]) * (figures[i + 1] - figures[i]) < 0)
      extremes.push_back(figures[i]);
  }
  if (finite.empty()) return no_value;
  if (!extremes.empty() && draw.choice(2) == 0)
    return extremes[static_cast<std::size_t>(draw.choice(static_cast<int>(extremes.size())))] *
           (1 + (draw.choice(2) == 0 ? -1 : 1) * draw.decades(1e-3, 1e-1));
  const auto [least, most] = std::ranges::minmax(finite);
  return draw.uniform(least, most);
}

TEST(RandomQuestions, NoTurnIsMissedAndNoneIsWrong) {
  const auto questions = environment("DASHPAD_QUESTIONS", 15);
  constexpr const char* keys[]{"pad.thickness", "impactor.speed", "pad.scale", "impactor.mass"};
  constexpr const char* figures[]{"peak_acceleration", "hic15", "peak_penetration", "peak_force"};
  constexpr int fine = 200;
  int asked = 0, turns = 0, close_pairs = 0;
  std::uint64_t max_impacts = 0;
  for (std::uint64_t seed = 0; seed < questions; ++seed) {
    SCOPED_TRACE(seed);
    Draw draw(seed + 1000);
    const ImpactCase impact = draw.choice(10) == 0 ? foam_case(seed) : plausible_case(seed);
    const std::string key = keys[draw.choice(4)];
    const ResultQuantity& figure = result_quantity(figures[draw.choice(4)]);
    const CaseQuantities quantities = quantities_of(impact);
    const double value = quantities.find(key)->get(impact);
    margin::Question question{
        .impacts = {{.impact = impact,
                     .limits = {{.figure = &figure, .value = 1e30, .title = figure.title}}}},
        .key = key,
        .unit = quantities.find(key)->unit,
        .low = value / draw.uniform(1.2, 4),
        .high = value * draw.uniform(1.2, 4),
        .logarithmic = true,
        .options = {.tolerance = 1e-3},
        .intervals = false};
    if (!violations(question).empty()) continue;
    margin::Impacts impacts(question);  // below its limit a figure of a cut impact is no value
    const auto value_at = [&](int i) {
      return question.low * std::pow(question.high / question.low, static_cast<double>(i) / fine);
    };
    std::vector<double> on_grid;
    for (int i = 0; i <= fine; ++i) on_grid.push_back(impacts.look(value_at(i), false).figures.front());
    double& limit = question.impacts.front().limits.front().value;
    limit = random_limit(on_grid, draw);
    if (std::isnan(limit)) continue;
    ++asked;
    const margin::Answer answer = solve_for(question);
    EXPECT_TRUE(answer.is_complete);
    max_impacts = std::max(max_impacts, answer.impacts);
    for (int i = 0; i < fine; ++i) {
      const double from = on_grid[static_cast<std::size_t>(i)], to = on_grid[static_cast<std::size_t>(i) + 1];
      // Nearer to the limit than the solver's error neither side is certain.
      const double unclear = 3e-3 * limit;
      if (!((from < limit - unclear && to > limit + unclear) ||
            (from > limit + unclear && to < limit - unclear)))
        continue;
      EXPECT_TRUE(std::ranges::any_of(answer.turns,
                                      [&](const margin::Turn& turn) {
                                        return turn.value >= value_at(i) * (1 - 1e-4) &&
                                               turn.value <= value_at(i + 1) * (1 + 1e-4);
                                      }))
          << key << ", " << figure.key << " = " << limit << ", between " << value_at(i) << " and "
          << value_at(i + 1);
    }
    margin::Impacts again(question);
    for (const margin::Turn& turn : answer.turns) {
      ++turns;
      const auto figure_at = [&](double at) { return again.look(at, false).figures.front(); };
      if (!turn.jumps) {
        EXPECT_NEAR(figure_at(turn.value) / limit, 1, 4e-3) << key << " = " << turn.value;
        continue;
      }
      const double before = figure_at(turn.value - 2 * turn.precision - 1e-9 * turn.value);
      const double after = figure_at(turn.value + 2 * turn.precision + 1e-9 * turn.value);
      EXPECT_NE(before > limit, after > limit) << key << " = " << turn.value;
    }
    for (std::size_t i = 1; i < answer.turns.size(); ++i)
      if (answer.turns[i].value / answer.turns[i - 1].value <
          std::pow(question.high / question.low, 1.0 / 20))
        ++close_pairs;
  }
  EXPECT_GT(asked, static_cast<int>(questions) / 2);
  EXPECT_GT(turns, asked / 2);
  EXPECT_LE(max_impacts, 150u);
  RecordProperty("asked", asked);
  RecordProperty("turns", turns);
  RecordProperty("close_pairs", close_pairs);
  RecordProperty("max_impacts", static_cast<int>(max_impacts));
}

}  // namespace
}  // namespace dashpad::test
