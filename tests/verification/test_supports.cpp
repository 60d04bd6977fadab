/// Supports that crush, are damped, carry a panel or have a free body behind them, and gravity, against
/// closed forms: linear systems by their matrix exponential, energies and momenta.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "dashpad/impact/post_impact.hpp"
#include "dashpad/impact/solve.hpp"
#include "shared/run_once.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr double modulus = 3e5;

/// A flat disc on an elastic pad: a spring of 5 kg at 3 m/s.
ImpactCase disc_on_spring() {
  ImpactCase impact = impact_on(Elastic{modulus}, Support::linear(3e5));
  impact.impactor = {.mass = 5, .nose = FlatDisc{0.05}, .speed = 3};
  impact.pad.thickness = 0.06;
  return impact;
}
double pad_stiffness(const ImpactCase& impact) {
  return modulus * sections_of(impact).area_beyond() / impact.pad.thickness;
}
double support_stiffness(const ImpactCase& impact) { return 1 / impact.support.compliance(0); }

template <std::size_t n>
using Vector = std::array<double, n>;
template <std::size_t n>
using Matrix = std::array<Vector<n>, n>;

/// exp(A t) y: a Taylor series over parts of t that are short.
template <std::size_t n>
Vector<n> linear_motion(const Matrix<n>& a, Vector<n> y, double t) {
  double size = 0;
  for (const Vector<n>& row : a)
    for (const double entry : row) size = std::max(size, std::abs(entry));
  const int parts = 1 + static_cast<int>(4 * static_cast<double>(n) * size * t);
  const double step = t / parts;
  for (int part = 0; part < parts; ++part) {
    Vector<n> term = y;
    for (int k = 1; k <= 16; ++k) {
      Vector<n> next{};
      for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j) next[i] += a[i][j] * term[j] * step / k;
      term = next;
      for (std::size_t i = 0; i < n; ++i) y[i] += term[i];
    }
  }
  return y;
}

/// Of a run by itself, whose figures are extrapolated.
constexpr double of_history = 3e-4;

/// The force of an elastic pad over the history, against what the linear system says up to the release.
template <std::size_t n, class Force>
void expect_force(const ImpactCase& impact, const Matrix<n>& system, const Vector<n>& begin, Force force_of,
                  double allowed = 2e-6) {
  const Solution solution = solve(impact, {.tolerance = 1e-6});
  ASSERT_TRUE(solution.summary.trustworthy()) << to_string(solution.summary.status);
  const History& h = solution.history;
  const double scale = *solution.summary.peak_force;
  Vector<n> state = begin;
  double worst = 0, largest = 0;
  for (std::size_t i = 1; i < h.size() && (largest < scale / 2 || h.force[i] > 0.05 * scale); ++i) {
    state = linear_motion(system, state, h.time[i] - h.time[i - 1]);
    worst = std::max(worst, std::abs(h.force[i] - force_of(state)));
    largest = std::max(largest, force_of(state));
    // The peak lies between two entries.
    if (force_of(state) < 0.999 * scale || i + 1 == h.size()) continue;
    const double step = h.time[i + 1] - h.time[i];
    for (int k = 1; k < 16; ++k)
      largest = std::max(largest, force_of(linear_motion(system, state, step * k / 16)));
  }
  EXPECT_LE(worst, of_history * scale);
  EXPECT_NEAR(scale, largest, allowed * scale);
}

// --- A panel

/// X, V, x, u: impactor and panel, springs and a damper between panel and ground.
Matrix<4> panel_system(const ImpactCase& impact) {
  const double kp = pad_stiffness(impact), ks = support_stiffness(impact), c = impact.backing.damping;
  const double mass = impact.impactor.mass, m = impact.backing.mass;
  return {{{0, 1, 0, 0}, {-kp / mass, 0, kp / mass, 0}, {0, 0, 0, 1}, {kp / m, 0, -(kp + ks) / m, -c / m}}};
}

TEST(Panel, IsASecondMassOnASpring) {
  for (const double mass : {0.5, 2.0, 20.0})
    for (const double damping : {0.0, 200.0}) {
      ImpactCase impact = disc_on_spring();
      impact.backing.mass = mass;
      impact.backing.damping = damping;
      SCOPED_TRACE(fmt::format("{} kg, {} N s/m", mass, damping));
      const double kp = pad_stiffness(impact);
      expect_force<4>(impact, panel_system(impact), {0, 3, 0, 0},
                      [&](const Vector<4>& y) { return kp * (y[0] - y[2]); });
    }
}

