#pragma once
/// The impactor's motion over a step, given the force at its end.
///
///   V1 = V0 - (F0 / 2 + F1 / 2 - q / 6) dt / M                                     (theory.md, Eq. 23)
///   X1 = X0 + V0 dt - (F0 / 3 + F1 / 6 - q / 12) dt^2 / M
///
/// and for gravity V1 + g dt, X1 + g dt^2 / 2. q is the curvature term of the parabola of F(t) through the
/// last three moments, 0 after an event. A sheet adds its mass and drag (impact/sheet.hpp). For a pad without
/// memory on an elastic support the mean force has exact work (theory.md, Eq. 24). The same force moves the
/// back of the pad. Compression positive; SI units.

#include <algorithm>
#include <cmath>
#include <utility>

#include "dashpad/impact/impact_case.hpp"
#include "impact/sheet.hpp"
#include "impact/trial.hpp"
#include "model/contact/contact.hpp"
#include "model/support/foundation.hpp"

namespace dashpad {

template <IsContact Contact>
class Motion {
 public:
  Motion(const Impactor& impactor, const Foundation& foundation, const Contact& contact, Sheet sheet = {})
      : mass_(impactor.mass),
        gravity_(impactor.gravity),
        foundation_(foundation),
        contact_(contact),
        sheet_(std::move(sheet)) {}

  /// Starts at first contact; `speed` in m/s, `force` in N.
  void start(double speed, double force) {
    now_ = {};
    sheet_.start();
    now_.velocity = now_.drive = speed * mass_ / moving_mass();
    now_.back.transmitted = foundation_.transmitted_at_first(force);
    deepest_ = last_step_ = mean_stiffness_ = stiffness_ = work_on_sheet_ = 0;
    is_held_ = false;
    jump_to(force);
  }
  [[nodiscard]] const State& now() const { return now_; }
  /// Largest penetration so far, m.
  [[nodiscard]] double deepest() const { return deepest_; }
  /// Rate of the force over the last step, N/s, and its length, s.
  [[nodiscard]] double force_rate() const { return force_rate_; }
  [[nodiscard]] double last_step() const { return last_step_; }

  /// Accepts the end of a step; `smooth`: the force continues from it without a kink.
  void accept(const State& end, double step, bool smooth) {
    if (sheet_.has_mass()) {
      // The work is summed step by step, since the drag jumps at the rim of a nose.
      const Sheet::Load sheet = sheet_.load(now_.penetration, end.penetration, step);
      work_on_sheet_ +=
          (sheet.drag + sheet.mass * (end.velocity - now_.velocity) / step) * (end.motion - now_.motion);
      learn_stiffness(end, step);
      sheet_.accept(contact_.contact_radius(), end.penetration < now_.penetration, step);
    }
    force_rate_ = (end.force - now_.force) / step;
    last_step_ = step;
    smooth_ = smooth;
    now_ = end;
    deepest_ = std::max(deepest_, end.penetration);
    learn_work();
  }
  /// Energy given to a sheet since first contact, without that to a flat tip's share, J.
  [[nodiscard]] double work_on_sheet() const { return work_on_sheet_; }
  void stop() { now_.velocity = 0; }
  /// Lets the back strike its stop; the nose moves on unchanged.
  void land(const BackState& back) {
    now_.back = back;
    now_.drive = now_.velocity - back.velocity();
    smooth_ = false;
  }
  /// Removes the residual of Eq. 25, which would determine the rate of a very short step.
  void close() { now_.motion = now_.penetration + now_.back.motion(); }
  /// Acceleration of the impactor under a force of the pad, m/s2.
  [[nodiscard]] double acceleration(double force) const { return (mass_ * gravity_ - force) / moving_mass(); }
  /// Lets the force jump where the nose meets foam that stayed crushed.
  void begin_crushing(double penetration, double force) {
    now_.penetration = penetration;
    jump_to(force);
  }
  /// Begins to hold the shape of the pad: what is behind it then determines the force.
  void begin_holding() {
    now_.back = foundation_.stuck(now_.back, now_.velocity);
    jump_to(foundation_.force_when_stuck(now_.back, now_.force, moving_mass(), mass_ * gravity_));
  }
  /// Fills `end`, except its drive, for a step in which the pad is held; not for a support at once.
  void stick(double step, State& end) const {
    const BackState from = foundation_.stuck(now_.back, now_.velocity);
    end.time = now_.time + step;
    end.penetration = now_.penetration;
    end.back = foundation_.after_with(from, moving_mass(), mass_ * gravity_, step);
    end.motion = now_.motion + (end.back.motion() - now_.back.motion());
    end.velocity = end.back.velocity();
    end.force = foundation_.force_when_stuck(end.back, now_.force, mass_, mass_ * gravity_);
    if (const double recoil = foundation_.recoil(end.back); recoil < 0) {
      // The back stops, and the impactor, which only pressure holds to it, leaves.
      end.velocity += recoil;
      end.force = -std::abs(end.force);
    }
  }

