#pragma once
/// The stretch of a pulse in which the impactor touches what it strikes.

#include <optional>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// From `begin` to `end`, s, both included.
struct Stretch {
  double begin = 0, end = 0;
};

struct Contact {
  double begin = 0, end = 0;   ///< s
  double velocity_change = 0;  ///< m/s, over that stretch, magnitude
};

/// `along` is the acceleration along the axis of the impact, m/s2, of either sign: of a resultant that of its
/// main axis, since a length never changes its sign. Contact is the stretch around the peak above the level
/// of `quiet`, where nothing happens: its mean and its scatter, which a record of lengths has too; without
/// one, the stretch that keeps the sign of the peak. It goes on over an interruption, as by ringing, behind
/// which, within a quarter of the width of the pulse, the velocity changes by another 1 %. That width is the
/// time above half the peak, from where the acceleration last leaves that level before the peak to where it
/// first reaches it again: a second blow is none of it. Throws std::invalid_argument for what check()
/// refuses.
Contact contact_of(const Pulse& along, const std::optional<Stretch>& quiet = {});

}  // namespace dashpad::injury
