/// The contact of a nose with a foam by curves: its force is the integral of the columns' stress, and its
/// steps and panels converge.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "model/contact/foam_contact.hpp"
#include "property/random_case.hpp"
#include "shared/run_once.hpp"
#include "shared/samples.hpp"
#include "verification/order.hpp"

namespace dashpad::test {
namespace {

constexpr double thickness = 0.03;

/// Integral of the positive stress of the columns in the accepted state, by very many of them.
double force_of_columns(const FoamContact& contact, const Sections& nose, double penetration) {
  double force = nose.tip > 0 ? nose.tip * std::max(contact.column(0).stress, 0.0) : 0;
  const double deepest = std::min(penetration, nose.depth);
  constexpr int count = 6000;
  // Middles of pieces that are even in the root of the strain, and so are small where the strain is.
  const double low = std::sqrt((penetration - deepest) / penetration);
  const auto depth_at = [&](double place) {
    const double x = low + (1 - low) * place / count;
    return std::max(penetration * (1 - x) * (1 + x), 0.0);
  };
  double outer = nose.area(depth_at(0));
  for (int i = 0; i < count; ++i) {
    const double inner = nose.area(depth_at(i + 1));
    force += std::max(contact.column(depth_at(i + 0.5)).stress, 0.0) * (outer - inner);
    outer = inner;
  }
  return force;
}

/// Takes the contact through a path of the penetration: of the force, its largest difference over its
/// largest.
struct Worst {
  double difference = 0;
  double penetration = 0, expected = 0, found = 0;
};
template <class Law>
Worst force_against_columns(const Law& law, const Sections& nose, std::uint64_t seed, double resolution) {
  FoamContact contact(law, thickness, nose);
  contact.start(resolution, thickness);
  std::mt19937_64 generator(seed);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(generator() >> 11) * 0x1p-53;
  };
  double y = 0, time = 0, largest = 0;
  Worst worst;
  for (int leg = 0; leg < 8; ++leg) {
    const double to = leg == 0 ? uniform(0.3, 0.9) * thickness : uniform(0, 0.9) * thickness;
    const double step =
        std::abs(to - y) / thickness / law.curves.slowest_rate / std::pow(10, uniform(-1, 5)) / 4;
    for (int i = 0; i < 4; ++i) {
      const PadTrial trial = contact.trial((to - y) / (4 - i), time, step);
      contact.accept(trial);
      y += trial.advance, time += step;
      largest = std::max(largest, trial.force);
      const double expected = force_of_columns(contact, nose, y);
      const double difference = std::abs(trial.force - expected) / largest;
      if (difference > worst.difference) worst = {difference, y, expected, trial.force};
    }
  }
  return worst;
}

/// A step that ends beyond its trial leaves the foam as if it had been tried there.
TEST(FoamContact, MovesOnAsIfTriedThere) {
  FoamContact moved(sample_law<Foam>(), thickness, sections_of(Sphere{0.08}));
  FoamContact tried(sample_law<Foam>(), thickness, sections_of(Sphere{0.08}));
  for (FoamContact* contact : {&moved, &tried}) contact->start(0.1, thickness / 2);
  constexpr double step = 2e-4;
  for (int k = 0; k < 30; ++k) {
    const double advance = k < 20 ? 5e-4 : -5e-4;
    PadTrial trial = moved.trial(0.99 * advance, k * step, step);
    trial.further = 0.01 * advance;
    moved.accept(trial);
    tried.accept(tried.trial(advance, k * step, step));
    const double force = moved.trial(advance, (k + 1) * step, step).force;
    const double expected = tried.trial(advance, (k + 1) * step, step).force;
    ASSERT_NEAR(force, expected, 1e-9 * std::abs(expected)) << k;
  }
}

/// Also where columns in the middle of the contact press while others are let go.
TEST(FoamContactForce, IsTheIntegralOfItsColumns) {
  double of_all = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed)
    for (const Nose& nose :
         {Nose(Sphere{0.08}), Nose(Sphere{0.015}), Nose(FlatDisc{0.06}), Nose(Cone{0.1, 1.2}),
          Nose(Cone{0.05, 1.3, 0.02}), Nose(Rod{0.02, 0.05}), Nose(Cylinder{0.06, 0.15}),
          Nose(Cylinder{0.01, 0.1}),
          Nose(Profile{.points = {{0, 0.005}, {0.004, 0.02}, {0.012, 0.022}, {0.02, 0.05}}})}) {
      const auto check = [&](const auto& law) {
        const Worst worst = force_against_columns(law, sections_of(nose), seed, 1e-4);
        EXPECT_LT(worst.difference, 1e-3)
            << law.name << ", seed " << seed << ", " << name_of(nose) << ", penetration " << worst.penetration
            << ": " << worst.found << " instead of " << worst.expected;
        of_all = std::max(of_all, worst.difference);
      };
      check(random_foam(seed));
      check(random_crushable_foam(seed));
      check(sample_law<Foam>());
      check(sample_law<CrushableFoam>());
    }
  fmt::print("largest difference {:.2g}\n", of_all);
}

