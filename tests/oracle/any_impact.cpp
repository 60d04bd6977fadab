#include "oracle/any_impact.hpp"

#include <memory>
#include <stdexcept>
#include <vector>

#include "answers/processor_time.hpp"
#include "oracle/any_motion.hpp"
#include "oracle/largest.hpp"
#include "oracle/ode_session.hpp"
#include "oracle/outline.hpp"
#include "oracle/pulse_track.hpp"

namespace dashpad::oracle {
namespace {

constexpr double longest = 10;  ///< s

class Impact final : public AnyMotion {
 public:
  using AnyMotion::AnyMotion;

  /// The penetration that is reached, roughly: on what does not move, once the impactor comes back.
  double way_in() {
    comes_back_ = false;
    return run().peak_penetration;
  }

  AnyImpact run() {
    std::vector<double> begin(memory_ + pad_->unknowns(), 0.0);
    begin[motion] = origin_ = found_ = pad_->begin(begin.data() + memory_, speed_);
    begin[velocity] = speed_ * mass_ / (mass_ + sheet_ * pad_->nose().tip);
    const double first = creeps_ ? just_after_contact(begin) : by_log_ ? origin_ / speed_ : 0;
    const bool is_stiff = begin.size() < 40 || kind_ != Kind::at_once || pad_->needs_speed();
    auto session = std::make_unique<OdeSession>(*this, is_stiff ? Method::bdf_dense : Method::adams_fixed,
                                                by_log_ ? std::log(first) : first, begin);
    note(first, session->state());
    const double begun = test::processor_seconds();
    double time = first;
    while (time < longest && session->steps() < options_.max_steps &&
           test::processor_seconds() - begun < options_.max_seconds && session->step()) {
      time = time_at(session->time());
      note(time, session->state());
      if (session->at_event() && !react(time, *session)) break;
      if (!anew_.empty()) {  // other unknowns from here on
        anew_.insert(anew_.begin(), session->state(), session->state() + memory_);
        by_log_ = false;
        if (creeps_ && !turn_back(time, anew_.data())) break;
        answer_.steps += session->steps();
        session = std::make_unique<OdeSession>(*this, Method::adams_fixed, time, anew_);
        anew_.clear();
      }
      const double* state = session->state();
      if (!comes_back_ && kind_ == Kind::at_once && state[velocity] < -0.2 * speed_) break;
      if (!touches_ && still_waited_for(state) <= 0) {
        answer_.ending = AnyImpact::Ending::released;
        break;
      }
    }
    const double* state = session->state();
    // Pressed on by its weight, an impactor may never leave.
    if (answer_.ending == AnyImpact::Ending::failed && gravity_ > 0 && touches_ &&
        std::fabs(state[velocity]) < 1e-2 * speed_)
      answer_.ending = AnyImpact::Ending::at_rest;
    if (answer_.ending == AnyImpact::Ending::released) {
      answer_.absorbed = absorbed(time, state);
      answer_.hic15 = pulse_.hic(0.015), answer_.hic36 = pulse_.hic(0.036);
    }
    answer_.steps += session->steps();
    answer_.peak_force = force_.most();
    answer_.peak_motion = motion_.most();
    answer_.peak_penetration = penetration_.most();
    answer_.peak_transmitted = transmitted_.most();
    answer_.peak_deflection = deflection_.most();
    answer_.set = footing_.set();
    answer_.body_speed = state[body_velocity];
    return answer_;
  }

  [[nodiscard]] int event_count() const override { return event_number; }
  void events(double clock, const double* state, double* values) override {
    const Now now = at(time_at(clock), state);
    const double closing = closing_speed(state, now);
    const double shown = shown_force(state, now);
    const bool goes_back = closing < 0;
    values[event_top] = state[velocity];
    values[event_turning] = is_going_on() ? closing_drive(state, now, closing) : 1;
    values[event_again] = pad_->is_loading() ? -1 : now.y - pad_->largest() - slack();
    values[event_weight] = state[velocity] < 0 && touches_ ? shown - mass_ * standard_gravity : 1;
    values[event_contact_end] = goes_back && touches_ ? shown - contact_end_share * force_.most() : 1;
    values[event_release] = touches_ && !goes_back ? 1 : now.pad.most;
    values[event_bottom] = pad_->thickness() * (1 - min_gap()) - now.y;
    const double giving = kind_ == Kind::at_once ? approach(state) - closing : now.rate;
    values[event_yield] = !footing_.crushes() ? 1
                          : crushes_on_       ? giving + 1e-9 * speed_
                                              : footing_.beyond(now.x) - slack();
    values[event_stop] = of_.preload == 0 || (kind_ == Kind::at_once && !creeps_) ? 1
                         : stands_ ? now.pad.force - footing_.force(0)
                                   : now.x;
    values[event_up] = creeps_ && !stands_ && is_on_curve() ? footing_.up(piece_, now.x) + slack() : 1;
    values[event_down] = creeps_ && !stands_ && is_on_curve() ? footing_.down(piece_, now.x) + slack() : 1;
    values[event_parting] = touches_ ? 1 : still_waited_for(state);
    values[event_slow] = 1;
    if (pad_->has_rates() && kind_ == Kind::damper && !stands_)
      values[event_slow] = !creeps_ ? (pad_->is_loading() ? closing / speed_ - slow : 1)
                                    : std::log(2 * slow * speed_) - state[log_speed];
  }

