#pragma once
/// One run through an impact at one resolution: the loop of theory.md, section 4, and its figures.
///
/// The phases of a run are loading, unloading, held (a rigid foam off its crush curve, or a fully compressed
/// pad on a yielding support, Eq. 29; also any pad for a moment, if neither of the other two has a solution)
/// and flight (contact is lost, but a panel may come after the impactor). They end at events
/// (impact/events.hpp), which are located within the step.

#include <algorithm>
#include <cmath>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "dashpad/quantities/constants.hpp"
#include "impact/equilibrium.hpp"
#include "impact/event_search.hpp"
#include "impact/events.hpp"
#include "impact/figures.hpp"
#include "impact/motion.hpp"
#include "impact/numerics.hpp"
#include "impact/predictor.hpp"
#include "impact/sheet.hpp"
#include "impact/step_control.hpp"
#include "impact/swing.hpp"
#include "model/contact/contact.hpp"
#include "model/contact/station_layout.hpp"
#include "model/support/foundation.hpp"

namespace dashpad {

/// The support without a panel too light to matter at the tolerance: the number of steps that resolve its
/// vibration would grow with the root of the ratio of masses (theory.md, section 5.2).
inline Backing without_light_panel(Backing backing, const Impactor& impactor, double tolerance) {
  if (backing.mass < numerics.lightest_panel * tolerance * impactor.mass && backing.gap == 0)
    backing.mass = 0;
  return backing;
}

template <IsContact Contact>
class March {
 public:
  March(const ImpactCase& impact, Contact& contact, const Options& options)
      : impactor_(impact.impactor),
        thickness_(impact.pad.thickness),
        foundation_(impact.support, without_light_panel(impact.backing, impactor_, options.tolerance),
                    impactor_.mass),
        contact_(contact),
        options_(options),
        has_sheet_(impact.pad.sheet > 0),
        has_backing_(impact.backing != Backing{}),
        motion_(impactor_, foundation_, contact, Sheet(impact.pad.sheet, sections_of(impact))),
        equilibrium_(contact, foundation_, motion_, thickness_),
        control_(impactor_.mass, sections_of(impact), thickness_, foundation_, FollowsRate<Contact>) {
    if constexpr (RemembersBlows<Contact>) crater_ = contact_.crater();
  }
  March(const March&) = delete;
  March& operator=(const March&) = delete;

  struct Bounds {
    double expected = infinite;  ///< expected peak penetration, m
    double max_work = infinite;  ///< work after which the run is given up, s
  };
  /// Runs the impact with steps of about `resolution` radians of the momentary oscillation.
  Figures run(double resolution, Track& track, Bounds bounds = {}) {
    double step = begin(resolution, bounds.expected, track);
    max_work_ = bounds.max_work;
    while (phase_ != Phase::over && !limit_is_reached(track)) {
      const double before = now_.time;
      const Phase phase_before = phase_;
      const Stretch next = next_stretch(step);
      if (next.moves) accept(next);
      if (next.event != Event::none) begin_phase(next.event);
      idle_ = now_.time > before ? 0 : idle_ + 1;
      if (now_.time > before) moments_ = 0;
      if (idle_ > 1) hold_for_a_moment();
      if (now_.time > before) record(track);
      if (next.event != Event::none && phase_ != Phase::over) track.begin_stretch();
      if (phase_ != phase_before && !foundation_.is_plain()) jump_from(phase_before);
      control_.learn(phase_, now_, predictor_);
      step =
          std::min(control_.next(phase_, motion_, predictor_, {now_.time - turning_time_, has_just_turned_}),
                   options_.time_limit - now_.time);
    }
    return read_figures(track);
  }

 private:
  static constexpr bool memoryless = HasEnergy<Contact>;

  /// A step that ends at the first event in it, or one that meets none.
  struct Stretch {
    Trial trial;
    Event event = Event::none;
    bool moves = true;  ///< if not, the event happens at the present state
  };