/// On the way back columns between the edge and the axis can press while both of these do not: at the edge
/// the unloading has taken the stress, at the axis the rate.
TEST(FoamContactForce, CountsARingThatPressesAloneAsWell) {
  const Sections nose = Sphere{0.08}.sections();
  int rings = 0;
  for (const double slope : {-0.05, 0.05, 0.1, 0.3})
    for (const double recoil : {0.5, 1.0}) {
      Foam law = sample_law<Foam>();
      law.recoil = recoil;
      law.curves.rate_effect = PowerRateEffect{0.08, slope, 300};
      ASSERT_TRUE(violations(PadLaw(law)).empty());
      FoamContact contact(law, thickness, nose);
      contact.start(1e-4, thickness);
      double y = 0, time = 0, largest = 0;
      const auto go = [&](double strain, double step) {
        const PadTrial trial = contact.trial(strain * thickness - y, time, step);
        contact.accept(trial);
        y = strain * thickness, time += step;
        largest = std::max(largest, trial.force);
        EXPECT_NEAR(trial.force, force_of_columns(contact, nose, y), 1e-5 * largest)
            << "recoil " << recoil << ", exponent 0.08 + " << slope << " e, strain " << strain;
        const bool ends_let_go = contact.column(0.999 * y).stress <= 0 && contact.column(0).stress <= 0;
        if (ends_let_go && force_of_columns(contact, nose, y) > 1e-4 * largest) ++rings;
      };
      for (int i = 1; i <= 8; ++i) go(0.77 * i / 8, 1e-3);
      for (int i = 76; i >= 2; --i) go(0.77 * i / 77, 1e-4);
    }
  EXPECT_GT(rings, 0) << "otherwise this test asks for nothing";
}

/// Where the rate counts most at a strain between, columns there let go before those at the edge and at the
/// axis do.
TEST(FoamContactForce, LeavesOutWhatLetsGoBetweenEdgeAndAxis) {
  const Sections nose = Sphere{0.08}.sections();
  Foam law = sample_law<Foam>();
  law.friction = 0;
  law.unloading_factor = 0, law.unloading_shape = 0.3, law.recoil = 0.7;
  TableCurve slow, fast;
  for (int i = 1; i <= 30; ++i) {
    const double strain = 0.02 * i;
    slow.strain.push_back(strain), fast.strain.push_back(strain);
    slow.stress.push_back(1e4 * (1 + 5 * strain));
    fast.stress.push_back(1e4 * (1.8 + 5 / (1 + std::exp(-(strain - 0.15) / 0.015))));
  }
  law.curves = {.base = slow, .slowest_rate = 1e-4, .rate_effect = CurvesRateEffect{{{10, fast}}}};
  law.unloading_curve.reset();
  ASSERT_TRUE(violations(PadLaw(law)).empty());
  FoamContact contact(law, thickness, nose);
  contact.start(1e-4, thickness);
  double y = 0, time = 0, largest = 0;
  int gaps = 0;
  const auto go = [&](double strain, double step) {
    const PadTrial trial = contact.trial(strain * thickness - y, time, step);
    contact.accept(trial);
    y = strain * thickness, time += step;
    largest = std::max(largest, trial.force);
    const auto presses = [&](double at) { return contact.column(y - at * thickness).stress > 0; };
    gaps += strain > 0.4 && presses(0.06) && !presses(0.2) && presses(0.98 * strain);
    EXPECT_NEAR(trial.force, force_of_columns(contact, nose, y), 1e-4 * largest) << "strain " << strain;
  };
  for (int i = 1; i <= 8; ++i) go(0.5 * i / 8, 1e-3);
  for (const double rate : {1e-4, 1e-2, 0.1, 1.0, 10.0})
    for (int i = 0; i < 4; ++i) go(y / thickness - 0.004, 0.004 / rate);
  EXPECT_GT(gaps, 0) << "otherwise this test asks for nothing";
}