TEST(Panel, OfALightPanelIsStruckAgain) {
  ImpactCase impact = disc_on_spring();
  impact.backing.mass = 0.05;
  const double kp = pad_stiffness(impact);
  expect_force<4>(
      impact, panel_system(impact), {0, 3, 0, 0}, [&](const Vector<4>& y) { return kp * (y[0] - y[2]); },
      1e-5);
  // A panel of some mass on a soft support runs away from the pad and comes back.
  impact.backing.mass = 1;
  impact.pad.thickness = 0.01;
  impact.support = Support::linear(1e4);
  const Solution twice = solve(impact, {.tolerance = 1e-4});
  ASSERT_EQ(twice.summary.status, Status::released);
  const std::vector<double>& force = twice.history.force;
  int contacts = 0;
  for (std::size_t i = 1; i < force.size(); ++i) contacts += force[i] > 0 && force[i - 1] == 0;
  EXPECT_GE(contacts, 2);
  EXPECT_NEAR(twice.summary.energy.residual, 0, 1e-4 * twice.summary.energy.impact);
}

/// With a damping ratio that stays, the support without mass is the limit, at a distance in proportion to the
/// root of the mass.
TEST(Panel, WithoutMassIsTheOldSupport) {
  const std::vector<PadLaw> laws{Elastic{modulus}, sample_law<LinearViscoelastic>(), sample_law<Foam>()};
  for (const PadLaw& law : laws) {
    ImpactCase impact = impact_on(law, Support::linear(2e5));
    const double limit = *solve(impact, {.tolerance = 1e-5}).summary.peak_force;
    std::vector<double> distance;
    for (const double share : {1e-1, 2.5e-2, 6.25e-3}) {
      impact.backing.mass = share * impact.impactor.mass;
      impact.backing.damping = 2 * 0.7 * std::sqrt(2e5 * impact.backing.mass);
      const Summary summary = solve(impact, {.tolerance = 1e-3}).summary;
      EXPECT_TRUE(summary.trustworthy()) << name_of(law) << ", share " << share;
      distance.push_back(relative_error(*summary.peak_force, limit));
    }
    EXPECT_LT(distance[1], 0.7 * distance[0]) << name_of(law);
    EXPECT_LT(distance[2], 0.7 * distance[1]) << name_of(law);
    EXPECT_LT(distance[2], 0.03) << name_of(law);
  }
}

TEST(Panel, InAGapIsAFreeBody) {
  ImpactCase impact = disc_on_spring();
  impact.backing.mass = 20;
  impact.backing.gap = 0.2;
  const Summary summary = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(summary.status, Status::released);
  const double reduced = 5.0 * 20 / 25;
  expect_relative(*summary.peak_force, 3 * std::sqrt(pad_stiffness(impact) * reduced), 2e-6, "peak force");
  expect_relative(*summary.rebound_speed, 3 * (20 - 5) / 25.0, 2e-6, "rebound");
  // And then strikes the spring behind its gap, alone.
  const double panel = 3 * 2 * 5 / 25.0;
  expect_relative(*summary.support->peak_transmitted, panel * std::sqrt(support_stiffness(impact) * 20), 2e-6,
                  "transmitted force");
}

// --- A damper

/// X, V, x: c dx/dt = kp (X - x) - ks x.
TEST(Damper, WithoutMassIsALinearSystem) {
  for (const double damping : {20.0, 300.0, 5000.0}) {
    ImpactCase impact = disc_on_spring();
    impact.backing.damping = damping;
    SCOPED_TRACE(damping);
    const double kp = pad_stiffness(impact), ks = support_stiffness(impact);
    const Matrix<3> system{{{0, 1, 0}, {-kp / 5, 0, kp / 5}, {kp / damping, 0, -(kp + ks) / damping}}};
    expect_force<3>(
        impact, system, {0, 3, 0}, [&](const Vector<3>& y) { return kp * (y[0] - y[2]); }, 1e-5);
  }
}

/// A pad of constant force P: V = v - P t / M, dx/dt = P / c exp(-k t / c), and it turns where they meet. The
/// pad itself sets no time in which a step would have to be short.
TEST(Damper, SettlesBelowAPadOfConstantForce) {
  ImpactCase impact = disc_on_spring();
  const double damping = 850, force = 2300, stiffness = support_stiffness(impact);
  impact.backing.damping = damping;
  impact.pad.thickness = 0.3;
  const double stress = force / sections_of(impact).area_beyond();
  impact.pad.material.law =
      RigidFoam{.crush_stress = stress, .crush_strain = 0.8, .second_stress = stress, .second_strain = 0.9};
  const auto rate = [&](double t) {
    return 3 - force * t / 5 - force / damping * std::exp(-stiffness * t / damping);
  };
  // Its pad first goes faster, then comes to a stop.
  double before = 2.8e-3, after = 3 * 5 / force;
  ASSERT_GT(rate(before), 0);
  for (int i = 0; i < 60; ++i) (rate((before + after) / 2) > 0 ? before : after) = (before + after) / 2;
  const double t = after;
  const double penetration =
      3 * t - force * t * t / 10 - force / stiffness * (1 - std::exp(-stiffness * t / damping));
  for (const double resolution : {0.05, 0.0125})
    expect_relative(run_once(impact, resolution).figures.peak_penetration, penetration,
                    2 * resolution * resolution, "penetration");
}

