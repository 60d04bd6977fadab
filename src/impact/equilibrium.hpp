#pragma once
/// The nonlinear solution of a step: a trial after which pad, support and impactor are in equilibrium.
///
///   0 = Y1 + Xs(F(Y1)) - X1(F(Y1))        the unknown is the penetration           (theory.md, Eq. 25)
///
/// in each of the phases, where Xs is the motion of the back of the pad, which on a moving support follows
/// from the force over the step. While the pad is held, the unknown is the force. SI units.

#include <algorithm>
#include <cmath>
#include <optional>

#include "dashpad/quantities/constants.hpp"
#include "impact/motion.hpp"
#include "impact/numerics.hpp"
#include "impact/predictor.hpp"
#include "impact/trial.hpp"
#include "model/contact/contact.hpp"
#include "model/root.hpp"

namespace dashpad {

template <IsContact Contact>
class Equilibrium {
 public:
  Equilibrium(Contact& contact, const Foundation& foundation, const Motion<Contact>& motion, double thickness)
      : contact_(contact), foundation_(foundation), motion_(motion), thickness_(thickness) {}

  void start(double resolution) { resolution_ = resolution; }

  /// A loading step. The unknown is the fourth root of the advance, since at the end of loading the force
  /// goes with a small power of the strain rate and has an infinite slope in the advance itself.
  Trial loading(double step, const Predictor& predictor) {
    const double locked = contact_.lock_penetration();
    const double unhindered = farthest(step);
    const double most = std::min(unhindered, locked) - now().penetration;
    if (most <= 0) return {.step = step, .obstacle = unhindered > locked ? Event::lock : Event::turning};
    MovingSearch at(*this, step, predictor);
    double advance = guess(step, predictor, at.slope);
    if (!(advance < most)) advance = spring_advance(step, at.slope);
    if (!(advance > 0 && advance < most))
      advance = std::min(std::max(predictor.pad_rate(), 0.0) * step, most) / 2;
    const double first = fourth_root(advance);
    const double last = fourth_root(most);
    const Root root = find_root([&](double z) { return at.residual(z * z * z * z); },
                                [&](double left) { return at.is_solved(left); },
                                {.high = last,
                                 .high_is_positive = unhindered <= locked,
                                 .guess = first,
                                 .slope = at.slope * (4 * first * first * first),
                                 .resolution = numerics.fourth_root_resolution * last});
    if (root.place == RootPlace::at_or_above_high) at.trial.obstacle = Event::lock;
    if (root.place == RootPlace::at_or_below_low) at.trial.obstacle = Event::turning;
    return with_drive(at.trial);
  }

  /// An unloading step. `just_turned`: loading has ended at this moment.
  Trial unloading(double step, const Predictor& predictor, bool just_turned) {
    MovingSearch at(*this, step, predictor);
    double advance = guess(step, predictor, at.slope);
    if (!(advance < 0)) advance = std::min(predictor.pad_rate(), -std::abs(speed_to_back())) * step / 2;
    at.may_let_go = true;
    // Strides are short, since of several roots the nearest belongs to the branch.
    const double resolution = numerics.rounding / 2 * (at.scale + thickness_);
    find_root([&](double x) { return at.residual(x); }, [&](double left) { return at.is_solved(left); },
              {.low = -infinite,
               .high = 0,
               .high_is_positive = now().drive < 0,
               .guess = advance,
               .slope = at.slope,
               .resolution = resolution,
               .stride = numerics.unloading_stride * std::abs(advance) + resolution});
    if (at.trial.pad.advance >= 0) {
      // By the error of the contact integral the pad carries less than the support's force: it is held until
      // that force has fallen. Likewise just after the turning point, where the drive is 0 within its error.
      if (!foundation_.is_firm(now().back, now().force) && (now().drive < 0 || just_turned)) {
        const Trial waiting = held(step, predictor);
        if (now().drive < 0 || waiting.end.drive < 0) return waiting;
      }
      at.trial.obstacle = Event::reloading;
    }
    return with_drive(at.trial);
  }

