#include "oracle/any_impact.hpp"

#include <array>
#include <memory>
#include <stdexcept>
#include <vector>

#include "answers/processor_time.hpp"
#include "oracle/footing.hpp"
#include "oracle/ode_session.hpp"
#include "oracle/pads.hpp"
#include "oracle/pulse_track.hpp"

namespace dashpad::oracle {
namespace {

constexpr double longest = 10;  ///< s

/// The largest value of a function that is known at moments: where it is smooth, the vertex of the last
/// three.
class Largest {
 public:
  void add(double time, double value) {
    if (known_ > 0 && time <= time_[2]) return;
    time_ = {time_[1], time_[2], time}, value_ = {value_[1], value_[2], value};
    known_ = std::min(known_ + 1, 3);
    most_ = std::fmax(most_, value);
    if (known_ < 3 || !(value_[1] >= value_[0] && value_[1] >= value_[2])) return;
    const double a = time_[0] - time_[1], b = time_[2] - time_[1];
    const double by_a = (value_[0] - value_[1]) / a, by_b = (value_[2] - value_[1]) / b;
    const double curve = (by_b - by_a) / (b - a), rise = by_a - curve * a;
    const double above = -rise * rise / (4 * curve);
    if (curve < 0 && above < 1e-3 * value_[1]) most_ = std::fmax(most_, value_[1] + above);
  }
  /// After a jump of its slope.
  void start_anew() { known_ = 0; }
  [[nodiscard]] double most() const { return most_; }

 private:
  std::array<double, 3> time_{}, value_{};
  int known_ = 0;
  double most_ = 0;
};

class Impact final : public OdeSystem {
 public:
  Impact(const ImpactCase& impact, double deepest, const AnyOptions& options)
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
        stands_(kind_ != Kind::at_once && of_.preload > 0),
        crushes_on_(footing_.beyond(0) >= 0) {
    if (pad_->needs_speed() && kind_ == Kind::at_once && !footing_.is_rigid())
      throw std::invalid_argument("oracle: laws 4 and 5 on an elastic support only below a sphere");
    // Turned, they hardly move at first, by the tenth power of the time, which no step follows.
    if (pad_->needs_speed() && kind_ == Kind::damper)
      throw std::invalid_argument("oracle: laws 4 and 5 on a damper without mass are not covered");
    if (stands_ && kind_ == Kind::panel && of_.body_mass > 0)
      throw std::invalid_argument("oracle: a panel under preload on a free body is not covered");
  }

  /// The penetration that is reached, roughly: on what does not move, once the impactor comes back.
  double way_in() {
    comes_back_ = false;
    return run().peak_penetration;
  }

  AnyImpact run() {
    std::vector<double> begin(memory + pad_->unknowns(), 0.0);
    begin[motion] = origin_ = found_ = pad_->begin(begin.data() + memory, speed_);
    begin[velocity] = speed_ * mass_ / (mass_ + sheet_ * pad_->nose().tip);
    const bool is_stiff = begin.size() < 40 || kind_ != Kind::at_once;
    OdeSession session(*this, is_stiff ? Method::bdf_dense : Method::adams_fixed, 0, begin);
    note(0, session.state());
    const double begun = test::processor_seconds();
    while (session.time() < longest && session.steps() < options_.most_steps &&
           test::processor_seconds() - begun < options_.most_seconds && session.step()) {
      const double* state = session.state();
      note(session.time(), state);
      if (session.at_event() && !react(session)) break;
      if (!comes_back_ && kind_ == Kind::at_once && state[velocity] < -0.2 * speed_) break;
      if (!touches_ && has_left(state)) {
        answer_.ending = AnyImpact::Ending::released;
        break;
      }
    }
    const double* state = session.state();
    // Pressed on by its weight, an impactor may never leave.
    if (answer_.ending == AnyImpact::Ending::failed && gravity_ > 0 && touches_ &&
        std::fabs(state[velocity]) < 1e-2 * speed_)
      answer_.ending = AnyImpact::Ending::at_rest;
    if (answer_.ending == AnyImpact::Ending::released) {
      answer_.absorbed = absorbed(state);
      answer_.hic15 = pulse_.hic(0.015), answer_.hic36 = pulse_.hic(0.036);
    }
    answer_.steps = session.steps();
    answer_.peak_force = force_.most();
    answer_.peak_motion = motion_.most();
    answer_.peak_penetration = penetration_.most();
    answer_.peak_transmitted = transmitted_.most();
    answer_.peak_deflection = deflection_.most();
    answer_.set = footing_.set();
    answer_.body_speed = state[body_velocity];
    return answer_;
  }