TEST(Damper, MayBeGivenAsALossFactor) {
  ImpactCase impact = disc_on_spring();
  impact.backing.mass = 2;
  impact.backing.loss_factor = 0.3;
  const double of_factor = *solve(impact).summary.peak_force;
  impact.backing.loss_factor = 0;
  impact.backing.damping = 0.3 * std::sqrt(3e5 * 7);
  EXPECT_DOUBLE_EQ(of_factor, *solve(impact).summary.peak_force);
}

// --- A support that crushes

TEST(CrushedSupport, KeepsItsSetAndLosesTheEnergyBetweenItsSlopes) {
  for (const double factor : {1.0, 2.0, 10.0}) {
    ImpactCase impact = disc_on_spring();
    const double kp = pad_stiffness(impact), ks = 3e5, ku = factor * ks;
    impact.backing.unloading_stiffness = ku;
    const Summary summary = solve(impact, {.tolerance = 1e-6}).summary;
    ASSERT_EQ(summary.status, Status::released);
    SCOPED_TRACE(factor);
    const double force = 3 * std::sqrt(5 / (1 / kp + 1 / ks));
    expect_relative(*summary.peak_force, force, 2e-6, "peak force");
    EXPECT_NEAR(*summary.support->set, force / ks - force / ku, 2e-6 * force / ks);
    EXPECT_NEAR(summary.energy.support_loss, force * force / 2 * (1 / ks - 1 / ku),
                2e-6 * summary.energy.impact);
    expect_relative(*summary.rebound_speed, std::sqrt(force * force * (1 / kp + 1 / ku) / 5), 2e-6,
                    "rebound");
    EXPECT_NEAR(summary.energy_absorbed_fraction, 0, 2e-6);
  }
}

TEST(CrushedSupport, FollowsItsCurve) {
  ImpactCase impact = disc_on_spring();
  impact.support = Support::through({{0.002, 1500}, {0.01, 1700}, {0.03, 8000}});
  impact.backing.unloading_stiffness = 1e6;
  const Summary summary = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(summary.status, Status::released);
  const double force = *summary.peak_force;
  // All energy is in pad and curve when the impactor stands still.
  EXPECT_NEAR(force * force / 2 / pad_stiffness(impact) + impact.support.energy(force), summary.energy.impact,
              2e-6 * summary.energy.impact);
  EXPECT_NEAR(*summary.support->set, impact.support.deflection(force) - force / 1e6,
              2e-6 * summary.support->peak_deflection);
  EXPECT_NEAR(summary.energy.residual, 0, 1e-6 * summary.energy.impact);
}

/// A second blow like the first finds a support that gives its energy back; a harder one goes on from the
/// set as the curve would have gone.
TEST(CrushedSupport, CarriesItsSetToTheNextBlow) {
  ImpactCase impact = disc_on_spring();
  const double kp = pad_stiffness(impact), ks = 3e5, ku = 1e6;
  impact.backing.unloading_stiffness = ku;
  impact.blows = Blows{2, 0};
  const std::vector<Blow> blows = solve_blows(impact, {.tolerance = 1e-6});
  ASSERT_EQ(blows.size(), 2U);
  const Summary& first = blows[0].solution.summary;
  const Summary& second = blows[1].solution.summary;
  const double force = 3 * std::sqrt(5 / (1 / kp + 1 / ks));
  expect_relative(blows[1].impact.backing.earlier_force, force, 2e-6, "earlier force");
  EXPECT_GT(*second.peak_force, *first.peak_force);
  // (F^2 - Fe^2) / 2 ks beyond the yield, Fe^2 / 2 ku up to it, and F^2 / 2 kp in the pad.
  const double peak = std::sqrt((45 + force * force * (1 / ks - 1 / ku)) / (1 / kp + 1 / ks));
  expect_relative(*second.peak_force, peak, 4e-6, "peak force");
  EXPECT_NEAR(*second.support->set, peak / ks - peak / ku, 4e-6 * second.support->peak_deflection);
  EXPECT_NEAR(second.energy.support_loss, (peak * peak - force * force) / 2 * (1 / ks - 1 / ku),
              4e-6 * second.energy.impact);
}