  /// A step at constant penetration; the support's force moves the impactor.
  Trial held(double step, const Predictor& predictor) {
    // A later unloading continues from this stiffness.
    Trial trial{.step = step, .pad_stiffness = predictor.pad_stiffness()};
    if (foundation_.kind() != Foundation::Kind::at_once) {
      motion_.stick(step, trial.end);
      trial.pad = contact_.trial(0, now().time, step);
      return with_drive(trial);
    }
    const double flexibility = motion_.flexibility(now().back, now().force, step);
    const double travel = std::abs(speed_to_back()) * step;
    const double scale = std::abs(reach(now())) + travel;
    // The support's line is continued below zero, so that the sign locates the release.
    const auto residual = [&](double force) {
      const double extended =
          force >= 0 ? 0 : force * foundation_.static_compliance(now().back, foundation_.holding());
      return motion_.residual(now().penetration, force, step, trial.end) + extended;
    };
    // At first contact there is no force yet.
    const double stride = now().force != 0 ? std::abs(now().force) : (travel + scale) / flexibility;
    find_root(residual, [&](double left) { return is_rounding(left, scale); },
              {.low = -infinite,
               .high = std::max(now().force, 0.0) + 2 * (travel + scale) / flexibility,
               .guess = now().force + motion_.approach(step, false) / flexibility,
               .slope = flexibility,
               .resolution = numerics.rounding * std::abs(now().force),
               .stride = stride});
    trial.pad = contact_.trial(0, now().time, step);
    return with_drive(trial);
  }

  /// A step without force, so that motion and penetration are known; in flight the latter is below zero.
  Trial released(double step, const Predictor& predictor) {
    Trial trial{.step = step, .pad_stiffness = predictor.pad_stiffness()};
    trial.end.penetration = -motion_.residual(0, 0, step, trial.end);
    trial.end.drive = trial.end.velocity - trial.end.back.velocity();
    // Foam that stays crushed remains where it was left.
    const double advance = contact_.recovers() ? trial.end.penetration - now().penetration : 0;
    trial.pad = contact_.trial(advance, now().time, step);
    return trial;
  }

  /// A step in which the penetration reaches the lock; Eq. 25 holds for one length of step only.
  Trial at_lock(double step, const Predictor& predictor) {
    Trial trial{.step = step, .pad_stiffness = predictor.pad_stiffness()};
    const double y = contact_.lock_penetration();
    trial.pad = contact_.trial(y - now().penetration, now().time, step);
    // On a support that does not yield the force may have no bound, and its mean is not half its last value.
    const double bound = foundation_.stops_hard() && !memoryless ? 2 * now().force : trial.pad.force;
    motion_.residual(y, std::min(trial.pad.force, bound), step, trial.end);
    trial.end.drive = trial.end.velocity - trial.end.back.velocity();
    return trial;
  }

  /// A step that ends with a known force, as at a corner of the support, and thus with known motion and
  /// penetration; for one length of step only the pad carries that force. If the pad would have to turn back,
  /// there is no such trial, and its force is that of a spring.
  Trial at_force(double force, Phase phase, double step, const Predictor& predictor) {
    Trial trial{.step = step, .pad_stiffness = predictor.pad_stiffness()};
    trial.end.penetration = -motion_.residual(0, force, step, trial.end);
    const double advance = trial.end.penetration - now().penetration;
    if (phase == Phase::loading ? advance > 0 : advance < 0) {
      trial.pad = contact_.trial(advance, now().time, step);
      trial.pad_stiffness = std::max((trial.pad.force - now().force) / advance, trial.pad.force / thickness_);
    } else {
      trial.pad = {advance, now().time, step, now().force + trial.pad_stiffness * advance};
      trial.obstacle = phase == Phase::loading ? Event::turning : Event::reloading;
    }
    return trial;
  }
  /// Whether the pad carries the force at the end of a trial to the accuracy of a solved one.
  [[nodiscard]] bool is_solved(const Trial& trial) const {
    const State& end = trial.end;
    const double flexibility = motion_.flexibility(end.back, end.force, trial.step);
    return trial.obstacle == Event::none &&
           std::abs(trial.pad.force - end.force) * flexibility <=
               allowed_residual(std::max(reach(now()), reach(end)), end.force, trial.pad_stiffness);
  }

