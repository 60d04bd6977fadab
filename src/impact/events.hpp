#pragma once
/// Table of events (theory.md, section 4): the phases of each, its indicator, and the side where a step ends.

#include <algorithm>
#include <array>
#include <cmath>
#include <type_traits>
#include <utility>

#include "dashpad/quantities/constants.hpp"
#include "impact/numerics.hpp"
#include "impact/trial.hpp"
#include "model/support/foundation.hpp"

namespace dashpad {

/// The data that indicators of events depend on.
struct Sight {
  Phase phase = Phase::loading;
  const State& now;
  const Trial& trial;
  const Foundation& foundation;
  bool recovers = true;     ///< whether the pad recovers
  double corner = 0;        ///< corner of the support: a force, N, or a deflection, m
  double joint = 0;         ///< penetration at which a pad struck before joins its first loading, m; 0: none
  bool is_pressed = false;  ///< in flight: a column is under pressure at the end
  double min_return = 0;    ///< speed above which a return of the back is awaited, m/s
  bool is_closed = false;   ///< the pad is fully compressed at the start
  /// Rate of the pad at the end over the next tested rate below, less 1.
  double over_rate_corner = 1;

  /// The quantity that passes the corners: force, N, or deflection, m.
  [[nodiscard]] double at_corner(const State& state) const {
    return foundation.kind() == Foundation::Kind::at_once ? state.force : state.back.deflection;
  }
};

struct EventKind {
  Event event;
  unsigned phases;  ///< those in which it may happen, a sum of bits
  /// Positive before the event, usually growing with the time until it.
  double (*indicator)(const Sight&);
  /// Whether the event can happen from the present state.
  bool (*is_armed)(const Sight&);
  /// Whether the step ends just after the event, as its far side has a solution.
  bool ends_after;

  [[nodiscard]] constexpr bool may_happen_in(Phase phase) const {
    return (phases >> static_cast<unsigned>(phase) & 1U) != 0;
  }
};

namespace event_rules {

inline constexpr unsigned loading = 1U << static_cast<unsigned>(Phase::loading);
inline constexpr unsigned unloading = 1U << static_cast<unsigned>(Phase::unloading);
inline constexpr unsigned held = 1U << static_cast<unsigned>(Phase::held);
inline constexpr unsigned flight = 1U << static_cast<unsigned>(Phase::flight);

inline constexpr double far_beyond = -infinite;

inline bool always(const Sight&) { return true; }
inline double force(const Sight& s) { return s.trial.end.force; }
inline double force_over_held_pad(const Sight& s) { return s.trial.end.force - s.trial.pad.force; }
inline double strength_left(const Sight& s) { return s.trial.pad.force - s.trial.end.force; }
/// A flat nose does not crush the foam until the support pushes hard enough; foam crushed before, until a
/// panel or a damper does. (A support at once never pushes harder than before.)
inline bool is_below_strength(const Sight& s) {
  const bool may_push_harder = s.now.penetration == 0 || s.foundation.kind() != Foundation::Kind::at_once;
  const double strength = s.trial.pad.force;
  // Just after the turning point the force is that of the pad, and may rise.
  return !s.recovers && !s.is_closed && may_push_harder &&
         (s.now.force < strength || s.trial.end.force > (1 + numerics.at_corner) * strength);
}
inline bool pad_recovers(const Sight& s) { return s.recovers; }
/// The drive, Eq. 26; without a solution of Eq. 25 the event has passed.
inline double drive(const Sight& s) {
  if (s.trial.obstacle == Event::turning) return far_beyond;
  return s.trial.end.drive;
}
/// Whether the panel has landed on its stop, where its speed jumps; that ends the step first.
inline bool has_landed(const Sight& s) { return s.trial.end.back.struck != 0; }
inline bool is_driven(const Sight& s) {
  return s.trial.obstacle == Event::turning || (s.now.drive > 0 && !has_landed(s));
}
inline double has_unloading_step(const Sight& s) {
  if (s.trial.obstacle == Event::reloading) return far_beyond;
  return 1;
}
inline double has_step_below_lock(const Sight& s) { return s.trial.obstacle == Event::lock ? -1 : 1; }
inline double way_to_corner(const Sight& s) {
  const double now = s.at_corner(s.now) - s.corner, then = s.at_corner(s.trial.end) - s.corner;
  // A panel that has struck its stop stays there; how far it would have moved is unknown.
  if (then == 0) return -std::abs(now);
  return now < 0 ? -then : then;
}
inline bool is_off_corner(const Sight& s) {
  return std::abs(s.at_corner(s.now) - s.corner) > numerics.at_corner * std::abs(s.corner);
}
inline double support_goes_on(const Sight& s) {
  return s.foundation.kind() == Foundation::Kind::at_once ? s.trial.force_rate : s.trial.end.back.rate;
}
inline bool is_crushing(const Sight& s) { return s.foundation.is_crushing(s.now.back, s.now.force); }
inline double is_apart(const Sight& s) { return s.is_pressed ? -1 : 1; }
/// Excess of the speed at which the panel can still return, or still moves away, over the least awaited one
/// in flight, m/s. The support may reach its largest values until then.
inline double speed_to_wait_for(const Foundation& foundation, const State& state, double least) {
  return std::max(foundation.fastest_return(state.back) + state.velocity, state.back.rate) - least;
}
inline double left_to_wait_for(const Sight& s) {
  return speed_to_wait_for(s.foundation, s.trial.end, s.min_return);
}
inline bool has_not_landed(const Sight& s) { return !has_landed(s); }
/// Speed at which the nose leaves the pad in flight, m/s; the law of columns has a corner where they turn.
inline double speed_apart(const Sight& s) { return -s.trial.end.drive; }
inline bool moves_apart(const Sight& s) { return s.recovers && s.now.drive < 0; }

inline double over_rate_corner(const Sight& s) { return s.over_rate_corner; }
inline double penetration_to_joint(const Sight& s) { return s.joint - s.trial.end.penetration; }
inline bool is_before_joint(const Sight& s) {
  return s.joint > 0 && s.joint - s.now.penetration > numerics.at_joint * s.joint;
}

/// The events in order of precedence if they coincide.
inline constexpr std::array<EventKind, 13> event_table{{
    {Event::release, unloading | held, force, always, true},
    {Event::touch, flight, is_apart, always, true},
    {Event::unlock, held, force_over_held_pad, pad_recovers, true},
    {Event::yielding, held, strength_left, is_below_strength, true},
    {Event::turning, loading, drive, is_driven, false},
    {Event::reloading, unloading, has_unloading_step, always, false},
    {Event::lock, loading, has_step_below_lock, always, true},
    {Event::support_turning, loading | unloading | held, support_goes_on, is_crushing, false},
    {Event::corner, loading | unloading | held | flight, way_to_corner, is_off_corner, true},
    {Event::joining, loading, penetration_to_joint, is_before_joint, true},
    {Event::rate_corner, loading, over_rate_corner, always, true},
    {Event::parting, flight, left_to_wait_for, has_not_landed, true},
    {Event::closing, flight, speed_apart, moves_apart, true},
}};

}  // namespace event_rules

using event_rules::event_table;

/// The first event of a trial, in the order of the table.
struct FirstEvent {
  const EventKind* kind = nullptr;  ///< null: the step is smooth
  double corner = 0;
  int count = 0;  ///< number of events in the trial

