#pragma once
/// What is asked of the solver and what it answers. SI throughout; forces, penetration and strains are
/// positive in compression, velocities positive towards the pad.

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "dashpad/impact/interval.hpp"
#include "dashpad/impact/pulse.hpp"
#include "dashpad/model/pad/material.hpp"
#include "dashpad/quantities/constants.hpp"

namespace dashpad {

struct Options {
  double tolerance = 1e-4;           ///< relative error asked for, in [1e-8, 1e-2]
  double time_limit = 10;            ///< s after first contact at which an impact is given up, > 0
  std::size_t most_steps = 400'000;  ///< of one run; more means that the tolerance cannot be met
  /// Computes column by column, without vectors and short cuts: many times slower, to check the fast path
  /// against.
  bool plain = false;
  /// Number of runs at successively halved resolution whatever the tolerance, in [0, 10]; 0: as many as the
  /// tolerance asks for. With a fixed number the results change smoothly with the numbers of the case,
  /// to some 5e-5 with three runs, which fits need (the rebound of a foam with a rate effect on a rigid
  /// support to 1e-3); the status then says whether the tolerance is met, and decides nothing.
  int fixed_runs = 0;

  /// Those that a case may give.
  static const std::array<Parameter<Options>, 2> parameters;
};

inline constexpr std::array<Parameter<Options>, 2> Options::parameters{{
    {"tolerance", "", "1", &Options::tolerance, in_words(1e-8, 1e-2, "at least 1e-8 and at most 1e-2"),
     "relative error asked for", LeftOut::computed},
    {"time_limit", "", "s", &Options::time_limit, in_words(0, infinite, "more than 0", false),
     "time after first contact at which an impact is given up", LeftOut::computed},
}};

/// Contact ends where the force falls below this share of its peak (theory.md, Eq. 28).
inline constexpr double contact_end_share = 1e-3;

enum class Status {
  not_run,
  released,           ///< the impactor left the pad
  bottomed_out,       ///< the pad was fully compressed on what does not give way at once: no finite force
  time_limit,         ///< still in contact at Options::time_limit
  tolerance_not_met,  ///< finished, but an error estimate or the energy residual is above the tolerance
  at_rest,            ///< under its weight the impactor came to rest on the pad
};
/// "released", "bottomed out", "time limit", "tolerance not met", "at rest", "not run".
std::string to_string(Status status);

struct Moment {
  double time = 0;      ///< s
  double velocity = 0;  ///< m/s
};

/// Estimated errors, relative to the figure unless it is said otherwise.
struct ErrorEstimates {
  double peak_force = 0;
  /// Relative to the time at which contact ends; not held to the tolerance, since a peak may be flat.
  double time_of_peak_force = 0;
  double peak_motion = 0;
  double peak_penetration = 0;
  /// Relative to the rebound speed, or to 1e-3 of the impact speed where that is more.
  double rebound_speed = 0;
  double contact_end = 0;         ///< of time and velocity at the end of contact, the larger
  double force_below_weight = 0;  ///< of time and velocity when the force falls below the weight, the larger
  double bottomed = 0;            ///< of time and velocity at bottoming, the larger
  double energy_absorbed = 0;     ///< of the absorbed fraction, relative to the impact energy
  double support = 0;             ///< of SupportFigures, the largest; of speeds relative to the impact speed
};

/// Energies at the end of the run, J. impact + weight = kinetic + support + support_loss + moving + pad +
/// sheet + residual.
struct EnergyLedger {
  double impact = 0;
  double weight = 0;  ///< work of the impactor's weight
  double kinetic = 0;
  double support = 0;       ///< stored in the support
  double support_loss = 0;  ///< crushed and damped
  double moving = 0;        ///< kinetic, of the panel and of the body behind the support
  double pad = 0;           ///< work done on the pad: what it stores and what it has lost
  double sheet = 0;         ///< given to a sheet on the pad: lost where it was struck, or carried away by it
  double residual = 0;      ///< what the numbers fail to account for