/// The set is what stays of the support's own deflection: no part of the gap before it.
TEST(CrushedSupport, HasNoSetByItsGap) {
  ImpactCase impact = disc_on_spring();
  const double ks = 3e5, ku = 1e6;
  impact.backing = {.unloading_stiffness = ku, .mass = 20, .gap = 0.2};
  // The panel alone, once the disc has left it, with a fifth of what that had.
  const Summary alone = solve(impact, {.tolerance = 1e-5}).summary;
  ASSERT_EQ(alone.status, Status::released);
  const double panel = 3 * 2 * 5 / 25.0, most = panel * std::sqrt(ks * 20);
  expect_relative(*alone.support->set, most / ks - most / ku, 2e-5, "set of the panel alone");
  expect_relative(alone.energy.support_loss, 20 * panel * panel / 2 * (1 - ks / ku), 2e-5, "loss");
  impact.backing.mass = 2;
  impact.backing.gap = 0.002;
  impact.blows = Blows{2, 0};
  const std::vector<Blow> blows = solve_blows(impact, {.tolerance = 1e-5});
  ASSERT_EQ(blows.size(), 2U);
  double before = 0;
  for (const Blow& blow : blows) {
    const Summary& s = blow.solution.summary;
    ASSERT_EQ(s.status, Status::released);
    const double force = s.support->crushing_force;
    expect_relative(*s.support->set, force / ks - force / ku, 2e-5, "set");
    // The support meets the panel behind the same gap, shorter by what the blow before has left.
    expect_relative(s.support->peak_deflection, impact.backing.gap + force / ks - before, 2e-5, "deflection");
    EXPECT_NEAR(s.energy.residual, 0, 1e-5 * s.energy.impact);
    before = *s.support->set;
  }
}

// --- A free body behind

TEST(FreeBody, SharesTheMomentum) {
  for (const Support& support : {Support::rigid(), Support::linear(3e5)}) {
    ImpactCase impact = disc_on_spring();
    impact.support = support;
    impact.backing.body_mass = 12;
    const Summary summary = solve(impact, {.tolerance = 1e-6}).summary;
    ASSERT_EQ(summary.status, Status::released);
    const double kp = pad_stiffness(impact);
    const double stiffness = support.is_rigid() ? kp : 1 / (1 / kp + 1 / 3e5);
    expect_relative(*summary.peak_force, 3 * std::sqrt(stiffness * 5 * 12 / 17), 2e-6, "peak force");
    expect_relative(*summary.rebound_speed, 3 * (12 - 5) / 17.0, 2e-6, "rebound");
    expect_relative(*summary.support->body_speed, 3 * 2 * 5 / 17.0, 2e-6, "body");
    expect_relative(*summary.restitution, 1, 2e-6, "restitution");
  }
}

TEST(FreeBody, OfALighterBodyTheImpactorGoesOn) {
  ImpactCase impact = disc_on_spring();
  impact.backing.body_mass = 2;
  const Summary summary = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(summary.status, Status::released);
  expect_relative(summary.release->velocity, 3 * (5 - 2) / 7.0, 2e-6, "velocity");
  EXPECT_EQ(*summary.rebound_speed, 0);
}

/// The report's Eqs. 1 to 4: velocities after the impact by momentum and the share of energy that is lost.
TEST(FreeBody, IsThePostImpactOfTheReport) {
  for (const PadLaw& law : {PadLaw(sample_law<Foam>()), PadLaw(sample_law<LinearViscoelastic>()),
                            PadLaw(sample_law<NineParameter>())}) {
    ImpactCase impact = impact_on(law, Support::linear(2e5));
    impact.backing.body_mass = 30;
    const Summary both = solve(impact, {.tolerance = 1e-5}).summary;
    ASSERT_EQ(both.status, Status::released);
    ImpactCase towards = impact;
    towards.backing = {};
    towards.impactor.mass = 4.0 * 30 / 34;
    const Summary relative = solve(towards, {.tolerance = 1e-5}).summary;
    const double lost = 1 - *relative.restitution * *relative.restitution;
    const PostImpact after = post_impact({4, impact.impactor.speed}, {30, 0}, lost, 1e-5);
    EXPECT_NEAR(both.release->velocity, after.first_velocity, 3e-5 * impact.impactor.speed) << name_of(law);
    EXPECT_NEAR(*both.support->body_speed, after.second_velocity, 3e-5 * impact.impactor.speed)
        << name_of(law);
    expect_relative(*both.peak_force, *relative.peak_force, 2e-5, "peak force");
  }
}

