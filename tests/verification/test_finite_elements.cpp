/// What columns leave out: the foam beside them. Finite elements of our own (tests/oracle) against closed
/// forms, the tabled forces of an earlier program computed anew, and the factor that makes up for most of the
/// difference.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "impact/neighbours.hpp"
#include "oracle/finite_elements.hpp"
#include "oracle/gauss.hpp"

namespace dashpad::test {
namespace {

using oracle::Face;
using oracle::Floor;
using oracle::graded;
using oracle::Hyperfoam;
using oracle::MeshedPad;
using oracle::RigidNose;
using oracle::RigidShape;
using std::numbers::pi;

// In kPa, on a pad of thickness 1. B is a fit to the static curve of a vinyl nitrile foam.
const Hyperfoam foam_a{{{100, 2}}, 0};
const Hyperfoam foam_b{{{494, 50}, {32.8, -1.475}}, 0};

/// Forces on a sphere, over the thickness squared, kPa, on a wide pad that is bonded to its floor and does
/// not slip on the nose. Computed by us with an earlier axisymmetric program, which was checked against
/// CalculiX 2.20; nothing of it is in tests/oracle.
struct TabledSphere {
  std::string name;
  const Hyperfoam& foam;
  double radius;                            ///< over the thickness
  std::array<double, 5> elements, columns;  ///< at the depths below
};
constexpr std::array<double, 5> depths{0.1, 0.25, 0.5, 0.6, 0.75};  ///< over the thickness
const std::array<TabledSphere, 3> tabled{{
    {"A, R/L 3.3", foam_a, 3.3, {28.72, 161.4, 679.9, 1033.8, 1839.1}, {21.27, 139.4, 628.7, 972.8, 1781.5}},
    {"B, R/L 3.3", foam_b, 3.3, {56.74, 211.3, 814.6, 1383.5, 3525.5}, {42.46, 169.8, 714.2, 1247.6, 3326.5}},
    {"B, R/L 2.0625",
     foam_b,
     2.0625,
     {39.39, 147.4, 546.5, 915.8, 2279.6},
     {26.34, 104.2, 433.0, 754.9, 2017.1}},
}};

/// By how much a sphere meets more force than columns give.
double factor(double y, double radius) {
  ImpactCase impact;
  impact.impactor.nose = Sphere{radius};
  impact.pad.thickness = 1;
  impact.pad.neighbours = 0.8;
  return factor_of_columns(impact)(y);
}

void expect_share(double value, double expected, double tolerance, const std::string& what) {
  EXPECT_NEAR(value / expected, 1, tolerance) << what << ": " << value << " instead of " << expected;
}

/// Equal square elements in a disc of the radius `even` as deep as that (or as the pad), longer ones beyond,
/// on a pad that is wider by four thicknesses.
MeshedPad pad_of(const Hyperfoam& foam, const RigidNose& nose, Floor floor, double even, double element,
                 double ratio = 1.2) {
  return {foam, nose, floor, graded(element, even, even + 4, ratio),
          graded(element, std::min(even, 1.0), 1, ratio)};
}

double hertz(double plane_modulus, double radius, double depth) {
  return 4.0 / 3 * plane_modulus * std::sqrt(radius) * std::pow(depth, 1.5);
}

/// The force of a large sphere on a linear elastic layer of thickness 1, bonded to its floor, that slips
/// below the sphere. Under a pressure that is a wave of number k the surface sinks by L(k) times what a
/// half-space would; so at a distance r from a point load the floor changes 1/r to 1/r + alpha + beta r^2 +
/// O(r^4), as in Dimitriadis and others 2002, Biophysical Journal 82:2798. Below the pressure of Hertz these
/// terms are a sphere again: the layer is a half-space under a sphere of another radius and depth. (Their
/// numbers for alpha and beta are 0.5 and 5 % off these at nu = 0.5, 6 and 36 % at nu = 0; and their series
/// takes the contact for that of a half-space, which makes it too low from the second order on.)
double bonded_layer(double plane_modulus, double nu, double radius, double depth) {
  const double kappa = 3 - 4 * nu;
  const auto change = [&](double k) {
    return (2 * kappa * std::sinh(2 * k) - 4 * k) /
               (2 * kappa * std::cosh(2 * k) + 1 + kappa * kappa + 4 * k * k) -
           1;
  };
  const double alpha = oracle::gauss(0, 20, 20, change);
  const double beta = oracle::gauss(0, 20, 20, [&](double k) { return -k * k / 4 * change(k); });
  double force = 0;
  for (int i = 0; i < 100; ++i) {
    const double load = force / (pi * plane_modulus);
    const double seeming_radius = 1 / (1 / radius + 2 * beta * load);
    // The square of the contact's radius, but for what beta changes in it.
    const double contact = seeming_radius * (depth - alpha * load);
    force = hertz(plane_modulus, seeming_radius, depth - (alpha + 0.4 * beta * contact) * load);
  }
  return force;
}

/// A sphere so large that strains are small; its contact is a little narrower than chi thicknesses in radius.
struct LightTouch {
  double nu, chi;  ///< chi: root of radius times depth
  double radius = 100 * chi, depth = chi * chi / radius;
  Hyperfoam foam{{{100, 2}}, nu};
  double plane_modulus = foam.young_modulus() / (1 - nu * nu);

