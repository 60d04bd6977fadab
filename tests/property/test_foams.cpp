/// What the laws by curves, foam and crushable foam, must keep at a column, whatever their cards: random
/// sound cards on random paths of the strain. Repeat one card with DASHPAD_RANDOM_SEED and
/// DASHPAD_RANDOM_CASES.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "dashpad/model/pad/law.hpp"
#include "model/pad/foam/foam_stress.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"

namespace dashpad::test {
namespace {

/// check(seed, law) for as many foams as crushable foams.
template <class Check>
void for_random_foams(std::uint64_t count, Check&& check) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", count);
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}, foam", seed));
    check(seed, random_foam(seed));
    SCOPED_TRACE(fmt::format("seed {}, crushable foam", seed));
    check(seed, random_crushable_foam(seed));
  }
}

std::string text_of(const std::vector<Violation>& broken) {
  std::string text;
  for (const Violation& one : broken) text += fmt::format("{} = {:.6g}: {}\n", one.key, one.value, one.rule);
  return text;
}

/// A column in a state that is set, not only reached: strain, the largest before, elastic strain of the slip.
class FoamState {
 public:
  template <SharesSlip Law>
  explicit FoamState(const Law& law) : stress_(law) {}

  [[nodiscard]] const FoamStress& law() const { return stress_; }
  [[nodiscard]] const SlipScale& slip() const { return stress_.slip(); }

  [[nodiscard]] double lasting(double strain, double largest) const { return stress(strain, largest, 0); }
  [[nodiscard]] double of_rate(double strain, double slip_rate) const {
    if (strain <= 0) return 0;
    const FoamStress::Place place = stress_.at(strain_of(strain));
    const auto ratio = [&](double u) {
      return stress_.ratio(place, 0, stress_.overstress().at(u), u).stress;
    };
    return place.base.stress * (ratio(slip_rate) - ratio(0));
  }
  [[nodiscard]] double stress(double strain, double largest, double g) const {
    return strain > 0 ? stress_.stress(strain_of(strain), std::max(largest - strain, 0.0), g) : 0;
  }

 private:
  FoamStress stress_;
};

double highest_strain_of(const FoamState& state) {
  // Into the continuation, but not to where the stress has no bound.
  const double last = state.law().curve().last_strain();
  return last + 0.5 * (1 - last);
}

// --- The cards
// -----------------------------------------------------------------------------------------------

TEST(Foams, RandomCardsAreSound) {
  for_random_foams(300, [](std::uint64_t, const auto& law) {
    const auto broken = violations(PadLaw(law));
    EXPECT_TRUE(broken.empty()) << text_of(broken);
  });
}

// --- The slip
// ------------------------------------------------------------------------------------------------

/// g by many small steps of the classical method of Runge and Kutta.
double slip_by_steps(const SlipScale& scale, double g, double from_rate, double to_rate, double time) {
  const auto slope = [&](double at, double x) {
    return from_rate + (to_rate - from_rate) * at / time - scale.slip_rate(x);
  };
  // The equation is at most as stiff as where the slip is as fast as the rate, or as it begins.
  const double fastest = std::abs(from_rate) + std::abs(to_rate) + std::abs(scale.slip_rate(g)) + scale.rate;
  const auto count = static_cast<int>(std::ceil(200 + 60 * fastest * time / scale.strain));
  const double h = time / count;
  for (int i = 0; i < count; ++i) {
    const double t = h * i;
    const double a = slope(t, g);
    const double b = slope(t + h / 2, g + h / 2 * a);
    const double c = slope(t + h / 2, g + h / 2 * b);
    const double d = slope(t + h, g + h * c);
    g += h / 6 * (a + 2 * b + 2 * c + d);
  }
  return g;
}

TEST(FoamSlip, IsExactAtAConstantRate) {
  const SlipScale scale{2.5e-4, 1e-3};
  for (const double start : {0.0, 1e-6, 2e-4, 2e-3, -2e-4, -2e-3})
    for (const double rate :
         {0.0, 1e-6, 5e-4, 1e-3, 2e-3, 0.1, 10.0, -1e-6, -5e-4, -1e-3, -2e-3, -0.1, -10.0})
      for (const double lags : {1e-6, 1e-2, 1.0, 30.0}) {
        const double u = std::abs(rate) + std::abs(scale.slip_rate(start)) + scale.rate;
        const double time = lags * scale.strain / u;
        const double expected = slip_by_steps(scale, start, rate, rate, time);
        EXPECT_NEAR(scale.after(start, rate, time), expected, 2e-7 * scale.strain)
            << "from " << start << " at " << rate << " for " << time;
      }
}

