#pragma once
/// The figures of one run at one resolution, before runs are compared.

#include <array>
#include <cstddef>
#include <optional>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"

namespace dashpad {

/// What a run leaves behind: the history, and where in it the phases change.
struct Track {
  History history;
  std::vector<std::size_t> stretch_starts;  ///< entries at which a smooth stretch begins; the first is 0

  void reserve(std::size_t entries) {
    for (auto* column : columns()) column->reserve(entries);
    stretch_starts.reserve(entries);
  }
  /// `layers`: of a pad of layers, how many.
  void clear(std::size_t layers = 0) {
    for (auto* column : columns()) column->clear();
    history.layer_strain.resize(layers);
    for (auto& strain : history.layer_strain) {
      strain.clear();
      strain.reserve(history.time.capacity());
    }
    stretch_starts.assign(1, 0);
  }
  /// The last entry is where a smooth stretch ends and the next begins.
  void begin_stretch() {
    if (stretch_starts.back() != size() - 1) stretch_starts.push_back(size() - 1);
  }
  [[nodiscard]] std::size_t size() const { return history.time.size(); }

 private:
  std::array<std::vector<double>*, 12> columns() {
    History& h = history;
    return {&h.time,           &h.force,       &h.pad_force,         &h.acceleration,
            &h.velocity,       &h.motion,      &h.penetration,       &h.support_deflection,
            &h.contact_radius, &h.axis_strain, &h.transmitted_force, &h.body_motion};
  }
};

enum class Ending { released, at_rest, bottomed_out, time_limit, too_many_steps };

struct Figures {
  Ending ending = Ending::too_many_steps;
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
  double left_to_sink = 0;  ///< m, of an impactor at rest on a pad that creeps
  /// Fastest speeds of an impactor that came to rest, m/s: in its last swing, and in the slowest before it.
  double last_swing = 0, slowest_swing = 0;
  double final_velocity = 0;
  double support_energy = 0;    ///< J, stored at the end
  double support_loss = 0;      ///< J, crushed and damped
  double moving_energy = 0;     ///< J, of panel and body at the end
  double weight_work = 0;       ///< J
  double peak_transmitted = 0;  ///< N
  double peak_deflection = 0;   ///< m
  double set = 0;               ///< m
  double crushing_force = 0;    ///< N, largest of a support that crushes
  double body_velocity = 0;     ///< m/s, at the end
  double pad_work = 0;          ///< J, integral of F dY
  double sheet_energy = 0;      ///< J, that the impactor has given a sheet on the pad
  double speed_to_sheet = 0;    ///< m/s, lost to it by a flat tip at first contact
  int reloadings = 0;
  std::size_t stations = 0;
  std::size_t steps = 0;
  double work = 0;  ///< of the run, s of a processor, roughly
};

/// Peak force and motion between the entries of a track: parabolas and cubics within each smooth stretch.
void read_peaks(const Track& track, Figures& figures);

/// The moment when the force falls below the impactor's weight on rebound, between the entries of a track;
/// the release, if it never was above.
void read_weight(const Track& track, const Impactor& impactor, Figures& figures);

/// The end of contact, between the entries of a track: the force falls below contact_end_share of its peak
/// for the last time. None unless the impactor was released without force. Reads `peak_force` and `ending`.
void read_contact_end(const Track& track, const Impactor& impactor, Figures& figures);

/// Integral of F dY over the track, by local parabolas of F(t) and Y(t) within each smooth stretch: of higher
/// order than the step, so that it audits the step's energy (theory.md, Eq. 30).
double work_on_pad(const Track& track);

}  // namespace dashpad
