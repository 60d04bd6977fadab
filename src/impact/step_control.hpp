#pragma once
/// The limits of a step's length, each by its name (theory.md, section 4, Step length).
///
/// Times in s, lengths in m, stiffness in N/m.

#include <algorithm>
#include <cmath>

#include "dashpad/impact/solution.hpp"
#include "dashpad/model/nose/sections.hpp"
#include "dashpad/quantities/constants.hpp"
#include "impact/motion.hpp"
#include "impact/numerics.hpp"
#include "impact/predictor.hpp"
#include "model/support/foundation.hpp"

namespace dashpad {

/// The last turn of the nose against the back of the pad.
struct LastTurn {
  double elapsed = 0;   ///< time since then, s; below 0 if there was none
  bool is_now = false;  ///< no time has passed since then
};

class StepControl {
 public:
  /// `follows_rate`: the pad's contact does, as that of a foam given by its curves.
  StepControl(double mass, const Sections& nose, double thickness, const Foundation& foundation,
              bool follows_rate)
      : mass_(mass),
        nose_(nose),
        share_of_side_(1 - nose.tip / nose.area_beyond()),
        thickness_(thickness),
        foundation_(foundation),
        follows_rate_(follows_rate) {}

  /// Starts a run; `lock`: penetration at which the pad locks, m.
  void start(double resolution, double lock) {
    resolution_ = resolution;
    lock_ = lock;
    largest_force_ = 0;
    usual_ = infinite;
  }

  /// The first step, short against what the pad's stiffness over it allows; sets `pad_stiffness` to that,
  /// N/m. `force_of(penetration, step)` is the growth of the pad's force, limited to `max_force`, N.
  template <class ForceOf>
  [[nodiscard]] double first_step(Phase phase, double speed, double max_force, ForceOf&& force_of,
                                  double& pad_stiffness) const {
    double y = resolution_ * std::min(thickness_, widening(0));
    for (int i = 0; i < numerics.max_first_halvings; ++i, y /= 2) {
      const double step = y / speed;
      const double force = force_of(y, step);
      pad_stiffness = 2 * force / y;
      if (force > max_force && i < numerics.max_halvings) continue;
      if (!(step > numerics.first_step * longest(phase, {}, pad_stiffness, speed))) return step;
    }
    return y / speed;
  }

  /// The longest step from a state that resolves the momentary oscillation, the strain and the closing gap.
  [[nodiscard]] double longest(Phase phase, const State& state, double pad_stiffness, double pad_rate) const {
    if (phase == Phase::flight)
      return std::min(oscillation_limit(phase, state, 0, 0), resolution_ * thickness_ / std::abs(pad_rate));
    double step = oscillation_limit(phase, state, pad_stiffness, pad_rate);
    if (phase != Phase::held && pad_rate != 0)
      step = std::min({step, strain_limit(state, pad_rate), gap_limit(state, pad_stiffness, pad_rate)});
    return step;
  }
  [[nodiscard]] double longest(Phase phase, const Trial& trial) const {
    return longest(phase, trial.end, trial.stiffness_to_resolve(), trial.pad_rate());
  }
  [[nodiscard]] double longest(Phase phase, const State& now, const Predictor& predictor) const {
    return longest(phase, now, predictor.stiffness_to_resolve(), predictor.pad_rate());
  }

  /// Usual length of a step from here on: the longest allowed, without a jump from its value before.
  [[nodiscard]] double usual() const { return usual_; }
  void learn(Phase phase, const State& now, const Predictor& predictor) {
    usual_ = std::min(longest(phase, now, predictor), numerics.growth * usual_);
  }
  void learn_force(double force) { largest_force_ = std::max(largest_force_, force); }

  /// The next step: at most half longer than the last, and shorter where an event is approached.
  template <class Contact>
  [[nodiscard]] double next(Phase phase, const Motion<Contact>& motion, const Predictor& predictor,
                            const LastTurn& turn) const {
    const State& now = motion.now();
    double step = usual_;
    const bool firm =
        foundation_.kind() == Foundation::Kind::damper || foundation_.is_firm(now.back, now.force);
    if (phase == Phase::loading && firm) step = std::min(step, turning_limit(now, predictor));
    const bool is_damped = foundation_.kind() == Foundation::Kind::damper &&
                           (follows_rate_ || (!HasEnergy<Contact> && now.time < usual_));
    if (phase == Phase::loading && is_damped && motion.force_rate() > 0)
      step = std::min(step, damped_limit(predictor, now.time));
    if (phase == Phase::unloading && firm && follows_rate_ && turn.elapsed > 0)
      step = std::min(step, logarithm_limit(turn.elapsed));
    if (phase == Phase::unloading) {
      step = std::min(step, end_of_unloading_limit(now, predictor));
      if (motion.force_rate() < 0) step = std::min(step, release_limit(now, motion.force_rate(), step));
    }
    // From rest against the panel the nose returns at a rate that grows with time.
    if (phase == Phase::flight && now.drive > 0 && turn.elapsed > 0)
      step = std::min(step, std::max(numerics.closing * resolution_ * turn.elapsed, resolution_ * usual_));
    // On a firm support the pad turns at rate zero, near which the force goes with a power of the time.
    const double last = turn.is_now && firm ? 0 : motion.last_step();
    return std::min(numerics.growth * std::max(last, resolution_ * usual_), step);
  }

