#pragma once
/// The support with all its parts, which the force of the pad moves in a step (theory.md, section 5.2).
///
/// There are three kinds, in which the force determines the deflection, its rate or its acceleration: at
/// once, without mass and damper; a damper without mass; a panel with mass. Behind each there may be a free
/// body. Compression positive, SI units.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dashpad/model/support/support.hpp"
#include "dashpad/quantities/constants.hpp"

namespace dashpad {

/// State of support and body. An elastic support on the ground leaves it at 0, since the force determines it.
struct BackState {
  double deflection = 0;     ///< x, m
  double rate = 0;           ///< dx/dt, m/s
  double struck = 0;         ///< dx/dt with which the panel struck its stop in the last step, m/s, <= 0
  double body_motion = 0;    ///< xb, m
  double body_velocity = 0;  ///< m/s
  double transmitted = 0;    ///< T, N

  /// Motion of the back of the pad, m, and its velocity, m/s.
  [[nodiscard]] double motion() const { return body_motion + deflection; }
  [[nodiscard]] double velocity() const { return body_velocity + rate; }
};

/// The force over a step, N: at both ends, its mean, and its first moment about the end over the step
/// squared. A body of mass m gains the velocity mean dt / m and the distance moment dt^2 / m.
struct StepForce {
  double now = 0;
  double end = 0;
  double mean = 0;
  double moment = 0;
  double step = 0;
};

/// Travel of the impactor over a step, m, and its velocity at the end, m/s.
struct Strike {
  double way = 0;
  double velocity = 0;
};

class Foundation {
 public:
  enum class Kind { at_once, damper, panel };

  /// The support must keep the rules of violations(ImpactCase). `impactor_mass` in kg, for a loss factor.
  Foundation(const Support& support, const Backing& backing, double impactor_mass);
  Foundation(const Foundation&) = delete;
  Foundation& operator=(const Foundation&) = delete;

  /// Sets the support to rest, as left by earlier blows.
  void start();

  /// Whether it is an elastic support on the ground, which has no state but the force.
  [[nodiscard]] bool is_plain() const { return plain_; }
  /// Whether the support is elastic, without damper or panel: its energy is a function of the force.
  [[nodiscard]] bool is_elastic() const { return kind_ == Kind::at_once && !crushes_; }
  /// Whether a pad turns where its speed against its back is 0, since the force cannot move the back at once.
  [[nodiscard]] bool is_firm(const BackState& now, double force) const {
    return kind_ == Kind::panel || stands_still(now, force);
  }
  /// Whether the support does not give way at all.
  [[nodiscard]] bool stands_still(const BackState& now, double force) const {
    if (support_.is_rigid()) return true;
    const bool is_held = force < holding() && now.deflection <= stop_;
    return is_held && (kind_ != Kind::panel || (now.rate == 0 && inverse_body_ == 0));
  }
  /// Whether stopping a fully compressed pad would need an infinite force.
  [[nodiscard]] bool stops_hard() const { return support_.is_rigid() || kind_ == Kind::panel; }
  [[nodiscard]] bool crushes() const { return crushes_; }
  /// Whether the back may come after an impactor that has left the pad.
  [[nodiscard]] bool swings() const { return kind_ == Kind::panel; }
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const Backing& backing() const { return backing_; }

  /// Force of the support on a pad that strikes it with `speed`, before any deflection, N.
  [[nodiscard]] double force_at_once(double speed) const {
    return kind_ == Kind::damper ? holding() + damping_ * speed : holding();
  }

  /// Transmitted part of the pad's `force` at first contact, N; a panel takes up all but the stop's share.
  [[nodiscard]] double transmitted_at_first(double force) const {
    return kind_ == Kind::panel ? std::min(force * share_of_panel(), holding()) : force;
  }

