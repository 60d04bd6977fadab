#pragma once
/// Where the back of the pad goes in a step, by the force that the pad brings to bear on it: the support with
/// its backing (theory.md, section 5.2).
///
/// Three kinds: at once, a massless support without a damper, whose deflection is a function of the force; a
/// massless one with a damper, whose rate is; a panel with mass, whose acceleration is. Behind each there
/// may be a free body. Compression positive, SI units.

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "dashpad/model/support/support.hpp"
#include "dashpad/quantities/constants.hpp"

namespace dashpad {

/// Of support and body; what an elastic support on the ground leaves at 0, since it is told by the force.
struct BackState {
  double deflection = 0;     ///< x, m
  double rate = 0;           ///< dx/dt, m/s
  double struck = 0;         ///< dx/dt with which it met its stop in the last step, m/s, at most 0
  double body_motion = 0;    ///< xb, m
  double body_velocity = 0;  ///< m/s
  double transmitted = 0;    ///< T, N

  /// Of the back of the pad.
  [[nodiscard]] double motion() const { return body_motion + deflection; }
  [[nodiscard]] double velocity() const { return body_velocity + rate; }
};

/// The force over a step: at its ends, its mean, and its first moment about the end, over the step squared.
/// A body of mass m gains mean dt / m of velocity and moment dt^2 / m of way.
struct StepForce {
  double now = 0;
  double end = 0;
  double mean = 0;
  double moment = 0;
  double step = 0;
};

/// Of the impactor over a step: its way, m, and its velocity at the end, m/s.
struct Strike {
  double way = 0;
  double velocity = 0;
};

class Foundation {
 public:
  enum class Kind { at_once, damper, panel };

  /// `impactor_mass` in kg, for a loss factor. A support that keeps the rules of violations(ImpactCase).
  Foundation(const Support& support, const Backing& backing, double impactor_mass);
  Foundation(const Foundation&) = delete;
  Foundation& operator=(const Foundation&) = delete;

  /// Back to rest, as earlier blows have left it.
  void start();

  /// An elastic support on the ground: the deflection is support().deflection(force), and no state is kept.
  [[nodiscard]] bool is_plain() const { return plain_; }
  /// Elastic and without a damper or a panel's mass: what it has taken is a function of the force.
  [[nodiscard]] bool is_elastic() const { return kind_ == Kind::at_once && !crushes_; }
  /// Whether a pad turns where its speed against its back is 0, since its back is where it is, whatever the
  /// force.
  [[nodiscard]] bool is_firm(const BackState& now, double force) const {
    return kind_ == Kind::panel || stands_still(now, force);
  }
  /// Whether the back does not give way at all.
  [[nodiscard]] bool stands_still(const BackState& now, double force) const {
    if (support_.is_rigid()) return true;
    const bool is_held = force < holding() && now.deflection <= stop_;
    return is_held && (kind_ != Kind::panel || (now.rate == 0 && inverse_body_ == 0));
  }
  /// Whether a force without limit would be needed to stop a pad that is fully compressed.
  [[nodiscard]] bool stops_hard() const { return support_.is_rigid() || kind_ == Kind::panel; }
  [[nodiscard]] bool crushes() const { return crushes_; }
  /// Whether the back may come after an impactor that has left the pad.
  [[nodiscard]] bool swings() const { return kind_ == Kind::panel; }
  [[nodiscard]] Kind kind() const { return kind_; }
  [[nodiscard]] const Backing& backing() const { return backing_; }

  /// Force that meets a pad which strikes with `speed` before it has any way to go, N.
  [[nodiscard]] double force_at_once(double speed) const {
    return kind_ == Kind::damper ? holding() + damping_ * speed : holding();
  }

  /// Of the pad's `force` at first contact, N: a panel takes it up, but for what it rests on.
  [[nodiscard]] double transmitted_at_first(double force) const {
    return kind_ == Kind::panel ? std::min(force * share_of_panel(), holding()) : force;
  }