  /// The trial with its drive (Eq. 26) at the end of the step, m/s, and its lasting stiffness: steps that
  /// resolved the effect of a changing rate like a spring would shrink without end.
  Trial with_drive(Trial trial) {
    const double rate = foundation_.follows_force_rate() ? contact_.force_rate_when_held(trial.pad) : 0;
    trial.end.drive =
        trial.end.velocity - foundation_.retreat(trial.end.back, trial.end.force, trial.pad.force, rate);
    if (foundation_.kind() == Foundation::Kind::damper &&
        !foundation_.is_firm(trial.end.back, trial.end.force))
      follow_damper(trial, rate);
    if (foundation_.crushes()) trial.force_rate = motion_.force_rate_after(trial.end.force, trial.step);
    if constexpr (FollowsRate<Contact>) {
      trial.lasting_stiffness = contact_.lasting_stiffness(trial.pad);
      if (trial.pad.advance < 0 || (trial.pad.advance > 0 && is_loaded_again())) {
        double chord = (trial.pad.force - now().force) / trial.pad.advance;
        // Where a foam turns against a panel, that is the stress of the rate; crushed foam is as stiff.
        if constexpr (!HasLayers<Contact>)
          if (foundation_.kind() == Foundation::Kind::panel && contact_.recovers())
            chord = std::min(chord, numerics.max_unloading_on_panel * trial.lasting_stiffness);
        trial.lasting_stiffness = std::max(trial.lasting_stiffness, chord);
      }
    }
    if constexpr (MayForget<Contact>) {
      // Against a panel the pad turns at rate zero, where the effect of a changing rate has no bound.
      const bool turns_at_rest = foundation_.kind() == Foundation::Kind::panel;
      if ((turns_at_rest || contact_.forgets(trial.pad)) && trial.pad.advance != 0) {
        // The stiffness at an unchanged rate, by a slightly longer step.
        const double more = numerics.more_of_the_same;
        const PadTrial& pad = trial.pad;
        const double beyond = contact_.trial((1 + more) * pad.advance, pad.from, (1 + more) * pad.step).force;
        trial.lasting_stiffness =
            std::max((beyond - pad.force) / (more * pad.advance), pad.force / thickness_);
      }
    }
    return trial;
  }

  /// On a damper the force determines the rate of the pad, which is the drive. Near 0 a rate may change its
  /// sign only as its growth has that sign, so the drive is the larger of the two (theory.md, Eq. 45), and a
  /// trial with the wrong sign has an error of its backward difference.
  void follow_damper(Trial& trial, double force_rate) const {
    State& end = trial.end;
    const double rate = end.drive;
    const double growth =
        foundation_.growth_of_rate(end.back, end.velocity, motion_.acceleration(end.force), force_rate);
    const bool comes_back = trial.pad.advance < 0;
    trial.overshoots = comes_back ? rate > 0 && growth < 0 : rate < 0 && growth > 0;
    end.drive = std::max(rate, growth);
  }

  /// Residual of Eq. 25 at the end of a trial, m; at the lock it is positive before the pad locks.
  [[nodiscard]] double residual(const Trial& trial) const { return motion_.residual(trial.end); }

  /// Motion of the impactor relative to what it meets, m, the scale of rounding errors.
  [[nodiscard]] double reach(const State& state) const {
    return state.motion - foundation_.origin(state.back);
  }
  /// Residual at which a trial of a pad with memory counts as solved, m; `scale`: the reach, m. Close to full
  /// compression it is limited by the gap over which the force grows.
  [[nodiscard]] double allowed_residual(double scale, double force, double pad_stiffness) const {
    const double gap = std::abs(contact_.lock_penetration() - now().penetration);
    const double growing = std::max(gap, std::abs(force) / pad_stiffness);
    const double share = numerics.solved_residual * resolution_ * resolution_ * resolution_;
    return std::max(share * std::min(scale, numerics.solved_residual_of_gap * growing),
                    numerics.rounding * scale);
  }

 private:
  static constexpr bool memoryless = HasEnergy<Contact>;

