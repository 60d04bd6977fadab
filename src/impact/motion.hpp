#pragma once
/// The impactor's motion over a step, given the force at its end.
///
///   V1 = V0 - (F0 / 2 + F1 / 2 - q / 6) dt / M                                     (theory.md, Eq. 23)
///   X1 = X0 + V0 dt - (F0 / 3 + F1 / 6 - q / 12) dt^2 / M
///
/// q is the bend of the parabola of F(t) through the last three moments, 0 after an event. For a pad without
/// memory the mean force is the one whose work is exact (theory.md, Eq. 24). Compression positive; SI units.

#include <cmath>

#include "dashpad/model/support/support.hpp"
#include "impact/trial.hpp"
#include "model/contact/contact.hpp"

namespace dashpad {

template <IsContact Contact>
class Motion {
 public:
  Motion(double mass, const Support& support) : mass_(mass), support_(support) {}

  /// `force`: at first contact, N.
  void start(double speed, double force) {
    now_ = {};
    now_.velocity = now_.drive = speed;
    now_.force = force;
    force_rate_ = last_step_ = 0;
    smooth_ = false;
  }
  [[nodiscard]] const State& now() const { return now_; }
  /// Of the last step, N/s and s.
  [[nodiscard]] double force_rate() const { return force_rate_; }
  [[nodiscard]] double last_step() const { return last_step_; }

  /// Takes the end of a step; `smooth`: the force goes on from it without a kink.
  void accept(const State& end, double step, bool smooth) {
    force_rate_ = (end.force - now_.force) / step;
    last_step_ = step;
    smooth_ = smooth;
    now_ = end;
  }
  void stop() { now_.velocity = 0; }

  /// Fills `end`, but for its drive, for a trial penetration and its force; returns the residual of Eq. 25,
  /// m.
  double residual(const Contact& contact, double penetration, double force, double step, State& end) const {
    const double motion = penetration + support_.deflection(force);
    end.penetration = penetration;
    end.force = force;
    end.time = now_.time + step;
    if constexpr (HasEnergy<Contact>) {
      end.velocity = now_.velocity - mean_force(contact, penetration, force, motion) * step / mass_;
      end.motion = now_.motion + (now_.velocity + end.velocity) / 2 * step;
    } else {
      const double rise = force - now_.force;
      const double bend = share_of_bend(step) * (rise - force_rate_ * step);
      end.velocity = now_.velocity - (now_.force + rise / 2 - bend / 6) * step / mass_;
      end.motion =
          now_.motion + (now_.velocity - (now_.force / 2 + rise / 6 - bend / 12) * step / mass_) * step;
    }
    return motion - end.motion;
  }
  /// How far the impactor goes in a step under the force that it meets now, m.
  [[nodiscard]] double travel(double step) const {
    return (now_.velocity - now_.force * step / (2 * mass_)) * step;
  }
  /// -dX1/dF1 of Eq. 23.
  [[nodiscard]] double inertial_compliance(double step) const {
    return step * step / mass_ * (HasEnergy<Contact> ? 0.25 : 1.0 / 6 - share_of_bend(step) / 12);
  }

 private:
  double mean_force(const Contact& contact, double penetration, double force, double motion) const {
    const double distance = motion - now_.motion;
    if (std::abs(distance) > 1e-7 * (std::abs(motion) + std::abs(now_.motion)))
      return (support_.energy(force) - support_.energy(now_.force) + contact.energy(penetration) -
              contact.energy(now_.penetration)) /
             distance;
    return (now_.force + force) / 2;
  }
  [[nodiscard]] double share_of_bend(double step) const { return smooth_ ? step / (step + last_step_) : 0; }

  double mass_;
  const Support& support_;
  State now_;
  double force_rate_ = 0;
  double last_step_ = 0;
  bool smooth_ = false;
};

}  // namespace dashpad