/// On a rigid support the force behind is that of the pad, which has no bound where it bottoms out.
TEST(FreeBody, BehindARigidSupportHasNoForceWhereThePadBottomsOut) {
  ImpactCase impact = impact_on(
      ViscoelasticFoam{.first_modulus = 1.4e6, .first_exponent = 9.8, .first_share = 0.1, .first_time = 1.6},
      Support::rigid());
  impact.impactor = {.mass = 4, .nose = FlatDisc{0.0003}, .speed = 1.8};
  impact.pad.thickness = 0.0094;
  impact.backing.body_mass = 1500;
  for (const double tolerance : {1e-3, 1e-4}) {
    SCOPED_TRACE(tolerance);
    const Summary s = solve(impact, {.tolerance = tolerance}).summary;
    ASSERT_EQ(s.status, Status::bottomed_out);
    EXPECT_FALSE(s.peak_force);
    EXPECT_FALSE(s.support->peak_transmitted);
    EXPECT_LT(s.errors.support, tolerance);
  }
}

// --- Preload

TEST(Preload, IsARigidSupportBelowIt) {
  ImpactCase impact = disc_on_spring();
  const double kp = pad_stiffness(impact);
  const double on_rigid = 3 * std::sqrt(5 * kp);
  impact.backing.preload = 1.2 * on_rigid;
  const Summary held = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(held.status, Status::released);
  expect_relative(*held.peak_force, on_rigid, 2e-6, "peak force");
  EXPECT_EQ(held.support->peak_deflection, 0);
  const double preload = 0.4 * on_rigid;
  impact.backing.preload = preload;
  const Summary gives = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(gives.status, Status::released);
  // F^2 / 2 kp + (F^2 - P^2) / 2 ks is the energy of the impact.
  const double force = std::sqrt((5 * 9 + preload * preload / 3e5) / (1 / kp + 1 / 3e5));
  expect_relative(*gives.peak_force, force, 2e-6, "peak force");
  expect_relative(gives.support->peak_deflection, (force - preload) / 3e5, 4e-6, "deflection");
  expect_relative(*gives.restitution, 1, 2e-6, "restitution");
}

TEST(Preload, HoldsAPanelAgainstItsStop) {
  ImpactCase impact = disc_on_spring();
  impact.backing.mass = 2;
  const double on_rigid = 3 * std::sqrt(5 * pad_stiffness(impact));
  impact.backing.preload = 1.1 * on_rigid;
  const Summary held = solve(impact, {.tolerance = 1e-6}).summary;
  ASSERT_EQ(held.status, Status::released);
  expect_relative(*held.peak_force, on_rigid, 4e-6, "peak force");
  impact.backing.preload = 0.5 * on_rigid;
  impact.backing.damping = 100;
  const Summary gives = solve(impact, {.tolerance = 1e-4}).summary;
  ASSERT_EQ(gives.status, Status::released);
  EXPECT_LT(*gives.peak_force, on_rigid);
  EXPECT_NEAR(gives.energy.residual, 0, 1e-3 * gives.energy.impact);
}

TEST(Preload, StaysWhereNoBlowReachesIt) {
  for (const bool is_curve : {false, true})
    for (const double mass : {0.0, 2.0})
      for (const double damping : {0.0, 100.0}) {
        ImpactCase impact = disc_on_spring();
        impact.backing = {.unloading_stiffness = 1e6, .damping = damping, .mass = mass};
        impact.backing.preload = 1.2 * 3 * std::sqrt(5 * pad_stiffness(impact));
        if (is_curve) impact.support = Support::through({{0.002, 500}, {0.01, 1000}, {0.03, 9000}});
        impact.blows = Blows{3, 0};
        ASSERT_TRUE(violations(impact).empty());
        const std::vector<Blow> blows = solve_blows(impact, {.tolerance = 1e-4});
        ASSERT_EQ(blows.size(), 3U);
        for (const Blow& blow : blows) {
          const Summary& s = blow.solution.summary;
          EXPECT_EQ(blow.impact.backing, impact.backing);
          EXPECT_EQ(*s.peak_force, *blows[0].solution.summary.peak_force);
          EXPECT_EQ(*s.support->set, 0);
          EXPECT_EQ(s.support->peak_deflection, 0);
          EXPECT_EQ(s.energy.support_loss, 0);
        }
      }
}

