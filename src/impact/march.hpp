#pragma once
/// One run through an impact at one resolution: the step, its events, and the figures read off.
///
///   0 = Y1 + Xs(F(Y1)) - X1(F(Y1))        the unknown is the penetration           (theory.md, Eq. 19)
///
/// with the motion of impact/motion.hpp.
///
/// The run goes through phases: loading, unloading, held (a rigid foam off its crush curve, or a fully
/// compressed pad on a yielding support: Eq. 26; a pad is also held for a moment where the contact integral's
/// error leaves neither of the other two). They end at events, which are located within the step.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>

#include "dashpad/impact/impact_case.hpp"
#include "dashpad/impact/solution.hpp"
#include "impact/event_search.hpp"
#include "impact/figures.hpp"
#include "impact/motion.hpp"
#include "impact/rate_trend.hpp"
#include "impact/root.hpp"
#include "impact/track.hpp"

namespace dashpad {

template <class Contact>
class March {
 public:
  March(const Impactor& impactor, double thickness, const Support& support, Contact& contact,
        const Options& options)
      : mass_(impactor.mass),
        radius_(impactor.radius),
        speed_(impactor.speed),
        thickness_(thickness),
        support_(support),
        contact_(contact),
        options_(options),
        motion_(impactor.mass, support) {}
  March(const March&) = delete;
  March& operator=(const March&) = delete;

  /// Runs the impact with steps of about `resolution` radians of the momentary oscillation. `expected` is the
  /// peak penetration, m, as far as it is known.
  Figures run(double resolution, Track& track, double expected = infinity) {
    resolution_ = resolution;
    figures_ = {};
    figures_.peak_pad_rate = speed_;
    track.clear();
    contact_.start(resolution, expected);
    motion_.start(speed_);
    pad_rate_ = speed_;
    pad_stiffness_ = drive_rate_ = tried_step_ = largest_force_ = 0;
    stiffening_ = 1;
    trend_.restart();
    turning_time_ = infinity;
    phase_ = Phase::loading;
    record(track);
    double step = first_step();
    double longest = longest_step();
    int idle = 0;
    while (phase_ != Phase::over) {
      if (now_.time >= options_.time_limit) {
        figures_.ending = Ending::time_limit;
        break;
      }
      if (track.size() > options_.most_steps || contact_.updates() > most_updates) break;
      const double before = now_.time;
      const bool smooth = advance(step);
      if (now_.time > before)
        idle = 0;
      else if (++idle > most_idle_events)
        break;
      else if (idle > 1)
        hold_for(0.1 * resolution_ * resolution_ * longest);
      if (now_.time > before) record(track);
      // In a shorter step the rate is little else than what the roots have left over.
      const double elapsed = now_.time - before;
      if (elapsed > 1e-2 * resolution * longest &&
          std::abs(pad_rate_) * elapsed > root_tolerance(now_.motion))
        figures_.peak_pad_rate = std::max(figures_.peak_pad_rate, std::abs(pad_rate_));
      if (!smooth && phase_ != Phase::over && track.phase_starts.back() != track.size() - 1)
        track.phase_starts.push_back(track.size() - 1);
      // After an event, where the strain rate may jump, steps grow from small ones.
      longest = std::min(longest_step(), 1.5 * longest);
      step = std::min({1.5 * std::max(motion_.last_step(), resolution_ * longest), approach(longest),
                       options_.time_limit - now_.time});
    }
    figures_.stations = contact_.stations();
    figures_.updates = contact_.updates();
    figures_.final_velocity = now_.velocity;
    figures_.support_energy = support_.energy(now_.force);
    read_peaks(track, figures_);
    read_weight(track, mass_, figures_);
    read_contact_end(track, mass_, figures_);
    if constexpr (closed_form)
      figures_.pad_work = contact_.energy(now_.penetration);
    else
      figures_.pad_work = work_on_pad(track);
    return figures_;
  }

 private:
  static constexpr bool closed_form = HasEnergy<Contact>;
  static constexpr double infinity = std::numeric_limits<double>::infinity();

