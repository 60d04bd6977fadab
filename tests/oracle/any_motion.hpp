#pragma once
/// What moves in the general oracle (any_impact.hpp): its unknowns and their rates.

#include <algorithm>
#include <cmath>
#include <memory>
#include <stdexcept>
#include <vector>

#include "oracle/any_impact.hpp"
#include "oracle/footing.hpp"
#include "oracle/ode_session.hpp"
#include "oracle/pace.hpp"
#include "oracle/pads.hpp"

namespace dashpad::oracle {

class AnyMotion : public OdeSystem {
 public:
  AnyMotion(const ImpactCase& impact, double deepest, const AnyOptions& options)
      : options_(options),
        mass_(impact.impactor.mass),
        speed_(impact.impactor.speed),
        gravity_(impact.impactor.gravity),
        sheet_(impact.pad.sheet),
        of_(impact.backing),
        footing_(impact.support, impact.backing, impact.impactor.mass),
        pad_(pad_model(impact, deepest, options.fineness)),
        kind_(footing_.is_rigid() || (of_.mass == 0 && footing_.damping() == 0) ? Kind::at_once
              : of_.mass > 0                                                    ? Kind::panel
                                                                                : Kind::damper),
        memory_(pad_->has_rates() ? log_speed + 1 : depth),
        creeps_(pad_->has_rates() && kind_ == Kind::at_once && !footing_.is_rigid()),
        stands_((kind_ != Kind::at_once || creeps_) && of_.preload > 0),
        crushes_on_(footing_.beyond(0) >= 0),
        by_log_(pad_->has_rates()),
        pace_(*pad_, speed_) {
    // Layers on what has neither mass nor damper: on a damper that does not count.
    if (pad_->needs_speed() && !creeps_ && kind_ == Kind::at_once && !footing_.is_rigid()) {
      footing_.set_damping(1e-6 * footing_.slope_of(0) * pad_->thickness() / speed_);
      kind_ = Kind::damper;
      stands_ = of_.preload > 0;
    }
    if (stands_ && kind_ == Kind::panel && of_.body_mass > 0)
      throw std::invalid_argument("oracle: a panel under preload on a free body is not covered");
  }

  bool derivative(double clock, const double* state, double* slope) override {
    const double time = time_at(clock);
    const Now now = at(time, state);
    if (!(now.y < pad_->thickness() && now.pad.force < 1e14)) return false;
    const double closing = pad_->needs_speed() ? closing_speed(state, now) : 0;
    slope[motion] = state[velocity];
    slope[velocity] = acceleration(state, now);
    slope[deflection] = kind_ == Kind::at_once ? 0 : now.rate;
    if (pad_->has_rates()) slope[depth] = creeps_ ? closing : 0;
    if (pad_->has_rates())
      slope[log_speed] =
          creeps_ && kind_ == Kind::damper && !is_in_balance(state)
              ? pace_.way() *
                    pace_.surplus(state[log_speed], pace_.way(), gain(state, now), support_slope()) /
                    (footing_.damping() * std::fabs(closing))
              : 0;
    slope[rate] = kind_ != Kind::panel || stands_
                      ? 0
                      : (now.pad.force - now.behind) / of_.mass - now.behind * inverse_body();
    slope[body] = state[body_velocity];
    slope[body_velocity] = now.behind * inverse_body();
    slope[damped] = kind_ == Kind::at_once ? 0 : footing_.damping() * now.rate * now.rate;
    pad_->rates(now.y, closing, time, state + memory_, slope + memory_);
    for (std::size_t i = 0; by_log_ && i < memory_ + pad_->unknowns(); ++i) slope[i] *= time;
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    const double relative = options_.relative;
    for (const std::size_t way : {motion, deflection, body})
      allowance[way] = relative * (std::fabs(state[way]) + 1e-2 * pad_->thickness());
    for (const std::size_t velocity_of : {velocity, rate, body_velocity})
      allowance[velocity_of] = relative * (std::fabs(state[velocity_of]) + 1e-2 * speed_);
    if (pad_->has_rates()) {
      const double gap = std::fmax(pad_->thickness() - state[depth], 0);
      allowance[motion] = relative * std::fabs(state[motion]) + 1e-12 * pad_->thickness();
      allowance[depth] = relative * std::fmin(std::fabs(state[depth]), gap) + 1e-12 * pad_->thickness();
      allowance[log_speed] = 10 * relative;
    }
    allowance[damped] = relative * mass_ * speed_ * speed_;
    pad_->allowances(relative, state + memory_, allowance + memory_);
  }

 protected:
  enum class Kind { at_once, damper, panel };
  enum : std::size_t {
    motion,
    velocity,
    deflection,
    rate,
    body,
    body_velocity,
    damped,
    depth,      ///< penetration, where the pad creeps
    log_speed,  ///< and of its speed on a damper
  };
  static constexpr double slow = 1e-3;  ///< of the impact speed, from where on a pad on a damper creeps
  struct Now {
    double time = 0;
    double y = 0, x = 0, rate = 0;  ///< penetration, deflection of the support and its rate
    double behind = 0;              ///< T
    Pressed pad = {};
  };

