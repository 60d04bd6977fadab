#pragma once
/// All injury figures of a pulse, and of a solved impact with their errors.

#include <optional>

#include "dashpad/impact/solution.hpp"
#include "dashpad/injury/clip.hpp"
#include "dashpad/injury/hic.hpp"
#include "dashpad/injury/peak.hpp"
#include "dashpad/injury/pulse.hpp"

namespace dashpad {

struct InjuryFigures {
  Peak peak;
  Hic hic15, hic36, hic_unlimited;
  double hic_d = 0;
  Clip contiguous_3ms, cumulative_3ms;
  double severity_index = 0;
  double velocity_change = 0;  ///< m/s

  /// Estimated relative errors of a solved impact; 0 for a pulse that is taken as it is.
  struct Errors {
    double peak = 0, hic15 = 0, hic36 = 0, hic_unlimited = 0, hic_d = 0, contiguous_3ms = 0,
           cumulative_3ms = 0, severity_index = 0, velocity_change = 0;
  } errors;
};

InjuryFigures injury_figures(const Pulse& pulse);

/// The acceleration of the impactor. Until its end the history of an impact on a rigid support that bottomed
/// out is finite; it is no whole pulse.
Pulse pulse_of(const History& history);

/// The figures of pulse_of(solution.history). The errors add what the solver says of its forces and what is
/// left by the steps of the history, from a comparison with every second step.
InjuryFigures injury_figures(const Solution& solution);

/// The same of a whole pulse; absent where it was cut off or is not finite: the impactor did not leave the
/// pad.
std::optional<InjuryFigures> whole_pulse_figures(const Solution& solution);

}  // namespace dashpad
