#pragma once
/// What a run leaves behind: the history, and where in it the phases change.

#include <array>
#include <cstddef>
#include <vector>

#include "dashpad/impact/solution.hpp"

namespace dashpad {

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

}  // namespace dashpad