  /// Column updates of one run, some seconds' worth; a run that asks for more is given up.
  static constexpr std::size_t most_updates = 50'000'000;
  /// Phases may change at one moment, but not for ever.
  static constexpr int most_idle_events = 16;
  /// Reloadings count from this drive on, in impact speeds; below, they may come from rounding.
  static constexpr double least_drive = 1e-3;

  enum class Phase { loading, unloading, held, over };
  /// Why a step must end where it ends, in the order in which they count when they coincide.
  enum class Event { none, release, lock, unlock, turning, reloading, corner };

  struct Attempt {
    State end;
    double advance = 0;            ///< of the penetration
    double pad_stiffness = 0;      ///< dF/dY over the step
    Event obstacle = Event::none;  ///< no equilibrium in this phase at this step
    double held_force = 0;         ///< held: what the pad itself carries
  };

  // ------------------------------------------------------------------ the step

  Attempt attempt(double step) { return phase_ == Phase::held ? attempt_held(step) : attempt_moving(step); }

  double residual(double penetration, double force, double step, State& end) const {
    return motion_.residual(contact_, penetration, force, step, end);
  }
  [[nodiscard]] double inertial_compliance(double step) const { return motion_.inertial_compliance(step); }

  static bool is_rounding(double left, double scale) {
    return std::abs(left) <= 4 * std::numeric_limits<double>::epsilon() * scale;
  }
  /// Of a pad with memory.
  [[nodiscard]] double root_tolerance(double scale) const {
    return std::max(0.1 * resolution_ * resolution_ * resolution_,
                    4 * std::numeric_limits<double>::epsilon()) *
           scale;
  }

  /// Loading, the unknown is the fourth root of the pad's advance: at the end of loading the force has a
  /// power of the strain rate with a small exponent, and an infinite slope in the advance itself.
  Attempt attempt_moving(double step) {
    Attempt result;
    const bool loading = phase_ == Phase::loading;
    const double locked = contact_.lock_penetration();
    const double unhindered = now_.motion + now_.velocity * step;
    const double most = std::min(unhindered, locked) - now_.penetration;
    if (loading && most <= 0) {
      result.obstacle = Event::turning;
      return result;
    }
    const double scale = std::max(std::abs(now_.motion), std::abs(unhindered));
    const double slope =
        1 + pad_stiffness_ * stiffening_ * (support_.compliance(now_.force) + inertial_compliance(step));
    double advance = guess_rate(step, slope) * step;
    RootSearch search;
    search.resolution = 2 * std::numeric_limits<double>::epsilon() * (scale + thickness_);
    result.pad_stiffness = pad_stiffness_ * stiffening_;
    double advanced_before = 0;
    double force_before = 0;
    int trials = 0;
    const auto at = [&](double advanced) {
      result.advance = advanced;
      const double force = contact_.trial(advanced, now_.time, step);
      const double distance = advanced - advanced_before;
      if (trials > 0 && std::abs(distance) > 1e-9 * std::abs(advanced) &&
          std::abs(force - force_before) > 1e-12 * std::abs(force))
        result.pad_stiffness = std::max((force - force_before) / distance, force / thickness_);
      ++trials, advanced_before = advanced, force_before = force;
      return residual(now_.penetration + advanced, force, step, result.end);
    };
    // What is left of the residual is taken up by the force, in proportion: Eq. 19 then holds but for the
    // curvature, and the columns stay where they were tried.
    const auto near = [&](double left) {
      // Without force the pad stays without it on the way to the root: the step passes the release.
      if (!loading && result.end.force <= 0 && left >= 0) return true;
      if constexpr (closed_form) return is_rounding(left, scale);
      const double flexibility = support_.compliance(result.end.force) + inertial_compliance(step);
      const double missing = -left / (1 + result.pad_stiffness * flexibility);
      const double allowed = root_tolerance(scale) * (trials > 1 ? 1 : 0.2);
      if (std::abs(left) > allowed) return false;
      if (std::abs(missing) > 0.05 * resolution_ * std::abs(result.advance))
        return std::abs(left) < 0.1 * allowed;
      const double force = result.end.force;
      if (force > 0)
        residual(result.end.penetration, std::max(force + result.pad_stiffness * missing, force / 2), step,
                 result.end);
      return true;
    };
    Root root;
    if (loading) {
      if (!(advance > 0 && advance < most)) advance = std::min(std::max(pad_rate_, 0.0) * step, most) / 2;
      search.high = fourth_root(most);
      search.high_is_positive = unhindered <= locked;
      search.guess = fourth_root(advance);
      search.slope = slope * fourth_power_slope(search.guess);
      search.resolution = 1e-14 * search.high;
      root = find_root([&](double z) { return at(z * z * z * z); }, near, search);
      if (root.place == RootPlace::at_or_above_high) result.obstacle = Event::lock;
      if (root.place == RootPlace::at_or_below_low) result.obstacle = Event::turning;
    } else {
      if (!(advance < 0)) advance = std::min(pad_rate_, -std::abs(now_.velocity)) * step / 2;
      search.low = -infinity;
      search.high = 0;
      search.high_is_positive = now_.drive < 0;
      search.guess = advance;
      search.slope = slope;
      // Short strides: of several roots, the one next to where the pad is belongs to the branch.
      search.stride = 0.2 * std::abs(advance) + search.resolution;
      root = find_root(at, near, search);
      if (result.advance >= 0) {
        // The pad, by the error of the contact integral, carries less than the support asks for: it is held
        // until the support has come down to it.
        // Likewise just after the turning, where the drive is 0 but for an error of either sign.
        if (!support_.is_rigid() && (now_.drive < 0 || now_.time == turning_time_)) {
          const Attempt held = attempt_held(step);
          if (now_.drive < 0 || held.end.drive < 0) return held;
        }
        result.obstacle = Event::reloading;
      }
    }
    result.end.drive = drive(result.end);
    if (result.obstacle == Event::none) tried_step_ = step, tried_rate_ = result.advance / step;
    return result;
  }
  /// Mean rate of the penetration over a step: by its trend, or between the rate now and that of the last
  /// step that was tried from here, of which events take many. After an event the pad is taken as a spring;
  /// `slope` is that of Eq. 19.
  [[nodiscard]] double guess_rate(double step, double slope) const {
    if (tried_step_ != 0) {
      if (!trend_.is_known()) return tried_rate_;
      const double now = trend_.now();
      return now + (tried_rate_ - now) * step / tried_step_;
    }
    if (trend_.is_known()) return trend_.over(step);
    return phase_ == Phase::loading ? std::max(now_.velocity, 0.0) / slope : -std::abs(now_.velocity) / slope;
  }
  static double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }
  static double fourth_power_slope(double z) { return 4 * z * z * z; }

