/// The solver on random cases, most of them extreme. Repeat one case, or take more, with
///
///   DASHPAD_RANDOM_SEED=1234 DASHPAD_RANDOM_CASES=1 test_property --gtest_filter=RandomCases.*

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <map>

#include "dashpad/impact/solve.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr std::uint64_t solved_cases = 300;
/// Share of random cases that may end without meeting the tolerance.
constexpr double max_not_met = 0.06;

void expect_finite(const char* name, double value) {
  EXPECT_TRUE(std::isfinite(value)) << name << ": " << value;
}
void expect_finite(const char* name, const std::optional<double>& value) {
  if (value) expect_finite(name, *value);
}
void expect_finite(const char* name, const std::optional<Moment>& moment) {
  if (moment) expect_finite(name, moment->time + moment->velocity);
}
void expect_finite(const char* name, const std::vector<double>& column, std::size_t size) {
  ASSERT_EQ(column.size(), size) << name;
  for (const double value : column) ASSERT_TRUE(std::isfinite(value)) << name << ": " << value;
}

void expect_numbers(const Summary& s) {
  expect_finite("peak force", s.peak_force);
  expect_finite("time of peak force", s.time_of_peak_force);
  expect_finite("peak acceleration", s.peak_acceleration);
  expect_finite("peak motion", s.peak_motion);
  expect_finite("peak penetration", s.peak_penetration);
  expect_finite("peak strain", s.peak_strain);
  expect_finite("peak strain rate", s.peak_strain_rate);
  expect_finite("weight", s.force_below_weight);
  expect_finite("contact end", s.contact_end);
  expect_finite("release", s.release);
  expect_finite("bottomed", s.bottomed);
  expect_finite("rebound speed", s.rebound_speed);
  expect_finite("restitution", s.restitution);
  expect_finite("energy absorbed", s.energy_absorbed_fraction);
  expect_finite("energy residual", s.energy.residual);
}

void expect_numbers(const History& h) {
  expect_finite("time", h.time, h.size());
  expect_finite("force", h.force, h.size());
  expect_finite("acceleration", h.acceleration, h.size());
  expect_finite("velocity", h.velocity, h.size());
  expect_finite("motion", h.motion, h.size());
  expect_finite("penetration", h.penetration, h.size());
  expect_finite("support deflection", h.support_deflection, h.size());
  expect_finite("contact radius", h.contact_radius, h.size());
  expect_finite("largest strain", h.axis_strain, h.size());
}

void expect_increasing_time(const History& h) {
  ASSERT_GE(h.size(), 2U);
  EXPECT_EQ(h.time.front(), 0);
  for (std::size_t i = 1; i < h.size(); ++i) ASSERT_GT(h.time[i], h.time[i - 1]) << "entry " << i;
}

/// Share of the impact energy that a pad may give back beyond what it took. Laws 4 and 5 are not dissipative
/// for all parameters: a pad that hardly relaxes and unloads more slowly than it was loaded gains a little
/// (seed 148: 0.065 %; the CVODE oracle finds 0.066 %). The others have no such excuse.
double largest_gain(const PadLaw& law) {
  const bool empirical =
      std::holds_alternative<NineParameter>(law) || std::holds_alternative<TwentyOneParameter>(law);
  return empirical ? 0.05 : 1e-9;
}

