#pragma once
/// The figures of one run at one resolution, before the comparison of runs.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// Record of a run: its history, and the smooth stretches between events in it.
struct Track {
  History history;
  std::vector<std::size_t> stretch_starts;  ///< entries at which a smooth stretch begins; the first is 0

  void reserve(std::size_t entries) {
    for (auto* column : columns()) column->reserve(entries);
    stretch_starts.reserve(entries);
  }
  /// `layers`: number of layers, 0 for a pad of one foam.
  void clear(std::size_t layers = 0) {
    for (auto* column : columns()) column->clear();
    history.layer_strain.resize(layers);
    for (auto& strain : history.layer_strain) {
      strain.clear();
      strain.reserve(history.time.capacity());
    }
    stretch_starts.assign(1, 0);
  }
  /// Ends a smooth stretch at the last entry and begins the next.
  void begin_stretch() {
    if (stretch_starts.back() != size() - 1) stretch_starts.push_back(size() - 1);
  }
  [[nodiscard]] std::size_t size() const { return history.time.size(); }

 private:
  std::array<std::vector<double>*, 12> columns() {
    static_assert(sizeof(History) == 13 * sizeof(std::vector<double>), "all but the strains of layers");
    History& h = history;
    return {&h.time,           &h.force,       &h.pad_force,         &h.acceleration,
            &h.velocity,       &h.motion,      &h.penetration,       &h.support_deflection,
            &h.contact_radius, &h.axis_strain, &h.transmitted_force, &h.body_motion};
  }
};

struct Figures {
  Status ending = Status::tolerance_not_met;  ///< of a run that was given up, tolerance_not_met
  double peak_force = 0;
  double time_of_peak_force = 0;
  double peak_motion = 0;
  double peak_penetration = 0;
  double peak_pad_rate = 0;  ///< |dY/dt|, m/s
  std::optional<Moment> force_below_weight;
  std::optional<Moment> contact_end;
  std::optional<Moment> release;
  std::optional<Moment> bottomed;
  std::optional<Moment> rest;
  double left_to_sink = 0;  ///< distance that an impactor at rest on a creeping pad would still sink, m
  /// Largest speeds of an impactor that came to rest, m/s: in its last swing, and in the slowest one before.
  double last_swing = 0, slowest_swing = 0;
  double final_velocity = 0;
  EnergyLedger energy;          ///< without those of the impactor and the residual
  double peak_transmitted = 0;  ///< N
  double peak_deflection = 0;   ///< m
  double set = 0;               ///< m
  double crushing_force = 0;    ///< largest force of a support that crushes, N
  double body_velocity = 0;     ///< at the end, m/s
  double speed_to_sheet = 0;    ///< lost to the sheet by a flat tip at first contact, m/s
  int reloadings = 0;
  std::size_t stations = 0;
  std::size_t steps = 0;
  double work = 0;  ///< estimated processor time of the run, s
};

/// Reads peaks between the entries of a track, by parabolas and cubics in smooth stretches.
void read_peaks(const Track& track, Figures& figures);

/// Reads the moment at which the force falls below the weight on rebound; the release if it never exceeds it.
void read_weight(const Track& track, const Impactor& impactor, Figures& figures);

/// Reads the end of contact between entries: the force falls below contact_end_share of its peak for the last
/// time. None unless the impactor was released without force. Uses `peak_force` and `ending`.
void read_contact_end(const Track& track, const Impactor& impactor, Figures& figures);

/// Integral of F dY over the track, J, by local parabolas of F(t) and Y(t) within each smooth stretch: of
/// higher order than the step, whose energy it thus audits (theory.md, Eq. 30).
double work_on_pad(const Track& track);

}  // namespace dashpad