  /// The penetration stays; the support's force moves the impactor.
  Attempt attempt_held(double step) {
    Attempt result;
    result.pad_stiffness = pad_stiffness_;  // an unloading that waits for the support goes on from it
    RootSearch search;
    search.low = -infinity;
    search.high = infinity;
    const double y = now_.penetration;
    const double flexibility = support_.compliance(now_.force) + inertial_compliance(step);
    search.guess = now_.force + now_.velocity * step / flexibility;
    search.slope = flexibility;
    const double scale = std::abs(now_.motion) + std::abs(now_.velocity) * step;
    search.resolution = 4 * std::numeric_limits<double>::epsilon() * std::abs(now_.force);
    search.stride = std::abs(now_.force);
    // Below zero the support's line goes on: the release is located by the sign.
    const auto f = [&](double force) {
      const double extended = force >= 0 ? 0 : force * support_.compliance(0);
      return residual(y, force, step, result.end) + extended;
    };
    search.high = std::max(now_.force, 0.0) + 2 * (std::abs(now_.velocity) * step + scale) / flexibility;
    find_root(
        f, [&](double left) { return is_rounding(left, scale); }, search);
    result.held_force = contact_.trial(0, now_.time, step);
    result.end.drive = drive(result.end);
    return result;
  }

  /// Without force the motion is known, and with it the penetration of an unloaded support.
  Attempt attempt_release(double step) {
    Attempt result;
    residual(0, 0, step, result.end);
    result.end.penetration = result.end.motion;
    result.advance = result.end.penetration - now_.penetration;
    result.pad_stiffness = pad_stiffness_;
    contact_.trial(result.advance, now_.time, step);
    result.end.drive = drive(result.end);
    return result;
  }