  /// m, of a support at once.
  [[nodiscard]] double deflection(double force) const {
    return bare_ ? support_.deflection(force) : deflection_at_once(force);
  }
  /// The end of a step.
  [[nodiscard]] BackState after(const BackState& now, const StepForce& force, const Strike& impactor) const;
  /// The same where an impactor sticks to the back; `weight` of it presses, N. Not for a support at once.
  [[nodiscard]] BackState after_with(const BackState& now, double impactor_mass, double weight,
                                     double step) const;
  /// The state in which an impactor with a velocity has the back of the pad move with it.
  [[nodiscard]] BackState stuck(const BackState& now, double velocity) const;
  /// What an impactor that sticks to the back gains on it, m/s, where that strikes its stop: it goes on.
  [[nodiscard]] double recoil(const BackState& end) const { return end.struck * share_of_panel(); }
  /// The force between the two, N; `force` is what it was before.
  [[nodiscard]] double force_when_stuck(const BackState& now, double force, double impactor_mass,
                                        double weight) const;
  /// d(motion of the back)/dF at the end of a step, m/N. `share` is that of the force's moment.
  [[nodiscard]] double compliance(const BackState& now, double force, double step, double share) const {
    return plain_ ? support_.compliance(force) : moving_compliance(now, force, step, share);
  }
  /// dx/dF as the support alone has it, m/N; of a rigid one, 0.
  [[nodiscard]] double static_compliance(const BackState& now, double force) const;
  /// Square of the momentary frequency of an impactor and what it swings on, 1/s2. Held: the pad is stiff.
  [[nodiscard]] double square_frequency(const BackState& now, double force, double pad_stiffness, bool held,
                                        double impactor_mass) const;
  /// Square of the rate at which a damper and its spring settle, 1/s2, by the share that they have in the
  /// `pad_rate`, m/s. A pad that is not much softer than the spring settles with them, and it is 0.
  [[nodiscard]] double square_settling(const BackState& now, double pad_stiffness, double pad_rate) const;
  /// Speed by which the back outruns a pad that is held still, but for that of the impactor: theory.md, Eq.
  /// 26. `force` is that at the end of a step, `of_pad` and `force_rate` are what the pad carries and loses
  /// while it is held, N and N/s.
  [[nodiscard]] double retreat(const BackState& end, double force, double of_pad, double force_rate) const {
    if (plain_) return support_.compliance(force) * force_rate;
    return moving_retreat(end, force, of_pad, force_rate);
  }
  /// Of the rate of a pad on a damper, dY/dt = V - v_body - (F - Fs) / c, were it 0: how fast it grows with
  /// the `acceleration` of the impactor, m/s2, and what the pad gains in force while it is held, N/s; times
  /// the time of damper and support, m/s.
  [[nodiscard]] double growth_of_rate(const BackState& end, double velocity, double acceleration,
                                      double force_rate) const;
  /// Until a step is taken a damper goes along with the impactor but for the mean rate of the pad, which a
  /// backward difference of second order may overshoot where the rate comes down to 0. Whether that is new.
  bool follow_closely() { return !std::exchange(follows_closely_, true); }
  /// From where the motion of an impactor is counted that meets the back of the pad, m.
  [[nodiscard]] double origin(const BackState& back) const {
    return kind_ == Kind::at_once ? back.body_motion : back.motion();
  }

  /// How long the panel takes to its stop if it goes on as it does, s; without end if it does not go there.
  [[nodiscard]] double time_to_stop(const BackState& now) const {
    const bool comes = kind_ == Kind::panel && std::isfinite(stop_) && now.rate < 0 && now.deflection > stop_;
    return comes ? (now.deflection - stop_) / -now.rate : infinite;
  }
  /// It strikes its stop now.
  BackState land(const BackState& now);
  /// Takes a step; `smooth`: it did not end with an event.
  void accept(const BackState& now, const BackState& end, double force, double step, bool smooth);
  /// Whether the support is being crushed further in this state; not after turn() until it is again.
  [[nodiscard]] bool is_crushing(const BackState& now, double force) const {
    return crushes_ && !turned_ &&
           (kind_ == Kind::at_once ? force >= yield_force_
                                   : now.deflection >= yield_ && now.deflection > stop_);
  }
  /// It comes back from here.
  void turn() { turned_ = true; }