  /// Deflection of a support at once, m.
  [[nodiscard]] double deflection(double force) const {
    return bare_ ? support_.deflection(force) : deflection_at_once(force);
  }
  /// The state at the end of a step.
  [[nodiscard]] BackState after(const BackState& now, const StepForce& force, const Strike& impactor) const;
  /// The same with an impactor of that `weight`, N, stuck to the back. Not for a support at once.
  [[nodiscard]] BackState after_with(const BackState& now, double impactor_mass, double weight,
                                     double step) const;
  /// The state as the back of the pad begins to move with an impactor of that velocity, m/s.
  [[nodiscard]] BackState stuck(const BackState& now, double velocity) const;
  /// Velocity of an impactor stuck to the back relative to it when the back strikes its stop, m/s; <= 0.
  [[nodiscard]] double recoil(const BackState& end) const { return end.struck * share_of_panel(); }
  /// The force between impactor and back, N; `force`: its value before.
  [[nodiscard]] double force_when_stuck(const BackState& now, double force, double impactor_mass,
                                        double weight) const;
  /// d(motion of the back)/dF at the end of a step, m/N. `share`: derivative of StepForce::moment by its end.
  [[nodiscard]] double compliance(const BackState& now, double force, double step, double share) const {
    return plain_ ? support_.compliance(force) : moving_compliance(now, force, step, share);
  }
  /// dx/dF of the support alone, m/N; 0 for a rigid one.
  [[nodiscard]] double static_compliance(const BackState& now, double force) const;
  /// Square of the angular frequency of the impactor on pad and support, 1/s2; `held`: the pad is stiff.
  [[nodiscard]] double square_frequency(const BackState& now, double force, double pad_stiffness, bool held,
                                        double impactor_mass) const;
  /// Square of the rate at which damper and spring settle, 1/s2, weighted by their share in `pad_rate`, m/s.
  /// It is 0 if the pad is not much softer than the spring, and settles with them.
  [[nodiscard]] double square_settling(const BackState& now, double pad_stiffness, double pad_rate) const;
  /// Speed of the back below a pad that is held still, m/s; the impactor's speed less this is the drive
  /// (theory.md, Eq. 26). `force` is that at the end of a step, N; `of_pad` and `force_rate` are force and
  /// dF/dt of the held pad, N and N/s.
  [[nodiscard]] double retreat(const BackState& end, double force, double of_pad, double force_rate) const {
    if (plain_) return support_.compliance(force) * force_rate;
    return moving_retreat(end, force, of_pad, force_rate);
  }
  /// Whether the retreat, or the growth of the rate on a damper, depends on the `force_rate` of the held pad.
  [[nodiscard]] bool follows_force_rate() const {
    return kind_ == Kind::damper || (kind_ == Kind::at_once && !support_.is_rigid());
  }
  /// Growth of the rate dY/dt = V - v_body - (F - Fs) / c of a pad on a damper where that rate is 0, times c
  /// over the first slope of Fs, m/s (theory.md, Eq. 45). `acceleration` is that of the impactor, m/s2,
  /// `force_rate` is dF/dt of the held pad, N/s.
  [[nodiscard]] double growth_of_rate(const BackState& end, double velocity, double acceleration,
                                      double force_rate) const;
  /// Makes a damper use a difference of first order, with the pad's mean rate, until a step is accepted: one
  /// of second order may overshoot where that rate falls to 0. Returns whether this is new.
  bool follow_closely() { return !std::exchange(follows_closely_, true); }
  /// Origin of the motion of an impactor relative to what it meets, m.
  [[nodiscard]] double origin(const BackState& back) const {
    return kind_ == Kind::at_once ? back.body_motion : back.motion();
  }

  /// Time until the panel reaches its stop at its present rate, s; infinite if it does not move there.
  [[nodiscard]] double time_to_stop(const BackState& now) const {
    const bool comes = kind_ == Kind::panel && std::isfinite(stop_) && now.rate < 0 && now.deflection > stop_;
    return comes ? (now.deflection - stop_) / -now.rate : infinite;
  }
  /// Lets the panel strike its stop now.
  BackState land(const BackState& now);
  /// Accepts a step; `smooth`: it did not end with an event.
  void accept(const BackState& now, const BackState& end, double force, double step, bool smooth);
  /// Whether the support is being crushed in this state; false after turn() until crushing continues.
  [[nodiscard]] bool is_crushing(const BackState& now, double force) const {
    return crushes_ && !turned_ &&
           (kind_ == Kind::at_once ? force >= yield_force_
                                   : now.deflection >= yield_ && now.deflection > stop_);
  }
  /// Begins the way back of the support.
  void turn() { turned_ = true; }

  /// Corners at which the slope of the support changes: forces for a support at once, N, else deflections, m.
  [[nodiscard]] const std::vector<double>& corners() const { return bare_ ? support_.corners() : corners_; }

