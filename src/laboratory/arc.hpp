#pragma once
/// The parts of a strain history in which the strain only grows, only falls, or stands still.

#include <cstddef>
#include <vector>

#include "dashpad/laboratory/strain_history.hpp"

namespace dashpad::laboratory {

struct Motion {
  double strain = 0;
  double rate = 0;  ///< 1/s
};

/// A parabola in time that does not turn. It is evaluated from its nearer end, so that a strain or a rate
/// which vanishes at an end does so without cancellation.
struct Stretch {
  double time = 0;      ///< of its start, s since first contact
  double duration = 0;  ///< s
  Motion start;
  Motion end;
  double acceleration = 0;  ///< of the strain, 1/s2

  /// `x` s after the start, best near it.
  [[nodiscard]] Motion after_start(double x) const;
  /// `y` s before the end, best near it.
  [[nodiscard]] Motion before_end(double y) const;
  [[nodiscard]] Motion at(double x) const {
    return x <= duration / 2 ? after_start(x) : before_end(duration - x);
  }
  [[nodiscard]] Stretch part(double from, double to) const;
  /// 1: the strain grows, -1: it falls, 0: it stands still.
  [[nodiscard]] int direction() const;
};

struct Arc : Stretch {
  double piece_duration = 0;
  double offset = 0;  ///< of its start in its piece, s
};

/// A piece that turns is split at its vertex. The history must have no violations().
std::vector<Arc> arcs_of(const StrainHistory& history);

}  // namespace dashpad::laboratory