TEST(FoamSlip, IsExactWhereTheRateGoesEvenly) {
  const SlipScale scale{2.5e-4, 1e-3};
  for (const double start : {0.0, 2e-4, 2e-3, -2e-3})
    for (const double from : {0.0, 1e-3, 0.1, 10.0, -0.1, -10.0})
      for (const double to : {0.0, -1e-3, 0.05, 0.1, 4.0, 10.0, -0.2, -20.0})
        for (const double lags : {1e-4, 1e-2, 0.5, 3.0, 30.0}) {
          const double u = std::abs(from) + std::abs(to) + std::abs(scale.slip_rate(start)) + scale.rate;
          const double time = lags * scale.strain / u;
          const double expected = slip_by_steps(scale, start, from, to, time);
          EXPECT_NEAR(scale.after(start, from, to, time), expected, 1e-6 * scale.strain)
              << "from " << start << " at " << from << " to " << to << " for " << time;
        }
}

/// Two parts of a stretch are the whole.
TEST(FoamSlip, GoesOnFromWhereItIs) {
  for (const SlipScale scale : {SlipScale{2.5e-4, 1e-5}, SlipScale{5e-6, 1e-7}, SlipScale{2.5e-3, 1e-2}})
    for (const double start : {0.0, 1e-9, 3.0, 12.0, -0.1, -3.0, -12.0})
      for (const double rate : {0.0, 1e-7, 1e-5, 1e-2, 1.0, 300.0, -1e-7, -1e-5, -1e-2, -1.0, -300.0})
        for (const double strain : {1e-9, 1e-5, 1e-3, 0.1}) {
          const double g = start * scale.strain;
          const double time = strain / std::max(std::abs(rate), scale.rate);
          const double once = scale.after(g, rate, time);
          for (const double share : {0.5, 0.01, 0.9}) {
            const double twice = scale.after(scale.after(g, rate, share * time), rate, (1 - share) * time);
            EXPECT_NEAR(twice, once, 1e-6 * scale.strain)
                << "u0 " << scale.rate << ", from " << start << " c at " << rate << " for " << time;
          }
        }
}

TEST(FoamSlip, IsTheSameTheOtherWayRound) {
  const SlipScale scale{2.5e-4, 1e-3};
  for (const double start : {0.0, 1e-7, 2e-4, 2e-3})
    for (const double rate : {1e-6, 1e-3, 0.1, 10.0, -1e-6, -1e-3, -0.1, -10.0})
      for (const double time : {1e-9, 1e-6, 1e-3, 1.0}) {
        EXPECT_EQ(scale.after(-start, -rate, time), -scale.after(start, rate, time));
        EXPECT_EQ(scale.after(-start, -rate, -2 * rate, time), -scale.after(start, rate, 2 * rate, time));
      }
}

/// A slip that has had its time is as fast as the strain; held, it comes to nothing.
TEST(FoamSlip, EndsAtTheRateOfTheStrain) {
  const SlipScale scale{2.5e-4, 1e-5};
  for (const double start : {0.0, 2e-4, 2e-3, -2e-3})
    for (const double rate : {1e-8, 1e-5, 1e-2, 1.0, 300.0, -1e-2, -300.0}) {
      const double time = 60 * scale.strain / std::min(std::abs(rate) + scale.rate, 1.0) * 20;
      const double end = scale.after(start, rate, time);
      EXPECT_NEAR(scale.slip_rate(end), rate, 1e-6 * std::abs(rate) + 1e-9 * scale.rate)
          << "from " << start << " at " << rate;
      EXPECT_NEAR(scale.after(end, 0, 1e6), 0, 1e-12 * scale.strain);
    }
}