 private:
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
    event_slow,
    event_up,
    event_down,
    event_parting,
    event_number
  };
  void note(double time, const double* state) {
    const Now now = at(time, state);
    const double shown = shown_force(state, now);
    force_.add(time, shown);
    pulse_.add(time, gravity_ * time - state[velocity], shown / mass_);
    transmitted_.add(time, now.behind);
    // What leaves a pad on a free body may go on behind it for good.
    if (touches_) motion_.add(time, state[motion] - origin_);
    penetration_.add(time, now.y);
    deflection_.add(time, now.x);
    pad_->reached(now.y, state + memory_);
    if (now.y < pad_->largest() - slack()) pad_->set_loading(false);
    if (crushes_on_) footing_.reached(now.x);
  }

  /// What happens at an event; false where the run ends.
  bool react(double time, OdeSession& session) {
    double* state = session.state();
    const auto& crossed = session.crossings();
    const Moment moment{time, state[velocity]};
    const Now now = at(time, state);
    bool changed = false;
    if (crossed[event_parting] < 0) {
      answer_.ending = AnyImpact::Ending::released;
      return false;
    }
    if (crossed[event_bottom] < 0) {
      answer_.bottomed = moment;
      answer_.ending = AnyImpact::Ending::bottomed_out;
      return false;
    }
    if (crossed[event_weight] < 0 && !answer_.force_below_weight) answer_.force_below_weight = moment;
    if (crossed[event_contact_end] < 0) answer_.contact_end = moment;
    if (crossed[event_turning] < 0 && pad_->holds() && footing_.is_rigid() && of_.body_mass == 0) {
      answer_.force_below_weight = Moment{moment.time, 0};
      answer_.ending = AnyImpact::Ending::released;
      return false;
    }
    if (crossed[event_turning] < 0 && is_going_on()) {
      pad_->reached(now.y, state + memory_);
      pad_->set_loading(false);
      anew_ = pad_->turned(now.y, state + memory_);
      if (anew_.empty() && creeps_ && !turn_back(time, state)) return false;
      changed = true;
    }
    if (crossed[event_up] < 0) ++piece_, changed = true;
    if (crossed[event_down] < 0) --piece_, changed = true;
    if (crossed[event_slow] != 0) change_pace(now, state), changed = true;
    if (crossed[event_again] > 0 && !pad_->is_loading()) pad_->set_loading(true), changed = true;
    if (crossed[event_yield] != 0) {
      if (crushes_on_) footing_.reached(now.x);
      crushes_on_ = !crushes_on_;
      piece_ = footing_.piece(now.x);
      changed = true;
    }
    if (stands_ ? crossed[event_stop] > 0 : crossed[event_stop] < 0) {
      struck_ += of_.mass * state[rate] * state[rate] / 2;
      state[deflection] = state[rate] = 0;
      // What strikes the stop under more than the preload leaves it again.
      stands_ = !stands_ && (kind_ == Kind::at_once || !(now.pad.force > footing_.force(0)));
      if (creeps_) state[depth] = now.y, piece_ = footing_.piece(0);
      if (creeps_ && !stands_) pace_.load(std::fmax(approach(state), 1e-3 * speed_));
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
    for (Largest* largest : {&force_, &transmitted_, &motion_, &penetration_, &deflection_})
      largest->start_anew();
    session.restart();
    return true;
  }

  /// Of the impact energy, what the pad has taken.
  [[nodiscard]] double absorbed(double time, const double* state) {
    const Now now = at(time, state);
    const auto moving = [](double mass, double speed) { return mass * speed * speed / 2; };
    const double elsewhere = moving(mass_, state[velocity]) + moving(of_.body_mass, state[body_velocity]) +
                             moving(of_.mass, now.rate + state[body_velocity]) + footing_.taken(now.x) +
                             state[damped] + struck_ - mass_ * gravity_ * (state[motion] - origin_);
    return 1 - elsewhere / moving(mass_, speed_);
  }

  /// m/s; at 0 nothing that the panel still may do brings it to the impactor again, nor does it still go
  /// away. Panel and body swing about their centre of gravity, undamped at most.
  [[nodiscard]] double still_waited_for(const double* state) const {
    if (kind_ != Kind::panel) return 0;
    const double of_body = of_.body_mass > 0 ? of_.body_mass / (of_.mass + of_.body_mass) : 1;
    const double centre = state[body_velocity] + (1 - of_body) * state[rate];
    if (stands_) return state[velocity] - centre;
    const double swing = std::sqrt(state[rate] * state[rate] +
                                   2 * footing_.energy_left(state[deflection]) / (of_.mass * of_body));
    return std::fmax(state[velocity] - (centre - of_body * swing), state[rate]);
  }

  bool touches_ = true;
  bool comes_back_ = true;  ///< is followed on the way back
  double origin_ = 0;
  std::vector<double> anew_;
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
  rough.relative = 1e-5, rough.max_seconds /= 4;
  const bool has_side = outline_of(impact.impactor.nose, impact.pad.area).end > 0;
  if (impact.pad.layers.empty() ? by_columns : has_side) {
    const double reached = Impact(impact, deepest, rough).way_in();
    deepest = std::fmin(1.02 * reached, (reached + deepest) / 2);
  }
  AnyOptions last = options;
  if (!impact.pad.layers.empty() && has_side)  // many columns with kinks
    last.relative *= 100, last.max_steps *= 4;
  AnyImpact answer = Impact(impact, deepest, last).run();
  // Between columns the edge of the contact on the way back is known to 1e-4 of the impact energy only.
  if (!impact.pad.layers.empty() && has_side) answer.absorbed.reset();
  return answer;
}

}  // namespace dashpad::oracle