  double begin(double resolution, double expected, Track& track) {
    resolution_ = resolution;
    figures_ = {};
    // A pad that does not give way at once is held until the support pushes hard enough.
    const double strength = contact_.first_force();
    const double at_once = foundation_.force_at_once(impactor_.speed);
    phase_ = strength > at_once && !foundation_.stops_hard() ? Phase::held : Phase::loading;
    idle_ = moments_ = 0;
    foundation_.start();
    swing_ = {};
    turning_time_ = infinite;
    has_just_turned_ = false;
    contact_.start(resolution, expected);
    if constexpr (RemembersBlows<Contact>) joint_ = contact_.joint();
    motion_.start(impactor_.speed, phase_ == Phase::held ? at_once : strength);
    figures_.peak_pad_rate = now_.velocity;
    equilibrium_.start(resolution);
    control_.start(resolution, contact_.lock_penetration());
    if constexpr (HasLayers<Contact>)
      track.clear(contact_.layers());
    else
      track.clear();
    add_entry(track);
    double stiffness = 0;
    const auto force_of = [&](double y, double step) { return contact_.trial(y, 0, step).force - strength; };
    // A pad on a damper may give way, as to a shock, long before either has moved far.
    const bool gives_way_first = !memoryless && foundation_.kind() == Foundation::Kind::damper;
    const double max_force = gives_way_first ? resolution * at_once : infinite;
    const double step = control_.first_step(phase_, impactor_.speed, max_force, force_of, stiffness);
    predictor_.start(impactor_.speed, stiffness);
    control_.learn(phase_, now_, predictor_);
    return step;
  }

  bool limit_is_reached(const Track& track) {
    if (now_.time >= options_.time_limit) {
      // An impactor that will not meet the pad again is released, even if the panel is still in its gap.
      const bool has_left =
          phase_ == Phase::flight && foundation_.fastest_return(now_.back) + now_.velocity <= min_return();
      figures_.ending = has_left ? Status::released : Status::time_limit;
      return true;
    }
    return track.size() > options_.max_steps || work(track) > max_work_ ||
           contact_.stations() >= max_stations || idle_ + moments_ > numerics.max_idle_events;
  }

  /// Work of the run so far, s.
  [[nodiscard]] double work(const Track& track) const {
    const double of_steps = numerics.work_of_step * double(track.size());
    if constexpr (HasLayers<Contact>)
      return of_steps +
             numerics.work_of_layered_column * double(contact_.updates() + contact_.nested_updates());
    else
      return of_steps + numerics.work_of_column * double(contact_.updates());
  }

  // ------------------------------------------------------------------ a step

  Trial attempt(double step) {
    Trial trial = attempt_as_it_is(step);
    if (trial.overshoots && foundation_.follow_closely()) trial = attempt_as_it_is(step);
    return trial;
  }
  Trial attempt_as_it_is(double step) {
    const Trial trial = phase_ == Phase::loading ? equilibrium_.loading(step, predictor_)
                        : phase_ == Phase::held  ? equilibrium_.held(step, predictor_)
                        : phase_ == Phase::flight
                            ? equilibrium_.released(step, predictor_)
                            : equilibrium_.unloading(step, predictor_, has_just_turned_);
    predictor_.learn_from_try(trial);
    return trial;
  }
  [[nodiscard]] Sight sight(const Trial& trial, double corner = 0) {
    const bool is_pressed =
        phase_ == Phase::flight &&
        (contact_.recovers() ? contact_.largest_stress(trial.pad) > 0
                             : trial.end.penetration > (1 + numerics.at_crater) * left_at_);
    Sight sight{phase_, now_, trial, foundation_, contact_.recovers(), corner, joint_, is_pressed};
    sight.min_return = min_return();
    sight.is_closed = now_.penetration >= (1 - numerics.at_joint) * contact_.lock_penetration();
    if constexpr (HasRateCorners<Contact>) {
      // The force may peak there; elsewhere a step passes the corner without loss of order.
      if (phase_ == Phase::loading && motion_.force_rate() > 0)
        if (const double at = contact_.rate_corner(); at > 0)
          sight.over_rate_corner = contact_.slip_rate(trial.pad) / at - 1;
    }
    return sight;
  }

  /// Whether a panel is about to land: the pad turns with it, so no loading step may reach that far.
  [[nodiscard]] bool lands_now() const {
    const double soon = numerics.event_precision * resolution_ * resolution_ * control_.usual();
    return phase_ == Phase::loading && foundation_.time_to_stop(now_.back) < soon;
  }

  Stretch next_stretch(double step) {
    if (lands_now()) return {{}, Event::landing, false};
    Trial trial = attempt(step);
    FirstEvent first = first_event(sight(trial));
    const double shortest = numerics.shortest_step * std::max(now_.time, step);
    // A step far too long for its result, or with several events, is halved.
    for (int i = 0; i < numerics.max_halvings && step > shortest; ++i) {
      const bool too_long =
          first.kind == nullptr && step > numerics.too_long * control_.longest(phase_, trial);
      const bool may_land =
          trial.obstacle == Event::turning && std::isfinite(foundation_.time_to_stop(now_.back));
      if (!too_long && !may_land && first.count <= 1) break;
      step /= 2;
      trial = attempt(step);
      first = first_event(sight(trial));
    }
    if (first.kind == nullptr) return {trial, Event::none, true};
    return stretch_to(first, trial, shortest);
  }