/// Whatever the numbers: a number, of a slip no faster than the strain or than it was.
TEST(FoamSlip, IsANumberWhateverTheRatios) {
  for (const double rate_scale : {1e-15, 1e-12, 1e-9, 1e-5, 1.0, 1e6})
    for (const double lag : {5e-6, 2.5e-4, 2.5e-3}) {
      const SlipScale scale{lag, rate_scale};
      for (const double start : {0.0, 1e-12, 1.0, 30.0, -1.0, -30.0})
        for (const double rate : {0.0, 1e-15, 1e-9, 1e-3, 1.0, 1e3, 1e6, 1e9})
          for (const double side : {1.0, -1.0})
            for (const double time : {1e-15, 1e-9, 1e-6, 1e-3, 1.0, 1e3, 1e9}) {
              const double g = start * lag;
              const double end = scale.after(g, side * rate, time);
              ASSERT_TRUE(std::isfinite(end)) << "u0 " << rate_scale << ", c " << lag << ": from " << start
                                              << " c at " << side * rate << " for " << time;
              const double u = scale.slip_rate(end);
              const double most = std::max(rate, std::abs(scale.slip_rate(g)));
              EXPECT_LE(std::abs(u), most * (1 + 1e-6) + 1e-9 * rate_scale)
                  << "u0 " << rate_scale << ", c " << lag << ": from " << start << " c at " << side * rate
                  << " for " << time;
              // In a long time the slip is as fast as the strain.
              if (rate > 0 && rate * time > 100 * lag && std::abs(start) < 2) {
                EXPECT_NEAR(u, side * rate, 1e-3 * rate)
                    << "u0 " << rate_scale << ", c " << lag << ": from " << start << " c at " << side * rate
                    << " for " << time;
              }
            }
    }
}

TEST(FoamSlip, FollowsAChangingRate) {
  const SlipScale scale{2.5e-4, 1e-3};
  for (const double start : {0.0, 5e-4, -5e-4})
    for (const double from : {10.0, 2.0, -5.0})
      for (const double to : {10.0, 0.5, -5.0})
        for (const double lags : {0.01, 0.03, 0.1}) {
          const double time = lags * scale.strain / 10;
          const double expected = slip_by_steps(scale, start, from, to, time);
          // Second order in the step.
          EXPECT_NEAR(scale.after(start, from, to, time), expected,
                      0.1 * lags * lags * scale.strain + 1e-7 * scale.strain)
              << "from " << start << ", rate " << from << " to " << to << " in " << time;
        }
}

// --- The stress
// ----------------------------------------------------------------------------------------------

const std::vector<double> shares{1e-6, 1e-3, 0.02, 0.1, 0.3, 0.5, 0.8, 0.95, 1.0};

TEST(Foams, HaveNoStressWithoutStrainAndAreFinite) {
  for_random_foams(100, [](std::uint64_t, const auto& law) {
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    EXPECT_NEAR(state.stress(1e-14, 1e-14, 10 * state.slip().strain), 0,
                1e-3 * state.lasting(highest, highest));
    for (const double share : shares)
      for (const double of_largest : shares)
        for (const double u : {0.0, 1e-9, 1e-3, 1.0, 1e3, 1e6})
          for (const double side : {1.0, -1.0}) {
            const double largest = highest * of_largest;
            const double stress =
                state.lasting(share * largest, largest) + state.of_rate(share * largest, side * u);
            ASSERT_TRUE(std::isfinite(stress)) << share * largest << " of " << largest << " at " << side * u;
          }
  });
}

/// At a fixed state the stress does not fall as the slip rate rises.
TEST(Foams, DoNotWeakenAsTheSlipRateRises) {
  for_random_foams(100, [](std::uint64_t, const auto& law) {
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    std::vector<double> slip_rates{0};
    for (double u = 1e-9; u < 1e6; u *= 1.3)
      slip_rates.push_back(u), slip_rates.insert(slip_rates.begin(), -u);
    for (const double share : shares) {
      // Where the stress is next to nothing the ratio of curves that touch there is a cubic of its own.
      if (share < 1e-3) continue;
      const double strain = share * highest;
      const double base = state.law().curve().at(strain_of(strain)).stress;
      double before = -1e300;
      for (const double u : slip_rates) {
        const double now = state.of_rate(strain, u);
        EXPECT_GE(now, before - 1e-12 * base) << "strain " << strain << ", slip rate " << u;
        before = now;
      }
      EXPECT_EQ(state.of_rate(strain, 0), 0);
    }
  });
}

