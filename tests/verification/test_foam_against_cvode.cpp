/// Impacts on foams against a second solver, by formulas of its own (tests/oracle/foam_impact.hpp and
/// maxwell_impact.hpp): every form of the base curve, every rate effect, friction and unloading, and
/// viscoelastic foams with relaxation times shorter and longer than the impact, on every kind of support,
/// below a sphere, a flat disc, cones, a cylinder on its side and a profile.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "dashpad/impact/solve.hpp"
#include "model/pad/foam/foam_stress.hpp"
#include "oracle/cvode_impact.hpp"
#include "oracle/foam_formulas.hpp"
#include "oracle/maxwell_impact.hpp"
#include "property/draw.hpp"
#include "property/random_case.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

constexpr double tolerance = 1e-4;
/// What is asked of the solver, and as much again as a tenth of it for the oracle, whose table of an
/// unloading curve and root of the penetration are good to 1e-6.
constexpr double allowed = 1.1 * tolerance;

struct Named {
  std::string name;
  PadLaw law;
};

Foam plain() {
  Foam foam;
  foam.curves = {.base = soft_table(), .slowest_rate = 0.01, .rate_effect = NoRateEffect{}};
  return foam;
}

CurvesRateEffect faster_curves(bool linear) {
  const TableCurve base = soft_table();
  const auto times = [&](double factor, double slope, std::size_t points) {
    TableCurve curve;
    for (std::size_t i = 0; i < points; ++i) {
      curve.strain.push_back(base.strain[i]);
      curve.stress.push_back(base.stress[i] * (factor + slope * base.strain[i]));
    }
    return curve;
  };
  // The fastest machine did not reach the last strain.
  return {{{1, times(1.15, 0.1, 9)}, {100, times(1.5, 0.2, 8)}}, linear};
}

std::vector<Named> foams() {
  std::vector<Named> all;
  const auto add = [&](const std::string& name, auto&& change) {
    Foam foam = plain();
    change(foam);
    all.push_back({name, foam});
  };
  add("table", [](Foam&) {});
  add("avalle", [](Foam& f) { f.curves.base = AvalleCurve{60e3, 600e3, 0.5, 40e3, 1.6, 0.8}; });
  add("power", [](Foam& f) { f.curves.base = PowerCurve{80e3, 0.675, 1.09, 0.8}; });
  add("gibson-ashby", [](Foam& f) { f.curves.base = GibsonAshbyCurve{800e3, 50e3, 50e3, 0.05, 0.8}; });
  add("hyperfoam", [](Foam& f) { f.curves.base = HyperfoamCurve{60e3, 8, 10e3, -1.5, 0.7}; });
  add("power rate", [](Foam& f) { f.curves.rate_effect = PowerRateEffect{0.06, 0.05, 300}; });
  add("power rate, little", [](Foam& f) { f.curves.rate_effect = PowerRateEffect{0.1, 0, 20}; });
  add("factor rate", [](Foam& f) { f.curves.rate_effect = FactorRateEffect{{1, 30, 200}, {1.1, 1.3, 1.5}}; });
  add("curves rate", [](Foam& f) { f.curves.rate_effect = faster_curves(false); });
  add("curves rate, linear", [](Foam& f) { f.curves.rate_effect = faster_curves(true); });
  add("friction", [](Foam& f) { f.friction = 0.2; });
  add("unloading factor", [](Foam& f) { f.unloading_factor = 0.3, f.unloading_shape = 2; });
  add("unloading curve", [](Foam& f) {
    TableCurve back = soft_table();
    for (std::size_t i = 0; i < back.strain.size(); ++i)
      back.stress[i] *= 0.4 + 0.6 * std::pow(back.strain[i] / back.strain.back(), 3);
    f.unloading_curve = back;
    f.friction = 0.1;
  });
  add("no recoil", [](Foam& f) { f.curves.rate_effect = PowerRateEffect{0.06, 0, 300}, f.recoil = 0; });
  add("long lag", [](Foam& f) {
    f.curves.rate_effect = PowerRateEffect{0.06, 0, 300};
    f.lag_strain = 0.05;
    f.continuation_exponent = 1;
  });
  all.push_back({"sample", sample_law<Foam>()});
  all.push_back({"crushable sample", sample_law<CrushableFoam>()});
  CrushableFoam crushable = sample_law<CrushableFoam>();
  crushable.curves.rate_effect = NoRateEffect{};
  all.push_back({"crushable", crushable});
  crushable.curves = {.base = GibsonAshbyCurve{3e6, 200e3, 101.3e3, 0.03, 0.8},
                      .slowest_rate = 1e-3,
                      .rate_effect = PowerRateEffect{0.03, 0.02, 100}};
  all.push_back({"crushable gibson-ashby", crushable});
  return all;
}

