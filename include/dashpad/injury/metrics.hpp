#pragma once
/// Metrics of an acceleration pulse, exact for a pulse that is linear between its samples. All throw
/// std::invalid_argument for a pulse that check() refuses.

#include "dashpad/impact/pulse.hpp"
#include "dashpad/quantities/constants.hpp"

namespace dashpad::injury {

struct Peak {
  double magnitude = 0;  ///< m/s2
  double time = 0;       ///< s, of the first sample that has it
};

/// The largest magnitude.
Peak peak(const Pulse& pulse);

/// Magnitude of the integral of a over the whole pulse, m/s. It does not depend on the sensor's orientation.
double velocity_change(const Pulse& pulse);

/// Gadd's severity index: the integral of |a|^2.5 dt, a in g, t in s; in g^2.5 s.
double severity_index(const Pulse& pulse);

/// Head injury criterion.
///
///   HIC = max over t1 < t2, t2 - t1 <= W of (t2 - t1) | 1/(t2 - t1) integral of a dt |^2.5,  a in g, t in s
///
/// W = 15 ms gives HIC15, 36 ms HIC36 (FMVSS 208). Windows may end between samples, so that the result is
/// exact up to rounding. The magnitude of the mean counts, so that the sign of the sensor does not matter.
struct Hic {
  double value = 0;  ///< HIC, in its customary unit g^2.5 s
  double begin = 0;  ///< s, of a window that has this value
  double end = 0;    ///< s
};

inline constexpr double hic_power = 2.5;
inline constexpr double hic15_window = 15e-3;  // s
inline constexpr double hic36_window = 36e-3;  // s
inline constexpr double unlimited_window = infinite;

/// `longest_window` in s, > 0; unlimited_window for none. Throws std::invalid_argument otherwise. Returns the
/// earliest of several windows with the same value (to 1e-13); for a pulse of zeros, the value 0 and an empty
/// window at its first time. Proof and accuracy: docs/injury.md, HIC.
///
/// Example:
/// \code
/// const dashpad::Pulse pulse{.time = {0, 5e-3, 10e-3}, .acceleration = {0, 800, 0}};  // s, m/s2
/// const dashpad::injury::Hic hic15 = dashpad::injury::hic(pulse, dashpad::injury::hic15_window);
/// const auto clip = dashpad::injury::contiguous_clip(pulse, dashpad::injury::usual_clip);
/// std::printf("HIC15 %.0f, 3 ms clip %.0f g\n", hic15.value, clip.level / dashpad::standard_gravity);
/// \endcode
Hic hic(const Pulse& pulse, double longest_window);

/// HIC(d) = 0.75446 HIC36 + 166.4, for the free-motion headform (FMVSS 201U).
double hic_d(double hic36);

/// A level of acceleration that lasts for a duration, such as the 3 ms clip.
struct Clip {
  double level = 0;  ///< m/s2, >= 0
  double begin = 0;  ///< s, of the window that holds it; of a cumulative clip, when |a| first reaches it
  double end = 0;    ///< s; of a cumulative clip, when |a| is last at it
};

inline constexpr double usual_clip = 3e-3;  // s

// Clips: `duration` in s, > 0; std::invalid_argument otherwise. A pulse that is shorter has a clip of 0, from
// 0 to 0. Rounding of the times is tolerated: a plateau between samples at 3.5 and 6.5 ms lasts 3 ms.

/// The highest level that |a| meets or exceeds for one uninterrupted `duration` ("continuously" in FMVSS 201
/// and ECE R21), with the earliest such window.
Clip contiguous_clip(const Pulse& pulse, double duration);

/// The highest level that |a| meets or exceeds for a total of `duration`.
Clip cumulative_clip(const Pulse& pulse, double duration);

// Dwell times: how long |a| exceeds a level, m/s2; std::invalid_argument for a negative level. A plateau at
// the level does not count, and a touch of the level from above divides a stretch.

/// The total of all stretches above the level, s: the dwell time of FMVSS 218.
double cumulative_dwell(const Pulse& pulse, double level);

/// The longest stretch above the level, s.
double longest_dwell(const Pulse& pulse, double level);

}  // namespace dashpad::injury
