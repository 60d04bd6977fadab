#pragma once
/// Channel frequency class filters: a two-pole Butterworth filter run forwards and backwards, which has four
/// poles and no phase (docs/injury.md).
///
///   y(n) = a0 x(n) + a1 x(n-1) + a2 x(n-2) + b1 y(n-1) + b2 y(n-2),  wa = tan(wd T / 2)
///
/// Together, both runs pass half of a vibration at the corner wd, and -3 dB at 0.8022 of it, 5/3 of the
/// class.

#include <array>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

/// The corner wd of the design; the two published forms differ by 0.28 %.
enum class Corner {
  sae_j211,  ///< wd = 2 pi CFC 2.0775
  iso_6487,  ///< wd = 2 pi CFC / 0.6 * 1.25
};

/// The samples that the filter sees before the first and after the last one: those of the pulse in reverse,
/// as far as there are enough. "10 ms" means all samples of that time. A steady start begins as if the first
/// value had always been there.
enum class Ends {
  /// 2 x(end) - x, the pulse reflected in its end points, for 10 ms and at least 100 samples. Steady start.
  mirrored,
  /// No samples. Steady start.
  held,
  /// Like mirrored, but the first two outputs of a run are the mean of its first ten inputs.
  mirrored_from_mean,
  /// -x before the pulse, for pulses that start at 0, and 2 x(end) - x after it: 10 ms before, one sample
  /// more after, then nine samples of 2 x(end) - x on both sides. Steady start.
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

/// `interval` is the sampling interval, s. Throws std::invalid_argument if the class or the interval is not
/// positive, or the interval is so long that wd T / 2 reaches pi / 2.
FilterCoefficients cfc_coefficients(double channel_frequency_class, double interval, Corner corner);

/// Whether the sampling frequency is at least ten times the class (10 kHz for CFC 1000). Otherwise fast
/// vibrations may have been recorded as slower ones.
bool samples_suffice(double channel_frequency_class, double interval);

/// Whether each sample is within 1e-3 of the interval of its place on an even grid.
bool is_evenly_spaced(const Pulse& pulse);

/// The interval for resampling an uneven pulse before a filter, s: only one step in twenty is shorter. At
/// most twenty times as many samples as before.
double interval_for_filter(const Pulse& pulse);

/// The filtered pulse at the same times. Throws std::invalid_argument unless is_evenly_spaced(), and for what
/// check() or cfc_coefficients() refuses.
Pulse cfc_filtered(const Pulse& pulse, double channel_frequency_class, Corner corner = Corner::sae_j211,
                   Ends ends = Ends::mirrored);

/// Even samples by linear interpolation, from the first time to at most one interval before the end.
/// `interval` in s, > 0 and no longer than the pulse. Throws std::invalid_argument, also beyond 10 million.
Pulse resampled(const Pulse& pulse, double interval);

}  // namespace dashpad::injury