/// The impacts of this test take some 15 to 30 ms.
std::vector<Named> slow_foams() {
  std::vector<Named> all;
  const auto one = [&](const std::string& name, double share, double time, auto&& change) {
    ViscoelasticFoam foam = sample_law<ViscoelasticFoam>();
    foam.first_share = share, foam.first_time = time;
    foam.second_share = 0, foam.second_time = 1;
    change(foam);
    all.push_back({name, foam});
  };
  const auto plain = [](ViscoelasticFoam&) {};
  one("short branch", 3, 1e-3, plain);
  one("branch as long", 3, 1e-2, plain);
  one("long branch", 3, 0.3, plain);
  one("little branch", 0.3, 1e-2, plain);
  one("great branch", 10, 1e-2, [](ViscoelasticFoam& f) { f.first_modulus = 10e3; });
  one("one term", 2, 5e-3, [](ViscoelasticFoam& f) { f.second_modulus = 0; });
  one("steep", 2, 1e-2, [](ViscoelasticFoam& f) { f.first_exponent = -2, f.second_modulus = 0; });
  one("level", 4, 2e-2, [](ViscoelasticFoam& f) { f.first_modulus = 60e3, f.first_exponent = 25; });
  const auto two = [&](const std::string& name, double first_time, double second_time) {
    one(name, 2, first_time, [&](ViscoelasticFoam& f) { f.second_share = 1.5, f.second_time = second_time; });
  };
  two("short and as long", 1e-3, 1e-2);
  two("short and long", 1e-3, 0.3);
  two("as long and long", 1e-2, 0.3);
  two("both short", 5e-4, 2e-3);
  two("both the same", 1e-2, 1e-2);
  two("slower first", 0.1, 5e-3);
  all.push_back({"slow sample", sample_law<ViscoelasticFoam>()});
  return all;
}

void expect_same(const Summary& summary, const oracle::CvodeImpact& other, double limit, double gravity = 0) {
  const auto d = oracle::compare(summary, other);
  SCOPED_TRACE(d.text());
  const auto small = [&](const std::optional<double>& difference, const char* what) {
    ASSERT_TRUE(difference) << what;
    EXPECT_LE(std::abs(*difference), limit) << what;
  };
  small(d.peak_force, "peak force");
  small(d.peak_motion, "peak motion");
  small(d.peak_penetration, "peak penetration");
  small(d.contact_end_time, "end of contact");
  small(d.contact_end_velocity, "velocity at the end of contact");
  // Of a foam that brings next to nothing back the speed is held to a thousandth of the impact's.
  ASSERT_TRUE(summary.release && other.release);
  const double scale =
      std::max(std::abs(other.release->velocity), 1e-3 * std::abs(summary.rebound_speed.value()));
  // Under gravity the speed goes on changing until the release, the time of which is ill-posed (Eq. 27).
  const double of_time = gravity * std::abs(summary.release->time - other.release->time);
  EXPECT_NEAR(summary.release->velocity, other.release->velocity, limit * scale + of_time) << "rebound speed";
  // A flat peak has no sharp time: theory.md, section 4, holds it to 1 % of the contact.
  ASSERT_TRUE(summary.time_of_peak_force && other.contact_end);
  EXPECT_NEAR(*summary.time_of_peak_force, other.time_of_peak_force, 0.01 * other.contact_end->time);
}

TEST(FoamAgainstCvode, HasSoundSamples) {
  for (const auto& all : {foams(), slow_foams()})
    for (const Named& named : all)
      for (const Violation& broken : violations(named.law))
        ADD_FAILURE() << named.name << ": " << broken.key << " " << broken.rule;
}

