/// Noses other than sphere and disc, and pads that end before their nose does, against closed forms and
/// against each other.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "dashpad/impact/contact_snapshot.hpp"
#include "dashpad/impact/solve.hpp"
#include "shared/run_once.hpp"
#include "shared/samples.hpp"
#include "verification/order.hpp"

namespace dashpad::test {
namespace {

using std::numbers::pi;

constexpr double tolerance = 1e-6;
constexpr double degree = pi / 180;
const Cone pointed{.radius = 0.1, .half_angle = 60 * degree};
const Cone blunt{.radius = 0.05, .half_angle = 70 * degree, .tip_radius = 0.02};
/// So short that its side is met in every impact here.
const Cone stud{.radius = 0.04, .half_angle = 75 * degree, .tip_radius = 0.01};
const Ellipsoid knee{.half_depth = 0.06, .half_length = 0.09, .half_width = 0.05};
const Rod rod{.radius = 0.03, .tip_radius = 0.08};
const Platen platen{.length = 0.12, .width = 0.08};
const Cylinder pole{.radius = 0.06, .length = 0.15};
/// A flat tip, a steep side, a shoulder.
const Profile stepped{.points = {{0, 0.005}, {0.004, 0.02}, {0.012, 0.022}, {0.02, 0.05}}};
const std::vector<Nose> noses{pointed, blunt, stud, knee, rod, platen, pole, stepped};

ImpactCase impact_of(const Nose& nose, const PadLaw& law, Support support = Support::rigid()) {
  ImpactCase impact = impact_on(law, std::move(support));
  impact.impactor.nose = nose;
  return impact;
}

/// Equal in all figures of the impact.
void expect_alike(const ImpactCase& a, const ImpactCase& b, double allowed) {
  const Summary one = solve(a).summary;
  const Summary other = solve(b).summary;
  ASSERT_TRUE(one.trustworthy());
  expect_relative(one.peak_force.value(), other.peak_force.value(), allowed, "peak force");
  expect_relative(one.peak_penetration, other.peak_penetration, allowed, "penetration");
  ASSERT_EQ(one.rebound_speed.has_value(), other.rebound_speed.has_value());
  if (one.rebound_speed) expect_relative(*one.rebound_speed, *other.rebound_speed, allowed, "rebound");
}

const std::vector<PadLaw>& laws() {
  static const std::vector<PadLaw> all{
      sample_law<Elastic>(),       sample_law<LinearViscoelastic>(), sample_law<RigidFoam>(),
      sample_law<NineParameter>(), sample_law<TwentyOneParameter>(), sample_law<Foam>(),
      sample_law<CrushableFoam>(), sample_law<ViscoelasticFoam>()};
  return all;
}

// --- Sections: theory.md, Eq. 3, against geometry ---

TEST(Sections, OfAConeAreThoseOfItsGeometry) {
  for (const Cone& cone : {pointed, blunt, stud}) {
    const Sections sections = cone.sections();
    const double slope = std::tan(cone.half_angle), low = cone.tip_radius;
    const double end = (cone.radius - low) / slope;
    for (const double s : {0.1 * end, 0.5 * end, 0.999 * end}) {
      const double radius = low + s * slope;
      expect_relative(sections.area(s), pi * radius * radius, 1e-14, "area");
      expect_relative(sections.radius(s), radius, 1e-14, "radius");
      expect_relative(sections.depth_at(radius), s, 1e-13, "depth");
      expect_relative(sections.rate(s), radius * slope, 1e-14, "rate");
      // A frustum, and the integral of its volume.
      expect_relative(sections.volume(s), pi * s / 3 * (low * low + low * radius + radius * radius), 1e-13,
                      "volume");
      const double third = slope * s;
      expect_relative(sections.integral(s, 2),
                      pi * s * s * (low * low / 2 + low * third / 3 + third * third / 12), 1e-13,
                      "integral of the volume");
    }
    expect_relative(sections.area(2 * end), pi * cone.radius * cone.radius, 1e-13, "area of the base");
  }
}

TEST(Sections, OfAnEllipsoidAreThoseOfItsGeometry) {
  const Sections sections = knee.sections();
  for (const double s : {0.001, 0.02, 0.05}) {
    const double height = knee.half_depth - s;
    const double share = 1 - height * height / (knee.half_depth * knee.half_depth);
    expect_relative(sections.area(s), pi * knee.half_length * knee.half_width * share, 1e-13, "area");
  }
  expect_relative(sections.area(1), pi * knee.half_length * knee.half_width, 1e-14, "widest");
}

TEST(Sections, OfARodEndAtItsRadius) {
  const Sections sections = rod.sections();
  expect_relative(sections.depth, 0.08 - std::sqrt(0.08 * 0.08 - 0.03 * 0.03), 1e-14, "height of the dome");
  expect_relative(sections.area(1), pi * 0.03 * 0.03, 1e-14, "area of the rod");
  expect_relative(sections.area(0.003), Sphere{0.08}.sections().area(0.003), 1e-15, "area of the dome");
  // A dome that is nearly flat keeps its height.
  const Sections flat = Rod{.radius = 0.01, .tip_radius = 100}.sections();
  expect_relative(flat.depth, 5.0000000125e-7, 1e-15, "height of a flat dome");
}

TEST(Sections, AreCutToTheFaceOfThePad) {
  for (const Nose& nose : noses) {
    const Sections whole = sections_of(nose);
    for (const double share : {0.05, 0.3, 0.9, 1.0, 2.0}) {
      const double face = share * whole.area_beyond();
      const Sections cut = whole.limited_to(face);
      for (const double s : {1e-6, 0.002, 0.01, 0.03, 0.2})
        expect_relative(cut.area(s), std::min(whole.area(s), face), 1e-13, name_of(nose));
    }
  }
}

TEST(Noses, OfEqualSemiAxesAreTheSphereToTheLastBit) {
  for (const double radius : {0.08, 0.0762, 0.1, 1.0 / 3}) {
    const Sections sphere = Sphere{radius}.sections();
    for (const Sections& other :
         {Ellipsoid{radius, radius, radius}.sections(), Rod{radius, radius}.sections()}) {
      EXPECT_EQ(other.tip, sphere.tip);
      EXPECT_EQ(other.width, sphere.width);
      EXPECT_EQ(other.taper, sphere.taper);
      EXPECT_EQ(other.depth, sphere.depth);
    }
  }
}

// --- Elastic pads: closed forms ---

/// On a rigid support the energy of the elastic pad is E / L times the double integral of the area.
TEST(Noses, OnAnElasticPadTurnWhereItsEnergyIsThatOfTheImpact) {
  for (const Nose& nose : noses) {
    const ImpactCase impact = impact_of(nose, Elastic{3e5});
    const Sections sections = sections_of(nose);
    const double energy = impact.impactor.mass * impact.impactor.speed * impact.impactor.speed / 2;
    const double stiffness = 3e5 / impact.pad.thickness;
    double low = 0, high = 1;
    for (int i = 0; i < 200; ++i) {
      const double middle = (low + high) / 2;
      (stiffness * sections.integral(middle, 2) < energy ? low : high) = middle;
    }
    const Summary s = solve(impact, {.tolerance = tolerance}).summary;
    if (low > impact.pad.thickness) {
      EXPECT_TRUE(s.bottomed) << name_of(nose);
      continue;
    }
    expect_relative(s.peak_penetration, low, tolerance, name_of(nose) + ": penetration");
    expect_relative(s.peak_force.value(), stiffness * sections.volume(low), tolerance,
                    name_of(nose) + ": force");
    expect_relative(s.rebound_speed.value(), impact.impactor.speed, tolerance, name_of(nose) + ": rebound");
  }
}

/// F = E/L pi tan^2 y^3 / 3: the energy grows as y^4, and the time to the turning point is y/v times the
/// integral of 1 / sqrt(1 - u^4) from 0 to 1.
TEST(Noses, APointedConeOnAnElasticPadHasAClosedForm) {
  ImpactCase impact = impact_of(pointed, Elastic{1e6});
  impact.pad.thickness = 0.06;
  const double mass = impact.impactor.mass, speed = impact.impactor.speed;
  const double slope = std::tan(pointed.half_angle);
  const double factor = 1e6 / impact.pad.thickness * pi * slope * slope / 12;
  const double deepest = std::pow(mass * speed * speed / 2 / factor, 0.25);
  ASSERT_LT(deepest, std::min(impact.pad.thickness, pointed.sections().depth));
  constexpr double quarter_period = 1.3110287771460599;
  const Summary s = solve(impact, {.tolerance = tolerance}).summary;
  expect_relative(s.peak_penetration, deepest, tolerance, "penetration");
  expect_relative(s.peak_force.value(), 4 * factor * deepest * deepest * deepest, tolerance, "force");
  expect_relative(s.time_of_peak_force.value(), quarter_period * deepest / speed, 10 * tolerance, "time");
  ASSERT_TRUE(s.release);
  expect_relative(s.release->time, 2 * quarter_period * deepest / speed, 1e-5, "release");
}

/// The crush force is the crush stress times the section, from the flat tip on.
TEST(Noses, ABluntConeOnRigidFoamStopsWhereItsCrushEnergyIsThatOfTheImpact) {
  const RigidFoam foam = sample_law<RigidFoam>();
  ImpactCase impact = impact_of(blunt, foam);
  impact.impactor.speed = 1.5;
  const double energy = impact.impactor.mass * impact.impactor.speed * impact.impactor.speed / 2;
  const Sections sections = blunt.sections();
  double low = 0, high = foam.crush_strain * impact.pad.thickness;
  ASSERT_GT(foam.crush_stress * sections.volume(high), energy);
  for (int i = 0; i < 200; ++i) {
    const double middle = (low + high) / 2;
    (foam.crush_stress * sections.volume(middle) < energy ? low : high) = middle;
  }
  const Solution solution = solve(impact, {.tolerance = tolerance});
  expect_relative(solution.summary.peak_penetration, low, tolerance, "penetration");
  expect_relative(solution.summary.peak_force.value(), foam.crush_stress * sections.area(low), tolerance,
                  "force");
  EXPECT_EQ(solution.history.force.front(), foam.crush_stress * sections.tip);
}

// --- Noses that are the same to a pad ---

TEST(Noses, APlatenIsADiscOfItsArea) {
  const FlatDisc disc{std::sqrt(platen.length * platen.width / pi)};
  for (const PadLaw& law : laws())
    for (const Support& support : {Support::rigid(), Support::linear(2e5)})
      expect_alike(impact_of(platen, law, support), impact_of(disc, law, support), 1e-9);
}

TEST(Noses, AnEllipsoidCountsByTheProductOfItsLateralSemiAxes) {
  const Ellipsoid round{.half_depth = 0.06,
                        .half_length = std::sqrt(knee.half_length * knee.half_width),
                        .half_width = std::sqrt(knee.half_length * knee.half_width)};
  for (const PadLaw& law : laws()) expect_alike(impact_of(knee, law), impact_of(round, law), 1e-6);
}

TEST(Noses, ARodIsItsDomeAsLongAsItsSideIsNotMet) {
  for (const PadLaw& law : laws()) {
    ImpactCase of_rod = impact_of(Rod{.radius = 0.06, .tip_radius = 0.08}, law, Support::linear(1e5));
    of_rod.impactor.speed = 1;
    ImpactCase of_sphere = of_rod;
    of_sphere.impactor.nose = Sphere{0.08};
    ASSERT_LT(solve(of_sphere).summary.peak_penetration, sections_of(of_rod.impactor.nose).depth);
    expect_alike(of_rod, of_sphere, 1e-4);
  }
}

TEST(PadFace, APlatenLargerThanTheBlockIsTheBlock) {
  for (const PadLaw& law : laws()) {
    ImpactCase wide = impact_of(Platen{0.3, 0.2}, law, Support::linear(2e5));
    wide.pad.area = 0.01;
    expect_alike(wide, impact_of(Platen{0.1, 0.1}, law, Support::linear(2e5)), 1e-9);
  }
}

/// Where the sphere's section has the area of the pad, the side of a rod of that area begins.
TEST(PadFace, ASphereWiderThanThePadIsADomedRod) {
  for (const PadLaw& law : laws()) {
    ImpactCase cut = impact_of(Sphere{0.08}, law, Support::linear(2e5));
    cut.pad.area = pi * 0.03 * 0.03;
    const ImpactCase as_rod = impact_of(rod, law, Support::linear(2e5));
    ASSERT_GT(solve(as_rod).summary.peak_penetration, sections_of(rod).depth) << name_of(law);
    expect_alike(cut, as_rod, 1e-6);
  }
}

TEST(PadFace, OfAPadWiderThanTheNoseDoesNotMatter) {
  const ImpactCase endless = impact_of(knee, sample_law<TwentyOneParameter>());
  ImpactCase wide = endless;
  wide.pad.area = 0.1;
  EXPECT_EQ(solve(wide).summary.peak_force, solve(endless).summary.peak_force);
}

// --- Columns ---

/// The force of laws with memory at the end of one path, by ever more columns: also with no weight at the
/// axis, and with a rim, where the weight ends with a jump.
template <class Law>
void expect_order_of_columns(const Nose& nose, double coarsest = 0.4) {
  constexpr double thickness = 0.03, speed = 3, depth = 0.6 * thickness;
  const Sections sections = sections_of(nose);
  const auto force_at = [&](double resolution) {
    ColumnField<Law> field(sample_law<Law>(), thickness, sections);
    field.start(resolution, depth);
    constexpr int steps = 400;
    double force = 0;
    for (int i = 0; i < steps; ++i) {
      const PadTrial trial = field.trial(depth / steps, i * depth / speed / steps, depth / speed / steps);
      field.accept(trial);
      force = trial.force;
    }
    return force;
  };
  const double fine = force_at(coarsest / 128);
  std::vector<double> size, error;
  for (int level = 0; level < 5; ++level) {
    size.push_back(coarsest / (1 << level));
    error.push_back(std::abs(force_at(size.back()) / fine - 1));
  }
  expect_order(size, error, fmt::format("{}, {}", name_of(nose), Law::name), 2.6);
}

TEST(Noses, HaveColumnsOfSecondOrder) {
  for (const Nose& nose : std::vector<Nose>{pointed, blunt, stud, rod, pole, stepped}) {
    expect_order_of_columns<LinearViscoelastic>(nose);
    expect_order_of_columns<NineParameter>(nose);
    // Below a cylinder the error of the coarsest runs changes its sign.
    expect_order_of_columns<TwentyOneParameter>(nose, std::holds_alternative<Cylinder>(nose) ? 0.2 : 0.4);
    expect_order_of_columns<ViscoelasticFoam>(nose);
  }
}

/// The closed form of law 4 against columns, and vectors against single columns.
TEST(Noses, GiveTheSameAnswersByBothPaths) {
  for (const Nose& nose : noses)
    for (const PadLaw& law : laws()) {
      const ImpactCase impact = impact_of(nose, law, Support::linear(3e5));
      const Summary fast = solve(impact, {.tolerance = 1e-4}).summary;
      const Summary plain = solve(impact, {.tolerance = 1e-4, .plain = true}).summary;
      const std::string what = name_of(nose) + ", " + name_of(law);
      ASSERT_EQ(fast.status, plain.status) << what;
      expect_relative(fast.peak_force.value(), plain.peak_force.value(), 2e-4, what + ": force");
      expect_relative(fast.peak_penetration, plain.peak_penetration, 2e-4, what + ": penetration");
      ASSERT_EQ(fast.rebound_speed.has_value(), plain.rebound_speed.has_value()) << what;
      if (fast.rebound_speed)
        expect_relative(*fast.rebound_speed, *plain.rebound_speed, 2e-4, what + ": rebound");
    }
}

/// Whole impacts of a cone on a pad of columns and a spring, at halved resolutions: the largest errors over
/// several speeds, so that none is small because two parts of it happen to cancel.
TEST(Noses, AConeConvergesWithSecondOrder) {
  constexpr std::size_t compared = 5;
  constexpr double coarsest = 0.1;
  const std::vector<std::pair<const char*, double (*)(const Figures&)>> read{
      {"peak force", [](const Figures& f) { return f.peak_force; }},
      {"peak penetration", [](const Figures& f) { return f.peak_penetration; }},
      {"end of contact", [](const Figures& f) { return f.contact_end.value().time; }}};
  for (const Nose& nose : {Nose(pointed), Nose(blunt)}) {
    std::vector<std::vector<double>> error(read.size(), std::vector<double>(compared, 0.0));
    for (const double speed : {1.6, 2.0, 2.4}) {
      ImpactCase impact = impact_of(nose, sample_law<TwentyOneParameter>(), Support::linear(2e5));
      impact.impactor.speed = speed;
      std::vector<Figures> runs;
      double resolution = coarsest;
      for (std::size_t i = 0; i < compared + 2; ++i, resolution /= 2)
        runs.push_back(run_once(impact, resolution).figures);
      for (std::size_t k = 0; k < read.size(); ++k) {
        const auto figure = read[k].second;
        const double finest = figure(runs[compared + 1]);
        const double best = finest + (finest - figure(runs[compared])) / 3;
        for (std::size_t i = 0; i < compared; ++i)
          error[k][i] = std::max(error[k][i], relative_error(figure(runs[i]), best));
      }
    }
    std::vector<double> size;
    for (std::size_t i = 0; i < compared; ++i) size.push_back(coarsest / double(1 << i));
    for (std::size_t k = 0; k < read.size(); ++k) {
      const double order = observed_order(size, error[k]);
      fmt::print("{:6}{:18} {:.1e} to {:.1e}, order {:.2f}\n", name_of(nose), read[k].first, error[k].front(),
                 error[k].back(), order);
      // As for a sphere (test_convergence.cpp).
      EXPECT_GT(order, 1.6) << read[k].first;
      EXPECT_LT(order, 2.5) << read[k].first;
    }
  }
}

TEST(Noses, BalanceTheirEnergy) {
  for (const Nose& nose : noses)
    for (const PadLaw& law : laws())
      for (const Support& support :
           {Support::rigid(), Support::linear(3e5), Support::through({{2e-3, 500}, {0.01, 1e4}})}) {
        const Summary s = solve(impact_of(nose, law, support)).summary;
        const std::string what =
            fmt::format("{}, {}, {} points", name_of(nose), name_of(law), support.points().size());
        EXPECT_TRUE(s.trustworthy()) << what << ": " << to_string(s.status);
        EXPECT_LE(std::abs(s.energy.residual), 1e-4 * s.energy.impact) << what;
      }
}

/// From the first moment on it is all of the tip that touches, whatever the law.
TEST(Noses, WithAFlatTipTouchWithAllOfIt) {
  for (const Nose& nose : {Nose(platen), Nose(FlatDisc{0.06}), Nose(blunt)})
    for (const PadLaw& law : laws()) {
      const History history = solve(impact_of(nose, law, Support::linear(3e5))).history;
      const double radius = sections_of(nose).radius(0);
      EXPECT_GE(history.contact_radius[history.size() / 4], radius * (1 - 1e-12))
          << name_of(nose) << ", " << name_of(law);
    }
}

/// The stress of the snapshots, over circles of the sections' areas, is the force of the history.
TEST(Noses, HaveSnapshotsThatAddUpToTheForce) {
  for (const Nose& nose : noses)
    for (const PadLaw& law : laws()) {
      ImpactCase impact = impact_of(nose, law, Support::linear(3e5));
      impact.pad.area = 0.008;
      const Solution solution = solve(impact);
      const double peak = solution.summary.peak_force.value();
      const auto snapshots = contact_snapshots(impact, solution.history);
      EXPECT_FALSE(snapshots.empty()) << name_of(nose) << ", " << name_of(law);
      for (const ContactSnapshot& snapshot : snapshots) {
        if (!snapshot.determined) continue;
        EXPECT_NEAR(snapshot.force_of_stress(), snapshot.force, 0.01 * std::max(snapshot.force, 0.1 * peak))
            << name_of(nose) << ", " << name_of(law) << ", " << snapshot.when;
        EXPECT_LE(snapshot.radius.back(), std::sqrt(0.008 / pi) * (1 + 1e-12));
      }
    }
}

}  // namespace
}  // namespace dashpad::test
