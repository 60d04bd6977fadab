#pragma once
/// Head injury criterion.
///
///   HIC = max over t1 < t2, t2 - t1 <= W of (t2 - t1) | 1/(t2 - t1) integral of a dt |^2.5,  a in g, t in s
///
/// W = 15 ms gives HIC15, 36 ms HIC36 (FMVSS 208). The windows end anywhere, not only at samples: for the
/// pulse that is linear between its samples the result is exact up to rounding. A resultant is never
/// negative; of a pulse with sign the magnitude of the mean counts, so that turning the sensor round changes
/// nothing.

#include <limits>

#include "dashpad/impact/pulse.hpp"

namespace dashpad::injury {

struct Hic {
  double value = 0;  ///< HIC, in its customary unit g^2.5 s
  double begin = 0;  ///< s, of a window that has this value
  double end = 0;    ///< s
};

inline constexpr double hic_power = 2.5;
inline constexpr double hic15_window = 15e-3;  // s
inline constexpr double unlimited_window = std::numeric_limits<double>::infinity();

/// `longest_window` in s, > 0; unlimited_window for none. Of several windows with the same value (to 1e-13)
/// the earliest; a pulse without any acceleration has the value 0 and the empty window at its first time.
/// Throws std::invalid_argument for a pulse that check() refuses or a window that is not positive. The proof
/// that this is the maximum, and its accuracy: docs/injury.md, HIC.
Hic hic(const Pulse& pulse, double longest_window);

/// HIC(d) = 0.75446 HIC36 + 166.4, of the free-motion headform (FMVSS 201U).
double hic_d(double hic36);

}  // namespace dashpad::injury
