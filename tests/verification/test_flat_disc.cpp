// A flat disc: the strain is the same everywhere below it, so the pad is one spring, one crush force, one
// column.

#include <gtest/gtest.h>

#include <boost/numeric/odeint.hpp>
#include <cmath>
#include <numbers>

#include "dashpad/impact/solve.hpp"
#include "oracle/law_formulas.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

using test::expect_relative;
using test::sample_law;

constexpr double tolerance = 1e-6;

ImpactCase disc_on(const PadLaw& law, Support support = Support::rigid()) {
  ImpactCase impact = test::impact_on(law, std::move(support));
  impact.impactor.nose = FlatDisc{0.06};
  return impact;
}

double area_of(const ImpactCase& impact) { return sections_of(impact.impactor.nose).area(1); }

TEST(flat_disc, on_an_elastic_pad_swings_like_a_mass_on_a_spring) {
  for (const Support& support : {Support::rigid(), Support::linear(5e4)}) {
    const ImpactCase impact = disc_on(Elastic{3e5}, support);
    const double pad = 3e5 * area_of(impact) / impact.pad.thickness;
    const double stiffness = support.is_rigid() ? pad : 1 / (1 / pad + 1 / 5e4);
    const double frequency = std::sqrt(stiffness / impact.impactor.mass);
    const Summary s = solve(impact, {.tolerance = tolerance}).summary;
    const double force = impact.impactor.speed * std::sqrt(stiffness * impact.impactor.mass);
    expect_relative(s.peak_force.value(), force, tolerance, "peak force");
    expect_relative(s.time_of_peak_force.value(), std::numbers::pi / 2 / frequency, tolerance, "its time");
    expect_relative(s.peak_penetration, force / pad, tolerance, "penetration");
    ASSERT_TRUE(s.release);
    expect_relative(s.release->time, std::numbers::pi / frequency, tolerance, "release");
    expect_relative(s.release->velocity, -impact.impactor.speed, tolerance, "rebound");
  }
}

TEST(flat_disc, on_rigid_foam_stops_under_a_constant_force) {
  const RigidFoam foam = sample_law<RigidFoam>();
  const ImpactCase impact = disc_on(foam);
  const double force = foam.crush_stress * area_of(impact);
  const double mass = impact.impactor.mass, speed = impact.impactor.speed;
  const Solution solution = solve(impact, {.tolerance = tolerance});
  const Summary& s = solution.summary;
  expect_relative(s.peak_force.value(), force, tolerance, "force");
  expect_relative(s.peak_penetration, mass * speed * speed / 2 / force, tolerance, "penetration");
  expect_relative(solution.history.time.back(), mass * speed / force, tolerance, "duration");
  EXPECT_EQ(solution.history.force.front(), force) << "from the first moment on";
}

/// The support gives way alone until it pushes with the crush force; then the foam does; then the support
/// swings back.
TEST(flat_disc, on_rigid_foam_waits_for_the_support) {
  constexpr double stiffness = 1e6;
  const RigidFoam foam = sample_law<RigidFoam>();
  const ImpactCase impact = disc_on(foam, Support::linear(stiffness));
  const double force = foam.crush_stress * area_of(impact);
  const double mass = impact.impactor.mass, speed = impact.impactor.speed;
  const double left = mass * speed * speed - force * force / stiffness;
  ASSERT_GT(left, 0);
  const double frequency = std::sqrt(stiffness / mass);
  const double crush = std::sqrt(mass * left) / force;  // s
  const double first = std::asin(force / (speed * std::sqrt(stiffness * mass))) / frequency;
  const Summary s = solve(impact, {.tolerance = tolerance}).summary;
  expect_relative(s.peak_force.value(), force, tolerance, "force");
  expect_relative(s.peak_penetration, left / 2 / force, tolerance, "penetration");
  ASSERT_TRUE(s.release);
  expect_relative(s.release->time, first + crush + std::numbers::pi / 2 / frequency, tolerance, "release");
  expect_relative(s.release->velocity, -force / std::sqrt(stiffness * mass), tolerance, "rebound");
}

/// On a curved support the force of the first step, which goes up from nothing, is found by a search.
TEST(flat_disc, on_rigid_foam_waits_for_a_curved_support) {
  ImpactCase impact = disc_on(RigidFoam{61819, 0.353, 241792, 0.545},
                              Support::through({{0.002, 877}, {0.005, 1324}, {0.008, 2453}, {0.012, 2522}}));
  impact.impactor = {.mass = 29.4, .nose = FlatDisc{0.016}, .speed = 11.2};
  const Summary s = solve(impact).summary;
  EXPECT_EQ(s.status, Status::released);
  EXPECT_LT(std::abs(s.energy.residual), 1e-4 * s.energy.impact);
}

/// A support too soft to push hard enough gets all back.
TEST(flat_disc, on_rigid_foam_may_not_crush_it) {
  constexpr double stiffness = 1e5;
  const ImpactCase impact = disc_on(sample_law<RigidFoam>(), Support::linear(stiffness));
  const Summary s = solve(impact, {.tolerance = tolerance}).summary;
  EXPECT_EQ(s.peak_penetration, 0);
  expect_relative(s.peak_force.value(), impact.impactor.speed * std::sqrt(stiffness * impact.impactor.mass),
                  tolerance, "force");
  ASSERT_TRUE(s.release);
  expect_relative(s.release->velocity, -impact.impactor.speed, tolerance, "rebound");
}