  /// The step that ends at an event, which happens within the trial `beyond`.
  Stretch stretch_to(const FirstEvent& first, const Trial& beyond, double shortest) {
    const Event event = first.event();
    const double too_short = numerics.min_step_to_branch_end * resolution_ * beyond.step;
    Trial trial = locate(first, beyond, is_corner(event));
    // On a branch with several forces for a rate the slower search is needed.
    if (is_corner(event) && !equilibrium_.is_solved(trial)) trial = locate(first, beyond, false);
    // An immediate event changes the phase at the present state, but a step still leads to release or lock.
    const bool branch_ends = event == Event::turning || event == Event::reloading;
    const bool goes_on = event != Event::release && event != Event::lock;
    if ((goes_on && trial.step < shortest) || (branch_ends && trial.step < too_short))
      return {{}, event, false};
    if (trial.step < shortest) trial = look(first, shortest, false).trial;
    if (trial.obstacle != Event::none && trial.obstacle != Event::lock) return {{}, event, false};
    if (event == Event::lock) trial.pad_stiffness = attempt(trial.step).pad_stiffness;
    if (event == Event::release) trial.end.force = 0;
    return {trial, event, true};
  }

  /// Whether it is the release of a moving pad with memory, found by Eq. 27 along the motion without force.
  [[nodiscard]] bool is_lost_contact(Event event) const {
    return !memoryless && event == Event::release && phase_ != Phase::held;
  }

  /// Whether it is a corner of a support at once below a moving pad with memory, where the force is known.
  [[nodiscard]] bool is_corner(Event event) const {
    return !memoryless && !has_sheet_ && event == Event::corner && phase_ != Phase::held &&
           phase_ != Phase::flight && foundation_.kind() == Foundation::Kind::at_once;
  }

  /// A trial in the search of an event, and its indicator, positive before the event.
  struct Look {
    Trial trial;
    double value = 0;
  };
  Look look(const FirstEvent& first, double step, bool by_force) {
    const EventKind& kind = *first.kind;
    if (kind.event == Event::lock) {
      const Trial trial = equilibrium_.at_lock(step, predictor_);
      return {trial, equilibrium_.residual(trial)};
    }
    if (is_lost_contact(kind.event)) {
      const Trial trial = equilibrium_.released(step, predictor_);
      return {trial, contact_.largest_stress(trial.pad)};
    }
    if (by_force) {
      const double side = now_.force < first.corner ? -1 : 1;
      const double just_beyond = first.corner * (1 - side * numerics.at_corner / 2);
      const Trial trial = equilibrium_.at_force(just_beyond, phase_, step, predictor_);
      return {trial, side * (trial.pad.force - just_beyond)};
    }
    return seen(first, attempt(step));
  }
  [[nodiscard]] Look seen(const FirstEvent& first, const Trial& trial) {
    double value = first.kind->indicator(sight(trial, first.corner));
    if (first.event() == Event::release && value <= 0 && phase_ != Phase::held)
      value = contact_.largest_stress(trial.pad);
    return {trial, value};
  }

  /// The longest step before an event or the shortest beyond it, as its kind asks; of length 0 if it is now.
  Trial locate(const FirstEvent& first, const Trial& beyond, bool by_force) {
    const EventKind& kind = *first.kind;
    const bool by_attempt = kind.event != Event::lock && !is_lost_contact(kind.event) && !by_force;
    const Look far = by_attempt ? seen(first, beyond) : look(first, beyond.step, by_force);
    Trial before;
    Trial after = far.trial;
    const auto value_at = [&](double step) {
      const Look found = look(first, step, by_force);
      (found.value > 0 ? before : after) = found.trial;
      return found.value;
    };
    const bool turning = kind.event == Event::turning;
    const double share = turning && !memoryless ? numerics.turning_precision * resolution_
                                                : numerics.event_precision * resolution_ * resolution_;
    EventSearch search;
    search.step = beyond.step;
    search.precision = std::max(share * beyond.step, numerics.rounding * (now_.time + beyond.step));
    search.value_then = far.value;
    if (turning && now_.drive > 0)
      search.value_now = now_.drive, search.guess = predictor_.time_to_turning(now_);
    bracket_event(value_at, search);
    Trial found = kind.ends_after || before.step == 0 ? after : before;
    return by_force ? equilibrium_.with_drive(found) : found;
  }

  // ------------------------------------------------------------------ what changes the state

