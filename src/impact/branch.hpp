#pragma once
/// The phase that follows an event (theory.md, section 4). With `is_driven` and `has_unloading_step` of
/// impact/events.hpp, which tell how far a branch goes, all there is of rules about branches.
///
/// The rate that satisfies equilibrium has up to three values; the drive (Eq. 26) says which of them the
/// limit of a vanishing dashpot takes.

#include "impact/trial.hpp"

namespace dashpad {

/// What an impact is made of, as far as branches go.
struct BranchConditions {
  bool pad_recovers = true;  ///< the pad follows its law back; if not, it holds its deformation
  bool stops_hard = false;   ///< Foundation::stops_hard()
  bool rigid_support = false;
  bool back_is_waited_for = false;  ///< it may come after the impactor, or still goes away from it
};

/// `drive` is that of the state now, m/s. Phase::over: the run ends.
inline Phase phase_after(Event event, Phase now, double drive, BranchConditions conditions) {
  const Phase by_drive = drive > 0 ? Phase::loading : Phase::unloading;
  switch (event) {
    case Event::release: return conditions.back_is_waited_for ? Phase::flight : Phase::over;
    case Event::parting: return Phase::over;
    case Event::lock: return conditions.stops_hard ? Phase::over : Phase::held;
    case Event::turning:
      if (conditions.pad_recovers) return Phase::unloading;
      return conditions.rigid_support ? Phase::over : Phase::held;
    case Event::touch:
    case Event::yielding:
    case Event::reloading: return Phase::loading;
    case Event::unlock: return by_drive;
    case Event::support_turning:
    case Event::corner:
    case Event::joining:
    case Event::rate_corner:
    case Event::landing:
    case Event::closing:
    case Event::none: break;
  }
  return now;
}

}  // namespace dashpad
