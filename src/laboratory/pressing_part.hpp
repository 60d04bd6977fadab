#pragma once
/// Where in an arc a column presses whose stress is known at every moment of it.

#include "laboratory/viscous_column.hpp"

namespace dashpad::laboratory {

/// Asks `presses(x)` at even places of the arc, and finds the crossings between them. `lost`: whether the
/// column did not press before the arc; then whether it does after it.
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

}  // namespace dashpad::laboratory