 private:
  [[nodiscard]] double oscillation_limit(Phase phase, const State& state, double pad_stiffness,
                                         double pad_rate) const {
    const bool held = phase == Phase::held;
    if (!foundation_.is_plain()) {
      double squared = foundation_.square_frequency(state.back, state.force, pad_stiffness, held, mass_);
      if (!held)
        squared = std::max(squared, foundation_.square_settling(state.back, pad_stiffness, pad_rate));
      return squared > 0 ? resolution_ / std::sqrt(squared) : infinite;
    }
    const double compliance = foundation_.static_compliance(state.back, state.force);
    const double stiffness = held ? 1 / compliance : 1 / (1 / pad_stiffness + compliance);
    return resolution_ * std::sqrt(mass_ / stiffness);
  }
  [[nodiscard]] double strain_limit(const State& state, double pad_rate) const {
    return resolution_ * std::min(thickness_, widening(state.penetration)) / std::abs(pad_rate);
  }
  /// Penetration over which the area of the contact changes, m; it grows with the share of a flat tip.
  [[nodiscard]] double widening(double penetration) const {
    return share_of_side_ > 0 ? (nose_.depth + penetration) / share_of_side_ : infinite;
  }
  [[nodiscard]] double gap_limit(const State& state, double pad_stiffness, double pad_rate) const {
    const double gap = lock_ - state.penetration;
    const double open = gap / lock_;
    const double closing =
        follows_rate_ ? numerics.closing_of_foam + numerics.closing_of_open_foam * open * open * open * open
                      : numerics.closing;
    const double share = std::min(numerics.max_closing, closing * resolution_);
    // A bounded force grows over more than the remaining gap.
    const bool is_bounded = pad_stiffness * gap < numerics.bounded * state.force;
    const double least = is_bounded ? numerics.min_closing_if_bounded : numerics.min_closing;
    return (share * gap + least * resolution_ * resolution_ * thickness_) / std::abs(pad_rate);
  }
  [[nodiscard]] double turning_limit(const State& now, const Predictor& predictor) const {
    const double left = predictor.time_to_turning(now);
    if (!(left > 0)) return infinite;
    double step = numerics.towards_turning * left;
    if (follows_rate_) step = std::min(step, logarithm_limit(left));
    return std::max(step, resolution_ * usual_);
  }
  /// Near the turning point the force depends on the logarithm of the time to it; steps that grow with the
  /// root of that time keep the error of second order.
  [[nodiscard]] double logarithm_limit(double time) const { return std::sqrt(resolution_ * usual_ * time); }
  /// While the force rises, a pad on a damper gives way in a time of its own, far below that of an
  /// oscillation; at first contact it is as short as the time since then.
  [[nodiscard]] double damped_limit(const Predictor& predictor, double time) const {
    const double scale = predictor.time_scale();
    if (!std::isfinite(scale)) return numerics.growth * time;
    return resolution_ * std::max(numerics.damped * scale, std::min(usual_, time));
  }
  /// Where unloading may end at any moment, the pad's rate changes with the square root of the time left.
  [[nodiscard]] double end_of_unloading_limit(const State& now, const Predictor& predictor) const {
    if (now.drive <= 0) return infinite;
    return resolution_ * std::max(usual_, predictor.time_scale());
  }
  /// Steps shrink towards the release, since the force vanishes there with a power of the time left.
  [[nodiscard]] double release_limit(const State& now, double force_rate, double step) const {
    const bool in_contact = now.force > contact_end_share * largest_force_;
    const double fall =
        in_contact ? std::min(numerics.max_fall, numerics.fall * resolution_) : numerics.max_fall;
    const double shortest =
        (in_contact ? numerics.shortest_before_end : numerics.shortest_after_end) * resolution_ * step;
    return std::max(shortest, -fall * now.force / force_rate);
  }

  double mass_;
  Sections nose_;
  double share_of_side_;  ///< share of the nose's largest area that is not the tip's
  double thickness_;
  const Foundation& foundation_;
  bool follows_rate_;
  double resolution_ = 0;
  double lock_ = 0;
  double largest_force_ = 0;  ///< largest force so far, N
  double usual_ = 0;
};

}  // namespace dashpad