  bool derivative(double time, const double* state, double* slope) override {
    const Now now = at(state);
    if (!(now.y < pad_->thickness() && now.pad.force < 1e14)) return false;
    slope[motion] = state[velocity];
    slope[velocity] = acceleration(state, now);
    slope[deflection] = kind_ == Kind::at_once ? 0 : now.rate;
    slope[rate] = kind_ != Kind::panel || stands_
                      ? 0
                      : (now.pad.force - now.behind) / of_.mass - now.behind * inverse_body();
    slope[body] = state[body_velocity];
    slope[body_velocity] = now.behind * inverse_body();
    slope[damped] = kind_ == Kind::at_once ? 0 : footing_.damping() * now.rate * now.rate;
    const double closing = pad_->needs_speed() ? closing_speed(state, now) : 0;
    pad_->rates(now.y, closing, time, state + memory, slope + memory);
    return true;
  }
  void allowances(const double* state, double* allowance) override {
    const double relative = options_.relative;
    for (const std::size_t way : {motion, deflection, body})
      allowance[way] = relative * (std::fabs(state[way]) + 1e-2 * pad_->thickness());
    for (const std::size_t velocity_of : {velocity, rate, body_velocity})
      allowance[velocity_of] = relative * (std::fabs(state[velocity_of]) + 1e-2 * speed_);
    allowance[damped] = relative * mass_ * speed_ * speed_;
    pad_->allowances(relative, allowance + memory);
  }
  [[nodiscard]] int event_count() const override { return event_number; }
  void events(double, const double* state, double* values) override {
    const Now now = at(state);
    const double closing = closing_speed(state, now);
    const double shown = shown_force(state, now);
    const bool goes_back = closing < 0;
    values[event_top] = state[velocity];
    values[event_turning] = pad_->is_loading() ? closing : 1;
    values[event_again] = pad_->is_loading() ? -1 : now.y - pad_->largest() - slack();
    values[event_weight] = state[velocity] < 0 && touches_ ? shown - mass_ * standard_gravity : 1;
    values[event_contact_end] = goes_back && touches_ ? shown - contact_end_share * force_.most() : 1;
    values[event_release] = touches_ && !goes_back ? 1 : now.pad.most;
    values[event_bottom] = pad_->thickness() * (1 - least_gap()) - now.y;
    const double giving =
        kind_ == Kind::at_once ? state[velocity] - state[body_velocity] - closing : now.rate;
    values[event_yield] = !footing_.crushes() ? 1
                          : crushes_on_       ? giving + 1e-9 * speed_
                                              : footing_.beyond(now.x) - slack();
    values[event_stop] = of_.preload == 0 || kind_ == Kind::at_once ? 1
                         : stands_                                  ? now.pad.force - footing_.force(0)
                                                                    : now.x;
  }

 private:
  enum class Kind { at_once, damper, panel };
  enum : std::size_t { motion, velocity, deflection, rate, body, body_velocity, damped, memory };
  enum : std::size_t {
    event_top,
    event_turning,
    event_again,
    event_weight,
    event_contact_end,
    event_release,
    event_bottom,
    event_yield,
    event_stop,
    event_number
  };
  struct Now {
    double y = 0, x = 0, rate = 0;  ///< penetration, deflection of the support and its rate
    double behind = 0;              ///< T
    Pressed pad;
  };