  [[nodiscard]] Event event() const { return kind == nullptr ? Event::none : kind->event; }
};

/// The first event among those of a phase, with calls that the compiler resolves.
template <Phase phase>
FirstEvent first_event_in(Sight sight) {
  FirstEvent first;
  const auto look = [&](const EventKind& kind, double corner) {
    sight.corner = corner;
    if (!(kind.is_armed(sight) && kind.indicator(sight) <= 0)) return;
    if (first.count++ == 0) first.kind = &kind, first.corner = corner;
  };
  const auto look_at = [&]<std::size_t row>(std::integral_constant<std::size_t, row>) {
    constexpr const EventKind& kind = event_table[row];
    if constexpr (kind.may_happen_in(phase)) {
      if (sight.trial.obstacle != Event::none && kind.event != sight.trial.obstacle) return;
      if constexpr (kind.event != Event::corner)
        look(kind, 0);
      else
        for (const double corner : sight.foundation.corners()) look(kind, corner);
    }
  };
  [&]<std::size_t... row>(std::index_sequence<row...>) {
    (look_at(std::integral_constant<std::size_t, row>()), ...);
  }
  (std::make_index_sequence<event_table.size()>());
  return first;
}

/// The first event of a trial; without a solution, only the one that prevents it.
inline FirstEvent first_event(const Sight& sight) {
  switch (sight.phase) {
    case Phase::loading: return first_event_in<Phase::loading>(sight);
    case Phase::unloading: return first_event_in<Phase::unloading>(sight);
    case Phase::held: return first_event_in<Phase::held>(sight);
    case Phase::flight: return first_event_in<Phase::flight>(sight);
    case Phase::over: break;
  }
  return {};
}

// The phase that follows an event (theory.md, section 4). Together with `is_driven` and `has_unloading_step`,
// the ends of branches, these are the rules about branches. The first phase, the end at rest and the phase
// after a pad was held for a moment are set by March.
//
// Up to three rates satisfy equilibrium; the drive selects that of a vanishing dashpot (Eq. 26).

/// Conditions of an impact on which branches depend.
struct BranchConditions {
  bool pad_recovers = true;  ///< the pad unloads by its law; if not, it holds its deformation
  bool stops_hard = false;   ///< Foundation::stops_hard()
  bool rigid_support = false;
  bool back_is_waited_for = false;  ///< the back may come after the impactor, or still moves away
};

/// The phase after an event; `drive`: present drive, m/s. Phase::over ends the run.
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
    default: return now;
  }
}

}  // namespace dashpad
