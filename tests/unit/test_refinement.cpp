/// Comparison of runs at halved resolution, on made-up sequences whose limit is known.

#include "impact/refinement.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <limits>
#include <tuple>
#include <vector>

#include "dashpad/quantities/constants.hpp"
#include "impact/numerics.hpp"

namespace dashpad {
namespace {

const Impactor impactor{.mass = 2, .nose = Sphere{0.1}, .speed = 3};
const ImpactCase on_rigid_support{.title = {}, .impactor = impactor, .pad = {}, .support = {}};
constexpr double impact_energy = 9;  // J
constexpr double rebound = 2;        // m/s

/// Figures whose relative errors are `error`, with different factors.
Figures figures_with(double error) {
  const auto off = [error](double x, double factor) { return x * (1 + factor * error); };
  Figures f;
  f.ending = Status::released;
  f.peak_force = off(500, 1);
  f.time_of_peak_force = off(0.01, -2);
  f.peak_motion = off(0.05, 0.5);
  f.peak_penetration = off(0.02, 0.3);
  f.peak_pad_rate = off(3, 0.1);
  f.force_below_weight = Moment{off(0.02, 1), off(-1.9, 0.4)};
  f.contact_end = Moment{off(0.0205, -1), off(-1.99, 0.6)};
  f.release = Moment{off(0.021, -1), off(-rebound, 0.7)};
  f.final_velocity = f.release->velocity;
  f.energy.pad = off(impact_energy - impactor.mass * rebound * rebound / 2, 1.5);
  return f;
}

/// Adds runs, coarse to fine, until they settle; error(k) is that of run k, and the second is `apart` from
/// the first. The number of runs, 0 if it never does.
int settles(Refinement& refinement, const std::function<double(int)>& error, double apart = 0) {
  for (int k = 0; k < numerics.max_fixed_runs; ++k) {
    refinement.add(figures_with(error(k)), apart);
    if (refinement.settled()) return k + 1;
  }
  return 0;
}

double second_order(int k) { return 0.01 * std::pow(0.25, k); }

TEST(refinement, extrapolates_a_second_order_sequence_to_its_limit) {
  Refinement refinement(on_rigid_support, 1e-4);
  ASSERT_NE(settles(refinement, second_order), 0);
  const Figures& f = refinement.figures();
  EXPECT_NEAR(f.peak_force, 500, 1e-10);
  EXPECT_NEAR(f.release->time, 0.021, 1e-14);
  EXPECT_NEAR(f.release->velocity, -rebound, 1e-12);
  EXPECT_NEAR(f.peak_motion, 0.05, 1e-14);
}

TEST(refinement, takes_at_least_two_runs) {
  Refinement refinement(on_rigid_support, 1e-2);
  EXPECT_EQ(settles(refinement, [](int) { return 0.0; }), 2);
  EXPECT_LE(refinement.errors().peak_force, 1e-11) << "rounding is all there is";
  EXPECT_GE(refinement.errors().energy_absorbed, 0.9e-12)
      << "of the impact energy, not of what is left of it";
}

TEST(refinement, does_not_trust_two_runs_beyond_their_reach) {
  const auto none = [](int) { return 0.0; };
  for (const auto& [tolerance, apart, runs] :
       {std::tuple{1e-3, 0.9e-3, 2}, {1e-3, 1.1e-3, 3}, {1e-3, infinite, 3}, {0.9e-3, 0.0, 3}}) {
    Refinement refinement(on_rigid_support, tolerance);
    EXPECT_EQ(settles(refinement, none, apart), runs) << tolerance << ' ' << apart;
  }
  ImpactCase with_corners = on_rigid_support;
  with_corners.support = Support::through({{0.01, 100}, {0.02, 400}});
  Refinement refinement(with_corners, 1e-3);
  EXPECT_EQ(settles(refinement, none), 3) << "a corner of the support is met in a step, anywhere";
}

TEST(refinement, counts_the_distance_of_two_runs_in_their_errors) {
  Refinement refinement(on_rigid_support, 1e-3);
  refinement.add(figures_with(0));
  refinement.add(figures_with(0), 2e-4);
  EXPECT_NEAR(refinement.errors().peak_force, 6e-4, 1e-10);
  EXPECT_EQ(refinement.errors().bottomed, 0) << "it did not";
}

/// Of a motion with a constant force, which cubics follow.
TEST(refinement, two_runs_are_as_far_apart_as_their_motions_at_any_time) {
  const auto history = [](double step, double faster) {
    History h;
    for (int i = 0; i * step <= 1.0001; ++i) {
      const double t = i * step;
      h.time.push_back(t);
      h.acceleration.push_back(-2);
      h.velocity.push_back(3 - 2 * t + faster);
      h.motion.push_back(3 * t - t * t + faster * t);
    }
    return h;
  };
  const History fine = history(0.05, 0);
  EXPECT_NEAR(distance_between(fine, history(0.1, 0), impactor), 0, 1e-14);
  EXPECT_NEAR(distance_between(fine, history(0.07, 0), impactor), 0, 1e-14);
  EXPECT_NEAR(distance_between(fine, history(0.1, 0.03), impactor), 0.015, 1e-12)
      << "0.03 m farther after 1 s, of 2 m; the velocities are 0.01 of the impact speed apart";
  History spoilt = history(0.1, 0);
  spoilt.velocity[3] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_TRUE(std::isnan(distance_between(fine, spoilt, impactor)));
}

TEST(refinement, does_not_believe_that_the_rebound_is_suddenly_exact) {
  Refinement refinement(on_rigid_support, 1e-4);
  for (const double error : {0.0128, 0.0032, 0.0032, 0.0032}) refinement.add(figures_with(error));
  EXPECT_LE(refinement.errors().peak_force, 1e-4);
  EXPECT_GT(refinement.errors().rebound_speed, 1e-4);
}

/// At the last of four runs all moves by some share of the tolerance, for the first time within it.
TEST(refinement, asks_of_close_tolerances_that_runs_agree_to_half_of_them_or_twice) {
  for (const auto& [tolerance, share, settles] :
       {std::tuple{1e-3, 0.9, true}, {1e-4, 0.9, false}, {1e-4, 0.4, true}}) {
    Refinement refinement(on_rigid_support, tolerance);
    const double last = 0.5 * share * tolerance;
    for (const double error : {4.5 * tolerance, 0.0, 0.0, last}) refinement.add(figures_with(error));
    EXPECT_EQ(refinement.settled(), settles) << tolerance << ' ' << share;
    refinement.add(figures_with(last));
    EXPECT_TRUE(refinement.settled()) << tolerance << ' ' << share;
  }
}

TEST(refinement, does_not_believe_that_bottoming_is_suddenly_exact) {
  Refinement refinement(on_rigid_support, 1e-4);
  for (const double late : {0.0128, 0.0032, 0.0008, 0.0008, 0.0008}) {
    Figures run = figures_with(0);
    run.bottomed = Moment{0.01 * (1 + late), 1};
    refinement.add(run);
    if (late == 0.0008) {
      EXPECT_FALSE(refinement.settled());
    }
  }
  EXPECT_GT(refinement.errors().bottomed, 1e-9);
}

TEST(refinement, knows_nothing_after_one_run) {
  Refinement refinement(on_rigid_support, 1e-2);
  refinement.add(figures_with(0));
  EXPECT_FALSE(refinement.settled());
  EXPECT_TRUE(std::isinf(refinement.errors().peak_force));
}

TEST(refinement, takes_all_that_two_runs_differ_by_for_their_error) {
  Refinement refinement(on_rigid_support, 1e-1);
  refinement.add(figures_with(0.04));
  refinement.add(figures_with(0.01), 0);
  EXPECT_GE(refinement.errors().peak_force, 0.029);
}

TEST(refinement, takes_more_runs_for_a_closer_tolerance) {
  int before = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    Refinement refinement(on_rigid_support, tolerance);
    const int runs = settles(refinement, second_order);
    EXPECT_GT(runs, before);
    before = runs;
  }
}

TEST(refinement, estimates_no_less_than_the_true_error) {
  // Second order, with a part of the third order that the extrapolation does not see.
  const auto error = [](int k) { return second_order(k) + 0.05 * std::pow(0.125, k); };
  for (const double tolerance : {1e-2, 1e-3, 1e-4, 1e-5}) {
    Refinement refinement(on_rigid_support, tolerance);
    ASSERT_NE(settles(refinement, error), 0);
    const double true_error = std::abs(refinement.figures().peak_force / 500 - 1);
    EXPECT_LE(true_error, refinement.errors().peak_force);
    EXPECT_LE(refinement.errors().peak_force, tolerance);
  }
}

TEST(refinement, does_not_settle_on_an_irregular_sequence) {
  constexpr double tolerance = 1e-4;
  const std::vector<std::function<double(int)>> irregular{
      [](int k) { return k % 2 == 0 ? 1e-3 : -1e-3; },         // to and fro
      [](int k) { return 1e-3 * std::sin(5.3 * k * k + 1); },  // noise
      [](int k) { return 0.1 / (k + 1); },                     // creeping
      [](int k) { return 1e-3 * k; },                          // drifting
  };
  for (std::size_t i = 0; i < irregular.size(); ++i) {
    Refinement refinement(on_rigid_support, tolerance);
    EXPECT_EQ(settles(refinement, irregular[i]), 0) << "sequence " << i;
  }
}

TEST(refinement, does_not_take_a_chance_agreement_for_accuracy) {
  // Extrapolations of run 2 and run 1 agree at 0 by chance, but the run itself is 1 % off.
  Refinement refinement(on_rigid_support, 1e-4);
  for (const double error : {0.16, 0.04, 0.01}) refinement.add(figures_with(error));
  EXPECT_FALSE(refinement.settled());
  EXPECT_GT(refinement.errors().peak_force, 1e-4);
}

TEST(refinement, does_not_compare_runs_that_end_differently) {
  Refinement refinement(on_rigid_support, 1e-2);
  for (int k = 0; k < numerics.max_fixed_runs; ++k) {
    Figures run = figures_with(0);
    if (k % 2 == 0) {
      run.bottomed = Moment{0.01, 1};
    }
    refinement.add(run);
    EXPECT_FALSE(refinement.settled()) << k;
  }
}

/// Numbers of a run, each of which would be passed over by a comparison with one that is not a number.
TEST(refinement, does_not_settle_on_what_is_no_number) {
  constexpr double no_number = std::numeric_limits<double>::quiet_NaN();
  const std::vector<std::function<void(Figures&)>> spoilers{
      [](Figures& f) { f.peak_force = no_number; },
      [](Figures& f) { f.time_of_peak_force = no_number; },
      [](Figures& f) { f.peak_motion = no_number; },
      [](Figures& f) { f.peak_penetration = no_number; },
      [](Figures& f) { f.peak_pad_rate = no_number; },
      [](Figures& f) { f.force_below_weight->velocity = no_number; },
      [](Figures& f) { f.contact_end->time = no_number; },
      [](Figures& f) { f.contact_end->velocity = no_number; },
      [](Figures& f) { f.release->velocity = no_number; },
      [](Figures& f) { f.final_velocity = no_number; },
      [](Figures& f) { f.energy.pad = std::numeric_limits<double>::infinity(); },
  };
  for (std::size_t i = 0; i < spoilers.size(); ++i) {
    Refinement refinement(on_rigid_support, 1e-2);
    for (int k = 0; k < 4; ++k) {
      Figures run = figures_with(0);
      spoilers[i](run);
      refinement.add(run);
      EXPECT_FALSE(refinement.settled()) << "number " << i << ", run " << k;
    }
  }
}

TEST(refinement, holds_the_end_of_contact_to_the_tolerance_but_not_the_time_of_release) {
  Refinement refinement(on_rigid_support, 1e-3);
  for (int k = 0; k < 3; ++k) {
    Figures run = figures_with(0);
    run.release->time = 0.021 + 0.005 * (k % 2);
    refinement.add(run);
  }
  EXPECT_TRUE(refinement.settled());
  Figures late = figures_with(0);
  late.contact_end->time = 0.025;
  refinement.add(late);
  EXPECT_FALSE(refinement.settled());
  EXPECT_GT(refinement.errors().contact_end, 0.01);
}

/// What it gave up with, whether the end of its time or no number, is no figure of the impact.
TEST(refinement, a_run_that_fails_changes_nothing_of_what_was_agreed_on) {
  for (const bool is_no_number : {false, true}) {
    Refinement refinement(on_rigid_support, 1e-6);
    EXPECT_TRUE(refinement.add(figures_with(1e-3)));
    EXPECT_TRUE(refinement.add(figures_with(0.25e-3), 0));
    const Figures before = refinement.figures();
    const ErrorEstimates errors = refinement.errors();
    Figures failed = figures_with(0);
    failed.peak_force = is_no_number ? std::numeric_limits<double>::quiet_NaN() : 2.9e12;
    if (!is_no_number) failed.ending = Status::tolerance_not_met;
    EXPECT_FALSE(refinement.add(failed));
    EXPECT_FALSE(refinement.settled());
    EXPECT_EQ(refinement.figures().peak_force, before.peak_force);
    EXPECT_EQ(refinement.errors().peak_force, errors.peak_force);
    EXPECT_TRUE(refinement.add(figures_with(0.0625e-3)));  // the next goes on from the last that was sound
    EXPECT_LT(refinement.errors().peak_force, errors.peak_force);
  }
}

TEST(refinement, estimates_are_not_cut_to_the_tolerance) {
  Refinement refinement(on_rigid_support, 1e-3);
  for (int k = 0; k < 4; ++k) refinement.add(figures_with(k == 3 ? 0.4e-3 : 0));
  ASSERT_TRUE(refinement.settled());
  EXPECT_GT(refinement.errors().peak_force, 1e-3);
}

TEST(refinement, a_reloading_that_only_one_run_has_asks_for_a_fourth) {
  Refinement refinement(on_rigid_support, 1e-3);
  for (int k = 0; k < 4; ++k) {
    Figures run = figures_with(0);
    run.reloadings = k % 2;
    refinement.add(run);
    EXPECT_EQ(refinement.settled(), k == 3) << k;
  }
}

/// Swings this much slower than the speed of rest, or faster, in shares of it; second order.
TEST(refinement, an_impactor_is_at_rest_only_once_its_last_swing_is_told_from_one_with_more_to_come) {
  const double slow = numerics.speed_at_rest * impactor.speed;
  const auto runs_until_settled = [&](double last, double slowest, double error) {
    Refinement refinement(on_rigid_support, 1e-2);
    for (int k = 0; k < numerics.max_fixed_runs; ++k, error /= 4) {
      Figures run = figures_with(0);
      run.ending = Status::at_rest;
      run.last_swing = slow * (last - error);
      run.slowest_swing = slow * (slowest - error);
      refinement.add(run, 0);
      EXPECT_EQ(refinement.settled(), k > 1 && std::isfinite(refinement.errors().energy_absorbed)) << k;
      if (refinement.settled()) return k + 1;
    }
    return 0;
  };
  EXPECT_EQ(runs_until_settled(0.5, 1.5, 1e-2), 3) << "two may both be at rest too early";
  EXPECT_GT(runs_until_settled(0.9999, 1.5, 1e-2), 3);
  EXPECT_GT(runs_until_settled(0.5, 1.0001, 1e-2), 3);
  EXPECT_EQ(runs_until_settled(1.001, 1.5, 1e-2), 0) << "all runs would have to end a swing later";
}

TEST(refinement, does_not_settle_while_energy_is_missing) {
  Refinement refinement(on_rigid_support, 1e-3);
  for (int k = 0; k < numerics.max_fixed_runs; ++k) {
    Figures run = figures_with(0);
    run.energy.pad -= 0.01 * impact_energy;
    refinement.add(run);
    EXPECT_FALSE(refinement.settled()) << k;
  }
}

}  // namespace
}  // namespace dashpad
