#pragma once
/// The metrics of an acceleration pulse. Each has a source of its own, and is exact for the pulse that is
/// linear between its samples. All throw std::invalid_argument for a pulse that check() refuses.

#include "dashpad/impact/pulse.hpp"
#include "dashpad/quantities/constants.hpp"

namespace dashpad::injury {

struct Peak {
  double magnitude = 0;  ///< m/s2
  double time = 0;       ///< s, of the first sample that has it
};

/// The largest magnitude.
Peak peak(const Pulse& pulse);

/// Magnitude of the integral of a over the whole pulse, m/s: how a sensor is mounted does not change it.
double velocity_change(const Pulse& pulse);

/// Gadd's severity index, SI = integral of |a|^2.5 dt, a in g, t in s, in g^2.5 s.
double severity_index(const Pulse& pulse);

/// Head injury criterion.
///
///   HIC = max over t1 < t2, t2 - t1 <= W of (t2 - t1) | 1/(t2 - t1) integral of a dt |^2.5,  a in g, t in s
///
/// W = 15 ms gives HIC15, 36 ms HIC36 (FMVSS 208). The windows end anywhere, not only at samples: for the
/// pulse that is linear between its samples the result is exact up to rounding. A resultant is never
/// negative; of a pulse with sign the magnitude of the mean counts, so that turning the sensor round changes
/// nothing.
struct Hic {
  double value = 0;  ///< HIC, in its customary unit g^2.5 s
  double begin = 0;  ///< s, of a window that has this value
  double end = 0;    ///< s
};

inline constexpr double hic_power = 2.5;
inline constexpr double hic15_window = 15e-3;  // s
inline constexpr double hic36_window = 36e-3;  // s
inline constexpr double unlimited_window = infinite;

/// `longest_window` in s, > 0 (std::invalid_argument otherwise); unlimited_window for none. Of several
/// windows with the same value (to 1e-13) the earliest; a pulse without any acceleration has the value 0 and
/// the empty window at its first time. The proof that this is the maximum, and its accuracy: docs/injury.md,
/// HIC.
Hic hic(const Pulse& pulse, double longest_window);

/// HIC(d) = 0.75446 HIC36 + 166.4, of the free-motion headform (FMVSS 201U).
double hic_d(double hic36);

/// The acceleration that lasts: 3 ms clip and the like.
struct Clip {
  double level = 0;  ///< m/s2, >= 0
  double begin = 0;  ///< s, of the window that holds it; of a cumulative clip, when |a| first reaches it
  double end = 0;    ///< s; of a cumulative clip, when |a| is last at it
};

inline constexpr double usual_clip = 3e-3;  // s

// Both take a duration in s, > 0, and throw std::invalid_argument for another. A pulse that is shorter has a
// clip of 0, from 0 to 0. The rounding of the times is forgiven: a plateau between samples at 3.5 and 6.5 ms
// lasts 3 ms.

/// The highest level that |a| meets or exceeds for one uninterrupted `duration`: the reading of FMVSS 201 and
/// ECE R21, "continuously". Of several windows of this length that hold it the earliest.
Clip contiguous_clip(const Pulse& pulse, double duration);

/// The highest level that |a| meets or exceeds for `duration` in all, its stretches added.
Clip cumulative_clip(const Pulse& pulse, double duration);

// For how long |a| is above a level, m/s2; both throw std::invalid_argument for one that is negative. Above
// means above: a plateau at the level does not count, and a touch of the level from above divides a stretch.

/// All stretches above the level added, s: FMVSS 218's dwell time.
double cumulative_dwell(const Pulse& pulse, double level);

/// The longest of them, s.
double longest_dwell(const Pulse& pulse, double level);

}  // namespace dashpad::injury