TEST(FoamContactForce, OfAFlatDiscIsItsAreaTimesTheStress) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    const auto check = [&](const auto& law) {
      const FoamStress column(law);
      FoamContact contact(law, thickness, FlatDisc{0.06}.sections());
      contact.start(0.01, thickness);
      const double area = std::numbers::pi * 0.06 * 0.06;
      double y = 0, g = 0, time = 0;
      for (const double to : {0.2, 0.5, 0.8, 0.7, 0.3, 0.6, 0.85, 0.1}) {
        // A rate that holds from step to step, so that the slip is exact.
        contact.start(0.01, thickness);
        y = g = time = 0;
        const double rate = 30, step = to / rate / 8;
        for (int i = 0; i < 8; ++i) {
          const PadTrial trial = contact.trial(to * thickness / 8, time, step);
          contact.accept(trial);
          y += trial.advance, time += step;
          g = column.slip().after(g, rate, step);
          const Strain strain{y / thickness, (thickness - y) / thickness};
          expect_relative(trial.force, area * column.stress(strain, 0, g), 1e-9,
                          fmt::format("seed {}, force", seed));
        }
      }
    };
    check(random_foam(seed));
    check(random_crushable_foam(seed));
  }
}

// --- Orders
// --------------------------------------------------------------------------------------------------

Foam smooth_foam() {
  Foam law;
  law.unloading_factor = 0.3;
  law.curves = {.base = GibsonAshbyCurve{400e3, 50e3, 40e3, 0.02, 0.9},
                .slowest_rate = 0.01,
                .rate_effect = PowerRateEffect{0.06, 0, 300}};
  // The rate's stress follows within a strain that even the coarsest step resolves.
  law.lag_strain = 0.05;
  return law;
}

TEST(FoamOrder, OfTheTimeStepsIsTwoAtLeast) {
  CrushableFoam crushable;
  crushable.unloading_modulus = 2e6;
  crushable.curves = smooth_foam().curves;
  crushable.lag_strain = 0.05;
  for (const PadLaw& law : {PadLaw(smooth_foam()), PadLaw(crushable)})
    for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
      const ImpactCase impact = impact_on(law, support);
      const double time = 0.4 * impact.pad.thickness / impact.impactor.speed;
      constexpr int levels = 4, coarsest = 48;
      constexpr double finest = 1e-4;  // of the panels
      const State fine = loaded_for(impact, time, coarsest << (levels + 1), finest);
      std::vector<double> size, of_velocity, of_penetration;
      for (int level = 0; level < levels; ++level) {
        const int steps = coarsest << level;
        const State end = loaded_for(impact, time, steps, finest);
        size.push_back(time / steps);
        of_velocity.push_back(std::abs(end.velocity - fine.velocity) / impact.impactor.speed);
        of_penetration.push_back(std::abs(end.penetration - fine.penetration) / fine.penetration);
      }
      const std::string on =
          fmt::format("{}, {} support, ", name_of(law), support.is_rigid() ? "rigid" : "linear");
      expect_order(size, of_velocity, on + "velocity", 3.2);
      expect_order(size, of_penetration, on + "penetration", 3.2);
    }
}