  /// Of the thickness: with less the pad counts as closed. By Eq. 29 on what yields at once and with columns
  /// that remember, else, where the force has no finite value then, as near as CVODE comes.
  [[nodiscard]] double least_gap() const {
    return kind_ == Kind::at_once && (!footing_.is_rigid() || pad_->unknowns() > 1) ? 1e-9 : 1e-7;
  }
  /// A length of rounding.
  [[nodiscard]] double slack() const { return 1e-10 * pad_->thickness(); }
  [[nodiscard]] double inverse_body() const { return of_.body_mass > 0 ? 1 / of_.body_mass : 0; }
  [[nodiscard]] Pressed pressed(double y, const double* state) const {
    return pad_->pressed(y, state + memory, sheet_ > 0);
  }

  Now at(const double* state) {
    Now now;
    const double way = state[motion] - state[body];
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
    const double full = pad_->thickness() * (1 - least_gap() / 2);
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
  [[nodiscard]] double closing_speed(const double* state, const Now& now) const {
    const double approach = state[velocity] - state[body_velocity];
    if (kind_ != Kind::at_once) return approach - now.rate;
    if (footing_.is_rigid() || now.x <= 0) return approach;
    const double little = pad_->little();
    std::vector<double> slope(pad_->unknowns()), later(state, state + memory + slope.size()), sooner = later;
    pad_->rates(now.y, approach, 0, state + memory, slope.data());
    for (std::size_t i = 0; i < slope.size(); ++i) {
      later[memory + i] += little / speed_ * slope[i];
      sooner[memory + i] -= little / speed_ * slope[i];
    }
    const double by_time =
        (pressed(now.y, later.data()).force - pressed(now.y, sooner.data()).force) / (2 * little / speed_);
    const double by_way =
        (pressed(now.y + little, state).force - pressed(now.y - little, state).force) / (2 * little);
    const double stiffness = footing_.slope(now.x);
    return (stiffness * approach - by_time) / (stiffness + std::fmax(by_way, 0));
  }

  /// Eq. 76; without a sheet Eq. 1.
  [[nodiscard]] double acceleration(const double* state, const Now& now) const {
    const double force = std::fmax(now.pad.force, 0);
    if (sheet_ == 0) return gravity_ - force / mass_;
    double drag = 0;
    if (now.y >= pad_->largest() && now.y > 0 && now.y < pad_->nose().end) {
      const double closing = std::fmax(closing_speed(state, now), 0);
      drag = sheet_ * pad_->nose().widening(now.y) * closing * closing;
    }
    return (mass_ * gravity_ - force - drag) / (mass_ + sheet_ * now.pad.area);
  }
  [[nodiscard]] double shown_force(const double* state, const Now& now) const {
    return mass_ * (gravity_ - acceleration(state, now));
  }

  void note(double time, const double* state) {
    const Now now = at(state);
    const double shown = shown_force(state, now);
    force_.add(time, shown);
    pulse_.add(time, gravity_ * time - state[velocity], shown / mass_);
    transmitted_.add(time, now.behind);
    motion_.add(time, state[motion] - origin_);
    penetration_.add(time, now.y);
    deflection_.add(time, now.x);
    pad_->reached(now.y, state + memory);
    if (now.y < pad_->largest() - slack()) pad_->set_loading(false);
    if (crushes_on_) footing_.reached(now.x);
  }

  /// What happens at an event; false where the run ends.
  bool react(OdeSession& session) {
    double* state = session.state();
    const auto& crossed = session.crossings();
    const Moment moment{session.time(), state[velocity]};
    const Now now = at(state);
    bool changed = false;
    if (crossed[event_bottom] < 0) {
      answer_.bottomed = moment;
      answer_.ending = AnyImpact::Ending::bottomed_out;
      return false;
    }
    if (crossed[event_weight] < 0) answer_.force_below_weight = moment;
    if (crossed[event_contact_end] < 0) answer_.contact_end = moment;
    if (crossed[event_turning] < 0 && pad_->holds() && footing_.is_rigid() && of_.body_mass == 0) {
      answer_.force_below_weight = Moment{moment.time, 0};
      answer_.ending = AnyImpact::Ending::released;
      return false;
    }
    if (crossed[event_turning] < 0 && pad_->is_loading()) {
      pad_->reached(now.y, state + memory);
      pad_->set_loading(false);
      pad_->turned(now.y, state + memory);
      changed = true;
    }
    if (crossed[event_again] > 0 && !pad_->is_loading()) pad_->set_loading(true), changed = true;
    if (crossed[event_yield] != 0) {
      if (crushes_on_) footing_.reached(now.x);
      crushes_on_ = !crushes_on_;
      changed = true;
    }
    if (crossed[event_stop] != 0) {
      struck_ += of_.mass * state[rate] * state[rate] / 2;
      state[deflection] = state[rate] = 0;
      // What strikes the stop under more than the preload leaves it again.
      stands_ = !stands_ && !(now.pad.force > footing_.force(0));
      changed = true;
    }
    if (crossed[event_release] != 0) {
      touches_ = crossed[event_release] > 0;
      if (!touches_) pad_->left();
      // Of a release alone only the last counts.
      if (touches_ && answer_.force_below_weight && answer_.force_below_weight->velocity > 0)
        answer_.force_below_weight.reset();
      if (!touches_) answer_.rebound_speed = std::fmax(-state[velocity], 0);
      if (!touches_ && !answer_.force_below_weight) answer_.force_below_weight = moment;
      changed = true;
    }
    if (!changed) return true;
    for (Largest* of : {&force_, &transmitted_, &motion_, &penetration_, &deflection_}) of->start_anew();
    session.restart();
    return true;
  }

  /// Of the impact energy, what the pad has taken.
  [[nodiscard]] double absorbed(const double* state) {
    const Now now = at(state);
    const auto moving = [](double mass, double speed) { return mass * speed * speed / 2; };
    const double elsewhere = moving(mass_, state[velocity]) + moving(of_.body_mass, state[body_velocity]) +
                             moving(of_.mass, now.rate + state[body_velocity]) + footing_.taken(now.x) +
                             state[damped] + struck_ - mass_ * gravity_ * (state[motion] - origin_);
    return 1 - elsewhere / moving(mass_, speed_);
  }

  /// Nothing that the panel still may do brings it to the impactor again.
  [[nodiscard]] bool has_left(const double* state) const {
    if (kind_ != Kind::panel) return true;
    const double away = state[body_velocity] - state[velocity];
    const double moves = state[rate] * state[rate] + 2 * footing_.energy_left(state[deflection]) / of_.mass;
    return stands_ ? away > 0 : away > 0 && away * away >= moves;
  }

  AnyOptions options_;
  double mass_, speed_, gravity_, sheet_;
  Backing of_;
  Footing footing_;
  std::unique_ptr<PadModel> pad_;
  Kind kind_;
  bool stands_;      ///< the panel, against its stop
  bool crushes_on_;  ///< further than ever
  bool touches_ = true;
  bool comes_back_ = true;  ///< is followed on the way back
  double found_ = 0, origin_ = 0;
  double struck_ = 0;  ///< lost by the panel on its stop, J
  PulseTrack pulse_;
  Largest force_, transmitted_, motion_, penetration_, deflection_;
  AnyImpact answer_;
};

}  // namespace

AnyImpact solve_any(const ImpactCase& impact, const AnyOptions& options) {
  double deepest = impact.pad.thickness;
  // Columns at fixed depths are laid to the depth that is reached.
  const PadLaw& law = impact.pad.material.law;
  const bool by_columns =
      std::holds_alternative<ViscoelasticFoam>(law) || std::holds_alternative<LinearViscoelastic>(law) ||
      std::holds_alternative<NineParameter>(law) || std::holds_alternative<TwentyOneParameter>(law);
  AnyOptions rough = options;
  rough.relative = 1e-5;
  if (by_columns && impact.pad.layers.empty())
    deepest = std::fmin(1.02 * Impact(impact, deepest, rough).way_in(), deepest);
  return Impact(impact, deepest, options).run();
}

}  // namespace dashpad::oracle