  /// Of the thickness: with less the pad counts as closed. By Eq. 29 on what yields at once and with columns
  /// that remember, else, where the force has no finite value then, as near as CVODE comes.
  [[nodiscard]] double min_gap() const {
    return kind_ == Kind::at_once && (!footing_.is_rigid() || pad_->unknowns() > 1) ? 1e-9 : 1e-7;
  }
  [[nodiscard]] double time_at(double clock) const { return by_log_ ? std::exp(clock) : clock; }
  /// A length of rounding.
  [[nodiscard]] double slack() const { return 1e-10 * pad_->thickness(); }
  [[nodiscard]] double inverse_body() const { return of_.body_mass > 0 ? 1 / of_.body_mass : 0; }
  [[nodiscard]] Pressed pressed(double y, const double* state) const {
    return pad_->pressed(y, state + memory_, sheet_ > 0);
  }

  [[nodiscard]] static double approach(const double* state) { return state[velocity] - state[body_velocity]; }

  Now at(double time, const double* state) {
    Now now{.time = time};
    const double way = state[motion] - state[body];
    if (creeps_) {
      now.y = stands_ ? way : state[depth];
      now.x = way - now.y;
      now.pad = pressed(now.y, state);
      now.behind = now.pad.force;
      now.rate = stands_                 ? 0
                 : kind_ == Kind::damper ? approach(state) - pace_.way() * std::exp(state[log_speed])
                                         : 0;
      pad_->prepare(now.y, time, state + memory_);
      return now;
    }
    if (kind_ == Kind::at_once) {
      now.y = footing_.is_rigid() ? way : found_ = balanced(way, state);
      now.x = way - now.y;
      now.pad = pressed(now.y, state);
      now.behind = now.pad.force;
      return now;
    }
    now.x = state[deflection];
    now.y = way - now.x;
    now.pad = pressed(now.y, state);
    const double spring = footing_.force(now.x);
    if (kind_ == Kind::damper) {
      now.rate = stands_ ? 0 : (now.pad.force - spring) / footing_.damping();
      now.behind = now.pad.force;
    } else {
      now.rate = stands_ ? 0 : state[rate];
      now.behind = stands_ ? now.pad.force : spring + footing_.damping() * now.rate;
    }
    return now;
  }

  /// The penetration at which the pad carries what a massless support gives.
  [[nodiscard]] double balanced(double way, const double* state) const {
    const auto surplus = [&](double y) { return pressed(y, state).force - footing_.force(way - y); };
    if (surplus(way) <= 0) return way;
    const double full = pad_->thickness() * (1 - min_gap() / 2);
    double high = std::min(std::min(found_, full), way), low = high, stride = 1e-7 * pad_->thickness();
    double f_high = surplus(high), f_low = f_high;
    if (f_high > 0)
      for (; f_low > 0; stride *= 4) high = low, f_high = f_low, low -= stride, f_low = surplus(low);
    else
      for (; f_high < 0 && high < full; stride *= 4)
        low = high, f_low = f_high, high = std::min({high + stride, full, way}), f_high = surplus(high);
    double y = high;
    for (int i = 0, side = 0; i < 100 && high - low > 1e-15 * pad_->thickness(); ++i) {  // rule of Illinois
      y = f_high == f_low || i % 8 == 7 ? (low + high) / 2 : (low * f_high - high * f_low) / (f_high - f_low);
      const double f = surplus(y);
      if (f == 0) break;
      double& other = f < 0 ? f_high : f_low;
      (f < 0 ? low : high) = y;
      (f < 0 ? f_low : f_high) = f;
      const int now = f < 0 ? -1 : 1;
      if (side == now) other /= 2;
      side = now;
    }
    return y;
  }

  /// dY/dt; on a massless support from d(F - Fs)/dt = 0.
  [[nodiscard]] double closing_speed(const double* state, const Now& now) {
    const double approach = AnyMotion::approach(state);
    if (creeps_ && !stands_ && (kind_ == Kind::at_once || is_in_balance(state)))
      return pace_.balanced(gain(state, now), support_slope());
    if (kind_ != Kind::at_once || stands_) return approach - now.rate;
    if (footing_.is_rigid() || now.x <= 0) return approach;
    const double little = pad_->little();
    std::vector<double> slope(pad_->unknowns()), later(state, state + memory_ + slope.size()), sooner = later;
    pad_->rates(now.y, approach, 0, state + memory_, slope.data());
    for (std::size_t i = 0; i < slope.size(); ++i) {
      later[memory_ + i] += little / speed_ * slope[i];
      sooner[memory_ + i] -= little / speed_ * slope[i];
    }
    const double by_time =
        (pressed(now.y, later.data()).force - pressed(now.y, sooner.data()).force) / (2 * little / speed_);
    const double by_way =
        (pressed(now.y + little, state).force - pressed(now.y - little, state).force) / (2 * little);
    const double stiffness = footing_.slope(now.x);
    return (stiffness * approach - by_time) / (stiffness + std::fmax(by_way, 0));
  }