/// Column by column: stress by the library and by the oracle's formulas.
TEST(FoamAgainstCvode, AgreesOnTheStressOfAColumn) {
  const auto check = [](const std::string& name, const auto& law) {
    SCOPED_TRACE(name);
    const FoamStress ours(law);
    const oracle::FoamFormulas other(law);
    const double highest = 0.5 + 0.5 * other.last_strain();
    for (const double share : {0.001, 0.01, 0.1, 0.3, 0.5, 0.8, 0.9, 1.0})
      for (const double back : {0.0, 1e-3, 0.1, 0.4, 0.9})
        for (const double u : {0.0, 1e-6, 1e-4, 0.3, 7.0, 180.0, 5e3})
          for (const double side : {1.0, -1.0}) {
            const double largest = share * highest, strain = largest * (1 - back);
            const SlipScale slip = ours.slip();
            const double g = side * slip.strain * std::log1p(u / slip.rate);
            const double stress = ours.stress(strain_of(strain), largest - strain, g);
            const double expected = other.stress(strain, 1 - strain, largest - strain, side * u);
            // Where a faster curve ends the library's cells take the corner off.
            EXPECT_NEAR(stress, expected, 5e-5 * other.base(largest, 1 - largest))
                << "strain " << strain << " of " << largest << ", slip rate " << side * u;
          }
    for (const double share : {0.001, 0.01, 0.1, 0.3, 0.5, 0.8, 0.9, 1.0}) {
      const double strain = share * highest;
      expect_relative(ours.curve().at(strain_of(strain)).work, other.work(strain, 1 - strain), 5e-5, "work");
    }
  };
  for (const Named& named : foams())
    std::visit(
        [&]<class Law>(const Law& law) {
          if constexpr (SharesSlip<Law>) check(named.name, law);
        },
        named.law);
}

/// `earlier`: largest strain that earlier blows have left on the axis.
void compare_on(const std::vector<Support>& supports, const std::vector<Nose>& noses,
                const std::vector<Named>& all = foams(), int fewest = 18, double earlier = 0) {
  int compared = 0;
  for (const Named& named : all)
    for (const Nose& nose : noses)
      for (const Support& support : supports) {
        ImpactCase impact = impact_on(named.law, support);
        impact.impactor.nose = nose;
        impact.pad.earlier_penetration = earlier * impact.pad.thickness;
        // A flat disc meets all of its pad at once.
        if (std::holds_alternative<FlatDisc>(nose)) impact.impactor.speed = 2;
        // Below a strain of 0.98: at 0.994 the peak forces of one foam (curves rate, linear) differ by 8e-4.
        if (std::holds_alternative<Cone>(nose) && support.is_rigid()) impact.impactor.speed = 2.8;
        SCOPED_TRACE(
            fmt::format("{}, {}, support of {} points", named.name, name_of(nose), support.points().size()));
        const auto other = oracle::solve_with_cvode(impact);
        if (other.ending == oracle::Ending::bottomed_out) continue;
        // Beyond its tested strain crushed foam lets go in rings, and the oracle looks for them at 96 places.
        const bool is_crushed = std::holds_alternative<CrushableFoam>(named.law);
        if (earlier > 0 && is_crushed && other.peak_penetration > 0.8 * impact.pad.thickness) continue;
        // CVODE gives up on one foam (hyperfoam) below a cylinder, whose widening has no bound at the tip.
        if (other.ending == oracle::Ending::failed && std::holds_alternative<Cylinder>(nose)) continue;
        ASSERT_EQ(other.ending, oracle::Ending::released);
        const Summary summary = solve(impact, {.tolerance = tolerance}).summary;
        fmt::print("{:22} {:9} {} strain {:.3f}: {}\n", named.name, name_of(nose), support.points().size(),
                   summary.peak_strain, oracle::compare(summary, other).text());
        EXPECT_EQ(summary.status, Status::released) << to_string(summary.status);
        expect_same(summary, other, allowed);
        ++compared;
      }
  EXPECT_GE(compared, fewest) << "too few that do not bottom";
}

const Sphere head{0.08};
const FlatDisc plate{0.06};
const Support spring = Support::linear(2e5);
const Support curved = Support::through({{0.002, 600}, {0.006, 1500}, {0.02, 9000}});

TEST(FoamAgainstCvode, AgreesBelowASphereOnARigidSupport) { compare_on({Support::rigid()}, {head}); }
TEST(FoamAgainstCvode, AgreesBelowASphereOnASpring) { compare_on({spring}, {head}); }
TEST(FoamAgainstCvode, AgreesBelowASphereOnACurvedSupport) { compare_on({curved}, {head}); }
TEST(FoamAgainstCvode, AgreesBelowAFlatDiscOnARigidSupport) { compare_on({Support::rigid()}, {plate}); }
TEST(FoamAgainstCvode, AgreesBelowAFlatDiscOnASpring) { compare_on({spring}, {plate}); }
TEST(FoamAgainstCvode, AgreesBelowAFlatDiscOnACurvedSupport) { compare_on({curved}, {plate}); }