  /// Fills `end`, except its drive, for a trial penetration and its force; returns the residual of Eq. 25, m.
  double residual(double penetration, double force, double step, State& end) const {
    end.penetration = penetration;
    end.force = force;
    end.time = now_.time + step;
    const StepForce over = force_over(penetration, force, step);
    if (sheet_.has_mass()) [[unlikely]] {
      const Sheet::Load sheet = sheet_.load(now_.penetration, penetration, step);
      const double mass = mass_ + sheet.mass;
      move(end, over.mean + sheet.drag, over.moment + sheet.drag / 2, mass, gravity_ * mass_ / mass, step);
    } else {
      move(end, over.mean, over.moment, mass_, gravity_, step);
    }
    if (foundation_.is_plain()) return penetration + foundation_.deflection(force) - end.motion;
    end.back = foundation_.after(now_.back, over, {end.motion - now_.motion, end.velocity});
    return penetration + end.back.motion() - end.motion;
  }
  /// Force of pad and sheet that slows the impactor down, N.
  [[nodiscard]] double force_on_impactor() const {
    if (!sheet_.has_mass()) return now_.force;
    const double carried = sheet_.carried();
    return (now_.force + sheet_.drag(now_.penetration, pad_rate()) + carried * gravity_) * mass_ /
           (mass_ + carried);
  }
  /// Residual of Eq. 25 for a state filled before, m.
  [[nodiscard]] double residual(const State& end) const {
    return end.penetration +
           (foundation_.is_plain() ? foundation_.deflection(end.force) : end.back.motion()) - end.motion;
  }
  /// Travel towards the back of the pad in a step, m, at constant force or, if `unhindered`, without force.
  [[nodiscard]] double approach(double step, bool unhindered) const {
    const double force = unhindered ? 0 : now_.force;
    const double way = (now_.velocity - force * step / (2 * mass_) + gravity_ * step / 2) * step;
    if (foundation_.is_plain()) return way;
    const StepForce over{force, force, force, force / 2, step};
    const double velocity = now_.velocity - force * step / mass_ + gravity_ * step;
    return way - (foundation_.after(now_.back, over, {way, velocity}).motion() - now_.back.motion());
  }
  /// dF/dt at the end of a step, N/s.
  [[nodiscard]] double force_rate_after(double force, double step) const {
    const double rise = force - now_.force;
    return (rise + share_of_bend(step) * (rise - force_rate_ * step)) / step;
  }
  /// Magnitude of d(X1 - Xback1)/dF1, m/N, with the support's compliance at `force`.
  [[nodiscard]] double flexibility(const BackState& back, double force, double step) const {
    return foundation_.compliance(back, force, step, share_of_moment(step)) + inertial_compliance(step);
  }
  /// -dX1/dF1 of Eq. 23, m/N.
  [[nodiscard]] double inertial_compliance(double step) const {
    return step * step / mass_ * share_of_moment(step);
  }