  [[nodiscard]] double force() const {
    MeshedPad pad = pad_of(foam, {RigidShape::sphere, radius, Face::smooth}, Floor::bonded, chi, chi / 16);
    return pad.press(depth, depth / 2);
  }
};

/// Eq. 6 of theory.md for a sphere on a stress that depends on strain alone; thickness 1.
double column_force(const Hyperfoam& foam, double radius, double y) {
  return oracle::gauss(0, y, 20, [&](double s) { return foam.column_stress(y - s) * 2 * pi * (radius - s); });
}

TEST(FiniteElements, HaveTheSlopesOfTheirEnergy) {
  const double h = 1e-5;
  for (const double nu : {0.0, 0.2}) {
    const Hyperfoam foam{{{494, 20}, {32.8, -1.475}}, nu};
    const Eigen::Vector3d l(0.6, 1.1, 0.95);
    const auto at = oracle::stretch_energy(foam, l);
    for (Eigen::Index i = 0; i < 3; ++i) {
      const Eigen::Vector3d step = h * Eigen::Vector3d::Unit(i);
      const auto more = oracle::stretch_energy(foam, l + step), less = oracle::stretch_energy(foam, l - step);
      EXPECT_NEAR((more.value - less.value) / (2 * h), at.slope[i], 1e-7 * at.slope.norm());
      EXPECT_LT(((more.slope - less.slope) / (2 * h) - at.curvature.col(i)).norm(),
                1e-7 * at.curvature.norm());
    }
  }
}

/// Free to slip above and below, a block is columns whatever Poisson's ratio is; bonded, where that is 0.
TEST(FiniteElements, GiveABlockTheStressOfAColumn) {
  for (const Hyperfoam& foam : {foam_a, foam_b, Hyperfoam{{{100, 2}}, 0.1}, Hyperfoam{{{253.6, 20.18}}, 0.2}})
    for (const bool bonded : {false, true}) {
      if (bonded && foam.poisson_ratio > 0) continue;
      constexpr double radius = 2;
      MeshedPad block(foam, {RigidShape::flat_disc, radius, bonded ? Face::rough : Face::smooth},
                      bonded ? Floor::bonded : Floor::frictionless, graded(0.25, radius, radius, 1),
                      graded(0.25, 1, 1, 1));
      for (const double depth : {0.01, 0.25, 0.5, 0.75}) {
        const double stress = block.press(depth, 0.05) / (pi * radius * radius);
        expect_share(stress, foam.column_stress(depth - block.give(stress)), 1e-6, "stress");
      }
    }
}

TEST(FiniteElements, ComeToHertzOnAThickPad) {
  const LightTouch touch{.nu = 0, .chi = 0.01};
  // A layer a hundred times as thick as the contact is wide adds 0.8 % by itself.
  expect_share(touch.force(), hertz(touch.plane_modulus, touch.radius, touch.depth), 0.02, "force");
}

/// Of what is allowed, 0.3 to 0.4 % are the elements (half as large ones are that much closer), 0.2 % the
/// strains, and up to 0.9 % at chi = 0.4 the r^4 that the formula leaves out.
TEST(FiniteElements, ComeToTheBondedLayer) {
  for (const double nu : {0.0, 0.3})
    for (const double chi : {0.1, 0.2, 0.3, 0.4}) {
      const LightTouch touch{.nu = nu, .chi = chi};
      expect_share(touch.force(), bonded_layer(touch.plane_modulus, nu, touch.radius, touch.depth), 0.015,
                   "chi " + std::to_string(chi) + ", nu " + std::to_string(nu));
    }
}

/// Twelve elements through the thickness. With 24, and with half the step, forces differ by 0.8 % at most, by
/// 1 % at the first depth, where the contact is some ten elements wide.
TEST(FiniteElements, MeetTheTabledForcesOnASphere) {
  for (const TabledSphere& sphere : tabled) {
    const double contact = std::sqrt(depths.back() * (2 * sphere.radius - depths.back()));
    MeshedPad pad = pad_of(sphere.foam, {RigidShape::sphere, sphere.radius, Face::rough}, Floor::bonded,
                           contact, 1.0 / 12);
    for (std::size_t i = 0; i < depths.size(); ++i)
      expect_share(pad.press(depths[i], 0.05), sphere.elements[i], i == 0 ? 0.02 : 0.01,
                   sphere.name + " at " + std::to_string(depths[i]));
  }
}

/// The stress is singular below the edge, so the tables are extrapolated, as here, from two meshes.
TEST(FiniteElements, MeetTheTabledForcesOnADisc) {
  for (const auto& [radius, forces] :
       {std::pair{1.0, std::array{250.76, 594.18}}, {2.0, std::array{852.45, 2083.9}}}) {
    const RigidNose disc{RigidShape::flat_disc, radius, Face::rough};
    MeshedPad coarse = pad_of(foam_a, disc, Floor::frictionless, radius, 1.0 / 12);
    MeshedPad fine = pad_of(foam_a, disc, Floor::frictionless, radius, 1.0 / 24);
    for (const std::size_t i : {0U, 1U}) {
      const double depth = i == 0 ? 0.25 : 0.5;
      const double force = 2 * fine.press(depth, 0.05) - coarse.press(depth, 0.05);
      expect_share(force, forces[i], 0.01, "disc at " + std::to_string(depth));
    }
  }
}

/// To the digits of the materials: the last of 32.8 may stand for 0.15 %.
TEST(Neighbours, AreNotInTheColumnsOfTheTables) {
  for (const TabledSphere& sphere : tabled)
    for (std::size_t i = 0; i < depths.size(); ++i)
      expect_share(column_force(sphere.foam, sphere.radius, depths[i]), sphere.columns[i], 1.5e-3,
                   sphere.name + " at " + std::to_string(depths[i]));
}

TEST(Neighbours, AreMadeUpForByTheFactor) {
  for (const TabledSphere& sphere : tabled)
    for (std::size_t i = 1; i < depths.size(); ++i)
      expect_share(factor(depths[i], sphere.radius) * column_force(sphere.foam, sphere.radius, depths[i]),
                   sphere.elements[i], 0.1, sphere.name + " at " + std::to_string(depths[i]));
}

}  // namespace
}  // namespace dashpad::test
