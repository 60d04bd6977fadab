#pragma once
/// The constants of the runs through an impact: what each is, in which unit, and why it has this value. Those
/// of the root and event searches and of the stations stand in their own files.
///
/// None of them is physics: with a finer resolution the figures tend to the same values whatever these are.
/// Equation numbers are those of theory.md; rho is the resolution of a run.

#include <cstddef>
#include <limits>

namespace dashpad {

struct Numerics {
  // --- The step (Eq. 25) ---

  /// Residual of Eq. 25, in rho^3 of the motion, or of so many times the gap above the lock, at which a trial
  /// of a pad with memory counts as solved. The force takes up the rest; the error is of third order, below
  /// that of the step. (The force grows over the gap: of the motion alone it was more than the gap itself.)
  double solved_residual = 0.1;
  double solved_residual_of_gap = 10;
  /// Share of it that a first trial must reach: its slope is a guess, and so is what the force takes up.
  double solved_first_trial = 0.2;
  /// What the force takes up may move the penetration by this much, in rho of its advance, before the
  /// stricter `solved_small_advance` holds: the columns stay where they were tried.
  double largest_take_up = 0.05;
  double solved_small_advance = 0.1;  ///< share of the allowed residual
  /// And it may then be no more than this share of the advance, but for rounding: what is left over of one
  /// step is made up for in the next, whose rate would be nothing else where the pad hardly moves. (Without
  /// this, steps near the turning point on a rigid support shrank to rounding.)
  double most_take_up = 0.1;
  /// And it is at most this share of the force, in rho: a step of a few roundings of the time has no
  /// stiffness. (Where up to half of the force was taken up, the next step resolved the jump back, and runs
  /// on a panel stalled in steps of 1e-16 s.)
  double most_force_taken_up = 0.1;
  /// Rounding of a sum of a few terms, relative: what a residual without memory is solved to.
  double rounding = 4 * std::numeric_limits<double>::epsilon();
  /// Two trials that differ by less say nothing about the slope dF/dY: relative, of advance and force.
  double least_change_of_advance = 1e-9;
  double least_change_of_force = 1e-12;
  /// First stride of the search on unloading, in advances: of several roots the nearest belongs to the
  /// branch.
  double unloading_stride = 0.2;
  /// Below this, relative to its upper end, the fourth root of an advance is rounding.
  double fourth_root_resolution = 1e-14;

  /// Share of an advance by which it is made longer to learn the stiffness at an unchanged rate.
  double more_of_the_same = 1e-3;

  // --- The guess of the next step ---

  /// Change of the pad's stiffness from one step to the next that a guess may assume.
  double most_stiffening = 2;
  /// Steps in a row that may have no other stiffness than a guess before it is no more than what the step
  /// shows. (Steps of a pad without memory became shorter by a factor of 1.4 each, down to nothing; those of
  /// law 4 on a panel stayed at 3e-10 s.)
  int most_guesses = 6;
  /// Share of the gap that a guess after an event may open or close.
  double guess_of_gap = 0.1;
  /// A rate that fell to less than this share of the last is the breakdown towards the turning point: the
  /// stiffness over that step is not that of a spring.
  double breakdown_of_rate = 0.4;

  // --- Events ---

  /// Tolerance of an event's place in a step, in rho^2 of the step: an event shifts the figures by its error.
  double event_precision = 1e-3;
  /// Of the turning point with memory, in rho of the step: the pad turns at a rate near zero, so that a
  /// little early or late changes nothing of first order.
  double turning_precision = 2e-2;
  /// A branch that ends within this share (in rho) of a step ends at once: in so short a step nothing moves
  /// but what the last root has left over.
  double least_step_to_branch_end = 1e-2;
  /// Roundings of the time: no step is shorter.
  double shortest_step = 64 * std::numeric_limits<double>::epsilon();
  /// A force this near to a corner of the support, relative, is at it.
  double at_corner = 1e-9;
  /// A penetration this near to that of earlier blows, relative, has reached it.
  double at_joint = 1e-12;
  /// In flight, crushed foam is met this far beyond where it was left, relative: what goes on with a panel
  /// without force would meet it by rounding.
  double at_crater = 1e-9;
  /// Halvings of a step that met several events at once, or proved far too long: down to rounding.
  int most_halvings = 60;
  /// A step is taken again at half its length if it is this many times as long as what it found allows.
  double too_long = 2;
  /// Phases may change at one moment, but not for ever.
  int most_idle_events = 16;
  /// Where neither phase has a solution the pad is held for this long, in rho^2 of a step.
  double held_moment = 0.1;
  /// On a panel, with which it goes on as one body, only where the two move against each other no faster than
  /// this, in impact speeds: rounding. (A quarter of the impact energy was lost where they did.)
  double least_speed_to_stop = 1e-6;
  /// What comes after an impactor that has left the pad no faster than this, in impact speeds, is not waited
  /// for.
  double least_return = 1e-6;
  /// Reloadings count from this drive (Eq. 26) on, in impact speeds; below, they may come from rounding.
  double least_drive = 1e-3;

