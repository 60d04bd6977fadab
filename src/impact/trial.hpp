#pragma once
/// The state of an impact, and a step tried from it; both are values.

#include "model/contact/contact.hpp"
#include "model/support/foundation.hpp"

namespace dashpad {

/// State of an impact: time in s, lengths in m, velocity in m/s, force in N.
struct State {
  double time = 0, motion = 0, velocity = 0, penetration = 0, force = 0;
  /// Speed of the impactor less that at which the support gives way as the force of a pad held still relaxes,
  /// m/s; > 0 loads the pad (theory.md, Eq. 26).
  double drive = 0;
  BackState back;  ///< stays 0 for an elastic support on the ground
};

/// Phase of a run; in flight no column is under pressure, but the back may come after the impactor.
enum class Phase { loading, unloading, held, flight, over };

/// Event that ends a phase or a smooth stretch (theory.md, section 4).
enum class Event {
  none,
  release,
  touch,
  unlock,
  yielding,
  turning,
  reloading,
  lock,
  support_turning,
  corner,
  joining,
  rate_corner,
  landing,
  closing,
  parting
};

/// A step tried from the present state, which changes only when the step is accepted.
struct Trial {
  State end = {};
  PadTrial pad = {};
  double step = 0;               ///< s
  double pad_stiffness = 0;      ///< dF/dY over the step, N/m
  double lasting_stiffness = 0;  ///< dF/dY without the immediate effect of the rate, N/m; 0: the same
  double force_rate = 0;         ///< dF/dt at the end by Eq. 23, N/s; only for supports that crush
  Event obstacle = Event::none;  ///< why Eq. 25 has no solution over this step
  bool overshoots = false;       ///< on a damper: the rate at the end has an impossible sign

  /// Stiffness that steps must resolve, N/m.
  [[nodiscard]] double stiffness_to_resolve() const {
    return lasting_stiffness > 0 ? lasting_stiffness : pad_stiffness;
  }
  /// Mean rate of the penetration, m/s.
  [[nodiscard]] double pad_rate() const { return pad.whole_advance() / step; }
};

}  // namespace dashpad