 private:
  /// Updates dF/dY of a pad with a sheet at the end of a step; at least 0, despite rounding in short steps.
  void learn_stiffness(const State& end, double step) {
    const double advance = end.penetration - now_.penetration;
    is_held_ = advance == 0;
    const double mean = is_held_ ? mean_stiffness_ : std::max((end.force - now_.force) / advance, 0.0);
    stiffness_ = std::max(mean + share_of_bend(step) * (mean - mean_stiffness_), 0.0);
    mean_stiffness_ = mean;
  }
  /// Present dY/dt, m/s; a support at once yields as the force grows.
  [[nodiscard]] double pad_rate() const {
    if (is_held_) return 0;
    if (foundation_.kind() != Foundation::Kind::at_once) return now_.velocity - now_.back.velocity();
    const double closing = now_.velocity - now_.back.body_velocity;
    return stiffness_ > 0 ? closing / (1 + foundation_.static_compliance(now_.back, now_.force) * stiffness_)
                          : closing;
  }
  /// Mass of the impactor and of the sheet that it carries, kg.
  [[nodiscard]] double moving_mass() const { return mass_ + sheet_.carried(); }
  void move(State& end, double mean, double moment, double mass, double gravity, double step) const {
    end.velocity = now_.velocity - mean * step / mass + gravity * step;
    end.motion = now_.motion + (now_.velocity - moment * step / mass + gravity * step / 2) * step;
  }
  void jump_to(double force) {
    now_.force = force;
    force_rate_ = 0;
    smooth_ = false;
    learn_work();
  }
  /// Whether pad and support have energies that are functions of their state.
  [[nodiscard]] bool keeps_energy() const { return HasEnergy<Contact> && foundation_.is_elastic(); }
  [[nodiscard]] StepForce force_over(double penetration, double force, double step) const {
    if constexpr (HasEnergy<Contact>) {
      if (foundation_.is_elastic()) {
        const double mean = mean_force(penetration, force);
        return {now_.force, force, mean, mean / 2, step};
      }
    }
    const double rise = force - now_.force;
    const double bend = share_of_bend(step) * (rise - force_rate_ * step);
    return {now_.force, force, now_.force + rise / 2 - bend / 6, now_.force / 2 + rise / 6 - bend / 12, step};
  }
  /// Updates the travel and work of pad and support up to now, common to all trials from here.
  void learn_work() {
    if constexpr (HasEnergy<Contact>) {
      if (!foundation_.is_elastic()) return;
      way_ = now_.penetration + foundation_.deflection(now_.force);
      work_ = foundation_.elastic_energy(now_.force) + contact_.energy(now_.penetration);
    }
  }
  [[nodiscard]] double mean_force(double penetration, double force) const {
    const double way = penetration + foundation_.deflection(force);
    const double distance = way - way_;
    if (std::abs(distance) > 1e-7 * (std::abs(way) + std::abs(way_)))
      return (foundation_.elastic_energy(force) + contact_.energy(penetration) - work_) / distance;
    return (now_.force + force) / 2;
  }
  [[nodiscard]] double share_of_moment(double step) const {
    return keeps_energy() ? 0.25 : 1.0 / 6 - share_of_bend(step) / 12;
  }
  [[nodiscard]] double share_of_bend(double step) const { return smooth_ ? step / (step + last_step_) : 0; }

  double mass_;
  double gravity_;
  const Foundation& foundation_;
  const Contact& contact_;
  Sheet sheet_;
  State now_;
  double force_rate_ = 0;
  double last_step_ = 0;
  double deepest_ = 0;
  bool smooth_ = false;
  double way_ = 0;   ///< m
  double work_ = 0;  ///< J
  // For a pad with a sheet: whether it was held over the last step, and dF/dY over that step and now, N/m.
  bool is_held_ = false;
  double mean_stiffness_ = 0;
  double stiffness_ = 0;
  double work_on_sheet_ = 0;
};

}  // namespace dashpad
