#include "model/support/foundation.hpp"

#include <cmath>

#include "dashpad/quantities/constants.hpp"

namespace dashpad {
namespace {

/// Number of corners beside those of the curve: at the stop, at force 0, and where crushing continues.
constexpr std::size_t other_corners = 3;
/// Relative distance below which two corners count as one.
constexpr double same_corner = 1e-6;

Foundation::Kind kind_of(const Support& support, const Backing& backing) {
  if (support.is_rigid()) return Foundation::Kind::at_once;
  if (backing.mass > 0) return Foundation::Kind::panel;
  return backing.damping > 0 || backing.loss_factor > 0 ? Foundation::Kind::damper
                                                        : Foundation::Kind::at_once;
}

}  // namespace

Foundation::Foundation(const Support& support, const Backing& backing, double impactor_mass)
    : support_(support),
      backing_(backing),
      kind_(kind_of(support, backing)),
      crushes_(backing.unloading_stiffness > 0 && !support.is_rigid()),
      bare_(kind_ == Kind::at_once && !crushes_ && !(backing.preload > 0)),
      plain_(bare_ && !(backing.body_mass > 0)),
      damping_(backing.damping),
      inverse_body_(backing.body_mass > 0 ? 1 / backing.body_mass : 0) {
  if (bare_) return;
  if (backing.loss_factor > 0)
    damping_ = backing.loss_factor * std::sqrt((impactor_mass + backing.mass) / support.compliance(0));
  offset_ = support.deflection(backing.preload);
  if (crushes_ && backing.earlier_force > backing.preload) {
    const double back = backing.earlier_force / backing.unloading_stiffness;
    yielded_before_ = support.deflection(backing.earlier_force) - offset_;
    set_before_ = std::max(yielded_before_ - back, 0.0);
    // A remaining preload still holds the panel on its stop; else the panel stands where the set has left it.
    if (set_before_ > 0) yielded_before_ = back;
    offset_ += set_before_;
  }
  if (backing.preload > 0) stop_ = 0 - set_before_;
  for (const double force : support_.corners())
    if (force > std::max(backing_.preload, backing_.earlier_force))
      of_curve_.push_back(kind_ == Kind::at_once ? force : curve_deflection(force));
  corners_.reserve(of_curve_.size() + other_corners);
}

void Foundation::start() {
  yield_ = backing_.gap + yielded_before_;
  yield_force_ = std::max(backing_.preload, backing_.earlier_force);
  crushed_before_ = crushed();
  damped_ = 0;
  turned_ = false;
  last_step_ = 0;
  follows_closely_ = false;
  find_corners();
}

void Foundation::find_corners() {
  const bool at_once = kind_ == Kind::at_once;
  const bool is_crushed = crushes_ && yield_ > backing_.gap;
  const double front = at_once ? yield_force_ : yield_;
  corners_.clear();
  if (at_once) {
    if (holding() > 0) corners_.push_back(holding());
  } else {
    if (std::isfinite(stop_)) corners_.push_back(stop_);
    if (!(holding() > 0)) corners_.push_back(free_way());
  }
  if (is_crushed) corners_.push_back(front);
  // Corners of the curve that lie behind are passed along the line of unloading.
  for (const double corner : of_curve_)
    if (!is_crushed || corner > (1 + same_corner) * front) corners_.push_back(corner);
}

// ---------------------------------------------------------------- the curve

double Foundation::curve_force(double x) const { return support_.force(offset_ + (x - backing_.gap)); }

double Foundation::curve_deflection(double force) const {
  return force <= curve_force(backing_.gap) ? backing_.gap
                                            : backing_.gap + (support_.deflection(force) - offset_);
}

double Foundation::energy_of_curve(double x) const {
  if (x <= backing_.gap) return 0;
  return support_.energy(curve_force(x)) - support_.energy(curve_force(backing_.gap));
}

double Foundation::spring(double x) const {
  if (crushes_ && x < yield_)
    return std::max(yield_force_ - backing_.unloading_stiffness * (yield_ - x), 0.0);
  return curve_force(x);
}

double Foundation::stiffness(double x) const {
  if (crushes_ && x < yield_) return spring(x) > 0 ? backing_.unloading_stiffness : 0;
  return x < backing_.gap ? 0 : 1 / support_.compliance(curve_force(x));
}

double Foundation::holding() const {
  if (!(backing_.preload > 0)) return 0;
  return crushes_ ? std::max(yield_force_ - backing_.unloading_stiffness * (yield_ - stop_), 0.0)
                  : backing_.preload;
}

double Foundation::free_way() const {
  return crushes_ ? yield_ - yield_force_ / backing_.unloading_stiffness : backing_.gap;
}

double Foundation::set() const {
  return crushes_ ? set_before_ + std::max(free_way() - backing_.gap, 0.0) : 0;
}

double Foundation::crushed() const {
  if (!crushes_) return 0;
  const double held = holding();
  return energy_of_curve(yield_) -
         (yield_force_ * yield_force_ - held * held) / (2 * backing_.unloading_stiffness);
}

double Foundation::balanced(double slope, double force) const {
  const double gap = backing_.gap;
  if (crushes_ && force < yield_force_ + slope * yield_) {
    const double x = force <= slope * free_way()
                         ? force / slope
                         : (force - yield_force_ + backing_.unloading_stiffness * yield_) /
                               (slope + backing_.unloading_stiffness);
    return std::max(x, stop_);
  }
  const double at_rest = holding() + slope * gap;
  if (force <= at_rest) return std::max(std::min(force / slope, gap), stop_);
  return gap + (support_.balanced(slope, force - slope * gap + slope * offset_) - offset_);
}

// ---------------------------------------------------------------- a step

double Foundation::deflection_at_once(double force) const {
  if (crushes_ && force < yield_force_)
    return std::max(yield_ - (yield_force_ - std::max(force, 0.0)) / backing_.unloading_stiffness, 0.0);
  return curve_deflection(force);
}

BackState Foundation::after(const BackState& now, const StepForce& force, const Strike& impactor) const {
  if (kind_ == Kind::panel) return after_swing(now, force, backing_.mass);
  const double body_way = (now.body_velocity + inverse_body_ * force.moment * force.step) * force.step;
  const double body_velocity = now.body_velocity + inverse_body_ * force.mean * force.step;
  BackState end = now;
  if (kind_ == Kind::damper) {
    const bool follows = follows_closely_ && now.deflection > stop_;
    const double ahead = impactor.velocity - body_velocity - (impactor.way - body_way) / force.step;
    end = after_creep(now, force, follows ? ahead : 0);
  } else {
    end.deflection = deflection(force.end);
  }
  end.body_motion += body_way;
  end.body_velocity = body_velocity;
  end.transmitted = force.end;
  return end;
}

/// Backward difference, of second order after a smooth step: creep that steps do not resolve dies out.
Foundation::Backward Foundation::backward(const BackState& now, double step) const {
  if (last_step_ == 0 || follows_closely_) return {1 / step, now.deflection / step};
  const double w = step / last_step_;
  return {(1 + 2 * w) / ((1 + w) * step),
          ((1 + w) * now.deflection - w * w / (1 + w) * last_deflection_) / step};
}

BackState Foundation::after_creep(const BackState& now, const StepForce& force, double ahead) const {
  Backward rate = backward(now, force.step);
  rate.rest -= ahead;
  BackState end = now;
  end.struck = 0;
  end.deflection = balanced(damping_ * rate.slope, force.end + damping_ * rate.rest);
  end.rate = rate.slope * end.deflection - rate.rest;
  return end;
}

BackState Foundation::after_with(const BackState& now, double impactor_mass, double weight,
                                 double step) const {
  return after_swing(now, {weight, weight, weight, weight / 2, step}, backing_.mass + impactor_mass);
}

BackState Foundation::stuck(const BackState& now, double velocity) const {
  BackState back = now;
  if (kind_ == Kind::damper) {
    back.rate = velocity - now.body_velocity;
    back.transmitted = spring(now.deflection) + damping_ * back.rate;
  }
  return back;
}

double Foundation::force_when_stuck(const BackState& now, double force, double impactor_mass,
                                    double weight) const {
  if (kind_ == Kind::at_once) return std::max(force, holding());
  return (weight * backing_.mass + impactor_mass * now.transmitted) / (impactor_mass + backing_.mass);
}

/// Moves panel and body by the average of the support's force and the moments of the pad's (section 5.2).
BackState Foundation::after_swing(const BackState& now, const StepForce& force, double mass) const {
  const double dt = force.step;
  const double inverse_mass = 1 / mass;
  if (rests_on_stop(now)) {
    // Body and panel move as one until the panel leaves the stop.
    const double leaving = holding() * (1 + mass * inverse_body_);
    if (force.end <= leaving) {
      const double share = inverse_body_ / (1 + mass * inverse_body_);
      BackState end = now;
      end.rate = end.struck = 0;
      end.body_motion += (now.body_velocity + share * force.moment * dt) * dt;
      end.body_velocity += share * force.mean * dt;
      end.transmitted = force.end / (1 + mass * inverse_body_);
      return end;
    }
    if (force.now < leaving) return left_stop(now, force, leaving, mass);
  }
  const double inverse = inverse_mass + inverse_body_;
  const double slowed = 1 / (1 + inverse * damping_ * dt / 2);
  const double free_rate =
      slowed * (now.rate + dt * (force.mean * inverse_mass - inverse * now.transmitted / 2));
  const double free_way =
      now.deflection + dt * (now.rate + dt * (force.moment * inverse_mass -
                                              inverse / 4 * (now.transmitted + damping_ * free_rate)));
  const double give = dt * dt * inverse / 4 * slowed;  // derivative of the deflection by the spring's force
  BackState end;
  end.deflection = balanced(1 / give, free_way / give);
  const double pushed = spring(end.deflection);
  end.rate = free_rate - slowed * dt * inverse / 2 * pushed;
  end.transmitted = pushed + damping_ * end.rate;
  const double sum = now.transmitted + end.transmitted;
  end.body_motion = now.body_motion + dt * (now.body_velocity + dt * inverse_body_ * sum / 4);
  end.body_velocity = now.body_velocity + dt * inverse_body_ * sum / 2;
  return end.deflection <= stop_ ? landed(end) : end;
}

/// The state after the panel has struck its stop: it moves on with the body.
BackState Foundation::landed(BackState panel) const {
  panel.deflection = stop_;
  panel.struck = std::min(panel.rate, 0.0);
  panel.body_velocity += panel.struck * (1 - share_of_panel());
  panel.rate = 0;
  panel.transmitted = spring(stop_);
  return panel;
}

BackState Foundation::land(const BackState& now) {
  const BackState end = landed(now);
  damped_ += lost_by(end.struck);
  last_step_ = 0;
  return end;
}

/// A step within which the panel leaves its stop, as the force passes `leaving`.
BackState Foundation::left_stop(const BackState& now, const StepForce& force, double leaving,
                                double mass) const {
  const double before = force.step * (leaving - force.now) / (force.end - force.now);
  const auto line = [](double from, double to, double step) {
    return StepForce{from, to, (from + to) / 2, from / 3 + to / 6, step};
  };
  const BackState then = after_swing(now, line(force.now, leaving, before), mass);
  return after_swing(then, line(leaving, force.end, force.step - before), mass);
}

double Foundation::static_compliance(const BackState& now, double force) const {
  if (bare_) return support_.compliance(force);
  if (kind_ != Kind::at_once) {
    const double slope = stiffness(now.deflection);
    return slope > 0 ? 1 / slope : infinite;
  }
  if (force < holding()) return 0;
  if (crushes_ && (force < yield_force_ || (turned_ && force <= yield_force_)))
    return 1 / backing_.unloading_stiffness;
  return support_.compliance(force);
}

double Foundation::moving_compliance(const BackState& now, double force, double step, double share) const {
  if (kind_ == Kind::at_once) return static_compliance(now, force) + inverse_body_ * step * step * share;
  if (kind_ == Kind::damper)
    return 1 / (stiffness(now.deflection) + damping_ * backward(now, step).slope) +
           inverse_body_ * step * step * share;
  const double inverse_mass = 1 / backing_.mass;
  const double inverse = inverse_mass + inverse_body_;
  const double give = step * step * inverse / 4 / (1 + inverse * damping_ * step / 2);
  return step * step * share * inverse_mass / (1 + give * stiffness(now.deflection));
}

double Foundation::square_frequency(const BackState& now, double force, double pad_stiffness, bool held,
                                    double impactor_mass) const {
  const double free = 1 / impactor_mass + inverse_body_;
  if (kind_ == Kind::at_once) {
    double compliance = static_compliance(now, force);
    if (held && compliance == 0) compliance = support_.compliance(backing_.preload);
    if (held) return compliance > 0 ? free / compliance : 0;
    return free / (1 / pad_stiffness + compliance);
  }
  const double spring = stiffness(now.deflection);
  // Below a stiff pad it is the damper that slows the impactor down.
  if (kind_ == Kind::damper)
    return (held ? spring : std::min(pad_stiffness, std::max(spring, damping_ * damping_ * free))) * free;
  if (held) return spring * (1 / (impactor_mass + backing_.mass) + inverse_body_);
  return pad_stiffness / impactor_mass + (pad_stiffness + spring) / backing_.mass + spring * inverse_body_;
}

double Foundation::square_settling(const BackState& now, double pad_stiffness, double pad_rate) const {
  if (kind_ != Kind::damper || pad_rate == 0) return 0;
  const double spring = stiffness(now.deflection);
  const double of_back = std::abs(now.rate), of_pad = std::abs(pad_rate);
  const double beyond = spring * of_back - 2 * pad_stiffness * std::max(of_back, of_pad);
  if (!(beyond > 0)) return 0;
  return spring * std::min(beyond / of_pad, spring) / (damping_ * damping_);
}

double Foundation::moving_retreat(const BackState& end, double force, double of_pad,
                                  double force_rate) const {
  switch (kind_) {
    case Kind::at_once: return end.body_velocity + static_compliance(end, force) * force_rate;
    case Kind::damper: {
      const double rate = (of_pad - spring(end.deflection)) / damping_;
      return end.body_velocity + (end.deflection <= stop_ ? std::max(rate, 0.0) : rate);
    }
    case Kind::panel: break;
  }
  return end.velocity();
}

double Foundation::growth_of_rate(const BackState& end, double velocity, double acceleration,
                                  double force_rate) const {
  const double of_masses = damping_ * (acceleration - inverse_body_ * end.transmitted);
  const double of_springs = stiffness(end.deflection) * (velocity - end.body_velocity) - force_rate;
  return (of_masses + of_springs) * support_.compliance(0);
}

void Foundation::accept(const BackState& now, const BackState& end, double force, double step, bool smooth) {
  if (bare_) return;
  if (kind_ != Kind::at_once) {
    const double rate = end.rate + end.struck;
    damped_ += damping_ * step * (now.rate * now.rate + now.rate * rate + rate * rate) / 3;
    damped_ += lost_by(end.struck);
    last_deflection_ = now.deflection;
    last_step_ = smooth ? step : 0;
    follows_closely_ = false;
  }
  const bool at_once = kind_ == Kind::at_once;
  if (!crushes_ || !(at_once ? force > yield_force_ : end.deflection > yield_)) return;
  yield_ = end.deflection;
  yield_force_ = at_once ? force : curve_force(yield_);
  turned_ = false;
  find_corners();
}

// ---------------------------------------------------------------- energy

Foundation::Energy Foundation::energy(const BackState& now, double force) const {
  if (bare_ && inverse_body_ == 0) return {.stored = support_.energy(force)};
  Energy energy;
  energy.damped = damped_;
  const double x = kind_ == Kind::at_once ? deflection(force) : now.deflection;
  if (crushes_) {
    const double left = spring(x);
    const double held = holding();
    energy.stored = (left * left - held * held) / (2 * backing_.unloading_stiffness);
    energy.crushed = crushed() - crushed_before_;
  } else {
    energy.stored = support_.is_rigid() ? 0 : bare_ ? support_.energy(force) : energy_of_curve(x);
  }
  if (inverse_body_ > 0) energy.moving += backing_.body_mass * now.body_velocity * now.body_velocity / 2;
  if (kind_ == Kind::panel) energy.moving += backing_.mass * now.velocity() * now.velocity() / 2;
  return energy;
}

double Foundation::fastest_return(const BackState& now) const {
  if (kind_ != Kind::panel) return 0;
  const double inverse = 1 / backing_.mass + inverse_body_;
  const double fastest = std::sqrt(2 * energy(now, 0).stored * inverse + now.rate * now.rate);
  if (inverse_body_ == 0) return fastest;
  // The swing is about the common centre of gravity.
  const double share = 1 / (1 + backing_.mass * inverse_body_);
  return share * fastest - (now.body_velocity + (1 - share) * now.rate);
}

}  // namespace dashpad
