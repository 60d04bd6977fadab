/// Pads of layers: layers of one foam against the pad of that foam, linear layers against springs in series,
/// layers of two foams against a second solver, the order of the method, and the limits.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "model/contact/layered_contact.hpp"
#include "oracle/foam_formulas.hpp"
#include "oracle/layered_impact.hpp"
#include "shared/samples.hpp"
#include "verification/order.hpp"

namespace dashpad::test {
namespace {

PadLayer layer_of(double thickness, const PadLaw& law) {
  PadLayer layer;
  layer.thickness = thickness;
  layer.material.name = name_of(law);
  layer.material.law = law;
  return layer;
}

ImpactCase in_layers(ImpactCase impact, std::vector<PadLayer> layers) {
  set_layers(impact.pad, std::move(layers));
  return impact;
}

Foam steady_foam(const RateEffect& effect = NoRateEffect{}) {
  Foam foam;
  foam.curves = {.base = soft_table(), .slowest_rate = 0.01, .rate_effect = effect};
  return foam;
}

std::vector<std::pair<std::string, PadLaw>> layer_laws() {
  Foam damaged = steady_foam();
  damaged.unloading_factor = 0.2;
  damaged.unloading_shape = 2;
  Foam rubbing = steady_foam();
  rubbing.friction = 0.2;
  Foam by_curve = steady_foam();
  by_curve.unloading_curve = soft_table();
  for (double& stress : by_curve.unloading_curve->stress) stress *= 0.5;
  by_curve.unloading_curve->stress.back() *= 2;
  Foam recoiling = steady_foam(PowerRateEffect{0.08, 0, 1000});
  recoiling.unloading_factor = 0.3;
  return {{"elastic", sample_law<Elastic>()},
          {"linear viscoelastic", sample_law<LinearViscoelastic>()},
          {"crushable", sample_law<CrushableFoam>()},
          {"without loss", steady_foam()},
          {"damage", damaged},
          {"friction", rubbing},
          {"unloading curve", by_curve},
          {"rate and recoil", recoiling},
          {"strong rate", steady_foam(PowerRateEffect{0.15, 0, 30})},
          {"all at once", sample_law<Foam>()}};
}

/// A third and two thirds of one foam are that foam, below a flat nose as exactly as two runs agree, below a
/// sphere to the tolerance, since the sampling points are others.
TEST(Layers, OfOneFoamAreThePadOfThatFoam) {
  double worst = 0;
  for (const auto& [name, law] : layer_laws())
    for (const Nose& nose : {Nose(FlatDisc{0.06}), Nose(Sphere{0.08})})
      for (const Support& support : {Support::rigid(), Support::linear(2e5)}) {
        SCOPED_TRACE(fmt::format("{}, {}, {}", name, name_of(nose), support.is_rigid() ? "rigid" : "linear"));
        ImpactCase whole = impact_on(law, support);
        whole.impactor.nose = nose;
        const Options options{.tolerance = 1e-3};
        const Summary one = solve(whole, options).summary;
        const Summary two =
            solve(in_layers(whole, {layer_of(0.01, law), layer_of(0.02, law)}), options).summary;
        ASSERT_EQ(one.status, two.status);
        // Each run may be in error by the tolerance; measured is a quarter of it.
        constexpr double limit = 1e-3;
        EXPECT_NEAR(*two.peak_force / *one.peak_force, 1, limit);
        EXPECT_NEAR(two.peak_penetration / one.peak_penetration, 1, limit);
        EXPECT_NEAR(*two.rebound_speed, *one.rebound_speed, limit * whole.impactor.speed);
        EXPECT_NEAR(two.contact_end->time / one.contact_end->time, 1, limit);
        EXPECT_NEAR(two.layers[0].peak_strain, two.peak_strain, 2e-3);
        EXPECT_NEAR(two.layers[1].peak_strain, two.peak_strain, 2e-3);
        worst = std::max({worst, std::abs(*two.peak_force / *one.peak_force - 1),
                          std::abs(*two.rebound_speed - *one.rebound_speed) / whole.impactor.speed});
      }
  fmt::print("largest difference of peak force and rebound speed: {:.1e}\n", worst);
}

/// Struck so hard that a thousandth of the thickness is left: the stress at the axis grows with the power of
/// the gap with which the foam is continued, and so must what the contact integral is weighted with.
TEST(Layers, OfOneFoamStruckHardAreThePadOfThatFoam) {
  Foam law = steady_foam();
  law.continuation_exponent = 2.5;
  ImpactCase whole = impact_on(law);
  whole.impactor.nose = Sphere{0.08};
  whole.impactor.speed = 11;
  const Options options{.tolerance = 1e-3};
  const Summary one = solve(whole, options).summary;
  const Summary two = solve(in_layers(whole, {layer_of(0.01, law), layer_of(0.02, law)}), options).summary;
  ASSERT_EQ(one.status, Status::released);
  ASSERT_EQ(two.status, Status::released);
  EXPECT_GT(one.peak_strain, 0.99);
  EXPECT_NEAR(*two.peak_force / *one.peak_force, 1, 1e-3);
  EXPECT_NEAR(*two.rebound_speed / *one.rebound_speed, 1, 1e-3);
}

/// Linear layers are springs in series: k = a / sum(L_i / E_i), the peak force V sqrt(M k).
TEST(Layers, LinearOnesBelowADiscAreSpringsInSeries) {
  ImpactCase impact = impact_on(Elastic{3e5});
  impact.impactor.nose = FlatDisc{0.06};
  impact = in_layers(
      impact, {layer_of(0.012, Elastic{3e5}), layer_of(0.008, Elastic{9e5}), layer_of(0.01, Elastic{5e5})});
  const double stiffness = sections_of(impact).tip / (0.012 / 3e5 + 0.008 / 9e5 + 0.01 / 5e5);
  const Summary s = solve(impact, {.tolerance = 1e-7}).summary;
  const double force = impact.impactor.speed * std::sqrt(impact.impactor.mass * stiffness);
  EXPECT_NEAR(*s.peak_force / force, 1, 1e-6);
  EXPECT_NEAR(s.peak_penetration * stiffness / force, 1, 1e-6);
  EXPECT_NEAR(*s.rebound_speed / impact.impactor.speed, 1, 1e-6);
  const double stress = force / sections_of(impact).tip;
  EXPECT_NEAR(s.layers[1].peak_strain / (stress / 9e5), 1, 1e-3);
}

/// Below a sphere they are one layer of the modulus L / sum(L_i / E_i), for which there is a closed form.
TEST(Layers, LinearOnesBelowASphereHaveAnEffectiveModulus) {
  const double effective = 0.03 / (0.012 / 3e5 + 0.018 / 6e5);
  ImpactCase one = impact_on(Elastic{effective});
  one.impactor.speed = 1.5;  // no layer is closed
  const ImpactCase two = in_layers(one, {layer_of(0.012, Elastic{3e5}), layer_of(0.018, Elastic{6e5})});
  const Summary a = solve(one, {.tolerance = 1e-6}).summary;
  const Summary b = solve(two, {.tolerance = 1e-5}).summary;
  EXPECT_NEAR(*b.peak_force / *a.peak_force, 1, 1e-5);
  EXPECT_NEAR(b.peak_penetration / a.peak_penetration, 1, 1e-5);
  EXPECT_NEAR(*b.rebound_speed / *a.rebound_speed, 1, 1e-5);
}

/// Two foams that differ in curve, rate effect and way back, against the second solver, whole impact.
TEST(Layers, OfTwoFoamsAgreeWithTheSecondSolver) {
  Foam soft = steady_foam(PowerRateEffect{0.08, 0, 1000});
  soft.unloading_factor = 0.4;
  soft.unloading_shape = 2;
  soft.lag_strain = 0.02;
  Foam hard = steady_foam(PowerRateEffect{0.03, 0, 500});
  hard.curves.base = GibsonAshbyCurve{2e6, 90e3, 50e3, 0.05, 0.8};
  hard.friction = 0.1;
  hard.lag_strain = 0.02;
  const oracle::FoamFormulas of_soft(soft), of_hard(hard);
  ImpactCase impact = impact_on(soft);
  impact.impactor.nose = FlatDisc{0.06};
  const Summary s =
      solve(in_layers(impact, {layer_of(0.015, soft), layer_of(0.015, hard)}), {.tolerance = 2e-4}).summary;
  const oracle::LayeredPeaks exact =
      oracle::solve_layers({impact.impactor.mass, impact.impactor.speed, sections_of(impact).tip, 5e-6},
                           {{0.015, &of_soft}, {0.015, &of_hard}});
  fmt::print(
      "peak force {:.2f} and {:.2f} N, penetration {:.5f} and {:.5f} mm, rebound {:.5f} and {:.5f} m/s\n",
      *s.peak_force, exact.force, 1e3 * s.peak_penetration, 1e3 * exact.penetration, *s.rebound_speed,
      exact.rebound_speed);
  EXPECT_NEAR(*s.peak_force / exact.force, 1, 1e-4);
  EXPECT_NEAR(s.peak_penetration / exact.penetration, 1, 1e-4);
  EXPECT_NEAR(*s.rebound_speed / impact.impactor.speed, exact.rebound_speed / impact.impactor.speed, 1e-4);
  // Of the finest run, not extrapolated.
  EXPECT_NEAR(s.layers[0].peak_strain, exact.strain[0], 1e-3);
  EXPECT_NEAR(s.layers[1].peak_strain, exact.strain[1], 1e-3);

  // A column has one stress: which layer is struck makes no difference.
  const Summary turned =
      solve(in_layers(impact, {layer_of(0.015, hard), layer_of(0.015, soft)}), {.tolerance = 2e-4}).summary;
  EXPECT_NEAR(*turned.peak_force / *s.peak_force, 1, 1e-9);
  EXPECT_NEAR(*turned.rebound_speed / *s.rebound_speed, 1, 1e-6);
}

/// The rate of the force of a pad held still (Eq. 54) against what a short step without advance changes,
/// loaded and on the way back.
TEST(Layers, HeldStillRelaxAsEq74Says) {
  const Foam soft = steady_foam(PowerRateEffect{0.08, 0, 1000});
  Foam hard = steady_foam(PowerRateEffect{0.05, 0, 1000});
  hard.curves.base = GibsonAshbyCurve{2e6, 90e3, 50e3, 0.05, 0.8};
  hard.unloading_factor = 0.5;
  for (const Nose& nose : {Nose(FlatDisc{0.06}), Nose(Sphere{0.08})}) {
    LayeredContact contact({{0.015, soft}, {0.01, hard}, {0.005, sample_law<LinearViscoelastic>()}},
                           sections_of(nose));
    contact.start(0.1, 0.015);
    constexpr double step = 1e-4;
    double time = 0;
    for (int k = 0; k < 60; ++k, time += step) {
      const double advance = k < 50 ? 2.5e-4 : -1e-4;
      const PadTrial trial = contact.trial(advance, time, step);
      const double rate = contact.force_rate_when_held(trial);
      contact.accept(trial);
      if (k % 10 != 5) continue;
      constexpr double moment = 1e-10;
      const double before = contact.trial(0, time + step, moment).force;
      const double change = contact.trial(0, time + step, 2 * moment).force - before;
      // A hundredth of the time in which the slip relaxes has passed at most.
      EXPECT_NEAR(change / moment / rate, 1, 0.02) << name_of(nose) << ", step " << k;
    }
  }
}

/// Two foams of different rate effects.
std::vector<LayerSeries::Part> skin_and_core() {
  return {{0.02, steady_foam(PowerRateEffect{0.08, 0, 1000})}, {0.05, sample_law<Foam>()}};
}

/// A penetration, slow and then fast, with few columns, twice as many, and sixteen times. With lines in place
/// of the cubics of Eq. 55a the errors are 1.4e-3 and 5.1e-4.
TEST(Layers, AreWeightedByCubics) {
  const auto forces = [&](double resolution) {
    LayeredContact contact(skin_and_core(), sections_of(Sphere{0.08}));
    contact.start(resolution, 0.045);
    std::vector<double> force;
    double time = 0;
    for (const double step : {1e-3, 1e-4}) {
      for (int k = 0; k < 20; ++k, time += step) {
        const PadTrial trial = contact.trial(1e-3, time, step);
        force.push_back(trial.force);
        contact.accept(trial);
      }
    }
    return force;
  };
  const std::vector<double> few = forces(0.1), more = forces(0.05), many = forces(0.00625);
  double of_few = 0, of_more = 0;
  for (std::size_t k = 10; k < many.size(); ++k) {
    of_few = std::max(of_few, std::abs(few[k] / many[k] - 1));
    of_more = std::max(of_more, std::abs(more[k] / many[k] - 1));
  }
  fmt::print("largest error of the force: {:.1e}, with twice the columns {:.1e}\n", of_few, of_more);
  EXPECT_LT(of_few, 1e-3);
  EXPECT_LT(of_more, 2e-4);
}

/// A step that ends a little beyond its trial leaves the layers as if it had been tried there, but for the
/// square of that little.
TEST(Layers, MoveOnAsIfTriedThere) {
  LayeredContact moved(skin_and_core(), sections_of(Sphere{0.08}));
  LayeredContact tried(skin_and_core(), sections_of(Sphere{0.08}));
  for (LayeredContact* contact : {&moved, &tried}) contact->start(0.02, 0.045);
  constexpr double step = 2e-4;
  double worst = 0;
  for (int k = 0; k < 60; ++k) {
    const double advance = k < 40 ? 1e-3 : -1e-3;
    const double further = k == 40 ? 0 : 1e-3 * advance;  // at the turn stresses jump
    PadTrial trial = moved.trial(advance - further, k * step, step);
    const PadTrial there = tried.trial(advance, k * step, step);
    trial.further = further;
    moved.accept(trial);
    tried.accept(there);
    const double force = moved.trial(0, (k + 1) * step, step).force;
    const double expected = tried.trial(0, (k + 1) * step, step).force;
    if (expected > 0) worst = std::max(worst, std::abs(force / expected - 1));
  }
  fmt::print("largest difference of the force: {:.1e}\n", worst);
  EXPECT_LT(worst, 1e-6);
}

/// What was just solved is its own guess: a column looked at again, or free of stress, takes few looks.
TEST(Layers, AColumnSolvedBeforeTakesFewLooks) {
  CrushableFoam crushed = sample_law<CrushableFoam>();
  crushed.curves.rate_effect = PowerRateEffect{0.05, 0, 1000};
  CrushableFoam hard = crushed;
  hard.curves.base = GibsonAshbyCurve{2e6, 90e3, 50e3, 0.05, 0.8};
  LayeredContact contact({{0.015, crushed}, {0.01, hard}}, sections_of(Sphere{0.08}));
  contact.start(0.05, 0.015);
  constexpr double step = 1e-4;
  double time = 0, looks = 0, columns = 0;
  int free_of_stress = 0;
  for (int k = 0; k < 70; ++k, time += step) {
    const double advance = k < 50 ? 2.5e-4 : -1e-4;
    contact.trial(advance, time, step);
    const std::size_t before = contact.updates();
    contact.accept(contact.trial(advance * (1 + 1e-13), time, step));
    looks += double(contact.updates() - before);
    columns += double(contact.touched_columns());
    for (std::size_t j = 0; j < contact.touched_columns(); ++j)
      free_of_stress += contact.column(j).stress < 0;
  }
  EXPECT_GT(free_of_stress, 0.1 * columns);
  EXPECT_LT(free_of_stress, 0.9 * columns);
  // One look and two to tell the slope by, and now and then one more.
  EXPECT_LT(looks, 4 * double(contact.layers()) * columns);
}

/// Even steps against steps a quarter of the finest, on loading below a disc.
TEST(Layers, TheStepIsOfSecondOrder) {
  const LinearViscoelastic soft = sample_law<LinearViscoelastic>();
  Foam hard = steady_foam();
  hard.curves.base = GibsonAshbyCurve{2e6, 90e3, 50e3, 0.05, 0.8};
  ImpactCase impact = impact_on(soft, Support::linear(2e5));
  impact.impactor.nose = FlatDisc{0.06};
  impact = in_layers(impact, {layer_of(0.015, soft), layer_of(0.015, hard)});
  const double time = 0.4 * impact.pad.thickness / impact.impactor.speed;
  constexpr int levels = 4, coarsest = 8;
  const State fine = loaded_for(impact, time, coarsest << (levels + 1));
  std::vector<double> size, of_velocity;
  for (int level = 0; level < levels; ++level) {
    const State end = loaded_for(impact, time, coarsest << level);
    size.push_back(time / (coarsest << level));
    of_velocity.push_back(std::abs(end.velocity - fine.velocity) / impact.impactor.speed);
  }
  // The parabola of the force (Eq. 23) leaves a third order where that of Eq. 9 is small.
  expect_order(size, of_velocity, "layers: velocity", 3.6);
}

/// A soft layer is struck through, and the other carries on.
TEST(Layers, OneStruckThroughLeavesTheOthers) {
  ImpactCase impact = impact_on(Elastic{3e5}, Support::linear(1e6));
  impact.impactor.nose = FlatDisc{0.06};
  impact = in_layers(impact, {layer_of(0.003, Elastic{2e4}), layer_of(0.027, Elastic{5e5})});
  const Summary s = solve(impact, {.tolerance = 1e-4}).summary;
  EXPECT_EQ(s.status, Status::released);
  ASSERT_TRUE(s.layers[0].struck_through.has_value());
  EXPECT_FALSE(s.layers[1].struck_through.has_value());
  EXPECT_NEAR(s.layers[0].peak_strain, 1, 1e-6);
  EXPECT_LT(std::abs(s.energy.residual), 1e-4 * s.energy.impact);
  EXPECT_NEAR(s.energy_absorbed_fraction, 0, 2e-3);
}

/// The stress at the axis grows over the gap that is left, of a millionth of the thickness as of a tenth.
/// Where no columns stood within a fiftieth, and the last step into the lock was long, the speed there
/// differed by 17 times itself from run to run.
TEST(Layers, ThatCloseKeepTheLedgerToTheEnd) {
  ImpactCase impact = impact_on(sample_law<LinearViscoelastic>(), Support::rigid());
  impact.impactor = {.mass = 0.94, .nose = Cone{.radius = 0.025, .half_angle = 1.1}, .speed = 0.92};
  impact =
      in_layers(impact, {layer_of(0.0041, input::read_material(material_folder / "ff-leap.toml").value().law),
                         layer_of(0.0036, LinearViscoelastic{.asymptotic_modulus = 207e3,
                                                             .initial_modulus = 834e3,
                                                             .relaxation_time = 5.8e-3})});
  const Summary coarse = solve(impact, {.tolerance = 1e-4, .fixed_runs = 3}).summary;
  const Summary fine = solve(impact, {.tolerance = 1e-4, .fixed_runs = 4}).summary;
  ASSERT_TRUE(coarse.bottomed && fine.bottomed);
  EXPECT_NEAR(coarse.bottomed->velocity, fine.bottomed->velocity, 1e-3 * fine.bottomed->velocity);
  EXPECT_LT(std::abs(fine.energy.residual), 1e-3 * fine.energy.impact);
}

}  // namespace
}  // namespace dashpad::test