/// What the rate adds when the slip goes on: the derivative that the solver takes for its turning point.
TEST(Foams, RelaxAsTheySay) {
  for_random_foams(60, [](std::uint64_t, const auto& law) {
    const FoamState state(law);
    const FoamStress& stress = state.law();
    const double highest = highest_strain_of(state);
    for (const double share : {0.02, 0.3, 0.8, 1.0})
      for (const double u : {1e-6, 0.037, 2.3, 170.0, -1e-6, -0.037, -2.3, -170.0}) {
        const SlipScale scale = state.slip();
        const double g = std::copysign(scale.strain * std::log1p(std::abs(u) / scale.rate), u);
        const FoamStress::Place place = stress.at(strain_of(share * highest));
        const double relaxing =
            place.base.stress * stress.ratio(place, 0, stress.overstress().at(u), u).relaxing;
        // While the strain is held, dg/dt = -u.
        const double h = 1e-5 * scale.strain;
        const auto at = [&](double x) { return state.of_rate(share * highest, scale.slip_rate(x)); };
        const double left = (at(g) - at(g - h)) / h * -u, right = (at(g + h) - at(g)) / h * -u;
        const double low = std::min(left, right), high = std::max(left, right);
        const double noise =
            1e-3 * (std::abs(left) + std::abs(right)) + 1e-9 * place.base.stress * std::abs(u) / h;
        EXPECT_GE(relaxing, low - noise) << "strain " << share * highest << ", slip rate " << u;
        EXPECT_LE(relaxing, high + noise) << "strain " << share * highest << ", slip rate " << u;
      }
  });
}

/// Where loading ends the lasting stress goes on from where it was.
TEST(Foams, TurnWithoutAJump) {
  for_random_foams(100, [](std::uint64_t seed, const auto& law) {
    // The points of an unloading curve may end below those of the loading.
    if constexpr (requires { law.unloading_curve; })
      if (law.unloading_curve && seed % 2 == 0) return;
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    for (const double share : shares) {
      const double largest = share * highest;
      const double top = state.lasting(largest, largest);
      constexpr double back = 1e-10;
      double slope = 0;
      if constexpr (requires { law.unloading_modulus; }) {
        const double beyond = state.lasting(largest * (1 + 1e-6), 0) - top;
        slope = std::max(law.unloading_modulus, 2 * beyond / (1e-6 * largest));
      }
      EXPECT_NEAR(state.lasting(largest * (1 - back), largest), top,
                  1e-6 * top + 1.01 * slope * back * largest)
          << "largest strain " << largest;
    }
  });
}

/// No jump in time when the rate jumps: in a nanosecond the stress changes by no more than the strain,
/// elastic and of the slip, can account for.
TEST(Foams, HaveNoJumpWhereTheRateJumps) {
  for_random_foams(60, [](std::uint64_t, const auto& law) {
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    for (const double before : {0.0, 1e-4, 1.0, 300.0, -1e-4, -1.0, -300.0})
      for (const double after : {0.0, 1e-4, 1.0, 300.0, -1e-4, -1.0, -300.0})
        for (const double share : {0.02, 0.3, 0.9}) {
          const double strain = share * highest;
          const double g = state.slip().after(0, before, 1);
          constexpr double time = 1e-9;
          const double then = strain + after * time;
          const double g_then = state.slip().after(g, after, time);
          const double change = state.stress(then, strain, g_then) - state.stress(strain, strain, g);
          // The steepest that any part is: of the lasting stress by strain, and of the rate's stress by g.
          const double step = 1e-7 * strain;
          const double steep =
              std::abs(state.lasting(strain, strain) - state.lasting(strain - step, strain)) / step +
              std::abs(state.lasting(strain + step, strain) - state.lasting(strain, strain)) / step;
          const double c = state.slip().strain;
          const auto at_g = [&](double x) {
            return state.of_rate(strain, state.slip().slip_rate(g + x * c));
          };
          double by_g = 0;
          for (int i = -50; i < 50; ++i)
            by_g = std::max(by_g, std::abs(at_g((i + 1) / 50.0) - at_g(i / 50.0)) / (c / 50));
          const double span = std::max(std::abs(after), std::abs(state.slip().slip_rate(g)));
          const double base = state.law().curve().at(strain_of(strain)).stress;
          const double over = 1 + std::abs(state.of_rate(strain, state.slip().slip_rate(g))) / base;
          const double bound =
              5 * (steep * over + by_g + base * over / strain) * span * time + 1e-9 * base * over;
          EXPECT_LE(std::abs(change), bound)
              << "strain " << strain << ", rate from " << before << " to " << after;
        }
  });
}

// --- The work
// ------------------------------------------------------------------------------------------------

/// A path of the strain: legs of constant rate. Work per volume by five points of Gauss in each of many short
/// steps, in which the slip is exact.
class Walk {
 public:
  explicit Walk(const FoamState& state) : state_(state) {}