  struct Energy {
    double stored = 0;   ///< stored in the support, J
    double crushed = 0;  ///< lost by crushing, J
    double damped = 0;   ///< lost in the damper and as the panel lands on its stop, J
    double moving = 0;   ///< kinetic energy of panel and body, J
  };
  [[nodiscard]] Energy energy(const BackState& now, double force) const;
  /// Energy of an elastic support, J.
  [[nodiscard]] double elastic_energy(double force) const {
    return bare_ ? support_.energy(force) : energy_of_curve(curve_deflection(force));
  }
  /// Force that holds the panel on its stop, N: the preload, or what crushing has left of it.
  [[nodiscard]] double holding() const;
  /// Lasting deflection relative to the new support, m.
  [[nodiscard]] double set() const;
  /// Largest force that the support has carried, N; 0 for one that does not crush.
  [[nodiscard]] double crushing_force() const { return crushes_ ? yield_force_ : 0; }
  /// Largest speed with which the back may come after the impactor, by the stored energy, m/s.
  [[nodiscard]] double fastest_return(const BackState& now) const;

 private:
  // The curve behind the gap, T as a function of x, without crushing.
  [[nodiscard]] double curve_force(double x) const;
  [[nodiscard]] double curve_deflection(double force) const;
  [[nodiscard]] double energy_of_curve(double x) const;
  // The same with crushing.
  [[nodiscard]] double spring(double x) const;
  [[nodiscard]] double stiffness(double x) const;
  /// x at which spring(x) + slope x = force; `slope` > 0.
  [[nodiscard]] double balanced(double slope, double force) const;

  [[nodiscard]] double deflection_at_once(double force) const;
  [[nodiscard]] double moving_compliance(const BackState& now, double force, double step, double share) const;
  [[nodiscard]] double moving_retreat(const BackState& end, double force, double of_pad,
                                      double force_rate) const;
  [[nodiscard]] BackState after_creep(const BackState& now, const StepForce& force, double ahead) const;
  [[nodiscard]] BackState after_swing(const BackState& now, const StepForce& force, double mass) const;
  [[nodiscard]] bool rests_on_stop(const BackState& back_state) const {
    return back_state.deflection <= stop_ && back_state.rate <= 0;
  }
  /// Rate of a damper as a backward difference: rate = slope x - rest, with x at the end of a step.
  struct Backward {
    double slope = 0, rest = 0;
  };
  [[nodiscard]] Backward backward(const BackState& now, double step) const;
  [[nodiscard]] BackState left_stop(const BackState& now, const StepForce& force, double leaving,
                                    double mass) const;
  /// Share of the panel's speed that it loses as it strikes its stop; the body takes over the rest.
  [[nodiscard]] double share_of_panel() const { return 1 / (1 + backing_.mass * inverse_body_); }
  [[nodiscard]] BackState landed(BackState panel) const;
  /// Energy lost by a panel that strikes its stop with a speed, J.
  [[nodiscard]] double lost_by(double speed) const {
    return speed * speed * backing_.mass * share_of_panel() / 2;
  }
  /// Deflection x above which the support has a force, without preload, m.
  [[nodiscard]] double free_way() const;
  /// Energy lost by crushing so far, J; the rest is recovered on the way back to the stop.
  [[nodiscard]] double crushed() const;
  void find_corners();

  const Support& support_;
  Backing backing_;
  Kind kind_ = Kind::at_once;
  bool crushes_ = false;
  bool bare_ = true;   ///< only the curve, without other parts but a free body
  bool plain_ = true;  ///< only the curve, on the ground
  double damping_ = 0;
  double inverse_body_ = 0;    ///< 1/Mb
  double stop_ = -infinite;    ///< x of the stop that holds the panel, m
  double offset_ = 0;          ///< deflection of the curve at rest, due to preload and set, m
  double set_before_ = 0;      ///< set left by an earlier force, m
  double yielded_before_ = 0;  ///< x behind the gap up to which that force has crushed it, m
  double crushed_before_ = 0;  ///< energy lost by crushing before this blow, J
  double yield_ = 0;           ///< largest x so far, up to which it is crushed, m
  double yield_force_ = 0;
  double damped_ = 0;  ///< energy lost in damper and landings, J
  bool turned_ = false;
  double last_deflection_ = 0;  ///< deflection before the last step, m
  double last_step_ = 0;        ///< length of the last step, s; 0 after an event
  bool follows_closely_ = false;
  std::vector<double> of_curve_;  ///< corners of the curve
  std::vector<double> corners_;   ///< corners ahead, and those that crushing moves
};

}  // namespace dashpad