  /// Eq. 20, from the last trial.
  double drive(const State& end) {
    return end.velocity - support_.compliance(end.force) * contact_.force_rate_when_held(end.time);
  }

  // ------------------------------------------------------------------ events

  /// What a step of this attempt runs into; `value` is positive before the event and not after.
  [[nodiscard]] bool passes(Event event, const Attempt& a, double corner, double& value) const {
    const bool moving = phase_ != Phase::held;
    switch (event) {
      case Event::release:
        value = a.end.force;
        return (moving ? phase_ == Phase::unloading : true) && a.end.force <= 0;
      case Event::lock: value = a.obstacle == Event::lock ? -1 : 1; return a.obstacle == Event::lock;
      case Event::unlock:
        value = a.end.force - a.held_force;
        return !moving && contact_.recovers() && value < 0;
      case Event::turning:
        value = a.obstacle == Event::turning ? -infinity : a.end.drive;
        return phase_ == Phase::loading && value <= 0 && (now_.drive > 0 || a.obstacle == Event::turning);
      case Event::reloading:
        value = a.obstacle == Event::reloading ? -infinity : 1;
        return a.obstacle == Event::reloading;
      case Event::corner:
        value = (a.end.force - corner) * (now_.force < corner ? -1 : 1);
        return std::abs(now_.force - corner) > 1e-9 * corner && value < 0;
      default: return false;
    }
  }

  struct Obstruction {
    Event event = Event::none;
    double corner = 0;
    int count = 0;
  };
  [[nodiscard]] Obstruction obstruction(const Attempt& a) const {
    Obstruction found;
    double value = 0;
    const auto add = [&](Event event, double corner) {
      if (!passes(event, a, corner, value)) return;
      if (found.count++ == 0) found.event = event, found.corner = corner;
    };
    if (a.obstacle == Event::none) {
      for (const Event event : {Event::release, Event::unlock, Event::turning, Event::reloading})
        add(event, 0);
      for (const double corner : support_.corners()) add(Event::corner, corner);
    } else {
      add(a.obstacle, 0);
    }
    return found;
  }

  /// Takes one step, of at most `step`. False if it ended at an event that breaks smoothness.
  bool advance(double step) {
    Attempt a = attempt(step);
    Obstruction o = obstruction(a);
    const double shortest = 64 * std::numeric_limits<double>::epsilon() * std::max(now_.time, step);
    // Far too long for what it found, or into several events at once: a shorter step tells more.
    for (int i = 0; i < 60 && step > shortest; ++i) {
      const bool too_long = o.event == Event::none && step > 2 * longest_step(a);
      if (!too_long && o.count <= 1) break;
      step /= 2;
      a = attempt(step);
      o = obstruction(a);
    }
    if (o.event != Event::none) {
      const double too_short = 1e-2 * resolution_ * step;
      step = locate(o, step);
      // At once: the phase changes where it stands. What ends or locks the run is still gone up to.
      const bool goes_on = o.event != Event::release && o.event != Event::lock;
      if (goes_on && step < shortest) return change_phase(o.event);
      // Nothing but what the last root has left over would move in so short a step.
      const bool branch_ends = o.event == Event::turning || o.event == Event::reloading;
      if (branch_ends && step < too_short) return change_phase(o.event);
      step = std::max(step, shortest);
      a = !closed_form && o.event == Event::release && phase_ != Phase::held ? attempt_release(step)
                                                                             : attempt(step);
      if (a.obstacle != Event::none && a.obstacle != Event::lock) return change_phase(o.event);
    }
    if (o.event == Event::lock) lock(step, a);
    if (o.event == Event::release) a.end.force = 0;
    contact_.accept();
    const double pad_rate = a.advance / step;
    tried_step_ = 0;
    if (phase_ == Phase::loading && pad_rate > 0.4 * pad_rate_) spring_ = a.pad_stiffness;
    pad_rate_ = pad_rate;
    if (phase_ != Phase::held) {
      stiffening_ = trend_.is_known() ? std::clamp(a.pad_stiffness / pad_stiffness_, 0.5, 2.0) : 1;
      pad_stiffness_ = a.pad_stiffness;
    }
    if (o.event == Event::none && pad_rate != 0)
      trend_.add(pad_rate, step);
    else
      trend_.restart();
    drive_rate_ = (a.end.drive - now_.drive) / step;
    motion_.accept(a.end, step, o.event == Event::none);
    if (o.event == Event::none) return true;
    return change_phase(o.event);
  }