  /// Whether the pad has been deeper, in this blow or before, and so may be stiffer than its base curve.
  [[nodiscard]] bool is_loaded_again() const {
    double deepest = motion_.deepest();
    if constexpr (RemembersBlows<Contact>) deepest = std::max(deepest, contact_.joint());
    return now().penetration < deepest;
  }
  [[nodiscard]] const State& now() const { return motion_.now(); }
  /// Guess of the advance, m; just after an event as for a spring.
  [[nodiscard]] double guess(double step, const Predictor& predictor, double slope) const {
    const std::optional<double> rate = predictor.next_rate(step);
    return rate ? *rate * step : spring_advance(step, slope);
  }
  /// Root of Eq. 25 for a linear force, m, within a share of the gap; `slope` is the slope of Eq. 25.
  [[nodiscard]] double spring_advance(double step, double slope) const {
    const double most = numerics.guess_of_gap * (contact_.lock_penetration() - now().penetration);
    return std::clamp(motion_.approach(step, false) / slope, -most, most);
  }
  /// Penetration at the end of a step if no force acted, m.
  [[nodiscard]] double farthest(double step) const {
    if (foundation_.is_plain()) return now().motion + motion_.approach(step, true);
    return now().motion - now().back.motion() + motion_.approach(step, true);
  }
  /// Speed of the impactor relative to the back of the pad, or to what is behind a support at once, m/s.
  [[nodiscard]] double speed_to_back() const { return now().velocity - now().back.velocity(); }
  static double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }
  static bool is_rounding(double left, double scale) { return std::abs(left) <= numerics.rounding * scale; }

  /// Search over trials of a moving pad: the residual as a function of the advance, and when it is solved.
  struct MovingSearch {
    MovingSearch(Equilibrium& equilibrium, double step, const Predictor& predictor) : of_(equilibrium) {
      const State& now = equilibrium.now();
      trial.step = step;
      trial.pad_stiffness = predictor.next_stiffness();
      scale = std::max(std::abs(equilibrium.reach(now)), std::abs(equilibrium.farthest(step)));
      slope = 1 + trial.pad_stiffness * equilibrium.motion_.flexibility(now.back, now.force, step);
    }

    double residual(double advance) {
      const PadTrial before = trial.pad;
      trial.pad = of_.contact_.trial(advance, of_.now().time, trial.step);
      const double force = trial.pad.force;
      const double distance = advance - before.advance;
      if (trials_ > 0 && std::abs(distance) > numerics.min_change_of_advance * std::abs(advance) &&
          std::abs(force - before.force) > numerics.min_change_of_force * std::abs(force))
        trial.pad_stiffness = std::max((force - before.force) / distance, force / of_.thickness_);
      ++trials_;
      return of_.motion_.residual(of_.now().penetration + advance, force, trial.step, trial.end);
    }

    /// Whether the trial is solved. The force then takes up the remaining residual linearly: Eq. 25 holds but
    /// for the curvature. Pads that follow the rate move on with it, the columns of others stay as they were
    /// tried.
    bool is_solved(double left) {
      State& end = trial.end;
      // Without force there is none on the way to the root either: the step passes the release.
      if (may_let_go && end.force <= 0 && left >= 0) return true;
      if constexpr (memoryless) return is_rounding(left, scale);
      const double flexibility = of_.motion_.flexibility(end.back, end.force, trial.step);
      const double missing = -left / (1 + trial.pad_stiffness * flexibility);
      const double allowed = of_.allowed_residual(scale, end.force, trial.pad_stiffness) *
                             (trials_ > 1 ? 1 : numerics.solved_first_trial);
      if (std::abs(left) > allowed) return false;
      constexpr double max_taken_up =
          FollowsRate<Contact> ? numerics.largest_move_on : numerics.largest_take_up;
      if (std::abs(missing) > max_taken_up * of_.resolution_ * std::abs(trial.pad.advance))
        return is_rounding(left, scale) ||
               (std::abs(left) < numerics.solved_small_advance * allowed &&
                std::abs(missing) < numerics.max_take_up * std::abs(trial.pad.advance));
      if (end.force <= 0) return true;
      // In a very short step the residual alone would determine the rate, and with it the force.
      const double taken_up = trial.pad_stiffness * missing;
      const double most =
          numerics.max_force_taken_up * of_.resolution_ * std::max(end.force, of_.now().force);
      if (std::abs(taken_up) > most) return is_rounding(left, scale);
      if constexpr (FollowsRate<Contact>)
        if (end.penetration + missing > 0) trial.pad.further = missing;
      of_.motion_.residual(end.penetration + trial.pad.further, end.force + taken_up, trial.step, end);
      return true;
    }

    Trial trial;
    double scale = 0;         ///< largest reach in the step, m
    double slope = 1;         ///< guess of the slope of Eq. 25 in the advance
    bool may_let_go = false;  ///< in unloading steps

   private:
    Equilibrium& of_;
    int trials_ = 0;
  };

  Contact& contact_;
  const Foundation& foundation_;
  const Motion<Contact>& motion_;
  double thickness_;
  double resolution_ = 0;
};

}  // namespace dashpad
