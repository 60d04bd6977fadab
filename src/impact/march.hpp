#pragma once
/// One run through an impact at one resolution: the step, its events, and the figures read off.
///
///   V1 = V0 - Fm dt / M,   X1 = X0 + (V0 + V1) dt / 2                              (theory.md, Eq. 17)
///   Fm = (F0 + F1) / 2, or for a pad without memory the mean whose work is exact   (theory.md, Eq. 18)
///   0 = Y1 + Xs(F(Y1)) - X1(F(Y1))        the unknown is the penetration           (theory.md, Eq. 19)
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
#include "impact/figures.hpp"
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
        options_(options) {}

  /// Runs the impact with steps of about `resolution` radians of the momentary oscillation.
  Figures run(double resolution, Track& track) {
    resolution_ = resolution;
    figures_ = {};
    track.clear();
    contact_.start(resolution);
    now_ = {};
    now_.velocity = now_.drive = speed_;
    pad_rate_ = speed_;
    pad_stiffness_ = force_rate_ = drive_rate_ = pad_acceleration_ = 0;
    pad_jerk_ = last_step_ = step_before_ = tried_step_ = 0;
    stiffening_ = 1;
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
      if (!smooth && phase_ != Phase::over && track.phase_starts.back() != track.size() - 1)
        track.phase_starts.push_back(track.size() - 1);
      // After an event, where the strain rate may jump, steps grow from small ones.
      longest = std::min(longest_step(), 1.5 * longest);
      step = std::min({1.5 * std::max(last_step_, resolution_ * longest), approach(longest),
                       options_.time_limit - now_.time});
    }
    figures_.stations = contact_.stations();
    figures_.updates = contact_.updates();
    figures_.final_velocity = now_.velocity;
    figures_.support_energy = support_.energy(now_.force);
    read_peaks(track, figures_);
    if constexpr (closed_form)
      figures_.pad_work = contact_.energy(now_.penetration);
    else
      figures_.pad_work = work_on_pad(track);
    return figures_;
  }

 private:
  static constexpr bool closed_form = requires(const Contact contact) { contact.energy(0.0); };
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

  struct State {
    double time = 0, motion = 0, velocity = 0, penetration = 0, force = 0;
    /// Speed by which the support outruns a pad held still; > 0 loads the pad (theory.md, Eq. 20).
    double drive = 0;
  };
  struct Attempt {
    State end;
    double advance = 0;            ///< of the penetration
    double pad_stiffness = 0;      ///< dF/dY over the step
    Event obstacle = Event::none;  ///< no equilibrium in this phase at this step
    double held_force = 0;         ///< held: what the pad itself carries
  };

  // ------------------------------------------------------------------ the step

  Attempt attempt(double step) { return phase_ == Phase::held ? attempt_held(step) : attempt_moving(step); }

  [[nodiscard]] double mean_force(double penetration, double force, double motion) const {
    if constexpr (closed_form) {
      const double distance = motion - now_.motion;
      if (std::abs(distance) > 1e-7 * (std::abs(motion) + std::abs(now_.motion)))
        return (support_.energy(force) - support_.energy(now_.force) + contact_.energy(penetration) -
                contact_.energy(now_.penetration)) /
               distance;
    }
    return (now_.force + force) / 2;
  }

  /// Fills `end` for a trial penetration; returns the residual of Eq. 19, m.
  double residual(double penetration, double force, double step, State& end) const {
    const double motion = penetration + support_.deflection(force);
    const double mean = mean_force(penetration, force, motion);
    end.penetration = penetration;
    end.force = force;
    end.time = now_.time + step;
    end.velocity = now_.velocity - mean * step / mass_;
    end.motion = now_.motion + (now_.velocity + end.velocity) / 2 * step;
    return motion - end.motion;
  }

  [[nodiscard]] double root_tolerance(double scale) const {
    return std::max(closed_form ? 0 : 2e-3 * resolution_ * resolution_ * resolution_,
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
        1 + pad_stiffness_ * stiffening_ * (support_.compliance(now_.force) + step * step / (4 * mass_));
    double advance = guess_rate(step) * step;
    RootSearch search;
    search.tolerance = root_tolerance(scale);
    search.resolution = 2 * std::numeric_limits<double>::epsilon() * (scale + thickness_);
    result.pad_stiffness = pad_stiffness_ * stiffening_;
    double advanced_before = 0;
    double force_before = 0;
    bool tried = false;
    const auto at = [&](double advanced) {
      result.advance = advanced;
      const double force = contact_.trial(advanced, now_.time, step);
      const double distance = advanced - advanced_before;
      if (tried && std::abs(distance) > 1e-9 * std::abs(advanced) &&
          std::abs(force - force_before) > 1e-12 * std::abs(force))
        result.pad_stiffness = std::max((force - force_before) / distance, force / thickness_);
      tried = true, advanced_before = advanced, force_before = force;
      return residual(now_.penetration + advanced, force, step, result.end);
    };
    Root root;
    if (loading) {
      if (!(advance > 0 && advance < most)) advance = std::min(std::max(pad_rate_, 0.0) * step, most) / 2;
      search.high = fourth_root(most);
      search.high_is_positive = unhindered <= locked;
      search.guess = fourth_root(advance);
      search.slope = slope * fourth_power_slope(search.guess);
      search.resolution = 1e-14 * search.high;
      root = find_root([&](double z) { return at(z * z * z * z); }, search);
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
      root = find_root(at, search);
      if (result.advance >= 0) {
        // The pad, by the error of the contact integral, carries less than the support asks for: it is held
        // until the support has come down to it.
        // Likewise just after the turning, where the drive is 0 but for an error of either sign.
        const bool turned = now_.time == turning_time_;
        if (!support_.is_rigid() && (now_.drive < 0 || turned)) {
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
  /// step that was tried from here, of which events take many.
  [[nodiscard]] double guess_rate(double step) const {
    const double ahead = (last_step_ + step) / 2;
    const double trend =
        pad_rate_ + ahead * (pad_acceleration_ + pad_jerk_ * (ahead + (step_before_ + last_step_) / 2));
    if (tried_step_ == 0) return trend;
    if (pad_acceleration_ == 0) return tried_rate_;
    const double now = pad_rate_ + pad_acceleration_ * last_step_ / 2;
    return now + (tried_rate_ - now) * step / tried_step_;
  }
  static double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }
  static double fourth_power_slope(double z) { return 4 * z * z * z; }

  /// The penetration stays; the support's force moves the impactor.
  Attempt attempt_held(double step) {
    Attempt result;
    RootSearch search;
    search.low = -infinity;
    search.high = infinity;
    const double y = now_.penetration;
    const double flexibility = support_.compliance(now_.force) + step * step / (4 * mass_);
    search.guess = now_.force + now_.velocity * step / flexibility;
    search.slope = flexibility;
    const double scale = std::abs(now_.motion) + std::abs(now_.velocity) * step;
    search.tolerance = 4 * std::numeric_limits<double>::epsilon() * scale;
    search.resolution = 4 * std::numeric_limits<double>::epsilon() * std::abs(now_.force);
    search.stride = std::abs(now_.force);
    // Below zero the support's line goes on: the release is located by the sign.
    const auto f = [&](double force) {
      const double extended = force >= 0 ? 0 : force * support_.compliance(0);
      return residual(y, force, step, result.end) + extended;
    };
    search.high = std::max(now_.force, 0.0) + 2 * (std::abs(now_.velocity) * step + scale) / flexibility;
    find_root(f, search);
    result.held_force = contact_.trial(0, now_.time, step);
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
      a = attempt(step);
      if (a.obstacle != Event::none && a.obstacle != Event::lock) return change_phase(o.event);
    }
    if (o.event == Event::lock) lock(step, a);
    note_weight(a, step);
    if (o.event == Event::release) a.end.force = 0;
    contact_.accept();
    const double pad_rate = a.advance / step;
    follow_trend(pad_rate, step, o.event == Event::none);
    tried_step_ = 0;
    pad_rate_ = pad_rate;
    if (phase_ != Phase::held) {
      const bool smooth = o.event == Event::none && pad_acceleration_ != 0;
      stiffening_ = smooth ? std::clamp(a.pad_stiffness / pad_stiffness_, 0.5, 2.0) : 1;
      pad_stiffness_ = a.pad_stiffness;
    }
    force_rate_ = (a.end.force - now_.force) / step;
    drive_rate_ = (a.end.drive - now_.drive) / step;
    now_ = a.end;
    if (o.event == Event::none) return true;
    return change_phase(o.event);
  }

  /// Divided differences of the mean rates of the last three steps.
  void follow_trend(double pad_rate, double step, bool smooth) {
    const double acceleration =
        smooth && last_step_ > 0 ? (pad_rate - pad_rate_) * 2 / (last_step_ + step) : 0;
    const bool known = acceleration != 0 && pad_acceleration_ != 0;
    pad_jerk_ = known ? (acceleration - pad_acceleration_) * 2 / (step_before_ + 2 * last_step_ + step) : 0;
    pad_acceleration_ = acceleration;
    step_before_ = last_step_;
    last_step_ = step;
  }

  /// Neither phase has a solution from here, as at a corner of the support from which loading and unloading
  /// both lead back: the pad is held for a moment.
  void hold_for(double step) {
    if (support_.is_rigid()) return;
    const Attempt a = attempt_held(step);
    contact_.accept();
    now_ = a.end;
    pad_rate_ = pad_acceleration_ = pad_jerk_ = tried_step_ = 0;
    last_step_ = step;
    if (now_.force <= 0)
      finish(Ending::released);
    else
      phase_ = now_.drive > 0 ? Phase::loading : Phase::unloading;
  }

  /// The longest step that does not pass the event.
  double locate(const Obstruction& o, double step) {
    double low = 0;
    double high = step;
    const auto value_at = [&](double x) {
      double value = 0;
      if (o.event == Event::lock) {
        State end;
        return residual_at_lock(x, end);
      }
      if (!closed_form && o.event == Event::release && phase_ != Phase::held) {
        // Without force the motion is known, and with it the penetration of an unloaded support.
        const double motion = now_.motion + (now_.velocity - now_.force * x / (4 * mass_)) * x;
        return contact_.largest_stress(motion - now_.penetration, now_.time, x);
      }
      const Attempt a = attempt(x);
      static_cast<void>(passes(o.event, a, o.corner, value));
      if (o.event == Event::release && a.obstacle == Event::none && a.end.force <= 0 && phase_ != Phase::held)
        value = contact_.largest_stress(a.advance, now_.time, x);
      return std::clamp(value, -1e300, 1e300);
    };
    // Regula falsi with halved end values (Illinois): the values may jump to a bound where no step exists.
    double f_low = o.event == Event::turning && now_.drive > 0 ? now_.drive : infinity;
    double f_high = value_at(high);
    const double precision = std::max(1e-3 * resolution_ * resolution_ * step,
                                      4 * std::numeric_limits<double>::epsilon() * (now_.time + step));
    int side = 0;
    double before = high;
    for (int i = 0; i < 80 && high - low > precision; ++i) {
      double x = (f_low * high - f_high * low) / (f_low - f_high);
      // Where the guesses have settled, one just beyond the event closes the bracket.
      if (std::abs(x - before) < precision / 50) x += (side == 1 ? 1 : -1) * precision / 25;
      before = x;
      // No solution at the far end is no number to interpolate with: first the drive's own trend, then
      // halves.
      if (f_high < -1e250) x = o.event == Event::turning && i == 0 ? -now_.drive / drive_rate_ : infinity;
      if (!(x > low && x < high) || i % 8 == 7) x = low + (high - low) / 2;
      const double f = value_at(x);
      if (f > 0) {
        low = x, f_low = f;
        if (side == 1) f_high /= 2;
        side = 1;
      } else {
        high = x, f_high = f;
        if (side == -1) f_low /= 2;
        side = -1;
        if (f == 0) break;
      }
    }
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
        } else if (support_.is_rigid()) {
          now_.velocity = 0;
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
      if (!figures_.weight) figures_.weight = figures_.release;
    }
  }

  /// The force falls below the impactor's weight on rebound within this step.
  void note_weight(const Attempt& a, double step) {
    const double weight = mass_ * standard_gravity;
    if (figures_.weight || !(a.end.velocity < 0) || !(a.end.force < weight)) return;
    if (now_.force <= weight) {
      // Light from the start of the rebound.
      const double share = now_.velocity > 0 ? now_.velocity / (now_.velocity - a.end.velocity) : 0;
      figures_.weight = Moment{now_.time + share * step, std::min(now_.velocity, 0.0)};
      return;
    }
    double low = 0;
    double high = step;
    double f_low = now_.force - weight;
    double f_high = a.end.force - weight;
    State at = a.end;
    const double precision = 1e-3 * resolution_ * resolution_;
    const double close = precision * (f_low - f_high);
    for (int i = 0; i < 40 && high - low > precision * step; ++i) {
      double x = (f_low * high - f_high * low) / (f_low - f_high);
      if (i % 3 == 2) x = low + (high - low) / 2;
      const Attempt trial = attempt(x);
      if (trial.obstacle != Event::none) break;
      at = trial.end;
      const double f = at.force - weight;
      (f > 0 ? low : high) = x;
      (f > 0 ? f_low : f_high) = f;
      if (std::abs(f) <= close) break;
    }
    figures_.weight = Moment{at.time, at.velocity};
    attempt(step);
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
    if (phase_ == Phase::unloading && now_.drive > 0 && pad_acceleration_ != 0)
      step = std::min(step, resolution_ * std::max(step, std::abs(pad_rate_ / pad_acceleration_)));
    if (phase_ == Phase::unloading && force_rate_ < 0)
      return std::min(step, std::max(resolution_ * step, -0.7 * now_.force / force_rate_));
    return step;
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
      pad_stiffness_ = 2 * force / y;
      if (!(step > 0.25 * longest_step(pad_stiffness_, {}, speed_))) return step;
    }
    return y / speed_;
  }

  void record(Track& track) {
    figures_.peak_pad_rate = std::max(figures_.peak_pad_rate, std::abs(pad_rate_));
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
  State now_;
  double pad_rate_ = 0;
  double pad_stiffness_ = 0;
  double stiffening_ = 1;  ///< of the pad from the step before to the last
  double force_rate_ = 0;
  double drive_rate_ = 0;
  double pad_acceleration_ = 0;
  double pad_jerk_ = 0;             ///< second divided difference
  double turning_time_ = infinity;  ///< the last
  double last_step_ = 0;
  double step_before_ = 0;
  double tried_step_ = 0;  ///< the last that was tried from the state now and had a solution; 0: none
  double tried_rate_ = 0;  ///< mean rate of the penetration over it
  Figures figures_;
};

}  // namespace dashpad