  /// Neither phase has a solution from here, as at a corner of the support from which loading and unloading
  /// both lead back: the pad is held for a moment.
  void hold_for(double step) {
    if (support_.is_rigid()) return;
    const Attempt a = attempt_held(step);
    contact_.accept();
    motion_.accept(a.end, step, false);
    pad_rate_ = tried_step_ = 0;
    trend_.restart();
    if (now_.force <= 0)
      finish(Ending::released);
    else
      phase_ = now_.drive > 0 ? Phase::loading : Phase::unloading;
  }

  /// The longest step that does not pass the event.
  double locate(const Obstruction& o, double step) {
    const auto value_at = [&](double x) {
      double value = 0;
      if (o.event == Event::lock) {
        State end;
        return residual_at_lock(x, end);
      }
      if (!closed_form && o.event == Event::release && phase_ != Phase::held) {
        attempt_release(x);
        return contact_.largest_stress();
      }
      const Attempt a = attempt(x);
      static_cast<void>(passes(o.event, a, o.corner, value));
      if (o.event == Event::release && a.end.force <= 0 && phase_ != Phase::held)
        value = contact_.largest_stress();
      return std::clamp(value, -1e300, 1e300);
    };
    // The pad turns at a rate near zero: a little early or late changes nothing of first order.
    const bool turning = o.event == Event::turning;
    const double share = turning && !closed_form ? 2e-2 * resolution_ : 1e-3 * resolution_ * resolution_;
    EventSearch search;
    search.step = step;
    search.precision =
        std::max(share * step, 4 * std::numeric_limits<double>::epsilon() * (now_.time + step));
    if (turning && now_.drive > 0) search.value_now = now_.drive, search.guess = -now_.drive / drive_rate_;
    const auto [low, high] = bracket_event(value_at, search);
    // A step that has a solution: just before the event where its far side has none.
    const bool far_side = o.event == Event::release || o.event == Event::lock || o.event == Event::unlock ||
                          o.event == Event::corner;
    return far_side || low == 0 ? high : low;
  }

  double residual_at_lock(double step, State& end) {
    const double y = contact_.lock_penetration();
    return residual(y, contact_.trial(y - now_.penetration, now_.time, step), step, end);
  }

  void lock(double step, Attempt& a) {
    residual_at_lock(step, a.end);
    a.advance = a.end.penetration - now_.penetration;
    a.end.drive = a.end.velocity;
    if (!figures_.bottomed) figures_.bottomed = Moment{a.end.time, a.end.velocity};
  }

  bool change_phase(Event event) {
    tried_step_ = 0;
    switch (event) {
      case Event::release: finish(Ending::released); break;
      case Event::lock:
        if (support_.is_rigid())
          finish(Ending::bottomed_out);
        else
          phase_ = Phase::held;
        break;
      case Event::turning:
        if (contact_.recovers()) {
          phase_ = Phase::unloading;
          turning_time_ = now_.time;
          pad_rate_ = std::min(now_.velocity, 0.0);
          pad_stiffness_ = spring_;
          stiffening_ = 1;
        } else if (support_.is_rigid()) {
          motion_.stop();
          finish(Ending::released);
        } else {
          phase_ = Phase::held;
        }
        break;
      case Event::reloading:
        if (now_.drive > least_drive * speed_) ++figures_.reloadings;
        phase_ = Phase::loading;
        pad_rate_ = std::max(now_.velocity, 0.0);
        break;
      case Event::unlock:
        phase_ = now_.drive > 0 ? Phase::loading : Phase::unloading;
        pad_rate_ = now_.velocity;
        break;
      default: break;
    }
    return false;
  }

  void finish(Ending ending) {
    phase_ = Phase::over;
    figures_.ending = ending;
    if (ending == Ending::released) {
      figures_.release = Moment{now_.time, now_.velocity};
    }
  }