  void accept(const Stretch& next) {
    contact_.accept(next.trial.pad);
    predictor_.learn(phase_, now_, next.trial, next.event);
    move_to(next.trial.end, next.trial.step, next.event == Event::none);
  }

  void move_to(const State& end, double step, bool smooth) {
    foundation_.accept(now_.back, end.back, end.force, step, smooth);
    const double before = now_.velocity;
    if (end.time > now_.time) has_just_turned_ = false;
    motion_.accept(end, step, smooth);
    if (impactor_.gravity == 0 || phase_ == Phase::flight) return;
    if (const std::optional<double> left = swing_.rest(before, now_, step, impactor_)) {
      figures_.rest = Moment{now_.time, now_.velocity};
      figures_.left_to_sink = *left;
      figures_.last_swing = swing_.last();
      figures_.slowest_swing = swing_.slowest();
      enter(Phase::over, Status::at_rest);
    }
  }

  /// Holds the pad for a moment where neither phase has a solution, as at some corners of the support.
  void hold_for_a_moment() {
    if (foundation_.stands_still(now_.back, now_.force)) return;
    // Holding would stop a pad that moves against a panel at once.
    const bool on_panel = foundation_.kind() == Foundation::Kind::panel;
    if (on_panel && std::abs(now_.drive) > numerics.min_speed_to_stop * impactor_.speed) return;
    const double moment = numerics.held_moment * resolution_ * resolution_ * control_.usual();
    const Trial trial = equilibrium_.held(moment, predictor_);
    contact_.accept(trial.pad);
    move_to(trial.end, moment, false);
    idle_ = 0;
    ++moments_;
    predictor_.forget_rate();
    if (phase_ == Phase::over) return;
    // Without force contact is lost.
    if (now_.force <= 0) return begin_phase(Event::release);
    enter(now_.drive > 0 ? Phase::loading : Phase::unloading, Status::released);
  }

  void begin_phase(Event event) {
    if (foundation_.kind() != Foundation::Kind::at_once) motion_.close();
    predictor_.begin_phase(event, now_);
    if (event == Event::support_turning) foundation_.turn();
    if (event == Event::landing) motion_.land(foundation_.land(now_.back));
    if (event == Event::closing) turn();
    if (event == Event::release) {
      figures_.release = Moment{now_.time, now_.velocity};
      left_at_ = now_.penetration;
    }
    if (event == Event::lock && !figures_.bottomed) figures_.bottomed = Moment{now_.time, now_.velocity};
    if (event == Event::reloading && now_.drive > numerics.min_drive * impactor_.speed) ++figures_.reloadings;
    const Phase next = phase_after(event, phase_, now_.drive, conditions());
    if constexpr (FollowsRate<Contact> && RemembersBlows<Contact>) {
      if (event == Event::turning) joint_ = std::max(joint_, now_.penetration);
      if (event == Event::touch) contact_.meet_again();
    }
    if (event == Event::turning) {
      turn();
      // Rigid foam on a firm support has brought the impactor to rest.
      if (next == Phase::over && foundation_.backing().body_mass == 0) motion_.stop();
    }
    enter(next, event == Event::lock ? Status::bottomed_out : Status::released);
  }

  void turn() {
    turning_time_ = now_.time;
    has_just_turned_ = true;
  }

  /// Lets the force jump where a phase begins in which something else determines it.
  void jump_from(Phase before) {
    if (phase_ == Phase::held) motion_.begin_holding();
    if (before == Phase::flight && phase_ == Phase::loading && !contact_.recovers())
      motion_.begin_crushing(left_at_, contact_.trial(0, now_.time, control_.usual()).force);
  }

  [[nodiscard]] BranchConditions conditions() const {
    return {.pad_recovers = contact_.recovers(),
            .stops_hard = foundation_.stops_hard(),
            .rigid_support = foundation_.stands_still(now_.back, now_.force),
            .back_is_waited_for =
                foundation_.swings() && event_rules::speed_to_wait_for(foundation_, now_, min_return()) > 0};
  }
  [[nodiscard]] double min_return() const { return numerics.min_return * impactor_.speed; }

  void enter(Phase phase, Status if_over) {
    const bool was_in_flight = phase_ == Phase::flight;
    phase_ = phase;
    if (phase != Phase::over) return;
    figures_.ending = if_over;
    if (if_over == Status::released && !was_in_flight) figures_.release = Moment{now_.time, now_.velocity};
  }

  // ------------------------------------------------------------------ the record of a run