  [[nodiscard]] double supply() const { return impact + weight; }
};

/// What a support that loses energy or moves has done; forces of the pad and the support differ there.
struct SupportFigures {
  /// Force on the ground or the body behind, N; absent where a pad bottoms out on a rigid support.
  std::optional<double> peak_transmitted;
  double peak_deflection = 0;        ///< m
  double crushing_force = 0;         ///< largest so far of a support that crushes, N
  std::optional<double> set;         ///< deflection of such a support that stays, m
  std::optional<double> body_speed;  ///< of a free body behind, at the end, m/s
};

/// A layer of a pad, on the axis: of the finest run, not extrapolated.
struct LayerSummary {
  double peak_strain = 0;
  double peak_strain_rate = 0;                ///< 1/s, magnitude
  std::optional<double> beyond_tested = {};   ///< when its strain passed the highest tested one, s
  std::optional<double> struck_through = {};  ///< when less than struck_through_gap of it was left, s
};

/// Of the thickness of a pad or a layer: with less left it counts as struck through.
inline constexpr double struck_through_gap = 1e-3;

/// Whether a pad is struck through at that penetration; both in m.
inline bool is_struck_through(double penetration, double thickness) {
  return thickness - penetration < struck_through_gap * thickness;
}

/// Whether an impactor at rest on a pad that creeps has a way left to go, m, that the tolerance would show.
inline bool is_still_sinking(double left, double penetration, double tolerance) {
  return left > tolerance * penetration;
}

struct Summary {
  Status status = Status::not_run;
  int blow = 1;   ///< of a series, which of its blows this is
  int blows = 1;  ///< how many were asked for
  /// Absent when the pad bottomed out on a rigid support: the model has no finite force there.
  std::optional<double> peak_force;          ///< N
  std::optional<double> time_of_peak_force;  ///< s
  double peak_motion = 0;                    ///< of the impactor since first contact, m
  double peak_penetration = 0;               ///< m, below the surface of the new pad
  double peak_strain = 0;                    ///< on the axis
  double peak_strain_rate = 0;               ///< 1/s, magnitude
  std::optional<double> peak_acceleration;   ///< m/s2, magnitude
  /// Force below the impactor's weight on rebound (the report's end of the impact).
  std::optional<Moment> force_below_weight;
  /// End of contact: the force falls below contact_end_share of its peak for the last time. Absent where
  /// contact is not lost: at the time limit, after bottoming out, with a rigid foam that stops the impactor
  /// on a rigid support.
  std::optional<Moment> contact_end;
  /// No column is left under pressure (theory.md, Eq. 27). Its time carries no error estimate: a spot of
  /// micrometres on the axis, which carries next to nothing, may decide it.
  std::optional<Moment> release;
  /// Pad fully compressed on the axis for the first time.
  std::optional<Moment> bottomed;
  /// Of an impactor that its weight presses on the pad.
  std::optional<Moment> rest;
  bool still_sinking = false;  ///< then, on a pad that creeps: motion and penetration are those so far
  std::optional<double> rebound_speed;  ///< at release, m/s; 0 if the impactor then still goes on
  /// Speed of separation over impact speed; from a body behind the support, if it is free.
  std::optional<double> restitution;
  /// Of supports that are more than an elastic curve on the ground.
  std::optional<SupportFigures> support;
  double energy_absorbed_fraction = 0;  ///< of the impact energy, by the pad, until the end of the run
  EnergyLedger energy;
  /// Lost by a flat tip to a sheet on the pad, at first contact and at once, m/s; 0 without either.
  double speed_to_sheet = 0;
  /// Largest force until the pad was deepest, N, where laws 4 and 5 push harder on the way back; else 0.
  double force_on_way_in = 0;
  std::vector<Extrapolation> extrapolations;
  /// What is not known of the figures; set by uncertainty::add_intervals().
  std::optional<Intervals> intervals;
  std::vector<double> softening_rates;  ///< tested rates whose curve falls somewhere, 1/s
  std::vector<LayerSummary> layers;     ///< from the struck face on; none of a pad of one foam
  ErrorEstimates errors;
  std::size_t steps = 0;  ///< of the finest run
  /// Of the finest run; 0 where the force was a closed form throughout (laws without memory; law 4 if never
  /// unloaded).
  std::size_t stations = 0;
  int runs = 0;  ///< resolutions compared
  double tolerance = 0;
  double wall_time = 0;  ///< s

  /// Whether the law was used beyond what it was tested or fitted for.
  [[nodiscard]] bool is_beyond(Beyond beyond) const {
    return std::ranges::find(extrapolations, beyond, &Extrapolation::beyond) != extrapolations.end();
  }

  /// Whether the figures may be relied on to the tolerance asked for.
  [[nodiscard]] bool trustworthy() const {
    return status == Status::released || status == Status::at_rest || status == Status::bottomed_out ||
           status == Status::time_limit;
  }
};

/// The impact over time, one entry a time step of the finest run.
struct History {
  std::vector<double> time;                ///< s
  std::vector<double> force;               ///< N, on the impactor
  std::vector<double> acceleration;        ///< m/s2, negative while the pad pushes
  std::vector<double> velocity;            ///< m/s
  std::vector<double> motion;              ///< m
  std::vector<double> penetration;         ///< m, below the surface of the new pad
  std::vector<double> support_deflection;  ///< m
  std::vector<double> contact_radius;      ///< m, outer edge of the stressed area
  std::vector<double> axis_strain;         ///< on the axis
  /// Of supports that are more than an elastic curve on the ground; else empty.
  std::vector<double> transmitted_force = {};  ///< N, on the ground or the body behind
  std::vector<double> body_motion = {};        ///< m
  /// Of a pad under a sheet with mass, of the foam; else empty: it is the force on the impactor.
  std::vector<double> pad_force = {};  ///< N
  /// Of each layer on the axis, from the struck face on; none of a pad of one foam.
  std::vector<std::vector<double>> layer_strain = {};
  [[nodiscard]] std::size_t size() const { return time.size(); }
  /// Of the foam, with or without a sheet on it, N.
  [[nodiscard]] const std::vector<double>& force_of_pad() const {
    return pad_force.empty() ? force : pad_force;
  }
};

struct Solution {
  Summary summary;
  History history;
  /// Of the run before the finest, with twice its step: what the steps leave in a figure shows in the
  /// difference. None if there was one run only.
  Pulse coarser = {};
};

}  // namespace dashpad
