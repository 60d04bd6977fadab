#pragma once
/// Pulses of one sign that rise to one peak and fall from it, as those of most impacts. For them the best
/// window of each length is where the pulse is above some level, so that one walk down from the peak answers
/// what a search over all windows does. Results are those of hic.cpp and clip.cpp up to rounding.

#include <cstddef>
#include <optional>

#include "dashpad/injury/metrics.hpp"
#include "injury/hic_search.hpp"

namespace dashpad::injury {

/// Where the peak of a hump is, and its sign, 1 or -1.
struct Hump {
  std::size_t peak = 0;
  double sign = 1;
};

/// Absent where the pulse is none: both signs, level stretches, or several peaks. `pulse` has passed check().
std::optional<Hump> hump_of(const Pulse& pulse);

/// hic() of a hump; `curve` is its pulse times sign * scale.
Hic hic_of(const Hump& hump, const hic_search::Curve& curve, double scale, double longest_window);

/// contiguous_clip() and cumulative_clip(), which are the same for a hump.
Clip clip_of(const Hump& hump, const Pulse& pulse, double duration);

/// A power of two that brings `largest` (> 0) near to 1, so that no power of a level overflows.
double scale_for(double largest);

/// HIC in g^2.5 s of the criterion of levels that were multiplied with `scale`.
double hic_from(double criterion, double scale);

}  // namespace dashpad::injury
