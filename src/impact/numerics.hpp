#pragma once
/// The constants of the runs through an impact, with their units and the reasons for their values. Those of
/// the root and event searches and of the stations are in their own files.
///
/// But for the limits of rest none is physics: with finer resolution the figures do not depend on them.
/// Equation numbers are those of theory.md; rho is the resolution of a run.

#include <cstddef>
#include <limits>

namespace dashpad {

struct Numerics {
  // --- The step (Eq. 25) ---

  /// Residual of Eq. 25 at which a trial of a pad with memory counts as solved, in rho^3 of the motion or, if
  /// less, of `solved_residual_of_gap` times the gap before the lock, over which the force grows. The force
  /// takes up the rest; the error is of third order, below that of the step.
  double solved_residual = 0.1;
  double solved_residual_of_gap = 10;
  /// Share of that residual required of a first trial, as its slope, and the force taken up, is a guess.
  double solved_first_trial = 0.2;
  /// Largest correction of the penetration equivalent to what the force takes up, in rho of the advance,
  /// above which the stricter `solved_small_advance` holds: the columns stay as they were tried.
  double largest_take_up = 0.05;
  /// The same for a pad that moves on with what the force takes up: its rate then is exact, and only the
  /// force is that of a guessed slope. (With 0.05 a head on a pillar took a fifth more steps or a run more.)
  double largest_move_on = 0.01;
  double solved_small_advance = 0.1;  ///< share of the allowed residual
  /// Largest such correction as a share of the advance, but for rounding: the next step, which makes up for
  /// it, may hardly move. (Without this, steps near the turning point on a rigid support shrank to rounding.)
  double max_take_up = 0.1;
  /// Largest force taken up, in rho of the force: a step of a few roundings of the time has no stiffness.
  /// (With up to half of the force runs on a panel stalled in steps of 1e-16 s.)
  double max_force_taken_up = 0.1;
  /// Relative rounding of a sum of a few terms, the accuracy of a residual without memory.
  double rounding = 4 * std::numeric_limits<double>::epsilon();
  /// Relative differences of advance and force below which two trials give no slope dF/dY.
  double min_change_of_advance = 1e-9;
  double min_change_of_force = 1e-12;
  /// First stride on unloading, in advances; of several roots the nearest belongs to the branch.
  double unloading_stride = 0.2;
  /// Rounding of the fourth root of an advance, relative to its upper bound.
  double fourth_root_resolution = 1e-14;

  /// Largest stiffness of a pad that unloads on a panel, in that of slow compression, of which steps take
  /// note.
  double max_unloading_on_panel = 10;
  /// Relative extension of a step that yields the stiffness at an unchanged rate.
  double more_of_the_same = 1e-3;

  // --- The guess of the next step ---

  /// Largest factor of the pad's stiffness from one step to the next that a guess may assume.
  double max_stiffening = 2;
  /// Largest number of consecutive steps whose stiffness is a guess; then it is limited to what the step
  /// shows. (Steps without memory shrank by 1.4 each, down to nothing; with law 4 on a panel to 3e-10 s.)
  int max_guesses = 6;
  /// Share of the gap by which a guess after an event may change it.
  double guess_of_gap = 0.1;
  /// Ratio of a rate to the last below which it breaks down towards the turning point: the stiffness over
  /// that step is not that of a spring.
  double breakdown_of_rate = 0.4;

  // --- Events ---

  /// Tolerance of an event's place in a step, in rho^2 of the step: an event shifts the figures by its error.
  double event_precision = 1e-3;
  /// The same of the turning point with memory, in rho of the step: near rate zero its error hardly matters.
  double turning_precision = 2e-2;
  /// Share of a step, in rho, within which the end of a branch counts as immediate: in so short a step only
  /// the residual of the last root moves anything.
  double min_step_to_branch_end = 1e-2;
  /// Shortest step, relative to the time: a few roundings of it.
  double shortest_step = 64 * std::numeric_limits<double>::epsilon();
  /// Relative distance of a force from a corner of the support below which it is at the corner.
  double at_corner = 1e-9;
  /// Relative distance of a penetration from that of earlier blows below which it has reached it.
  double at_joint = 1e-12;
  /// Relative distance beyond the penetration at the release from which on crushed foam is met in flight: an
  /// impactor that moves on with a panel without force would meet it by rounding.
  double at_crater = 1e-9;
  /// Largest number of halvings of a step with several events or far too long: down to rounding.
  int max_halvings = 60;
  /// Ratio of a step to the length allowed by its result above which it is halved.
  double too_long = 2;
  /// Largest number of changes of phase at one moment.
  int max_idle_events = 16;
  /// Time for which the pad is held where neither phase has a solution, in rho^2 of a step.
  double held_moment = 0.1;
  /// Largest speed against a panel, in impact speeds, at which that is done, since both then move on as one
  /// body: rounding. (A quarter of the impact energy was lost at higher ones.)
  double min_speed_to_stop = 1e-6;
  /// Largest speed of a back after an impactor that has left, in impact speeds, at which it is not awaited.
  double min_return = 1e-6;
  /// Least drive (Eq. 26) of a reloading that counts, in impact speeds; smaller ones may come from rounding.
  double min_drive = 1e-3;

  // --- Step length ---

