/// Noses whose area is no quadratic function of the depth: a cylinder on its side, profiles by points.
/// Against closed forms, and against the noses that they are or tend to.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <boost/math/quadrature/tanh_sinh.hpp>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "dashpad/impact/solve.hpp"
#include "shared/samples.hpp"
#include "verification/order.hpp"

namespace dashpad::test {
namespace {

using std::numbers::pi;

const Cylinder pole{.radius = 0.06, .length = 0.15};

std::vector<PadLaw> laws() {
  return {sample_law<Elastic>(),       sample_law<LinearViscoelastic>(), sample_law<RigidFoam>(),
          sample_law<NineParameter>(), sample_law<TwentyOneParameter>(), sample_law<Foam>(),
          sample_law<CrushableFoam>(), sample_law<ViscoelasticFoam>()};
}

ImpactCase impact_of(const Nose& nose, const PadLaw& law, Support support = Support::linear(2e5)) {
  ImpactCase impact = impact_on(law, std::move(support));
  impact.impactor.nose = nose;
  return impact;
}

void expect_alike(const Nose& one, const Nose& other, double allowed) {
  for (const PadLaw& law : laws()) {
    const Summary a = solve(impact_of(one, law), {.tolerance = 1e-5}).summary;
    const Summary b = solve(impact_of(other, law), {.tolerance = 1e-5}).summary;
    const std::string what = name_of(one) + ", " + name_of(law);
    ASSERT_TRUE(a.trustworthy() && b.trustworthy()) << what;
    expect_relative(a.peak_force.value(), b.peak_force.value(), allowed, what + ": peak force");
    expect_relative(a.peak_penetration, b.peak_penetration, allowed, what + ": penetration");
    ASSERT_EQ(a.rebound_speed.has_value(), b.rebound_speed.has_value()) << what;
    if (a.rebound_speed) expect_relative(*a.rebound_speed, *b.rebound_speed, allowed, what + ": rebound");
  }
}

/// Points of a section that is given over the angle from the axis, 0 to 90 degrees.
template <class Depth, class Size>
Profile sampled(Profile::Of kind, int count, Depth&& depth, Size&& size) {
  Profile profile{.of = kind};
  for (int i = 0; i <= count; ++i) {
    const double angle = pi / 2 * i / count;
    profile.points.push_back({depth(angle), size(angle)});
  }
  return profile;
}
Profile sampled_sphere(double radius, int count) {
  return sampled(
      Profile::Of::radius, count, [=](double angle) { return radius * (1 - std::cos(angle)); },
      [=](double angle) { return radius * std::sin(angle); });
}

// --- A cylinder on its side ---

TEST(Cylinder, HasTheSectionsOfItsGeometry) {
  const Sections sections = pole.sections();
  boost::math::quadrature::tanh_sinh<double> quadrature;
  for (const double s : {1e-7, 1e-4, 0.007, 0.0072, 0.0145, 0.03, 0.0599, 0.06}) {
    const auto chord = [](double depth) {
      return 2 * pole.length * std::sqrt(depth * (2 * pole.radius - depth));
    };
    expect_relative(sections.area(s), chord(s), 1e-15, "area");
    expect_relative(sections.depth_at(sections.radius(s)), s, s < 0.05 ? 1e-12 : 1e-6, "depth");
    expect_relative(sections.volume(s), quadrature.integrate(chord, 0.0, s), 1e-12, "volume");
    const auto moment = [&](double depth) { return (s - depth) * chord(depth); };
    expect_relative(sections.integral(s, 2), quadrature.integrate(moment, 0.0, s), 1e-11,
                    "integral of the volume");
    // Half a cylinder and the box below it.
    const double beyond = 0.02;
    expect_relative(sections.volume(pole.radius + beyond),
                    pole.length * pole.radius * (pi * pole.radius / 2 + 2 * beyond), 1e-14, "volume beyond");
  }
  for (const double s : {1e-5, 0.01, 0.05}) {
    const double step = 1e-6 * s;
    expect_relative(sections.rate(s), (sections.area(s + step) - sections.area(s - step)) / (4 * pi * step),
                    1e-7, "rate");
  }
}

TEST(Cylinder, IsCutIntoPiecesOfItsAreaAndVolume) {
  const Sections sections = pole.sections();
  for (const double grading : {0.5, 0.2}) {
    const std::vector<SectionPiece> pieces = sections.shape->pieces(grading);
    double end = 0;
    for (const SectionPiece& section_piece : pieces) {
      EXPECT_EQ(section_piece.from, end);
      end = section_piece.to;
      const auto rise = [&](double s) {
        return 2 * pi * (section_piece.width - section_piece.taper * (s + section_piece.from) / 2) *
               (s - section_piece.from);
      };
      expect_relative(sections.area(section_piece.from) + rise(section_piece.to),
                      sections.area(section_piece.to), 1e-12, "area");
    }
    EXPECT_EQ(end, pole.radius);
  }
}

/// F = E/L l R^2 (theta - sin theta cos theta), with cos theta = 1 - Y/R.
TEST(Cylinder, OnAnElasticPadHasAClosedForm) {
  for (const double speed : {0.3, 1.0, 2.5}) {
    ImpactCase impact = impact_of(pole, Elastic{3e5}, Support::rigid());
    impact.impactor.speed = speed;
    const Summary s = solve(impact, {.tolerance = 1e-7}).summary;
    ASSERT_TRUE(s.release);
    const double stiffness = 3e5 / impact.pad.thickness;
    const double angle = std::acos(1 - s.peak_penetration / pole.radius);
    const double volume =
        pole.length * pole.radius * pole.radius * (angle - std::sin(angle) * std::cos(angle));
    expect_relative(s.peak_force.value(), stiffness * volume, 1e-6, "force");
    const double energy = stiffness * pole.length * std::pow(pole.radius, 3) *
                          (std::sin(angle) - angle * std::cos(angle) - std::pow(std::sin(angle), 3) / 3);
    expect_relative(energy, impact.impactor.mass * speed * speed / 2, 1e-6, "energy");
    expect_relative(s.rebound_speed.value(), speed, 1e-7, "rebound");
  }
}

TEST(Cylinder, CountsByItsLength) {
  // Twice as long with twice the mass is twice the force, at any law on a rigid support.
  for (const PadLaw& law : laws()) {
    ImpactCase one = impact_of(pole, law, Support::rigid());
    ImpactCase two = one;
    two.impactor.mass *= 2;
    two.impactor.nose = Cylinder{pole.radius, 2 * pole.length};
    const Summary a = solve(one).summary, b = solve(two).summary;
    expect_relative(2 * a.peak_force.value(), b.peak_force.value(), 1e-9, name_of(law));
    expect_relative(a.peak_penetration, b.peak_penetration, 1e-9, name_of(law));
  }
}

/// The points lie closest at the tip, where the area begins like the root of the depth.
TEST(Cylinder, IsWhatAProfileOfItsAreasTendsTo) {
  constexpr int count = 300;
  Profile profile{.of = Profile::Of::area};
  for (int i = 0; i <= count; ++i) {
    const double share = double(i) / count;
    const double angle = pi / 2 * share * share;
    const double depth = pole.radius * 2 * std::pow(std::sin(angle / 2), 2);
    if (i == 0 || depth > profile.points.back().depth + 1e-8)
      profile.points.push_back({depth, 2 * pole.length * pole.radius * std::sin(angle)});
  }
  expect_alike(profile, pole, 2e-4);
}

// --- Profiles ---

TEST(Profile, OfTwoPointsIsACone) {
  const Cone cone{.radius = 0.05, .half_angle = 1.2, .tip_radius = 0.01};
  const Profile profile{.points = {{0, 0.01}, {0.04 / std::tan(1.2), 0.05}}};
  const Sections one = profile.sections(), other = cone.sections();
  for (const double s : {0.001, 0.01, 0.0155, 0.02}) {
    expect_relative(one.area(s), other.area(s), 1e-13, "area");
    expect_relative(one.volume(s), other.volume(s), 1e-13, "volume");
    expect_relative(one.integral(s, 2), other.integral(s, 2), 1e-13, "integral of the volume");
    expect_relative(one.depth_at(0.04), other.depth_at(0.04), 1e-13, "depth");
  }
  expect_alike(profile, cone, 3e-5);
}

TEST(Profile, OfOneSizeIsADisc) {
  const Sections sections = Profile{.points = {{0, 0.05}, {0.01, 0.05}}}.sections();
  EXPECT_EQ(sections.shape, nullptr);
  EXPECT_EQ(sections.tip, FlatDisc{0.05}.sections().tip);
  EXPECT_EQ(sections.depth, 0);
  // So is what is behind the widest section of any other.
  const Profile whole{.points = {{0, 0}, {0.01, 0.05}}};
  const Profile longer{.points = {{0, 0}, {0.01, 0.05}, {0.03, 0.05}, {0.1, 0.05}}};
  EXPECT_EQ(longer.sections().depth, whole.sections().depth);
}

TEST(Profile, IsTheSameInAsManyStretchesAsOneLikes) {
  Profile cone{.points = {{0, 0}, {0.03, 0.06}}};
  Profile cut{.points = {{0, 0}, {0.001, 0.002}, {0.01, 0.02}, {0.015, 0.03}, {0.03, 0.06}}};
  expect_alike(cut, cone, 3e-5);
}

TEST(Profile, IsScaledInAllLengths) {
  const Profile small{.points = {{0, 0.001}, {0.005, 0.02}, {0.02, 0.04}}};
  Profile half{.scale = 0.5, .points = small.points};
  for (Profile::Point& point : half.points) point.depth *= 2, point.size *= 2;
  for (const double s : {0.001, 0.004, 0.01, 0.03})
    expect_relative(half.sections().area(s), small.sections().area(s), 1e-14, "area");
  const Profile areas{.of = Profile::Of::area, .points = {{0, 0}, {0.01, 0.004}}};
  Profile twice = areas;
  twice.scale = 2;
  expect_relative(twice.sections().area(0.02), 4 * areas.sections().area(0.01), 1e-14, "area");
}

TEST(Profile, OfASphereTendsToItWithOrderTwo) {
  constexpr double radius = 0.08;
  std::vector<double> size, error;
  for (const int count : {10, 20, 40, 80}) {
    size.push_back(1.0 / count);
    error.push_back(std::abs(
        sampled_sphere(radius, count).sections().volume(0.03) / Sphere{radius}.sections().volume(0.03) - 1));
  }
  expect_order(size, error, "volume of a sampled sphere");
  expect_alike(sampled_sphere(radius, 200), Sphere{radius}, 3e-4);
}

TEST(Profile, NamesThePointThatBreaksARule) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto broken = [](std::vector<Profile::Point> points) {
    const auto faults = Profile{.points = std::move(points)}.faults();
    return faults.size() == 1 ? fmt::format("{}: {}", faults[0].point, faults[0].rule)
                              : fmt::format("{} faults", faults.size());
  };
  EXPECT_EQ(broken({{0, 0}, {1, 1}}), "0 faults");
  EXPECT_EQ(broken({{0, 0}}), "0: has fewer than two points");
  EXPECT_EQ(broken({{0.1, 0}, {1, 1}}), "0: the first depth must be 0: depths are measured from the tip");
  EXPECT_EQ(broken({{0, 0}, {1, 1}, {1, 2}}),
            "2: the depth must exceed the previous depth by at least 1e-9 m");
  EXPECT_EQ(broken({{0, 0}, {1, 1}, {2, 0.5}}), "2: the radius must not decrease with distance from the tip");
  EXPECT_EQ(broken({{0, -1}, {1, 1}}), "0: the radius must not be negative");
  EXPECT_EQ(broken({{0, 0}, {1, nan}}), "1: must be finite");
  EXPECT_EQ(broken({{0, 0}, {1, 0}}), "1: the radius must be more than 0 beyond the tip");
}

}  // namespace
}  // namespace dashpad::test