/// What a blow leaves of the preload, or of the support once nothing is left of it (theory.md, Eq. 44).
TEST(Preload, IsUsedUpByCrushing) {
  const double ks = 3e5, ku = 1e6, energy = 5 * 9 / 2.0;
  for (const double share : {0.1, 0.3, 0.6, 0.85}) {
    SCOPED_TRACE(share);
    ImpactCase impact = disc_on_spring();
    const double kp = pad_stiffness(impact);
    const double preload = share * 3 * std::sqrt(5 * kp);
    impact.backing = {.unloading_stiffness = ku, .preload = preload};
    impact.blows = Blows{2, 0};
    const std::vector<Blow> blows = solve_blows(impact, {.tolerance = 1e-6});
    ASSERT_EQ(blows.size(), 2U);
    const Summary& first = blows[0].solution.summary;
    const Summary& second = blows[1].solution.summary;
    const double force = std::sqrt((2 * energy + preload * preload / ks) / (1 / kp + 1 / ks));
    const double way = (force - preload) / ks;
    const double left = std::max(force - ku * way, 0.0);
    expect_relative(*first.peak_force, force, 2e-6, "first peak");
    EXPECT_NEAR(*first.support->set, std::max(way - force / ku, 0.0), 4e-6 * way);
    const double returned = force * force / 2 / kp + (force * force - left * left) / 2 / ku;
    expect_relative(*first.rebound_speed, std::sqrt(2 * returned / 5), 4e-6, "first rebound");
    // Up to the yield along the line of unloading, from what is left; beyond it on the curve.
    const double peak =
        std::sqrt((2 * energy + left * left / ku + force * force * (1 / ks - 1 / ku)) / (1 / kp + 1 / ks));
    ASSERT_GT(peak, force);
    expect_relative(*second.peak_force, peak, 4e-6, "second peak");
    const double all = (peak - preload) / ks;
    EXPECT_NEAR(*second.support->set, std::max(all - peak / ku, 0.0), 8e-6 * all);
    const double still_left = std::max(peak - ku * all, 0.0);
    const double loss = (peak * peak - force * force) / 2 * (1 / ks - 1 / ku) +
                        (still_left * still_left - left * left) / 2 / ku;
    EXPECT_NEAR(second.energy.support_loss, loss, 4e-6 * energy);
    EXPECT_NEAR(first.energy.residual, 0, 1e-6 * energy);
    EXPECT_NEAR(second.energy.residual, 0, 1e-6 * energy);
  }
}

/// A panel that strikes its stop goes on with the body behind: momentum stays, energy is lost.
TEST(Preload, LetsThePanelLandOnItsStopPlastically) {
  for (const double body : {0.0, 12.0})
    for (const double unloading : {0.0, 1e6}) {
      SCOPED_TRACE(fmt::format("body {}, unloading stiffness {}", body, unloading));
      ImpactCase impact = disc_on_spring();
      impact.backing = {.unloading_stiffness = unloading, .mass = 2, .body_mass = body};
      impact.backing.preload = 0.3 * 3 * std::sqrt(5 * pad_stiffness(impact));
      const Summary s = solve(impact, {.tolerance = 1e-5}).summary;
      ASSERT_EQ(s.status, Status::released);
      EXPECT_GT(s.support->peak_deflection, 0);
      EXPECT_NEAR(s.energy.residual, 0, 1e-5 * s.energy.impact);
      EXPECT_GT(s.energy.support_loss, 1e-3 * s.energy.impact);
    }
}

/// Foam that stays crushed holds nothing back: where its panel is stopped, the impactor goes on.
TEST(Preload, StopsThePanelAndNotTheImpactor) {
  for (const double body : {0.0, 40.0}) {
    SCOPED_TRACE(body);
    ImpactCase impact = impact_on(RigidFoam{4e5, 0.5, 6e5, 0.7}, Support::linear(3e5));
    impact.impactor = {.mass = 5, .nose = Sphere{0.1}, .speed = 3};
    impact.backing = {.mass = 0.5, .body_mass = body, .preload = 300};
    const Summary s = solve(impact, {.tolerance = 1e-3}).summary;
    ASSERT_EQ(s.status, Status::released);
    EXPECT_NEAR(s.energy.residual, 0, 1e-3 * s.energy.impact);
    EXPECT_GT(s.energy.support_loss, 0);
    if (body == 0) {
      EXPECT_GT(*s.rebound_speed, 0.3);
    }
  }
}

// --- A damper alone