void expect_physics(const ImpactCase& impact, const Summary& s) {
  EXPECT_NE(s.status, Status::not_run);
  EXPECT_LE(s.peak_penetration, impact.pad.thickness * (1 + 1e-12));
  EXPECT_GE(s.peak_penetration, 0);
  if (s.status == Status::tolerance_not_met) return;
  EXPECT_TRUE(s.bottomed || s.peak_penetration < impact.pad.thickness) << "bottomed and does not say so";
  EXPECT_EQ(s.status == Status::bottomed_out, !s.peak_force);
  if (s.status == Status::bottomed_out) {
    EXPECT_TRUE(s.bottomed);
    EXPECT_TRUE(impact.support.is_rigid());
  }
  if (s.status != Status::time_limit) {
    EXPECT_LE(std::abs(s.energy.residual), 1.001 * s.tolerance * s.energy.impact);
    const double gain = largest_gain(impact.pad.material.law);
    EXPECT_GE(s.energy_absorbed_fraction, -gain - s.errors.energy_absorbed);
    EXPECT_LE(s.energy_absorbed_fraction, 1 + s.errors.energy_absorbed);
  }
  if (s.release) {
    EXPECT_GE(s.restitution.value(), 0);
    EXPECT_LE(s.restitution.value(), 1 + largest_gain(impact.pad.material.law) + s.errors.rebound_speed);
    EXPECT_LE(s.time_of_peak_force.value(), s.release->time * (1 + 1e-9));
    ASSERT_TRUE(s.force_below_weight);
    EXPECT_LE(s.force_below_weight->time, s.release->time * (1 + 1e-9 + s.errors.force_below_weight));
  }
  if (s.contact_end) {
    ASSERT_TRUE(s.release);
    EXPECT_LE(s.time_of_peak_force.value(), s.contact_end->time * (1 + s.errors.contact_end));
  }
}

/// Every other nose, on the laws 1 to 5.
TEST(RandomCases, OfEveryNoseAreSolved) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", solved_cases);
  std::uint64_t not_met = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    const ImpactCase impact = nose_case(seed);
    SCOPED_TRACE(fmt::format("seed {}: {}, {}", seed, name_of(impact.impactor.nose),
                             name_of(impact.pad.material.law)));
    ASSERT_TRUE(violations(impact).empty());
    const Solution solution = solve(impact);
    expect_numbers(solution.summary);
    expect_numbers(solution.history);
    expect_increasing_time(solution.history);
    expect_physics(impact, solution.summary);
    if (solution.summary.status == Status::tolerance_not_met) ++not_met;
  }
  fmt::print("tolerance not met: {} of {}\n", not_met, cases);
  // Of a few cases the share says nothing.
  EXPECT_LE(static_cast<double>(not_met), (cases < 100 ? 1 : 0.01) * static_cast<double>(cases));
}

/// Of 300 such cases 10 miss a tolerance of 1e-3: pads of laws 4 and 5 on a damper, where more than one rate
/// is in equilibrium, light panels, and pads that close on a preloaded or damped support.
TEST(RandomCases, OnSupportsThatMoveAreSolved) {
  int not_met = 0;
  constexpr int cases = 120;
  for (std::uint64_t seed = 1; seed <= cases; ++seed) {
    const ImpactCase impact = moving_case(seed);
    SCOPED_TRACE(impact.title);
    ASSERT_TRUE(violations(impact).empty());
    const Summary s = solve(impact, {.tolerance = 1e-3}).summary;
    if (!s.trustworthy()) {
      ++not_met;
      continue;
    }
    expect_numbers(s);
    ASSERT_EQ(s.support.has_value(), impact.backing != Backing{});
    if (s.support) {
      if (s.support->peak_transmitted) expect_finite("transmitted force", *s.support->peak_transmitted);
      expect_finite("deflection", s.support->peak_deflection);
    }
    // Nothing comes back that was not there, but for what laws 4 and 5 may give.
    EXPECT_GE(s.energy_absorbed_fraction, -largest_gain(impact.pad.material.law) - 2e-3);
    EXPECT_GE(s.energy.support_loss, -1e-9 * s.energy.impact);
    EXPECT_LE(std::abs(s.energy.residual), 1e-3 * s.energy.impact);
  }
  EXPECT_LE(not_met, 9);
}