  /// On a damper, so slow that it follows the balance at once.
  [[nodiscard]] bool is_in_balance(const double* state) const {
    return kind_ == Kind::damper && pace_.way() > 0 && state[log_speed] < std::log(1e-11 * speed_);
  }
  [[nodiscard]] bool is_on_curve() const { return crushes_on_ || !footing_.crushes(); }
  /// The slope of the support the way it goes, N/m.
  [[nodiscard]] double support_slope() const {
    return is_on_curve() ? footing_.slope_of(piece_) : of_.unloading_stiffness;
  }
  /// What the support's force gains while the pad is held, N/s.
  [[nodiscard]] double gain(const double* state, const Now& now) {
    const double by_way = support_slope() * approach(state);
    if (kind_ == Kind::at_once) return by_way;
    return by_way + footing_.damping() * (acceleration(state, now) - now.behind * inverse_body());
  }
  /// Whether the pad may turn.
  [[nodiscard]] bool is_going_on() const {
    return creeps_ && !stands_ ? pace_.way() > 0 : pad_->is_loading();
  }
  /// Falls to 0 where it does.
  [[nodiscard]] double closing_drive(const double* state, const Now& now, double closing) {
    if (!creeps_ || stands_) return closing;
    const double drive = pace_.drive(gain(state, now));
    if (kind_ == Kind::at_once) return drive;
    return std::fmax(drive / footing_.slope_of(0), std::exp(state[log_speed])) - 1e-9 * speed_;
  }

  /// Where a pad in balance is pressed no longer; false where it finds no way back.
  bool turn_back(double time, double* state) {
    if (stands_) return true;
    if (crushes_on_ && footing_.crushes()) {
      footing_.reached(at(time, state).x);
      crushes_on_ = approach(state) > 0;
      piece_ = footing_.piece(at(time, state).x);
    }
    const Now now = at(time, state);
    if (kind_ == Kind::at_once) return pace_.turn(gain(state, now), support_slope(), 10 * speed_);
    pace_.set_way(-1);
    state[log_speed] = std::log(1e-10 * speed_);
    return true;
  }
  /// On a damper: from where the speed is that of what moves to where it is one of balance, or back.
  void change_pace(const Now& now, double* state) {
    creeps_ = !creeps_;
    if (!creeps_) {
      state[deflection] = now.x;
      return;
    }
    state[depth] = now.y;
    piece_ = footing_.piece(now.x);
    state[log_speed] = std::log(slow * speed_);
    pace_.set_way(1);
  }

  /// A pad in balance from an instant after first contact on; returns the time, s.
  double just_after_contact(std::vector<double>& begin) {
    const double y = 1e-9 * pad_->thickness();
    begin[depth] = y;
    double time = y / speed_, speed = speed_;
    pace_.load(speed_);
    piece_ = footing_.piece(0);
    for (int i = 0; i < 30; ++i) {
      static_cast<void>(pad_->begin(begin.data() + memory_, speed));
      const double force = pad_->pressed(y, begin.data() + memory_, false).force;
      begin[motion] = y + (stands_ ? 0 : footing_.deflection_at(force));
      time = begin[motion] / speed_;
      const Now now = at(time, begin.data());
      speed = std::fmax(closing_speed(begin.data(), now), 1e-30 * speed_);
    }
    return time;
  }

  /// Eq. 56; without a sheet Eq. 1.
  [[nodiscard]] double acceleration(const double* state, const Now& now) {
    const double force = std::fmax(now.pad.force, 0);
    if (sheet_ == 0) return gravity_ - force / mass_;
    double drag = 0;
    if (now.y >= pad_->largest() && now.y > 0 && now.y < pad_->nose().end) {
      const bool by_damper = kind_ == Kind::damper;
      const double closing = std::fmax(by_damper ? approach(state) - now.rate : closing_speed(state, now), 0);
      drag = sheet_ * pad_->nose().widening(now.y) * closing * closing;
    }
    return (mass_ * gravity_ - force - drag) / (mass_ + sheet_ * now.pad.area);
  }
  [[nodiscard]] double shown_force(const double* state, const Now& now) {
    return mass_ * (gravity_ - acceleration(state, now));
  }

  AnyOptions options_;
  double mass_, speed_, gravity_, sheet_;
  Backing of_;
  Footing footing_;
  std::unique_ptr<PadModel> pad_;
  Kind kind_;
  std::size_t memory_;     ///< where what the pad remembers begins
  std::size_t piece_ = 0;  ///< of the support's curve, where the pad creeps
  bool creeps_;            ///< as fast as keeps a pad of law 4 or 5 in balance
  bool stands_;            ///< the panel, against its stop
  bool crushes_on_;        ///< further than ever
  /// What is integrated over is the logarithm of the time: near first contact all happens on its scale.
  bool by_log_;
  Pace pace_;
  double found_ = 0;  ///< penetration, at the last call
};

}  // namespace dashpad::oracle