/// A pointed cone, and a blunt one whose side is met too.
const Cone pointed{.radius = 0.1, .half_angle = 1.2};
const Cone blunt{.radius = 0.05, .half_angle = 1.3, .tip_radius = 0.02};
TEST(FoamAgainstCvode, AgreesBelowConesOnARigidSupport) { compare_on({Support::rigid()}, {pointed, blunt}); }
TEST(FoamAgainstCvode, AgreesBelowConesOnASpring) { compare_on({spring}, {pointed, blunt}); }

/// A cylinder on its side, and a profile with a flat tip, a steep side and a shoulder.
const Cylinder pole{.radius = 0.06, .length = 0.15};
const Profile stepped{.points = {{0, 0.005}, {0.004, 0.02}, {0.012, 0.022}, {0.02, 0.05}}};
TEST(FoamAgainstCvode, AgreesBelowACylinderOnItsSide) { compare_on({spring}, {pole}); }
TEST(FoamAgainstCvode, AgreesBelowAProfile) { compare_on({spring}, {stepped}); }

/// Pads that were struck before: less deep than now, about as deep, and deeper.
TEST(FoamAgainstCvode, AgreesOnAPadStruckBeforeOnARigidSupport) {
  for (const double earlier : {0.3, 0.6, 0.85})
    compare_on({Support::rigid()}, {head, plate}, foams(), 26, earlier);
}
TEST(FoamAgainstCvode, AgreesOnAPadStruckBeforeOnASpring) {
  compare_on({spring}, {head, plate}, foams(), 26, 0.6);
}
TEST(FoamAgainstCvode, AgreesOnAPadStruckBeforeBelowOtherNoses) {
  compare_on({Support::rigid()}, {blunt}, foams(), 18, 0.5);
  compare_on({spring}, {stepped}, foams(), 16, 0.5);
}

/// A damper, a panel, a support that is crushed, a free body, gravity, by themselves and together.
TEST(FoamAgainstCvode, AgreesOnSupportsThatMove) {
  const auto with = [](auto&& change) {
    Backing backing;
    change(backing);
    return backing;
  };
  const std::vector<Backing> backings{
      with([](Backing& b) { b.damping = 300; }),
      with([](Backing& b) { b.damping = 5000; }),
      with([](Backing& b) { b.damping = 300, b.unloading_stiffness = 1e6; }),
      with([](Backing& b) { b.damping = 300, b.body_mass = 10; }),
      with([](Backing& b) { b.mass = 1; }),
      with([](Backing& b) { b.mass = 6, b.damping = 200; }),
      with([](Backing& b) { b.mass = 1, b.damping = 200, b.unloading_stiffness = 6e5; }),
      with([](Backing& b) { b.mass = 2, b.damping = 200, b.body_mass = 20; }),
  };
  int compared = 0, struck_again = 0;
  for (const Named& named : foams()) {
    if (named.name != "table" && named.name != "power rate" && named.name != "sample" &&
        named.name != "crushable sample")
      continue;
    for (std::size_t i = 0; i < backings.size(); ++i) {
      ImpactCase impact = impact_on(named.law, spring);
      if (i % 2 == 1) impact.impactor.nose = plate;
      impact.impactor.speed = 2.5;
      impact.backing = backings[i];
      if (i < 3) impact.impactor.gravity = 9.81;
      SCOPED_TRACE(fmt::format("{}, support {}", named.name, i));
      const auto other = oracle::solve_with_cvode(impact);
      ASSERT_EQ(other.ending, oracle::Ending::released);
      const Summary summary = solve(impact, {.tolerance = tolerance}).summary;
      fmt::print("{:18} {} strain {:.3f}: {}\n", named.name, i, summary.peak_strain,
                 oracle::compare(summary, other).text());
      EXPECT_EQ(summary.status, Status::released) << to_string(summary.status);
      // The second solver ends where contact is lost; the panel then may come after the impactor.
      if (summary.release->time > 1.1 * other.release->time) {
        EXPECT_NEAR(*summary.peak_force, other.peak_force, allowed * other.peak_force);
        EXPECT_GT(backings[i].mass, 0);
        ++struck_again;
        continue;
      }
      expect_same(summary, other, allowed, impact.impactor.gravity);
      if (backings[i].body_mass > 0)
        expect_relative(*summary.support->body_speed, other.body_velocity, allowed, "body");
      ++compared;
    }
  }
  EXPECT_EQ(compared + struck_again, 32);
  EXPECT_LE(struck_again, 6);
}