  /// Pressing only: a column does not pull.
  void go(double strain, double rate) {
    const double length = strain - strain_;
    if (length == 0) return hold(0);
    // Short against the lag where the slip changes, and against the strain.
    const double c = state_.slip().strain;
    double left = std::abs(length);
    const double sign = length < 0 ? -1 : 1;
    while (left > 0) {
      const double fresh = std::min({c / 4 + since_jump_ / 8, 0.01, std::max(strain_ / 8, 1e-5)});
      const double step = std::min(fresh, left);
      piece(sign * step, rate);
      since_jump_ += step;
      left -= step;
    }
    strain_ = strain;
  }
  void jump() { since_jump_ = 0; }
  void hold(double time) {
    g_ = state_.slip().after(g_, 0, time);
    since_jump_ = 0;
  }

  [[nodiscard]] double work() const { return work_; }
  [[nodiscard]] double error() const { return error_; }  ///< of the quadrature, at most
  [[nodiscard]] double most() const { return most_; }    ///< put in so far, at its largest
  [[nodiscard]] double strain() const { return strain_; }
  [[nodiscard]] double stress() const { return state_.stress(strain_, largest_, g_); }

 private:
  static constexpr std::array<double, 5> place{0.04691007703066802, 0.23076534494715845, 0.5,
                                               0.76923465505284155, 0.95308992296933198};
  static constexpr std::array<double, 5> weight{0.11846344252809454, 0.23931433524968324, 0.28444444444444444,
                                                0.23931433524968324, 0.11846344252809454};

  double over(double from, double advance, double g, double rate) {
    double sum = 0;
    const double side = advance < 0 ? -1 : 1;
    for (std::size_t i = 0; i < place.size(); ++i) {
      const double e = from + advance * place[i];
      const double x = state_.slip().after(g, side * rate, std::abs(advance) * place[i] / rate);
      sum += weight[i] * std::max(state_.stress(e, std::max(largest_, e), x), 0.0);
    }
    return sum * advance;
  }
  void piece(double advance, double rate) {
    const double side = advance < 0 ? -1 : 1;
    const double middle = state_.slip().after(g_, side * rate, std::abs(advance) / 2 / rate);
    const double whole = over(strain_, advance, g_, rate);
    const double halves =
        over(strain_, advance / 2, g_, rate) + over(strain_ + advance / 2, advance / 2, middle, rate);
    // Five points against twice five points: the error is well below the difference.
    error_ += std::abs(whole - halves);
    work_ += halves;
    most_ = std::max(most_, work_);
    g_ = state_.slip().after(g_, side * rate, std::abs(advance) / rate);
    strain_ += advance;
    largest_ = std::max(largest_, strain_);
  }

  const FoamState& state_;
  double strain_ = 0, largest_ = 0, g_ = 0;
  double since_jump_ = 0;
  double work_ = 0, error_ = 0, most_ = 0;
};

/// The column never gives back more than was put in, closed path or not: ramps, holds, dithers, loops within
/// loops, reloads, at rates over six decades.
TEST(Foams, NeverGiveBackMoreThanWasPutIn) {
  double closest = 1e300;
  for_random_foams(150, [&](std::uint64_t seed, const auto& law) {
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    const double c = state.slip().strain;
    Draw dice(seed * 7919 + 1);
    for (int path = 0; path < 4; ++path) {
      Walk walk(state);
      for (int leg = 0; leg < 12; ++leg) {
        const double rate = law.curves.slowest_rate * dice.decades(1e-2, 1e6);
        walk.jump();
        switch (dice.choice(6)) {
          case 0:
          case 1: walk.go(dice.uniform(0, highest), rate); break;
          case 2: walk.hold(dice.decades(1e-6, 1e3)); break;
          case 3: {
            // Dithers about where it is, by parts of the lag or more.
            const double here = walk.strain(), by = c * dice.decades(0.03, 30);
            for (int i = 0; i < 6; ++i) {
              walk.jump();
              walk.go(std::clamp(here + (i % 2 == 0 ? by : -by), 0.0, highest), rate);
            }
            walk.jump();
            walk.go(here, rate);
            break;
          }
          case 4: walk.go(walk.strain() * dice.uniform(0, 1), rate); break;
          default: walk.go(0, rate);
        }
        ASSERT_TRUE(std::isfinite(walk.work()));
        ASSERT_GE(walk.work(), -walk.error() - 1e-9 * walk.most())
            << "path " << path << ", leg " << leg << ": of " << walk.most() << " J/m3 put in";
      }
      walk.jump();
      walk.go(0, law.curves.slowest_rate * dice.decades(1e-2, 1e6));
      ASSERT_GE(walk.work(), -walk.error() - 1e-9 * walk.most()) << "path " << path << ", at the end";
      const double scale = state.law().curve().at(strain_of(highest)).work;
      EXPECT_LT(walk.error(), 5e-3 * walk.most() + 1e-6 * scale) << "a quadrature that proves nothing";
      if (walk.most() > 0) closest = std::min(closest, walk.work() / walk.most());
    }
  });
  fmt::print("least share lost on a path: {:.3g}\n", closest);
}