  /// Largest growth of steps from one to the next, also after an event, where the strain rate may jump.
  double growth = 1.5;
  /// Largest share of the gap that closes in a step, in rho, and at most `max_closing`.
  double closing = 4;
  /// The same of a foam by its curves: `closing_of_foam`, plus `closing_of_open_foam` times the fourth power
  /// of the gap over its first size. A foam takes the impact up in its steepest part, so that the gap that is
  /// left shows every error before. (With 4, one pressed nearly flat took half the steps, but two runs more.)
  double closing_of_foam = 0.6;
  double closing_of_open_foam = 8;
  double max_closing = 0.5;
  /// Closing always allowed, in rho^2 of the thickness, as a pad may lock. (With 1e-2 the last step into the
  /// lock passed over much of the work where the force has no bound.)
  double min_closing = 1e-6;
  double min_closing_if_bounded = 1e-2;
  /// Relative growth of the force over the gap below which it counts as bounded.
  double bounded = 0.1;
  /// Largest relative fall of the force in a step, in rho, before the end of contact, which is read between
  /// the entries; after it, and at most, `max_fall`.
  double fall = 7;
  double max_fall = 0.7;
  /// Shortest step towards the release, in rho of a usual step, before and after the end of contact.
  double shortest_before_end = 0.25;
  double shortest_after_end = 1;
  /// Largest share of the time until a pad on a rigid support turns that a step takes; unloading begins with
  /// a step of rho of a usual one. The force of laws 4 and 5 goes with a small power of the rate there, and a
  /// step of usual length contains the turning point anywhere: with such steps 9 of 5,500 figures of ordinary
  /// cases were off by more than 1e-4, with shorter ones 6, for 1 % more steps.
  double towards_turning = 0.7;
  /// Longest step while the force of a foam on a damper rises, in rho of the time in which its rate changes
  /// by a factor of e. (Steps limited only by `growth` passed the first touch in equally many steps at every
  /// rho, with an error of 1e-4: 6 of 6,863 figures of foams on moving supports were off by more than 1e-4,
  /// with this 2, for 2 % more time.)
  double damped = 4;
  /// Largest ratio of the first step to the step that the stiffness in it allows.
  double first_step = 0.25;
  int max_first_halvings = 400;
  /// Shortest step with a meaningful rate, in rho of a usual step; in shorter ones it is a residual.
  double min_step_with_rate = 1e-2;

  // --- Refinement (Eq. 31) ---

  /// Resolution of the first run: some thirty steps and a dozen stations.
  double first_resolution = 0.2;
  int max_fixed_runs = 10;
  /// Safety factor of the error estimates, since two runs may agree by chance.
  double safety_factor = 3;
  /// Least tolerance for which two runs may suffice, if also their motions agree: of 88,000 figures of
  /// ordinary cases 7 were off by more than 1e-3 then, without them 6. At 1e-4 every case needs more than
  /// two.
  double min_tolerance_of_two_runs = 1e-3;
  /// Energy residuals of the extrapolated figures that count to the distance of two runs: extrapolation takes
  /// an error of order 2 off, so that the residual shows how far they are from it.
  double residuals_of_two_runs = 3;
  /// Share of the tolerance within which three runs must have the bottoming.
  double share_of_bottoming = 0.5;
  /// Tolerance below which runs must agree to half of it once, or to all of it twice. Laws 4 and 5 have a
  /// small power of the rate, and their errors fall with scatter: with 1e-4 once, 34 of 26,603 figures of
  /// ordinary cases were off by more, at 0.5 to 1 times the printed estimate.
  double min_tolerance_in_full = 1e-3;
  /// Least ratio of the error of the rebound speed to the one before. The error depends on the places of
  /// events in their steps; below the ratio of its order it falls only by chance.
  double fastest_fall_of_error = 0.25;
  /// The same for bottoming on a yielding support (with 0.25, 8 of 8,800 plausible ones were off by 1e-4).
  double fastest_fall_of_bottoming = 0.5;
  /// Relative rounding of an extrapolated figure.
  double rounding_of_figures = 1e-12;
  /// Share of the impact speed below which the tolerance of a speed is relative to that share.
  double min_speed = 1e-3;
  /// Share of the impactor's motion to which the tolerance of smaller deflections and sets is relative.
  double min_deflection = 1e-3;
  /// Largest error of the time of the peak force, relative to the time at which contact ends.
  double loosest_time_of_peak = 0.01;

  // --- Rest ---

  /// Largest speed between two turns of an impactor that counts as at rest, in impact speeds, which leaves
  /// 1e-4 of the impact energy. One that does not swing is at rest if its speed, and the force less its
  /// weight over the weight, are below `creep_at_rest`.
  double speed_at_rest = 1e-2;
  double creep_at_rest = 1e-3;

  // --- Limits of a run ---

  /// Mass of a panel over that of the impactor and the tolerance, below which it is left out.
  double lightest_panel = 0.05;

  /// Largest work of all runs of an impact, s, times (1e-3 / t)^(7/8) for a tolerance t below 1e-3, at most
  /// `max_patience`. A run that would exceed it is not started.
  double max_work = 1.7;
  double max_patience = 15;
  /// Largest number of consecutive runs given up: some stall where finer ones get through.
  int max_given_up = 2;
  /// Work of a step, and of a column in a trial, s: rough times on a processor of 2024. It is counted, not
  /// timed, so that a case ends alike everywhere. A layered column in a root within a root counts twice.
  double work_of_step = 1.5e-6;
  double work_of_column = 1.4e-8;
  double work_of_layered_column = 1.5e-7;
};

inline constexpr Numerics numerics;

}  // namespace dashpad
