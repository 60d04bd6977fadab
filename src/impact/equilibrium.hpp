#pragma once
/// The nonlinear solve of a step: the trial at whose end pad, support and impactor agree.
///
///   0 = Y1 + Xs(F(Y1)) - X1(F(Y1))        the unknown is the penetration           (theory.md, Eq. 25)
///
/// where Xs is the motion of the back of the pad, which a support that moves has from the force over the
/// step,
///
/// in each of the phases. Held, the unknown is the force. Lengths in m, times in s, forces in N.

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

  /// The pad advances. Loading, the unknown is the fourth root of the advance: at the end of loading the
  /// force has a power of the strain rate with a small exponent, and an infinite slope in the advance itself.
  Trial loading(double step, const Predictor& predictor) {
    const double locked = contact_.lock_penetration();
    const double unhindered = farthest(step);
    const double most = std::min(unhindered, locked) - now().penetration;
    if (most <= 0) return without_solution(unhindered > locked ? Event::lock : Event::turning, step);
    MovingSearch at(*this, step, predictor);
    double advance = guess(step, predictor, at.slope);
    if (!(advance < most)) advance = spring_advance(step, at.slope);
    if (!(advance > 0 && advance < most))
      advance = std::min(std::max(predictor.pad_rate(), 0.0) * step, most) / 2;
    RootSearch search;
    search.high = fourth_root(most);
    search.high_is_positive = unhindered <= locked;
    search.guess = fourth_root(advance);
    search.slope = at.slope * slope_of_fourth_power(search.guess);
    search.resolution = numerics.fourth_root_resolution * search.high;
    const Root root = find_root([&](double z) { return at.residual(z * z * z * z); },
                                [&](double left) { return at.is_solved(left); }, search);
    if (root.place == RootPlace::at_or_above_high) at.trial.obstacle = Event::lock;
    if (root.place == RootPlace::at_or_below_low) at.trial.obstacle = Event::turning;
    return finished(at.trial);
  }

  /// The pad comes back. `just_turned`: the loading has ended at this moment.
  Trial unloading(double step, const Predictor& predictor, bool just_turned) {
    MovingSearch at(*this, step, predictor);
    double advance = guess(step, predictor, at.slope);
    if (!(advance < 0)) advance = std::min(predictor.pad_rate(), -std::abs(speed_to_back())) * step / 2;
    RootSearch search;
    search.low = -infinite;
    search.high = 0;
    search.high_is_positive = now().drive < 0;
    search.guess = advance;
    search.slope = at.slope;
    search.resolution = numerics.rounding / 2 * (at.scale + thickness_);
    // Short strides: of several roots, the one next to where the pad is belongs to the branch.
    search.stride = numerics.unloading_stride * std::abs(advance) + search.resolution;
    at.may_let_go = true;
    find_root([&](double x) { return at.residual(x); }, [&](double left) { return at.is_solved(left); },
              search);
    if (at.trial.pad.advance >= 0) {
      // The pad, by the error of the contact integral, carries less than the support asks for: it is held
      // until the support has come down to it. Likewise just after the turning, where the drive is 0 but for
      // an error of either sign.
      if (!foundation_.is_firm(now().back, now().force) && (now().drive < 0 || just_turned)) {
        const Trial waiting = held(step, predictor);
        if (now().drive < 0 || waiting.end.drive < 0) return waiting;
      }
      at.trial.obstacle = Event::reloading;
    }
    return finished(at.trial);
  }

  /// The penetration stays; the support's force moves the impactor.
  Trial held(double step, const Predictor& predictor) {
    Trial trial;
    trial.step = step;
    if (foundation_.kind() != Foundation::Kind::at_once) {
      motion_.stick(step, trial.end);
      trial.pad_stiffness = predictor.pad_stiffness();
      trial.pad = contact_.trial(0, now().time, step);
      return finished(trial);
    }
    trial.pad_stiffness =
        predictor.pad_stiffness();  // an unloading that waits for the support goes on from it
    const double flexibility = motion_.flexibility(now().back, now().force, step);
    const double travel = std::abs(speed_to_back()) * step;
    const double scale = std::abs(reach(now())) + travel;
    RootSearch search;
    search.low = -infinite;
    search.high = std::max(now().force, 0.0) + 2 * (travel + scale) / flexibility;
    search.guess = now().force + motion_.approach(step, false) / flexibility;
    search.slope = flexibility;
    search.resolution = numerics.rounding * std::abs(now().force);
    // At first contact there is no force yet to go by.
    search.stride = now().force != 0 ? std::abs(now().force) : (travel + scale) / flexibility;
    // Below zero the support's line goes on: the release is located by the sign.
    const auto residual = [&](double force) {
      const double extended =
          force >= 0 ? 0 : force * foundation_.static_compliance(now().back, foundation_.holding());
      return motion_.residual(now().penetration, force, step, trial.end) + extended;
    };
    find_root(
        residual, [&](double left) { return is_rounding(left, scale); }, search);
    trial.pad = contact_.trial(0, now().time, step);
    return finished(trial);
  }

  /// Without force the motion is known, and with it the penetration on an unloaded support; in flight, below
  /// zero.
  Trial released(double step, const Predictor& predictor) {
    Trial trial;
    trial.step = step;
    trial.pad_stiffness = predictor.pad_stiffness();
    trial.end.penetration = -motion_.residual(0, 0, step, trial.end);
    trial.end.drive = trial.end.velocity - trial.end.back.velocity();
    // Foam that stays crushed waits for the nose where it was left.
    const double advance = contact_.recovers() ? trial.end.penetration - now().penetration : 0;
    trial.pad = contact_.trial(advance, now().time, step);
    return trial;
  }

  /// The penetration reaches the lock, which satisfies Eq. 25 for one step only.
  Trial at_lock(double step, const Predictor& predictor) {
    Trial trial;
    trial.step = step;
    trial.pad_stiffness = predictor.pad_stiffness();
    const double y = contact_.lock_penetration();
    trial.pad = contact_.trial(y - now().penetration, now().time, step);
    // On what does not give way the force may have no bound there, and its impulse is not half of the last.
    const double bound = foundation_.stops_hard() && !memoryless ? 2 * now().force : trial.pad.force;
    motion_.residual(y, std::min(trial.pad.force, bound), step, trial.end);
    trial.end.drive = trial.end.velocity - trial.end.back.velocity();
    return trial;
  }

  /// The force at the end is known, as at a corner of the support, and with it motion and penetration; for
  /// one step only the pad then carries that force. A pad that would have to turn back to get there has no
  /// such trial, and its force is that of a spring.
  Trial at_force(double force, Phase phase, double step, const Predictor& predictor) {
    Trial trial;
    trial.step = step;
    trial.pad_stiffness = predictor.pad_stiffness();
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
  /// Whether the pad carries the force that a trial ends with, as nearly as in a solved one.
  [[nodiscard]] bool is_solved(const Trial& trial) const {
    const State& end = trial.end;
    const double flexibility = motion_.flexibility(end.back, end.force, trial.step);
    return trial.obstacle == Event::none &&
           std::abs(trial.pad.force - end.force) * flexibility <=
               allowed_residual(std::max(reach(now()), reach(end)), end.force, trial.pad_stiffness);
  }

  /// The trial with its drive (Eq. 26) at the end of the step, m/s. Steps that resolved as a spring what a
  /// change of the rate adds would become shorter without end.
  Trial finished(Trial trial) {
    const double rate = contact_.force_rate_when_held(trial.pad);
    trial.end.drive =
        trial.end.velocity - foundation_.retreat(trial.end.back, trial.end.force, trial.pad.force, rate);
    if (foundation_.kind() == Foundation::Kind::damper &&
        !foundation_.is_firm(trial.end.back, trial.end.force))
      follow_damper(trial, rate);
    if (foundation_.crushes()) trial.force_rate = motion_.force_rate_after(trial.end.force, trial.step);
    if constexpr (FollowsRate<Contact>) {
      trial.lasting_stiffness = contact_.lasting_stiffness(trial.pad);
      if (trial.pad.advance < 0 || (trial.pad.advance > 0 && is_loaded_again()))
        trial.lasting_stiffness =
            std::max(trial.lasting_stiffness, (trial.pad.force - now().force) / trial.pad.advance);
    }
    if constexpr (MayForget<Contact>) {
      // Against a panel the pad turns at rate zero, where a change of the rate adds without bound.
      const bool turns_at_rest = foundation_.kind() == Foundation::Kind::panel;
      if ((turns_at_rest || contact_.forgets(trial.pad)) && trial.pad.advance != 0) {
        // By a little more of the same rate.
        const double more = numerics.more_of_the_same;
        const PadTrial& pad = trial.pad;
        const double beyond = contact_.trial((1 + more) * pad.advance, pad.from, (1 + more) * pad.step).force;
        trial.lasting_stiffness =
            std::max((beyond - pad.force) / (more * pad.advance), pad.force / thickness_);
      }
    }
    return trial;
  }

  /// On a damper the force tells the rate of the pad, and the first drive is that rate. One that is about 0
  /// changes its sign only as it grows: that is the drive where the two differ, and a trial in which they do
  /// is off by its backward difference.
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

  /// Motion of the impactor towards what the step finds in place, m: what roundings are of.
  [[nodiscard]] double reach(const State& state) const {
    return state.motion - foundation_.origin(state.back);
  }
  /// Residual at which a trial of a pad with memory is solved, m; `scale`: the reach, m. Close to full
  /// compression what the motion allows may be more than the gap over which the force grows.
  [[nodiscard]] double allowed_residual(double scale, double force, double pad_stiffness) const {
    const double gap = std::abs(contact_.lock_penetration() - now().penetration);
    const double growing = std::max(gap, std::abs(force) / pad_stiffness);
    const double share = numerics.solved_residual * resolution_ * resolution_ * resolution_;
    return std::max(share * std::min(scale, numerics.solved_residual_of_gap * growing),
                    numerics.rounding * scale);
  }

 private:
  static constexpr bool memoryless = HasEnergy<Contact>;

  /// Up to where it has been, in this blow or before, the pad may be stiffer than its base curve.
  [[nodiscard]] bool is_loaded_again() const {
    double deepest = motion_.deepest();
    if constexpr (RemembersBlows<Contact>) deepest = std::max(deepest, contact_.joint());
    return now().penetration < deepest;
  }
  [[nodiscard]] const State& now() const { return motion_.now(); }
  /// Of the advance: after an event the pad is taken as a spring.
  [[nodiscard]] double guess(double step, const Predictor& predictor, double slope) const {
    const std::optional<double> rate = predictor.next_rate(step);
    return rate ? *rate * step : spring_advance(step, slope);
  }
  /// The root of Eq. 25 for a pad whose force grows in proportion to the advance, or a share of the gap:
  /// the stiffness changes with it. `slope` is that of Eq. 25.
  [[nodiscard]] double spring_advance(double step, double slope) const {
    const double most = numerics.guess_of_gap * (contact_.lock_penetration() - now().penetration);
    return std::clamp(motion_.approach(step, false) / slope, -most, most);
  }
  /// How far the nose would go into the pad in a step if nothing held it, m.
  [[nodiscard]] double farthest(double step) const {
    if (foundation_.is_plain()) return now().motion + motion_.approach(step, true);
    return now().motion - now().back.motion() + motion_.approach(step, true);
  }
  /// m/s; towards a support at once on the ground, that of the impactor.
  [[nodiscard]] double speed_to_back() const { return now().velocity - now().back.velocity(); }
  static double fourth_root(double x) { return std::sqrt(std::sqrt(x)); }
  static double slope_of_fourth_power(double z) { return 4 * z * z * z; }
  static bool is_rounding(double left, double scale) { return std::abs(left) <= numerics.rounding * scale; }
  static Trial without_solution(Event obstacle, double step) {
    Trial trial;
    trial.step = step;
    trial.obstacle = obstacle;
    return trial;
  }

  /// What the trials of a moving pad share: the residual by the advance, and when it is near enough to 0.
  struct MovingSearch {
    MovingSearch(Equilibrium& of, double step, const Predictor& predictor) : of_(of) {
      const State& now = of.now();
      trial.step = step;
      trial.pad_stiffness = predictor.next_stiffness();
      scale = std::max(std::abs(of.reach(now)), std::abs(of.farthest(step)));
      slope = 1 + trial.pad_stiffness * of.motion_.flexibility(now.back, now.force, step);
    }

    double residual(double advance) {
      const PadTrial before = trial.pad;
      trial.pad = of_.contact_.trial(advance, of_.now().time, trial.step);
      const double force = trial.pad.force;
      const double distance = advance - before.advance;
      if (trials_ > 0 && std::abs(distance) > numerics.least_change_of_advance * std::abs(advance) &&
          std::abs(force - before.force) > numerics.least_change_of_force * std::abs(force))
        trial.pad_stiffness = std::max((force - before.force) / distance, force / of_.thickness_);
      ++trials_;
      return of_.motion_.residual(of_.now().penetration + advance, force, trial.step, trial.end);
    }

    /// What is left of the residual is taken up by the force, in proportion: Eq. 25 then holds but for the
    /// curvature, and the columns stay where they were tried.
    bool is_solved(double left) {
      State& end = trial.end;
      // Without force the pad stays without it on the way to the root: the step passes the release.
      if (may_let_go && end.force <= 0 && left >= 0) return true;
      if constexpr (memoryless) return is_rounding(left, scale);
      const double flexibility = of_.motion_.flexibility(end.back, end.force, trial.step);
      const double missing = -left / (1 + trial.pad_stiffness * flexibility);
      const double allowed = of_.allowed_residual(scale, end.force, trial.pad_stiffness) *
                             (trials_ > 1 ? 1 : numerics.solved_first_trial);
      if (std::abs(left) > allowed) return false;
      if (std::abs(missing) > numerics.largest_take_up * of_.resolution_ * std::abs(trial.pad.advance))
        return is_rounding(left, scale) ||
               (std::abs(left) < numerics.solved_small_advance * allowed &&
                std::abs(missing) < numerics.most_take_up * std::abs(trial.pad.advance));
      if (end.force <= 0) return true;
      // In a very short step the rate, and with it the force, would be what the residual makes of it.
      const double taken_up = trial.pad_stiffness * missing;
      const double most =
          numerics.most_force_taken_up * of_.resolution_ * std::max(end.force, of_.now().force);
      if (std::abs(taken_up) > most) return is_rounding(left, scale);
      of_.motion_.residual(end.penetration, end.force + taken_up, trial.step, end);
      return true;
    }

    Trial trial;
    double scale = 0;         ///< of the reach, m
    double slope = 1;         ///< of Eq. 25 in the advance, as far as it is known
    bool may_let_go = false;  ///< unloading

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