/// What is fully compressed yields no more, however hard a damper pushes.
TEST(Damper, HoldsClosedFoamAsItIs) {
  ImpactCase impact = impact_on(RigidFoam{1.7e5, 0.49, 6.8e5, 0.64}, Support::linear(7.5e5));
  impact.impactor = {.mass = 50, .nose = Sphere{0.38}, .speed = 14.7};
  impact.pad.thickness = 0.022;
  impact.backing.damping = 740;
  const Summary s = solve(impact, {.tolerance = 1e-3}).summary;
  ASSERT_EQ(s.status, Status::released);
  EXPECT_DOUBLE_EQ(s.peak_penetration, impact.pad.thickness);
  EXPECT_TRUE(s.bottomed);
  EXPECT_NEAR(s.energy.residual, 0, 1e-3 * s.energy.impact);
}

// --- Gravity and rest

TEST(Gravity, PressesTheImpactorOn) {
  for (const Support& support : {Support::rigid(), Support::linear(3e5)}) {
    ImpactCase impact = disc_on_spring();
    impact.support = support;
    impact.impactor.gravity = 30;
    const Summary summary = solve(impact, {.tolerance = 1e-6}).summary;
    ASSERT_EQ(summary.status, Status::released);
    const double kp = pad_stiffness(impact);
    const double stiffness = support.is_rigid() ? kp : 1 / (1 / kp + 1 / 3e5);
    const double weight = 5 * 30;
    expect_relative(*summary.peak_force, weight + std::sqrt(weight * weight + stiffness * 5 * 9), 2e-6,
                    "peak force");
    expect_relative(*summary.rebound_speed, 3, 2e-6, "rebound");
    EXPECT_NEAR(summary.energy.weight, 0, 1e-5 * summary.energy.impact);
  }
}

TEST(Gravity, BringsAnImpactorToRestOnADamper) {
  ImpactCase impact = disc_on_spring();
  impact.impactor.gravity = 9.81;
  impact.impactor.speed = 0.05;
  impact.backing.damping = 1500;
  const Solution solution = solve(impact, {.tolerance = 1e-4});
  const Summary& summary = solution.summary;
  ASSERT_EQ(summary.status, Status::at_rest) << to_string(summary.status);
  ASSERT_TRUE(summary.rest);
  EXPECT_FALSE(summary.release);
  const double weight = 5 * 9.81;
  EXPECT_NEAR(solution.history.force.back(), weight, 0.1 * weight);
  EXPECT_NEAR(solution.history.motion.back(), weight / pad_stiffness(impact) + weight / 3e5,
              0.1 * summary.peak_motion);
  EXPECT_NEAR(summary.energy.residual, 0, 1e-4 * summary.energy.impact);
}

// --- Invariance, and the two paths

std::vector<Backing> kinds_of_backing() {
  return {{.unloading_stiffness = 6e5},
          {.damping = 300},
          {.damping = 200, .mass = 1},
          {.unloading_stiffness = 6e5, .damping = 200, .mass = 1, .body_mass = 20}};
}

/// Twice the masses, stresses, stiffnesses and damping: the same motion under twice the forces.
TEST(MovingSupport, DoublesItsForcesWithAllThatIsHeavyAndStiff) {
  for (const Backing& backing : kinds_of_backing()) {
    ImpactCase impact = impact_on(sample_law<Foam>(), Support::linear(2e5));
    impact.backing = backing;
    const Summary once = solve(impact, {.fixed_runs = 3}).summary;
    impact.impactor.mass *= 2;
    impact.pad.condition.scale = 2;
    impact.support = Support::linear(4e5);
    for (double Backing::*of :
         {&Backing::unloading_stiffness, &Backing::damping, &Backing::mass, &Backing::body_mass})
      impact.backing.*of *= 2;
    const Summary twice = solve(impact, {.fixed_runs = 3}).summary;
    expect_relative(*twice.peak_force, 2 * *once.peak_force, 1e-9, "peak force");
    expect_relative(*twice.support->peak_transmitted, 2 * *once.support->peak_transmitted, 1e-9, "behind");
    expect_relative(twice.peak_penetration, once.peak_penetration, 1e-9, "penetration");
    expect_relative(twice.contact_end->time, once.contact_end->time, 1e-9, "end of contact");
    expect_relative(twice.energy.support_loss, 2 * once.energy.support_loss, 1e-9, "lost");
  }
}

TEST(MovingSupport, IsTheSameByVectorsAndColumnByColumn) {
  for (const PadLaw& law :
       {PadLaw(sample_law<LinearViscoelastic>()), PadLaw(sample_law<TwentyOneParameter>()),
        PadLaw(sample_law<Foam>()), PadLaw(sample_law<CrushableFoam>())})
    for (const Backing& backing : kinds_of_backing()) {
      ImpactCase impact = impact_on(law, Support::linear(2e5));
      impact.backing = backing;
      const Summary vectors = solve(impact, {.tolerance = 1e-3}).summary;
      const Summary plain = solve(impact, {.tolerance = 1e-3, .plain = true}).summary;
      EXPECT_EQ(vectors.status, plain.status) << name_of(law);
      expect_relative(*vectors.peak_force, *plain.peak_force, 1e-3, name_of(law) + ", peak force");
      expect_relative(vectors.peak_penetration, plain.peak_penetration, 1e-3, name_of(law) + ", penetration");
    }
}

