#pragma once
/// Options and results of the solver. SI throughout; forces, penetration and strains are positive in
/// compression, velocities positive towards the pad.

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
  double tolerance = 1e-4;          ///< relative error asked for, in [1e-8, 1e-2]
  double time_limit = 10;           ///< time after first contact at which an impact is given up, s, > 0
  std::size_t max_steps = 400'000;  ///< limit for one run; beyond it the tolerance counts as out of reach
  /// Computes columns one by one, without short cuts: much slower, for checks of the fast path.
  bool plain = false;
  /// Number of runs at successively halved resolution whatever the tolerance, in [0, 10]; 0: as many as the
  /// tolerance asks for. With a fixed number the results are smooth functions of the case, as fits need: to
  /// some 5e-5 with three runs (rebound of a foam with a rate effect on a rigid support: 1e-3). The status
  /// still states whether the tolerance is met, but no further runs follow from it.
  int fixed_runs = 0;

  /// The options that a case may give.
  static const std::array<Parameter<Options>, 2> parameters;
};

inline constexpr std::array<Parameter<Options>, 2> Options::parameters{{
    {"tolerance", "", "1", &Options::tolerance, in_words(1e-8, 1e-2, "at least 1e-8 and at most 1e-2"),
     "required relative error", LeftOut::computed},
    {"time_limit", "", "s", &Options::time_limit, in_words(0, infinite, "more than 0", false),
     "time after first contact at which the run is stopped", LeftOut::computed},
}};

/// Contact ends where the force falls below this share of its peak (theory.md, Eq. 28).
inline constexpr double contact_end_share = 1e-3;

enum class Status {
  not_run,
  released,           ///< the impactor left the pad
  bottomed_out,       ///< pad fully compressed on a support that does not yield at once: no finite force
  time_limit,         ///< still in contact at Options::time_limit
  tolerance_not_met,  ///< error estimates or energy residual above the tolerance, or no run got through
  at_rest,            ///< under its weight the impactor came to rest on the pad
};
/// "released", "bottomed out", "time limit", "tolerance not met", "at rest", "not run".
std::string to_string(Status status);

struct Moment {
  double time = 0;      ///< s
  double velocity = 0;  ///< m/s
};

/// Estimated errors, relative to the figure unless stated otherwise.
struct ErrorEstimates {
  double peak_force = 0;
  /// Relative to the time at which contact ends; not held to the tolerance, since a peak may be flat.
  double time_of_peak_force = 0;
  double peak_motion = 0;
  double peak_penetration = 0;
  /// Relative to the rebound speed, or to 1e-3 of the impact speed where that is more.
  double rebound_speed = 0;
  double contact_end = 0;         ///< larger error of time and velocity at the end of contact
  double force_below_weight = 0;  ///< larger error of time and velocity at that moment
  double bottomed = 0;            ///< larger error of time and velocity at bottoming
  double energy_absorbed = 0;     ///< error of the absorbed fraction, relative to the impact energy
  double support = 0;             ///< largest error of SupportFigures; of speeds relative to the impact speed
};

/// Energies at the end of the run, J. impact + weight = kinetic + support + support_loss + moving + pad +
/// sheet + residual.
struct EnergyLedger {
  double impact = 0;
  double weight = 0;  ///< work of the impactor's weight
  double kinetic = 0;
  double support = 0;       ///< energy stored in the support
  double support_loss = 0;  ///< lost in the support by crushing and damping
  double moving = 0;        ///< kinetic energy of the panel and of the body behind
  double pad = 0;           ///< work done on the pad: what it stores and what it has lost
  double sheet = 0;         ///< given to a sheet on the pad: lost in the blows or kept as its motion
  double residual = 0;      ///< error of the balance

  [[nodiscard]] double supply() const { return impact + weight; }
};

/// Figures of a support that is more than an elastic curve, where forces of pad and support differ.
struct SupportFigures {
  /// Force on the ground or the body behind, N; absent where a pad bottoms out on a rigid support.
  std::optional<double> peak_transmitted = {};
  double peak_deflection = 0;             ///< m
  double crushing_force = 0;              ///< largest force so far of a support that crushes, N
  std::optional<double> set = {};         ///< lasting deflection of such a support, m
  std::optional<double> body_speed = {};  ///< final speed of a free body behind, m/s
};

/// Figures of a layer of a pad, on the axis: of the finest run, not extrapolated.
struct LayerSummary {
  double peak_strain = 0;
  double peak_strain_rate = 0;                ///< 1/s, magnitude
  std::optional<double> beyond_tested = {};   ///< time when it passed the highest tested strain, s
  std::optional<double> struck_through = {};  ///< time when it was struck through, s
};

/// Share of the thickness of a pad or a layer below which the rest counts as struck through.
inline constexpr double struck_through_gap = 1e-3;