  /// Where the slope of the support changes: forces of a support at once, else deflections.
  [[nodiscard]] const std::vector<double>& corners() const { return bare_ ? support_.corners() : corners_; }

  struct Energy {
    double stored = 0;   ///< in the support, J
    double crushed = 0;  ///< lost by crushing
    double damped = 0;   ///< by the damper, and where the panel lands on its stop
    double moving = 0;   ///< kinetic, of panel and body
  };
  [[nodiscard]] Energy energy(const BackState& now, double force) const;
  /// Of an elastic support, J.
  [[nodiscard]] double elastic_energy(double force) const {
    return bare_ ? support_.energy(force) : energy_of_curve(curve_deflection(force));
  }
  /// Force with which the panel is held on its stop, N: the preload, or what crushing has left of it.
  [[nodiscard]] double holding() const;
  /// Deflection that stays, from the support as it was when new, m.
  [[nodiscard]] double set() const;
  /// Largest force that the support has carried, N; 0 where that leaves nothing.
  [[nodiscard]] double crushing_force() const { return crushes_ ? yield_force_ : 0; }
  /// With which the back may come after the impactor at the most, by what is stored, m/s.
  [[nodiscard]] double fastest_return(const BackState& now) const;

 private:
  // The curve from where it lies at rest, behind the gap: T over x.
  [[nodiscard]] double curve_force(double x) const;
  [[nodiscard]] double curve_deflection(double force) const;
  [[nodiscard]] double energy_of_curve(double x) const;
  // And with what was crushed of it.
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
  [[nodiscard]] bool rests_on_stop(const BackState& of) const {
    return of.deflection <= stop_ && of.rate <= 0;
  }
  /// Of the damper's rate, by the deflection at the end of a step: rate = slope x - rest.
  struct Backward {
    double slope = 0, rest = 0;
  };
  [[nodiscard]] Backward backward(const BackState& now, double step) const;
  [[nodiscard]] BackState left_stop(const BackState& now, const StepForce& force, double leaving,
                                    double mass) const;
  /// Of the speed with which the panel strikes its stop, what it loses: the rest is the body's then.
  [[nodiscard]] double share_of_panel() const { return 1 / (1 + backing_.mass * inverse_body_); }
  [[nodiscard]] BackState landed(BackState panel) const;
  /// J, by a panel that strikes its stop with a speed.
  [[nodiscard]] double lost_by(double speed) const {
    return speed * speed * backing_.mass * share_of_panel() / 2;
  }
  /// Way of the panel behind which the support carries it, if no preload is left, m.
  [[nodiscard]] double free_way() const;
  /// Lost for good up to now, J: the rest comes back on the way to the stop.
  [[nodiscard]] double crushed() const;
  void find_corners();

  const Support& support_;
  Backing backing_;
  Kind kind_ = Kind::at_once;
  bool crushes_ = false;
  bool bare_ = true;   ///< the curve alone
  bool plain_ = true;  ///< and no body behind
  double damping_ = 0;
  double inverse_body_ = 0;    ///< 1/Mb
  double stop_ = -infinite;    ///< x at which a stop holds the panel, m
  double offset_ = 0;          ///< deflection of the curve at rest, by the preload or an earlier force, m
  double set_before_ = 0;      ///< by an earlier force, m
  double yielded_before_ = 0;  ///< x behind the gap up to which that has crushed it, m
  double crushed_before_ = 0;  ///< J
  double yield_ = 0;           ///< x up to which it has been crushed, m
  double yield_force_ = 0;
  double damped_ = 0;  ///< J
  bool turned_ = false;
  double last_deflection_ = 0;  ///< before the last step
  double last_step_ = 0;        ///< 0: after an event
  bool follows_closely_ = false;
  std::vector<double> of_curve_;  ///< its corners
  std::vector<double> corners_;   ///< those that are ahead, and those that crushing moves
};

}  // namespace dashpad