  // --- Step length ---

  /// Growth of steps from one to the next, also after an event, where the strain rate may jump.
  double growth = 1.5;
  /// The gap closes in a step by at most this many rho of it, but no more than `most_closing`.
  double closing = 4;
  double most_closing = 0.5;
  /// And by this many rho^2 of the thickness at least: a pad may lock. (With 1e-2 the last step into the lock
  /// passed over much of the work where the force has no bound.)
  double least_closing = 1e-6;
  double least_closing_if_bounded = 1e-2;
  /// Growth of the force over the gap, in shares of it, below which it has a bound there.
  double bounded = 0.1;
  /// While the end of contact is to come, a step takes the force down by this many rho of it; after it, and
  /// at the most, by `most_fall` of it. The end of contact is read between the entries.
  double fall = 7;
  double most_fall = 0.7;
  /// Shortest step towards the release, in rho of a usual step, before and after the end of contact.
  double shortest_before_end = 0.25;
  double shortest_after_end = 1;
  /// Of the time that is left until a pad on a rigid support turns a step takes this share; it begins to
  /// unload with a step of rho of a usual one. The force of laws 4 and 5 has a small power of the rate there,
  /// and the place of the turning point in a step of usual length is chance: with steps that end anywhere,
  /// 9 of 5,500 figures of ordinary cases were beyond 1e-4, with these 6, for 1 % more steps.
  double towards_turning = 0.7;
  /// While the force of a foam on a damper rises, a step is at most this many rho of the time in which its
  /// rate changes by a factor of e. (Steps that only grew by `growth` passed the first touch in as many steps
  /// at every rho, and left it 1e-4 off: 6 of 6,863 figures of foams on supports that move were beyond 1e-4,
  /// with this 2, for 2 % more time.)
  double damped = 4;
  /// The first step, in steps that its own stiffness would allow.
  double first_step = 0.25;
  int most_first_halvings = 400;
  /// A step shorter than this, in rho of a usual step, has no rate but what the roots have left over.
  double least_step_with_rate = 1e-2;

  // --- Refinement (Eq. 31) ---

  /// Resolution of the first run: some thirty steps and a dozen stations.
  double first_resolution = 0.2;
  int most_fixed_runs = 10;
  /// Safety factor of the error estimates, since two runs may agree by chance.
  double safety_factor = 3;
  /// Below this tolerance two runs are too few, however well they agree: the first has some thirty steps and
  /// a dozen stations, and of 4,500 plausible cases three agreed by chance (the worst was 5e-3 off).
  double least_tolerance_of_two_runs = 2e-3;
  /// Below this tolerance runs have to agree to half of it once, or to all of it twice. Laws 4 and 5 have a
  /// small power of the rate, and their errors fall with scatter: where 1e-4 once was enough, 34 of 26,603
  /// figures of ordinary cases were beyond it, at 0.5 to 1 times the estimate that is printed.
  double least_tolerance_in_full = 1e-3;
  /// The error of the rebound speed is at least this share of that before. At second order it falls to an
  /// eighth; to less, by chance: the places of events in their steps are left in it.
  double fastest_fall_of_error = 0.25;
  /// The same of bottoming on what yields (with a quarter 8 of 8,800 such figures of plausible cases were
  /// beyond 1e-4).
  double fastest_fall_of_bottoming = 0.5;
  /// Rounding of an extrapolated figure, relative.
  double rounding_of_figures = 1e-12;
  /// Speeds below this share of the impact speed are held to the tolerance relative to it.
  double least_speed = 1e-3;
  /// Deflections and sets below this share of the impactor's motion are held to the tolerance relative to it.
  double least_deflection = 1e-3;
  /// Largest error of the time of the peak force, relative to the time at which contact ends.
  double loosest_time_of_peak = 0.01;

  // --- Rest ---

  /// An impactor under its weight has come to rest when between two turns it was never faster than this share
  /// of the impact speed, which leaves 1e-4 of the impact energy; or, where it does not swing, when speed and
  /// what is left of the force are below the second share.
  double speed_at_rest = 1e-2;
  double creep_at_rest = 1e-3;

  // --- Limits of a run ---

  /// Mass of a panel, over that of the impactor and the tolerance, below which it is none.
  double lightest_panel = 0.05;

  /// Work of all runs of an impact together after which it is given up, s; for a tolerance t below 1e-3 more,
  /// by (1e-3 / t)^(7/8), but no more than `most_patience` times as much. A run that would exceed it is not
  /// begun.
  double most_work = 1.7;
  double most_patience = 15;
  /// Runs that may be given up one after the other before no more are begun: some stall where others get
  /// through.
  int most_given_up = 2;
  /// Work of a step, and of a column in a trial, s: what they take on a processor of 2024, roughly. Counted,
  /// not timed, so that the same case ends alike everywhere. A layered column inside a root within a root
  /// takes twice as long, with what is around it.
  double work_of_step = 1.5e-6;
  double work_of_column = 1.4e-8;
  double work_of_layered_column = 1.5e-7;
};

inline constexpr Numerics numerics;

}  // namespace dashpad