/// Whether a pad is struck through at that penetration; both in m.
inline bool is_struck_through(double penetration, double thickness) {
  return thickness - penetration < struck_through_gap * thickness;
}

/// Whether an impactor at rest would sink by `left`, m, more than the tolerance of its penetration, m.
inline bool is_still_sinking(double left, double penetration, double tolerance) {
  return left > tolerance * penetration;
}

struct Summary {
  Status status = Status::not_run;
  int blow = 1;   ///< number of this blow in a series
  int blows = 1;  ///< number of blows asked for
  /// Largest force; absent when the pad bottomed out on a rigid support, where the model has no finite force.
  std::optional<double> peak_force;          ///< N
  std::optional<double> time_of_peak_force;  ///< s
  double peak_motion = 0;                    ///< largest motion of the impactor since first contact, m
  double peak_penetration = 0;               ///< below the surface of the new pad, m
  double peak_strain = 0;                    ///< on the axis: peak_penetration over the thickness
  double peak_strain_rate = 0;               ///< 1/s, magnitude
  std::optional<double> peak_acceleration;   ///< m/s2, magnitude
  /// Moment at which the force falls below the impactor's weight on rebound (the report's end of the impact).
  std::optional<Moment> force_below_weight;
  /// End of contact: the force falls below contact_end_share of its peak for the last time. Absent at the
  /// time limit, after bottoming out, and where rigid foam stops the impactor on a rigid support.
  std::optional<Moment> contact_end;
  /// Release: no column is left under pressure (theory.md, Eq. 27). Its time has no error estimate, since a
  /// spot of micrometres on the axis that carries next to nothing may decide it.
  std::optional<Moment> release;
  /// Bottoming: the pad is fully compressed on the axis for the first time.
  std::optional<Moment> bottomed;
  /// Moment at which an impactor pressed on the pad by its weight comes to rest.
  std::optional<Moment> rest;
  bool still_sinking = false;  ///< at rest on a creeping pad: motion and penetration are those so far
  std::optional<double> rebound_speed;  ///< at release, m/s; 0 if the impactor still moves on
  /// Speed of separation over impact speed; of separation from the body behind the support, if there is one.
  std::optional<double> restitution;
  /// Figures of a support that is more than an elastic curve on the ground; else absent.
  std::optional<SupportFigures> support;
  double energy_absorbed_fraction = 0;  ///< share absorbed by the pad until the end of the run
  EnergyLedger energy;
  /// Speed that a flat tip loses to a sheet on the pad at first contact, m/s; 0 without either.
  double speed_to_sheet = 0;
  /// Largest force until the largest penetration, N, if laws 4 and 5 push harder on the way back; else 0.
  double force_on_way_in = 0;
  std::vector<Extrapolation> extrapolations;
  /// Intervals of the figures; set by uncertainty::add_intervals().
  std::optional<Intervals> intervals;
  std::vector<double> softening_rates;  ///< tested rates with a curve that falls somewhere, 1/s
  std::vector<LayerSummary> layers;     ///< from the struck face on; empty for a pad of one foam
  ErrorEstimates errors;
  std::size_t steps = 0;  ///< number of steps of the finest run
  /// Stations of the finest run; 0 with a closed form throughout (no memory, or law 4 never unloaded).
  std::size_t stations = 0;
  int runs = 0;  ///< number of runs, each at half the resolution before
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
  std::vector<double> force;               ///< force on the impactor, N
  std::vector<double> acceleration;        ///< m/s2, negative while the pad pushes
  std::vector<double> velocity;            ///< m/s
  std::vector<double> motion;              ///< m
  std::vector<double> penetration;         ///< below the surface of the new pad, m
  std::vector<double> support_deflection;  ///< m
  std::vector<double> contact_radius;      ///< outer radius of the stressed area, m
  std::vector<double> axis_strain;
  /// Empty unless the support is more than an elastic curve on the ground.
  std::vector<double> transmitted_force = {};  ///< force on the ground or the body behind, N
  std::vector<double> body_motion = {};        ///< m
  /// Force of the foam of a pad under a sheet; empty without a sheet, where it equals `force`.
  std::vector<double> pad_force = {};  ///< N
  /// Strain of each layer on the axis, from the struck face on; empty for a pad of one foam.
  std::vector<std::vector<double>> layer_strain = {};
  [[nodiscard]] std::size_t size() const { return time.size(); }
  /// Force of the foam, with or without a sheet on it, N.
  [[nodiscard]] const std::vector<double>& force_of_pad() const {
    return pad_force.empty() ? force : pad_force;
  }
};

struct Solution {
  Summary summary;
  History history;
  /// Pulse of the run before the finest, with twice its step, for the error of the steps; may be empty.
  Pulse coarser = {};
};

}  // namespace dashpad