// --- The ledger

/// Each part by itself: what goes in is what is left, and what is lost.
TEST(Ledger, ClosesOnEverySupport) {
  const auto with = [](auto&& change) {
    Backing backing;
    change(backing);
    return backing;
  };
  const std::vector<Backing> backings{
      with([](Backing& b) { b.unloading_stiffness = 1e6; }),
      with([](Backing& b) { b.damping = 300; }),
      with([](Backing& b) { b.mass = 1; }),
      with([](Backing& b) { b.mass = 1, b.damping = 300, b.unloading_stiffness = 1e6; }),
      with([](Backing& b) { b.mass = 1, b.damping = 300, b.body_mass = 10; }),
      with([](Backing& b) { b.body_mass = 10, b.unloading_stiffness = 1e6; }),
      with([](Backing& b) { b.preload = 200, b.damping = 300; }),
      with([](Backing& b) { b.gap = 0.002, b.mass = 1, b.damping = 300; }),
  };
  for (const PadLaw& law : {PadLaw(Elastic{modulus}), PadLaw(sample_law<LinearViscoelastic>()),
                            PadLaw(sample_law<Foam>()), PadLaw(sample_law<NineParameter>())})
    for (const Backing& backing : backings)
      for (const double gravity : {0.0, 9.81}) {
        if (gravity > 0 && backing.body_mass > 0) continue;
        ImpactCase impact = impact_on(law, Support::linear(2e5));
        impact.backing = backing;
        impact.impactor.gravity = gravity;
        ASSERT_TRUE(violations(impact).empty());
        std::vector<double> residual;
        for (const int runs : {2, 4, 6}) {
          const Summary s = solve(impact, {.fixed_runs = runs}).summary;
          const EnergyLedger& e = s.energy;
          // Of the run itself: where runs do not agree, the summary is that of the last that did.
          const Figures run = run_once(impact, 0.4 / std::pow(2, runs)).figures;
          const double v = run.final_velocity;
          residual.push_back(std::abs(e.impact + run.energy.weight - impact.impactor.mass * v * v / 2 -
                                      run.energy.support - run.energy.support_loss - run.energy.moving -
                                      run.energy.pad) /
                             e.impact);
          EXPECT_NEAR(e.supply(), e.kinetic + e.support + e.support_loss + e.moving + e.pad + e.residual,
                      1e-12 * e.impact);
          EXPECT_GE(e.support_loss, -1e-12 * e.impact);
        }
        SCOPED_TRACE(fmt::format("{}, {}, gravity {}: residuals {:.1e} {:.1e} {:.1e}", name_of(law),
                                 &backing - backings.data(), gravity, residual[0], residual[1], residual[2]));
        EXPECT_LT(residual[1], 1e-3);
        EXPECT_LT(residual[2], 1e-4) << "steps of a sixteenth";
      }
}

/// In flight there is no sheet to meet, wherever the panel goes meanwhile.
TEST(Ledger, ClosesWithASheetThatIsLeft) {
  for (const double mass : {0.5, 2.0}) {
    SCOPED_TRACE(mass);
    ImpactCase impact = impact_on(Elastic{4e6}, Support::linear(4.5e4));
    impact.impactor = {.mass = 1, .nose = FlatDisc{0.05}, .speed = 1.6};
    impact.pad.thickness = 0.06;
    impact.pad.sheet = 2;
    impact.backing = {.damping = 50, .mass = mass, .gap = 0.0005};
    const Solution solution = solve(impact, {.tolerance = 1e-3});
    const Summary& s = solution.summary;
    ASSERT_EQ(s.status, Status::released);
    EXPECT_NEAR(s.energy.residual, 0, 1e-3 * s.energy.impact);
    const History& h = solution.history;
    int in_flight = 0;
    for (std::size_t i = 1; i < h.size(); ++i) {
      if (h.pad_force[i - 1] > 0 || h.pad_force[i] > 0) continue;
      ++in_flight;
      EXPECT_NEAR(h.velocity[i], h.velocity[i - 1], 1e-9);
    }
    EXPECT_GT(in_flight, 0);
  }
}

}  // namespace
}  // namespace dashpad::test