/// One column under the mass on a rigid support, by the oracle's own formulas and an explicit method with
/// error control: the state is penetration, velocity, stress.
template <class OracleFormulas, class Law>
void expect_one_column(const Law& law) {
  namespace odeint = boost::numeric::odeint;
  using State = std::array<double, 3>;
  const ImpactCase impact = disc_on(law);
  const double thickness = impact.pad.thickness, mass = impact.impactor.mass, area = area_of(impact);
  const OracleFormulas formulas(law);
  double largest = 0;
  bool loading = true;
  const auto slope = [&](const State& x, State& dx, double time) {
    const double strain = x[0] / thickness;
    const double rate = (loading ? std::max(x[1], 0.0) : std::min(x[1], -0.0)) / thickness;
    const auto point = oracle::strain_point(strain, 1 - strain, formulas.m(), formulas.n());
    const auto terms = formulas.at_rate(rate);
    const auto envelope =
        formulas.envelope(point, formulas.at_strain(point), terms, loading ? strain : largest);
    dx = {x[1], -area * std::max(x[2], 0.0) / mass,
          formulas.envelope_rate(envelope, terms) +
              formulas.relaxation(time, strain) * (envelope.value - x[2])};
  };
  // Past the infinite slope at strain zero, where the rate is still that of the impact.
  constexpr double first_strain = 1e-10;
  const double speed = impact.impactor.speed;
  const auto first = oracle::strain_point(first_strain, 1 - first_strain, formulas.m(), formulas.n());
  State x{
      first_strain * thickness, speed,
      first.shape * formulas.started(first, formulas.at_strain(first), formulas.at_rate(speed / thickness))};
  double time = x[0] / speed;

  double peak = 0;
  odeint::runge_kutta_fehlberg78<State> method;
  auto controlled = odeint::make_controlled(1e-13, 1e-12, method);
  /// Up to the moment in which `value` falls to zero.
  const auto follow = [&](auto&& value) {
    double step = 1e-9;
    for (int i = 0; i < 10'000'000; ++i) {
      const State before = x;
      const double time_before = time;
      // Short while the strain is near zero; the peak is the largest of the states.
      step = std::min({step, 0.01 * time, 1e-6});
      if (controlled.try_step(slope, x, time, step) == odeint::fail) continue;
      peak = std::max(peak, x[2]);
      if (value(x) > 0) continue;
      double low = 0, high = time - time_before;
      for (int k = 0; k < 60; ++k) {
        const double middle = (low + high) / 2;
        State end = before;
        method.do_step(slope, end, time_before, middle);
        (value(end) > 0 ? low : high) = middle;
        x = end;
      }
      time = time_before + high;
      return;
    }
    FAIL() << "the event was not reached";
  };
  follow([](const State& at) { return at[1]; });
  const double deepest = x[0];
  largest = deepest / thickness;
  loading = false;
  x[1] = 0;
  follow([](const State& at) { return at[2]; });

  for (const double asked : {1e-4, 1e-5}) {
    const Summary s = solve(impact, {.tolerance = asked}).summary;
    expect_relative(s.peak_penetration, deepest, asked, "penetration");
    expect_relative(s.peak_force.value(), area * peak, asked, "peak force");
    ASSERT_TRUE(s.release);
    expect_relative(s.release->velocity, x[1], asked, "rebound");
    expect_relative(s.release->time, time, asked, "release");
  }
}

TEST(flat_disc, on_a_pad_with_memory_is_one_column) {
  expect_one_column<oracle::LinearFormulas>(sample_law<LinearViscoelastic>());
  expect_one_column<oracle::NineFormulas>(sample_law<NineParameter>());
  expect_one_column<oracle::TwentyOneFormulas>(sample_law<TwentyOneParameter>());
}

/// The energy of the impact is what the pad took in, the support holds and the impactor has left.
TEST(flat_disc, balances_its_energy_on_a_yielding_support) {
  for (const PadLaw& law : {PadLaw(sample_law<LinearViscoelastic>()), PadLaw(sample_law<NineParameter>()),
                            PadLaw(sample_law<TwentyOneParameter>())})
    for (const Support& support :
         {Support::linear(5e5),
          Support::through({{.deflection = 2e-3, .force = 500}, {.deflection = 0.01, .force = 1e4}})}) {
      const ImpactCase impact = disc_on(law, support);
      const double impact_energy = impact.impactor.mass * impact.impactor.speed * impact.impactor.speed / 2;
      const Summary s = solve(impact).summary;
      EXPECT_LT(std::abs(s.energy.residual), 1e-4 * impact_energy) << name_of(law);
      EXPECT_EQ(s.status, Status::released) << name_of(law);
    }
}

/// Between the closed form of the loading and one column there is no difference of stations.
TEST(flat_disc, needs_one_column_only) {
  const ImpactCase impact = disc_on(sample_law<TwentyOneParameter>());
  EXPECT_EQ(solve(impact).summary.stations, 1);
}

}  // namespace
}  // namespace dashpad