/// Every blow of every support that a case may have is solved or said not to be, and no magnitude is below 0.
TEST(RandomCases, OnAnySupportHaveFiguresThatMakeSense) {
  int not_met = 0;
  for (std::uint64_t seed = 1; seed <= 45; ++seed) {
    const ImpactCase impact = support_case(seed);
    SCOPED_TRACE(impact.title);
    ASSERT_TRUE(violations(impact).empty());
    for (const Blow& blow : solve_blows(impact, {.tolerance = 1e-3})) {
      EXPECT_TRUE(violations(blow.impact).empty());
      const Summary& s = blow.solution.summary;
      if (s.trustworthy()) {
        EXPECT_LE(std::abs(s.energy.residual), 1e-3 * s.energy.impact);
      }
      if (!s.trustworthy()) ++not_met;
      EXPECT_GE(s.energy.support_loss, -1e-9 * s.energy.impact);
      if (!s.support) continue;
      EXPECT_GE(s.support->peak_transmitted.value_or(0), 0);
      EXPECT_GE(s.support->peak_deflection, 0);
      EXPECT_GE(s.support->set.value_or(0), 0);
      if (blow.impact.backing.earlier_force == 0) {
        EXPECT_LE(s.support->set.value_or(0), 1.001 * s.support->peak_deflection + 1e-12);
      }
    }
  }
  EXPECT_EQ(not_met, 0);
}

TEST(RandomCases, AreSolvedOrSaidNotToBe) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", solved_cases);
  std::map<std::string, std::uint64_t> count;
  double slowest = 0;
  std::uint64_t slowest_seed = 0;
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const ImpactCase impact = random_case(seed);
    Solution solution;
    ASSERT_NO_THROW(solution = solve(impact));
    const Summary& s = solution.summary;
    ++count[to_string(s.status)];
    if (s.wall_time > slowest) slowest = s.wall_time, slowest_seed = seed;
    expect_numbers(s);
    expect_numbers(solution.history);
    expect_increasing_time(solution.history);
    expect_physics(impact, s);
  }
  for (const auto& [status, number] : count) fmt::print("{:20} {:5} of {}\n", status, number, cases);
  fmt::print("slowest: {:.2f} s, seed {}\n", slowest, slowest_seed);
  const double not_met = static_cast<double>(count[to_string(Status::tolerance_not_met)]);
  fmt::print("tolerance not met: {:.1f} %\n", 100 * not_met / static_cast<double>(cases));
  // Of a few cases the share says nothing.
  const double most = cases < 100 ? 1 : max_not_met;
  EXPECT_LE(not_met, most * static_cast<double>(cases));
}

/// Extreme cases on rigid supports whose steps once shrank to rounding before the turning point: what one
/// step had left over of its residual was the rate of the next.
TEST(RandomCases, TurnOnARigidSupportInFewSteps) {
  for (const std::uint64_t seed : {284ULL, 363ULL, 654ULL}) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const ImpactCase impact = random_case(seed);
    ASSERT_TRUE(impact.support.is_rigid());
    const Summary coarse = solve(impact, {.tolerance = 1e-3}).summary;
    const Summary fine = solve(impact, {.tolerance = 5e-4}).summary;
    EXPECT_TRUE(coarse.trustworthy()) << to_string(coarse.status);
    EXPECT_LT(coarse.steps, 5000U);
    expect_relative(coarse.peak_motion, fine.peak_motion, 1.1e-3, "peak motion");
    ASSERT_EQ(coarse.rebound_speed.has_value(), fine.rebound_speed.has_value());
    if (fine.rebound_speed)
      expect_relative(*coarse.rebound_speed, *fine.rebound_speed, 1.1e-3, "rebound speed");
  }
}

/// A pad that has closed to within rounding of its lock, and is driven on, is locked; it was taken for one
/// that turns, and neither phase had a solution.
TEST(RandomCases, LockWhereTheGapIsClosedToRounding) {
  for (const double tolerance : {1e-3, 1e-4}) {
    const Summary s = solve(plausible_case(135), {.tolerance = tolerance}).summary;
    EXPECT_EQ(s.status, Status::released);
    EXPECT_TRUE(s.bottomed);
  }
}

TEST(RandomCases, AreTheSameForTheSameSeed) {
  for (const std::uint64_t seed : {1ULL, 77ULL}) {
    const Summary a = solve(random_case(seed)).summary;
    const Summary b = solve(random_case(seed)).summary;
    EXPECT_EQ(a.peak_force, b.peak_force);
    EXPECT_EQ(a.peak_motion, b.peak_motion);
    EXPECT_EQ(a.rebound_speed, b.rebound_speed);
  }
}

}  // namespace
}  // namespace dashpad::test
