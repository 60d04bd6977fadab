#pragma once
/// The parts of a strain history in which the strain only grows, only falls, or stands still; when in one of
/// them a column carries stress; and places within a history where a value is wanted.

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

/// When in an arc a column carries stress; times from the arc's start.
struct Contact {
  bool any = false;
  double from = 0;
  double to = 0;
  bool taken_up = false;  ///< at `from`, after it was lost
  bool lost = false;      ///< at `to`
};

/// Where in an arc a column presses whose stress is known at every moment of it: asks `presses(x)` at even
/// places, and finds the crossings between them. `lost`: whether the column did not press before the arc;
/// then whether it does after it.
template <class Presses>
Contact pressing_part(const Arc& arc, bool& lost, Presses&& presses) {
  constexpr int places = 128;
  constexpr int halvings = 60;
  const auto crossing = [&](double before, double after) {
    const bool rises = presses(after);
    for (int i = 0; i < halvings; ++i) {
      const double middle = before + (after - before) / 2;
      (presses(middle) == rises ? after : before) = middle;
    }
    return rises ? after : before;
  };
  Contact contact{false, 0, arc.duration, false, false};
  bool pressed = presses(0.0);
  contact.any = pressed;
  double before = 0;
  for (int i = 1; i <= places && !contact.lost; ++i) {
    const double x = arc.duration * i / places;
    const bool presses_now = presses(x);
    if (presses_now && !contact.any) contact.from = crossing(before, x);
    contact.any = contact.any || presses_now;
    if (pressed && !presses_now) {
      contact.to = crossing(before, x);
      contact.lost = true;
    }
    pressed = presses_now;
    before = x;
  }
  contact.taken_up = contact.any && lost;
  lost = contact.lost || (lost && !contact.any);
  return contact;
}

/// Of a whole history, s.
double duration_of(const StrainHistory& history);

/// When the strain first stops to grow, s; 0 if it never grows.
double end_of_first_loading(const StrainHistory& history);

/// At a time from 0 to the end.
double strain_at(const StrainHistory& history, double time);

/// The same history in more pieces: one ends at each of `times` (increasing, s), so that it becomes a place
/// of output.
StrainHistory split_at(const StrainHistory& history, const std::vector<double>& times);

}  // namespace dashpad::laboratory