  // ------------------------------------------------------------------ step length

  /// Steps resolve the momentary oscillation, the strain and the closing gap.
  [[nodiscard]] double longest_step(double pad_stiffness, const State& state, double pad_rate) const {
    double stiffness = infinity;
    if (phase_ == Phase::held)
      stiffness = 1 / support_.compliance(state.force);
    else
      stiffness = 1 / (1 / pad_stiffness + support_.compliance(state.force));
    double step = resolution_ * std::sqrt(mass_ / stiffness);
    if (phase_ != Phase::held && pad_rate != 0) {
      const double gap = contact_.lock_penetration() - state.penetration;
      step = std::min(step,
                      resolution_ * std::min(thickness_, radius_ + state.penetration) / std::abs(pad_rate));
      step = std::min(step,
                      (std::min(0.5, 4 * resolution_) * gap + 1e-2 * resolution_ * resolution_ * thickness_) /
                          std::abs(pad_rate));
    }
    return step;
  }
  /// Towards the release steps shrink: the force vanishes there with a power of the time left. Likewise where
  /// the unloading may end any moment: there the pad's rate changes with the square root of the time left.
  [[nodiscard]] double approach(double step) const {
    if (phase_ == Phase::unloading && now_.drive > 0)
      step = std::min(step, resolution_ * std::max(step, trend_.time_scale()));
    if (phase_ != Phase::unloading || motion_.force_rate() >= 0) return step;
    // The end of contact is read between the entries, which must come closer as the resolution rises.
    const bool in_contact = now_.force > contact_end_share * largest_force_;
    const double fall = in_contact ? std::min(0.7, 7 * resolution_) : 0.7;
    const double shortest = (in_contact ? 0.25 : 1) * resolution_ * step;
    return std::min(step, std::max(shortest, -fall * now_.force / motion_.force_rate()));
  }
  [[nodiscard]] double longest_step() const { return longest_step(pad_stiffness_, now_, pad_rate_); }
  [[nodiscard]] double longest_step(const Attempt& a) const {
    return longest_step(a.pad_stiffness, a.end, a.advance / (a.end.time - now_.time));
  }

  /// Small against the first step that the momentary stiffness would allow.
  double first_step() {
    double y = resolution_ * std::min(thickness_, radius_);
    for (int i = 0; i < 400; ++i, y /= 2) {
      const double step = y / speed_;
      const double force = contact_.trial(y, 0, step);
      pad_stiffness_ = spring_ = 2 * force / y;
      if (!(step > 0.25 * longest_step(pad_stiffness_, {}, speed_))) return step;
    }
    return y / speed_;
  }

  void record(Track& track) {
    largest_force_ = std::max(largest_force_, now_.force);
    History& h = track.history;
    h.time.push_back(now_.time);
    h.force.push_back(now_.force);
    h.acceleration.push_back(0 - now_.force / mass_);
    h.velocity.push_back(now_.velocity);
    h.motion.push_back(now_.motion);
    h.penetration.push_back(now_.penetration);
    h.support_deflection.push_back(now_.motion - now_.penetration);
    h.contact_radius.push_back(contact_.contact_radius());
    h.largest_strain.push_back(now_.penetration / thickness_);
  }

  double mass_;
  double radius_;
  double speed_;
  double thickness_;
  const Support& support_;
  Contact& contact_;
  const Options& options_;
  double resolution_ = 0;
  Phase phase_ = Phase::loading;
  Motion<Contact> motion_;
  const State& now_ = motion_.now();
  double pad_rate_ = 0;
  double pad_stiffness_ = 0;
  double spring_ = 0;      ///< stiffness before the rate broke down towards the turning point
  double stiffening_ = 1;  ///< of the pad from the step before to the last
  double drive_rate_ = 0;
  double largest_force_ = 0;  ///< so far
  RateTrend trend_;
  double tried_step_ = 0;  ///< the last that was tried from the state now and had a solution; 0: none
  double tried_rate_ = 0;  ///< mean rate of the penetration over it
  double turning_time_ = infinity;  ///< the last
  Figures figures_;
};

}  // namespace dashpad