/// The force of one path by ever more panels. On loading it is a closed form for a foam whose rate effect is
/// the same at all strains. Where it is not, and on the way back, where every column has lost another share
/// of its stress, it is of the order of the steps.
TEST(FoamOrder, OfThePanelsIsThatOfTheSteps) {
  const Sections nose = Sphere{0.08}.sections();
  const auto force_at = [&](const Foam& law, double resolution, bool back) {
    FoamContact contact(law, thickness, nose);
    contact.start(resolution, thickness);
    const PadTrial loaded = contact.trial(0.6 * thickness, 0, 0.01);
    if (!back) return loaded.force;
    contact.accept(loaded);
    return contact.trial(-0.02 * thickness, 0.01, 0.01).force;
  };
  const auto error_at = [&](const Foam& law, double resolution, bool back) {
    return relative_error(force_at(law, resolution, back), force_at(law, 1e-6, back));
  };
  const Foam even = smooth_foam();
  EXPECT_LT(error_at(even, 0.1, false), 1e-14);
  Foam uneven = even;
  std::get<PowerRateEffect>(uneven.curves.rate_effect).exponent_slope = -0.05;
  struct Path {
    const Foam& law;
    bool back;
    double error;  ///< at the resolution of 0.1
  };
  for (const auto& [law, back, error] :
       {Path{uneven, false, 1e-5}, {even, true, 1e-3}, {uneven, true, 1e-3}}) {
    EXPECT_LT(error_at(law, 0.1, back), error);
    const double coarse = error_at(law, 0.01, back);
    EXPECT_LT(coarse, 1e-5);
    EXPECT_GT(coarse, 0) << "no panel was needed";
    EXPECT_LT(error_at(law, 0.001, back), coarse / 50);
  }
}

/// Between the points of a tested curve the ratio to the base curve waves; panels as wide as some of the
/// waves see them by chance.
TEST(FoamContactForce, SeesTheWavesBetweenThePointsOfTestedCurves) {
  const Sections nose = Sphere{0.08}.sections();
  for (const bool linear : {true, false})
    for (const int count : {12, 20}) {
      Foam law = smooth_foam();
      const auto& base = std::get<GibsonAshbyCurve>(law.curves.base);
      TableCurve points;
      for (int i = 1; i <= count; ++i) {
        const double strain = base.highest_strain * i * i / (count * count);
        points.strain.push_back(strain);
        points.stress.push_back(1.5 * base.stress(strain));
      }
      law.curves.rate_effect = CurvesRateEffect{{{100, points}}, linear};
      const auto force_at = [&](double resolution) {
        FoamContact contact(law, thickness, nose);
        contact.start(resolution, thickness);
        return contact.trial(0.6 * thickness, 0, 0.01).force;
      };
      const double exact = force_at(1e-6);
      for (const auto& [resolution, error] : {std::pair{0.05, 6e-6}, {0.0125, 1e-6}})
        EXPECT_LT(relative_error(force_at(resolution), exact), error)
            << count << " points, at a resolution of " << resolution;
    }
}

/// A pad that a damper stops at once gives way in far less time than the whole takes.
TEST(FoamOrder, OfTheStepsIsTwoOnADamperAsWell) {
  for (const double lag : {0.005, 0.05}) {
    ImpactCase impact;
    impact.impactor = {.mass = 0.3, .nose = FlatDisc{0.05}, .speed = 7};
    Foam law = smooth_foam();
    law.lag_strain = lag;
    impact.pad.material.law = law;
    impact.pad.thickness = 0.05;
    impact.support = Support::linear(4e4);
    impact.backing.damping = 20;
    const auto peak_at = [&](double resolution) { return run_once(impact, resolution).figures.peak_force; };
    const double exact = peak_at(0.0015625);
    EXPECT_LT(relative_error(peak_at(0.05), exact), 2.5e-4) << "lag strain " << lag;
    EXPECT_LT(relative_error(peak_at(0.0125), exact), 2e-5) << "lag strain " << lag;
  }
}

}  // namespace
}  // namespace dashpad::test