  void record(Track& track) {
    add_entry(track);
    // In a shorter step the rate is mostly the residual of the roots.
    const double rate = std::abs(predictor_.pad_rate());
    const double elapsed = track.history.time.back() - track.history.time[track.size() - 2];
    if (elapsed > numerics.min_step_with_rate * resolution_ * control_.usual() &&
        rate * elapsed >
            equilibrium_.allowed_residual(equilibrium_.reach(now_), now_.force, predictor_.pad_stiffness()))
      figures_.peak_pad_rate = std::max(figures_.peak_pad_rate, rate);
  }

  void add_entry(Track& track) {
    control_.learn_force(now_.force);
    History& h = track.history;
    h.time.push_back(now_.time);
    const double force = motion_.force_on_impactor();
    h.force.push_back(force);
    h.acceleration.push_back(0 - force / impactor_.mass);
    if (has_sheet_) h.pad_force.push_back(now_.force);
    h.velocity.push_back(now_.velocity);
    h.motion.push_back(now_.motion);
    // In flight, and by the precision of a release, the nose is above the pad.
    h.penetration.push_back(crater_ + std::max(now_.penetration, 0.0));
    h.support_deflection.push_back(foundation_.is_plain() ? now_.motion - now_.penetration
                                                          : now_.back.deflection);
    if (has_backing_) {
      h.transmitted_force.push_back(foundation_.is_plain() ? now_.force : now_.back.transmitted);
      h.body_motion.push_back(now_.back.body_motion);
    }
    h.contact_radius.push_back(contact_.contact_radius());
    h.axis_strain.push_back(h.penetration.back() / thickness_);
    if constexpr (HasLayers<Contact>)
      for (std::size_t i = 0; i < contact_.layers(); ++i)
        h.layer_strain[i].push_back(contact_.axis_strain(i));
  }

  Figures read_figures(const Track& track) {
    figures_.stations = contact_.stations();
    figures_.work = work(track);
    figures_.steps = track.size();
    figures_.final_velocity = now_.velocity;
    const Foundation::Energy energy = foundation_.energy(now_.back, now_.force);
    figures_.energy.support = energy.stored;
    figures_.energy.support_loss = energy.crushed + energy.damped;
    figures_.energy.moving = energy.moving;
    figures_.energy.weight = impactor_.mass * impactor_.gravity * now_.motion;
    figures_.set = foundation_.set();
    figures_.crushing_force = foundation_.crushing_force();
    figures_.body_velocity = now_.back.body_velocity;
    // An impactor that came back after a release and stayed has not left the pad.
    if (figures_.ending != Status::released) figures_.release.reset();
    read_peaks(track, figures_);
    // On a rigid support it is the force of the pad, which has no finite value at bottoming.
    if (figures_.ending == Status::bottomed_out && foundation_.kind() == Foundation::Kind::at_once)
      figures_.peak_transmitted = 0;
    read_weight(track, impactor_, figures_);
    read_contact_end(track, impactor_, figures_);
    if constexpr (memoryless)
      figures_.energy.pad = contact_.energy(contact_.recovers() ? std::max(now_.penetration, 0.0)
                                                                : figures_.peak_penetration - crater_);
    else
      figures_.energy.pad = work_on_pad(track);
    if (has_sheet_) {
      const double left = track.history.velocity.front();
      figures_.speed_to_sheet = impactor_.speed - left;
      figures_.energy.sheet =
          impactor_.mass * figures_.speed_to_sheet * (impactor_.speed + left) / 2 + motion_.work_on_sheet();
    }
    return figures_;
  }

  Impactor impactor_;
  double thickness_;
  double crater_ = 0;  ///< depth of the crater of a pad struck before, m below the surface of the new pad
  double joint_ = 0;   ///< penetration at which the pad joins its first loading, m; 0: none
  Foundation foundation_;
  Contact& contact_;
  const Options& options_;
  bool has_sheet_;
  bool has_backing_;  ///< the support is more than a curve on the ground
  Motion<Contact> motion_;
  const State& now_ = motion_.now();
  Equilibrium<Contact> equilibrium_;
  Predictor predictor_;
  StepControl control_;
  double resolution_ = 0;
  double max_work_ = 0;
  Phase phase_ = Phase::loading;
  int idle_ = 0;                  ///< loops since time last advanced
  int moments_ = 0;               ///< moments the pad was held since the last step
  double turning_time_ = 0;       ///< time of the last turn of the nose against the pad's back, s
  bool has_just_turned_ = false;  ///< no time has passed since turning_time_
  double left_at_ = 0;            ///< penetration at the last release, m
  Swing swing_;
  Figures figures_;
};

}  // namespace dashpad