/// Beyond the radius of a small sphere.
TEST(FoamAgainstCvode, AgreesBeyondTheRadius) {
  ImpactCase impact = impact_on(sample_law<Foam>());
  impact.impactor = {0.3, Sphere{0.008}, 2};
  const auto other = oracle::solve_with_cvode(impact);
  ASSERT_EQ(other.ending, oracle::Ending::released);
  ASSERT_GT(other.peak_penetration, 0.008);
  expect_same(solve(impact, {.tolerance = tolerance}).summary, other, allowed);
}

TEST(FoamAgainstCvode, SlowFoamsAgreeOnARigidSupport) {
  compare_on({Support::rigid()}, {head, plate}, slow_foams(), 26);
}
TEST(FoamAgainstCvode, SlowFoamsAgreeOnASpring) { compare_on({spring}, {head, plate}, slow_foams(), 26); }
TEST(FoamAgainstCvode, SlowFoamsAgreeOnACurvedSupport) {
  compare_on({curved}, {head, plate}, slow_foams(), 26);
}

/// Random slow foams and impacts.
TEST(FoamAgainstCvode, RandomSlowFoamsAgree) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    Draw draw(seed);
    ViscoelasticFoam law;
    law.first_modulus = draw.decades(5e3, 5e4), law.first_exponent = draw.uniform(1, 20);
    law.second_modulus = draw.decades(1e3, 2e4), law.second_exponent = draw.uniform(-3, -0.2);
    law.first_share = draw.decades(0.2, 5), law.first_time = draw.decades(5e-4, 0.5);
    law.second_share = draw.decades(0.2, 5), law.second_time = draw.decades(5e-4, 0.5);
    ImpactCase impact = impact_on(law, draw.choice(2) == 0 ? Support::rigid() : spring);
    impact.impactor = {draw.decades(1, 6), Sphere{draw.decades(0.02, 0.2)}, draw.decades(1, 5)};
    if (draw.choice(3) == 0) impact.impactor.nose = FlatDisc{draw.decades(0.04, 0.1)};
    impact.pad.thickness = draw.decades(0.02, 0.08);
    SCOPED_TRACE(fmt::format("seed {}", seed));
    const auto other = oracle::solve_with_cvode(impact);
    if (other.ending != oracle::Ending::released) continue;
    const Summary summary = solve(impact, {.tolerance = tolerance}).summary;
    fmt::print("{:2} strain {:.3f}: {}\n", seed, summary.peak_strain, oracle::compare(summary, other).text());
    EXPECT_EQ(summary.status, Status::released) << to_string(summary.status);
    expect_same(summary, other, allowed);
    ++compared;
  }
  EXPECT_GE(compared, 30);
}

/// The oracle itself: without branches no energy is lost, and where the columns take over the force goes on.
TEST(FoamAgainstCvode, TheOracleOfSlowFoamsIsSound) {
  ViscoelasticFoam law = sample_law<ViscoelasticFoam>();
  for (const Support& support : {Support::rigid(), spring}) {
    const auto slow = oracle::solve_with_cvode(impact_on(law, support));
    ASSERT_EQ(slow.ending, oracle::Ending::released);
    EXPECT_GT(slow.energy_absorbed, 0.3);
    EXPECT_LT(slow.drift, 1e-7);
    ViscoelasticFoam lasting = law;
    lasting.first_share = lasting.second_share = 0;
    lasting.first_modulus *= 4, lasting.second_modulus *= 4;
    const auto elastic = oracle::solve_with_cvode(impact_on(lasting, support));
    ASSERT_EQ(elastic.ending, oracle::Ending::released);
    EXPECT_NEAR(elastic.energy_absorbed, 0, 1e-6);
  }
  const oracle::MaxwellFormulas formulas(law);
  for (const double e : {-0.1, 0.0, 0.2, 0.7, 0.95}) {
    const double h = 1e-4 * (1 - e);
    const double slope = (formulas.lasting(e + h) - formulas.lasting(e - h)) / (2 * h);
    EXPECT_NEAR(formulas.lasting_slope(e), slope, 1e-6 * slope);
  }
}

}  // namespace
}  // namespace dashpad::test
