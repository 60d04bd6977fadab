#pragma once
/// Channel frequency class filters: a two-pole Butterworth filter run forwards and backwards, so that it has
/// four poles and no phase (docs/injury.md).
///
///   y(n) = a0 x(n) + a1 x(n-1) + a2 x(n-2) + b1 y(n-1) + b2 y(n-2),  wa = tan(wd T / 2)
///
/// Both runs together pass half of a vibration at the corner wd, and -3 dB at 0.8022 of it, 5/3 of the class.

#include <array>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// The corner of the design, wd: the two published forms differ by 0.28 %.
enum class Corner {
  sae_j211,  ///< wd = 2 pi CFC 2.0775
  iso_6487,  ///< wd = 2 pi CFC / 0.6 * 1.25
};

/// What the filter sees before the first and after the last sample. The samples put there are those of the
/// pulse in reverse, as many as there are at most. "10 ms" are all samples of that time.
///
/// A run in a steady state starts as if its first value had always been there.
enum class Ends {
  /// 2 x(end) - x: the pulse turned about its end points, for 10 ms and at least 100 samples. Steady start.
  mirrored,
  /// Nothing is put there. Steady start: as if the end value had always been there.
  held,
  /// As mirrored. The first two outputs of a run are the mean of its first ten inputs.
  mirrored_from_mean,
  /// -x before the pulse, which suits one that starts at 0, and 2 x(end) - x behind it: 10 ms before, one
  /// sample more behind, and around all that 2 x(end) - x for nine samples. Steady start.
  negated_before,
};

/// "sae", "iso".
const char* to_string(Corner corner);
/// "mirrored", "held", "mirrored-from-mean", "negated-before".
const char* to_string(Ends ends);
inline constexpr std::array all_ends{Ends::mirrored, Ends::held, Ends::mirrored_from_mean,
                                     Ends::negated_before};

struct FilterCoefficients {
  double a0 = 0, a1 = 0, a2 = 0, b1 = 0, b2 = 0;
};

inline constexpr std::array channel_frequency_classes{60, 180, 600, 1000};

/// `interval` is the sampling interval, s. Throws std::invalid_argument for a class or an interval that is
/// not positive, or an interval too long for the class: wd T / 2 must be below pi / 2.
FilterCoefficients cfc_coefficients(double channel_frequency_class, double interval, Corner corner);

/// Whether the sampling frequency is at least ten times the class, 10 kHz for CFC 1000. With less the filter
/// works, but vibrations that were too fast for the samples may have been recorded as slower ones.
bool samples_suffice(double channel_frequency_class, double interval);

/// The filtered pulse at the same times. The samples must be evenly spaced: each within 1e-3 of the interval
/// of its place; std::invalid_argument otherwise, and for what check() or cfc_coefficients() refuses.
Pulse cfc_filtered(const Pulse& pulse, double channel_frequency_class, Corner corner = Corner::sae_j211,
                   Ends ends = Ends::mirrored);

/// Samples at even intervals by linear interpolation, from the first time on, for filters of uneven pulses.
/// The last is at or less than an interval before the end. `interval` in s, > 0 and no longer than the pulse;
/// at most 10 million samples, std::invalid_argument otherwise.
Pulse resampled(const Pulse& pulse, double interval);

}  // namespace dashpad::injury