/// Fast in, slow out and slow in, fast out, with a loop inside: the classical ways to gain from a rate.
TEST(Foams, GainNothingFromTheRateOfTheWayBack) {
  for_random_foams(20, [](std::uint64_t, const auto& law) {
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    for (const double up : {1e-2, 1.0, 1e2, 1e4})
      for (const double down : {1e-2, 1.0, 1e2, 1e4})
        for (const double largest : {0.05, 0.5, 1.0}) {
          Walk walk(state);
          for (int i = 0; i < 3; ++i) {
            walk.jump();
            walk.go(largest * highest, up * law.curves.slowest_rate);
            walk.jump();
            walk.go(i == 0 ? 0.9 * largest * highest : 0, down * law.curves.slowest_rate);
          }
          EXPECT_GE(walk.work(), -walk.error() - 1e-9 * walk.most())
              << "up at " << up << ", down at " << down << " times the slowest rate, to "
              << largest * highest;
        }
  });
}

/// From a state that was already reached back to it: no state function of the slip is left to gain from once
/// the slip has died out.
TEST(Foams, LoseWorkOnEveryLoopBetweenStatesAtRest) {
  for_random_foams(80, [](std::uint64_t seed, const auto& law) {
    const FoamState state(law);
    const double highest = highest_strain_of(state);
    Draw dice(seed);
    for (int loop = 0; loop < 4; ++loop) {
      Walk walk(state);
      // The largest strain is behind, so that both ends are the same state.
      walk.go(highest, 100 * law.curves.slowest_rate);
      walk.go(dice.uniform(0, highest), law.curves.slowest_rate);
      walk.hold(1e12);
      const double from = walk.work(), strain = walk.strain();
      for (int leg = 0; leg < 5; ++leg) {
        walk.jump();
        walk.go(dice.uniform(0, highest), law.curves.slowest_rate * dice.decades(1e-2, 1e6));
        if (dice.choice(3) == 0) walk.hold(dice.decades(1e-6, 1e3));
      }
      walk.jump();
      walk.go(strain, law.curves.slowest_rate * dice.decades(1e-2, 1e6));
      EXPECT_GE(walk.work() - from, -walk.error() - 1e-6 * walk.most()) << "loop " << loop;
    }
  });
}

/// Slow loading and unloading of a crushable foam: it gives back a triangle, and keeps the rest of the
/// strain.
TEST(CrushableFoams, GiveBackATriangleAndKeepTheRest) {
  const std::uint64_t first = environment("DASHPAD_RANDOM_SEED", 1);
  const std::uint64_t cases = environment("DASHPAD_RANDOM_CASES", 100);
  for (std::uint64_t seed = first; seed < first + cases; ++seed) {
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const CrushableFoam law = random_crushable_foam(seed);
    const FoamState state(law);
    for (const double share : {0.05, 0.3, 0.7, 1.0}) {
      const double largest = share * state.law().curve().last_strain();
      const double top = state.law().curve().at(strain_of(largest)).stress;
      const double modulus = law.unloading_modulus;
      const double kept = largest - top / modulus;
      // So slowly that the rate adds nothing.
      const double rate = law.curves.slowest_rate * 1e-3;
      Walk walk(state);
      walk.go(largest, rate);
      const double at_top = walk.work();
      walk.jump();
      walk.go(kept, rate);
      const double returned = at_top - walk.work();
      EXPECT_NEAR(returned, top * top / (2 * modulus), 1e-6 * at_top) << "strain " << largest;
      EXPECT_NEAR(walk.stress(), 0, 1e-9 * top);
      EXPECT_GT(state.lasting(kept + 1e-6 * largest, largest), 0);
      EXPECT_EQ(state.lasting(kept - 1e-6 * largest, largest), 0);
      walk.go(0, rate);
      EXPECT_NEAR(at_top - walk.work(), returned, 1e-9 * at_top)
          << "nothing more below the strain that is kept";
    }
  }
}

}  // namespace
}  // namespace dashpad::test
