#pragma once
/// The acceleration that lasts: 3 ms clip and the like. Exact for the pulse that is linear between its
/// samples.

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

struct Clip {
  double level = 0;  ///< m/s2, >= 0
  double begin = 0;  ///< s, of the window that holds it; of a cumulative clip, when |a| first reaches it
  double end = 0;    ///< s; of a cumulative clip, when |a| is last at it
};

// Both take a duration in s, > 0, and throw std::invalid_argument for another or a pulse that check()
// refuses. A pulse that is shorter has a clip of 0, from 0 to 0. The rounding of the times is forgiven: a
// plateau between samples at 3.5 and 6.5 ms lasts 3 ms.

/// The highest level that |a| meets or exceeds for one uninterrupted `duration`: the reading of FMVSS 201 and
/// ECE R21, "continuously". Of several windows of this length that hold it the earliest.
Clip contiguous_clip(const Pulse& pulse, double duration);

/// The highest level that |a| meets or exceeds for `duration` in all, its stretches added.
Clip cumulative_clip(const Pulse& pulse, double duration);

}  // namespace dashpad::injury
