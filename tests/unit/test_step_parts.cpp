/// The parts of a step, each alone: the table of events, the branch rule, the guess of the next step, step
/// lengths.

#include <gtest/gtest.h>

#include <optional>

#include "dashpad/model/nose/sphere.hpp"
#include "impact/events.hpp"
#include "impact/predictor.hpp"
#include "impact/step_control.hpp"
#include "model/contact/curve_contact.hpp"

namespace dashpad::test {
namespace {

constexpr double mass = 4, radius = 0.08, thickness = 0.03, resolution = 0.1;

const Support rigid_support = Support::rigid();
const Support linear_support = Support::linear(1e4);
const Support curved_support = Support::through({{0.01, 100}, {0.02, 400}, {0.03, 1000}});
const Foundation rigid{rigid_support, {}, mass};
const Foundation spring{linear_support, {}, mass};
const Foundation corners{curved_support, {}, mass};
const CurveContact pad{StressCurve{}, true, thickness, Sphere{radius}.sections()};

/// A trial from a state with the force and drive `now` to one with those of `end`.
struct Tried {
  State now;
  Trial trial;
  Tried(double force_now, double drive_now, double force, double drive) {
    now.force = force_now, now.drive = drive_now;
    trial.end.force = force, trial.end.drive = drive;
    trial.step = 1e-3;
  }
  [[nodiscard]] FirstEvent in(Phase phase, const Foundation& foundation = spring,
                              bool recovers = true) const {
    return first_event(
        {.phase = phase, .now = now, .trial = trial, .foundation = foundation, .recovers = recovers});
  }
};

TEST(Events, NoneInASmoothStep) {
  EXPECT_EQ(Tried(50, 2, 60, 1).in(Phase::loading).event(), Event::none);
  EXPECT_EQ(Tried(60, -1, 50, -2).in(Phase::unloading).event(), Event::none);
  EXPECT_EQ(Tried(60, 0, 50, 0).in(Phase::held).event(), Event::none);
}

TEST(Events, TurningWhereTheDriveReachesZero) {
  EXPECT_EQ(Tried(50, 2, 60, -1).in(Phase::loading).event(), Event::turning);
  EXPECT_EQ(Tried(50, 2, 60, 0).in(Phase::loading).event(), Event::turning);
  EXPECT_EQ(Tried(50, 2, 60, -1).in(Phase::unloading).event(), Event::none);
  EXPECT_EQ(Tried(50, -1, 60, -2).in(Phase::loading).event(), Event::none) << "was not driven before either";
}

TEST(Events, ReleaseWhereTheForceIsGoneButNotOnLoading) {
  const Tried without_force(5, -1, 0, -1);
  EXPECT_EQ(without_force.in(Phase::unloading).event(), Event::release);
  EXPECT_EQ(without_force.in(Phase::held).event(), Event::release);
  EXPECT_EQ(without_force.in(Phase::loading).event(), Event::none);
}

TEST(Events, UnlockWhereThePadCarriesMoreThanTheSupport) {
  Tried locked(90, -1, 80, -1);
  locked.trial.pad.force = 85;
  EXPECT_EQ(locked.in(Phase::held).event(), Event::unlock);
  EXPECT_EQ(locked.in(Phase::held, spring, false).event(), Event::none) << "a rigid foam stays where it is";
  locked.trial.pad.force = 75;
  EXPECT_EQ(locked.in(Phase::held).event(), Event::none);
}

TEST(Events, CornersOfTheSupportEitherWayButNotFromTheCornerItself) {
  const FirstEvent up = Tried(90, 2, 120, 1).in(Phase::loading, corners);
  EXPECT_EQ(up.event(), Event::corner);
  EXPECT_EQ(up.corner, 100);
  EXPECT_EQ(Tried(120, -1, 90, -2).in(Phase::unloading, corners).event(), Event::corner);
  EXPECT_EQ(Tried(100, 2, 120, 1).in(Phase::loading, corners).event(), Event::none);
  EXPECT_EQ(Tried(90, 2, 500, 1).in(Phase::loading, corners).count, 2);
}

TEST(Events, AreCountedAndTakenInTheOrderOfTheTable) {
  const FirstEvent both = Tried(50, 2, 120, -1).in(Phase::loading, corners);
  EXPECT_EQ(both.event(), Event::turning);
  EXPECT_EQ(both.count, 2);
}

TEST(Events, ATrialWithoutSolutionHasNoOtherEventThanWhatIsInItsWay) {
  for (const auto& [obstacle, phase] : {std::pair{Event::lock, Phase::loading},
                                        {Event::turning, Phase::loading},
                                        {Event::reloading, Phase::unloading}}) {
    Tried tried(90, -1, 120, -1);
    tried.trial.obstacle = obstacle;
    const FirstEvent first = tried.in(phase, corners);
    EXPECT_EQ(first.event(), obstacle);
    EXPECT_EQ(first.count, 1);
  }
}

TEST(Branch, FollowsTheEventPadAndSupport) {
  const BranchConditions foam, foam_on_rock{true, true, true}, crushed{false, false, false},
      crushed_on_rock{false, true, true};
  EXPECT_EQ(phase_after(Event::turning, Phase::loading, 0, foam), Phase::unloading);
  EXPECT_EQ(phase_after(Event::turning, Phase::loading, 0, foam_on_rock), Phase::unloading);
  EXPECT_EQ(phase_after(Event::turning, Phase::loading, 0, crushed), Phase::held);
  EXPECT_EQ(phase_after(Event::turning, Phase::loading, 0, crushed_on_rock), Phase::over);
  EXPECT_EQ(phase_after(Event::lock, Phase::loading, 1, foam), Phase::held);
  EXPECT_EQ(phase_after(Event::lock, Phase::loading, 1, foam_on_rock), Phase::over);
  EXPECT_EQ(phase_after(Event::unlock, Phase::held, -1, foam), Phase::unloading);
  EXPECT_EQ(phase_after(Event::unlock, Phase::held, 1, foam), Phase::loading);
  EXPECT_EQ(phase_after(Event::reloading, Phase::unloading, -1, foam), Phase::loading);
  EXPECT_EQ(phase_after(Event::corner, Phase::unloading, 1, foam), Phase::unloading);
  EXPECT_EQ(phase_after(Event::release, Phase::held, -1, foam), Phase::over);
}

/// Accepts a step of the given length and advance.
void learn(Predictor& predictor, Phase phase, double step, double advance, double stiffness) {
  Trial trial;
  trial.step = step, trial.pad.advance = advance, trial.pad_stiffness = stiffness;
  predictor.learn(phase, {}, trial, Event::none);
}

TEST(Predictor, KnowsNoTrendAtFirstContact) {
  Predictor predictor;
  predictor.start(4, 1e5);
  EXPECT_EQ(predictor.pad_rate(), 4);
  EXPECT_EQ(predictor.next_rate(1e-3), std::nullopt);
}

TEST(Predictor, FollowsARateThatFallsLikeAnExponential) {
  Predictor predictor;
  predictor.start(4, 1e5);
  constexpr double step = 1e-3, time_scale = 5e-3;
  double expected = 4;
  for (int i = 0; i < 4; ++i, expected *= std::exp(-step / time_scale))
    learn(predictor, Phase::loading, step, expected * step, 1e5);
  EXPECT_NEAR(predictor.next_rate(step).value(), expected, 1e-12);
  EXPECT_NEAR(predictor.time_scale(), time_scale, 1e-12);
}

TEST(Predictor, ATriedStepServesTheNextTryFromThere) {
  Predictor predictor;
  predictor.start(4, 1e5);
  Trial tried;
  tried.step = 1e-3, tried.pad.advance = 2e-3;
  predictor.learn_from_try(tried);
  EXPECT_EQ(predictor.next_rate(5e-4), 2);
  tried.obstacle = Event::lock, tried.pad.advance = 9e-3;
  predictor.learn_from_try(tried);
  EXPECT_EQ(predictor.next_rate(5e-4), 2) << "without a solution there is nothing to learn";
}

TEST(Predictor, UnloadsWithTheStiffnessBeforeTheRateBrokeDown) {
  Predictor predictor;
  predictor.start(4, 1e5);
  learn(predictor, Phase::loading, 1e-3, 3e-3, 2e5);
  learn(predictor, Phase::loading, 1e-3, 1e-5, 9e9);
  State now;
  now.velocity = -0.5;
  predictor.begin_phase(Event::turning, now);
  EXPECT_EQ(predictor.pad_stiffness(), 2e5);
  EXPECT_EQ(predictor.next_stiffness(), 2e5);
  EXPECT_EQ(predictor.pad_rate(), -0.5);
}

StepControl control_on(const Foundation& foundation, bool follows_rate = false) {
  StepControl control(mass, Sphere{radius}.sections(), thickness, foundation, follows_rate);
  control.start(resolution, thickness);
  return control;
}

TEST(StepControl, ResolvesTheOscillationOfPadAndSupportInSeries) {
  const double stiffness = 1 / (1 / 3e4 + 1 / 1e4);
  EXPECT_NEAR(control_on(spring).longest(Phase::loading, {}, 3e4, 0),
              resolution * std::sqrt(mass / stiffness), 1e-12);
  EXPECT_NEAR(control_on(spring).longest(Phase::held, {}, 3e4, 7), resolution * std::sqrt(mass / 1e4), 1e-12);
}

TEST(StepControl, ResolvesStrainAndGap) {
  const StepControl control = control_on(rigid);
  State state;
  state.penetration = 0.001;
  EXPECT_NEAR(control.longest(Phase::loading, state, 1, 5), resolution * thickness / 5, 1e-12);
  EXPECT_EQ(control.longest(Phase::loading, state, 1, -5), control.longest(Phase::loading, state, 1, 5));
  state.penetration = 0.999 * thickness;
  const double gap = 0.001 * thickness;
  EXPECT_NEAR(control.longest(Phase::loading, state, 1, 5),
              (4 * resolution * gap + 1e-6 * resolution * resolution * thickness) / 5, 1e-12);
  EXPECT_NEAR(control_on(rigid, true).longest(Phase::loading, state, 1, 5),
              (0.6 * resolution * gap + 1e-6 * resolution * resolution * thickness) / 5, 1e-12)
      << "a foam by its curves";
}

TEST(StepControl, BeginsWithAQuarterOfWhatItsOwnStiffnessAllows) {
  const StepControl control = control_on(rigid);
  constexpr double speed = 2, slope = 3e9;
  double stiffness = 0;
  const auto force_of = [](double y, double) { return slope * y / 2; };
  const auto first_step = [&](double max_force) {
    return control.first_step(Phase::loading, speed, max_force, force_of, stiffness);
  };
  const double step = first_step(std::numeric_limits<double>::infinity());
  EXPECT_NEAR(stiffness, slope, 1e-3);
  const double allowed = numerics.first_step * control.longest(Phase::loading, {}, slope, speed);
  EXPECT_LE(step, allowed);
  EXPECT_GT(2 * step, allowed);
  EXPECT_LE(force_of(first_step(10) * speed, 0), 10);
}

TEST(StepControl, GrowsByHalf) {
  StepControl control = control_on(rigid);
  Motion<CurveContact> motion({.mass = mass}, spring, pad);
  Predictor predictor;
  predictor.start(2, 1e5);
  control.learn(Phase::loading, {}, predictor);
  const double usual = control.usual();
  motion.start(2, 0);
  motion.accept({}, 0.3 * usual, true);
  EXPECT_NEAR(control.next(Phase::loading, motion, predictor, {.elapsed = -1}), 0.45 * usual, 1e-15);
  motion.accept({}, usual, true);
  EXPECT_NEAR(control.next(Phase::loading, motion, predictor, {.elapsed = -1}), usual, 1e-15);
}

/// The impactor comes to rest in the time that is left, and goes back from there by a short step.
TEST(StepControl, ShrinksAboutTheTurningPointOnARigidSupport) {
  const auto steps_on = [](const Foundation& foundation) {
    StepControl control = control_on(foundation);
    Motion<CurveContact> motion({.mass = mass}, foundation, pad);
    Predictor predictor;
    predictor.start(2, 1e5);
    control.learn(Phase::loading, {}, predictor);
    const double usual = control.usual();
    State before, now;
    before.drive = 2, now.drive = 1;
    Trial trial;
    trial.step = 0.2 * usual;
    trial.pad = {1e-4, 0, trial.step, 10};
    trial.pad_stiffness = 1e5;
    trial.end = now;
    predictor.learn(Phase::loading, before, trial, Event::none);
    motion.start(2, 0);
    motion.accept(now, usual, true);
    return std::array{
        control.next(Phase::loading, motion, predictor, {.elapsed = -1}) / usual,
        control.next(Phase::unloading, motion, predictor, {.elapsed = 0, .is_now = true}) / usual};
  };
  const auto [towards, back] = steps_on(rigid);
  EXPECT_NEAR(towards, numerics.towards_turning * 0.2, 1e-9) << "as long as the last step took, by the drive";
  EXPECT_NEAR(back, numerics.growth * resolution, 1e-9);
  EXPECT_EQ(steps_on(spring)[0], 1) << "a pad that turns at a rate of its own has no such place";
}

TEST(StepControl, ShrinksTowardsTheRelease) {
  StepControl control = control_on(rigid);
  Motion<CurveContact> motion({.mass = mass}, spring, pad);
  Predictor predictor;
  predictor.start(-0.01, 1e5);
  control.learn(Phase::unloading, {}, predictor);
  control.learn_force(1000);
  motion.start(2, 0);
  State now;
  now.force = 10;
  motion.accept(now, 1e-3, true);
  now.force = 5;
  motion.accept(now, 1e-4, true);
  EXPECT_NEAR(control.next(Phase::unloading, motion, predictor, {.elapsed = -1}), 0.7 * 1e-4, 1e-12)
      << "seven tenths of the force";
}

}  // namespace
}  // namespace dashpad::test
