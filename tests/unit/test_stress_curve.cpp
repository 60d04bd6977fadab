/// The piecewise linear curve of a pad without memory, and the contact force and work that follow from it.

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/math/quadrature/gauss_kronrod.hpp>
#include <numbers>

#include "model/contact/curve_contact.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using Quadrature = boost::math::quadrature::gauss_kronrod<double, 15>;

TEST(stress_curve, adds_up_its_jump_and_kinks) {
  StressCurve curve;
  curve.initial_stress = 10;
  curve.add_kink(0.2, 100);
  curve.add_kink(0.5, -40);
  EXPECT_EQ(curve.at(-0.1), 0);
  EXPECT_EQ(curve.at(0), 0);
  EXPECT_EQ(curve.at(1e-300), 10);
  EXPECT_EQ(curve.at(0.2), 10);
  EXPECT_NEAR(curve.at(0.4), 30, 1e-12);
  EXPECT_NEAR(curve.at(0.7), 10 + 50 - 8, 1e-12);
}

TEST(stress_curve, of_a_rigid_foam_passes_through_its_points) {
  const auto law = sample_law<RigidFoam>();
  const StressCurve curve = law.curve();
  EXPECT_EQ(curve.at(1e-9), law.crush_stress);
  EXPECT_NEAR(curve.at(law.crush_strain), law.crush_stress, 1e-9);
  EXPECT_NEAR(curve.at(law.second_strain), law.second_stress, 1e-6);
  EXPECT_NEAR(curve.at(1), 10 * law.second_stress, 1e-6);
}

class CurveContacts : public testing::TestWithParam<double> {
 protected:
  static constexpr double thickness = 0.1;
  const double radius = GetParam();

  /// 2 pi times the integral of the stress over the contact, cut at the curve's kinks.
  [[nodiscard]] double force(const StressCurve& curve, double y) const {
    std::vector<double> cuts{0, std::min(y, radius)};
    for (const auto& kink : curve)
      cuts.push_back(std::clamp(y - kink.strain * thickness, 0.0, std::min(y, radius)));
    std::sort(cuts.begin(), cuts.end());
    double sum = 0;
    for (std::size_t i = 1; i < cuts.size(); ++i)
      if (cuts[i] > cuts[i - 1])
        sum += Quadrature::integrate([&](double s) { return curve.at((y - s) / thickness) * (radius - s); },
                                     cuts[i - 1], cuts[i]);
    return 2 * std::numbers::pi * sum;
  }

  template <class Law>
  void expect_integrals(const Law& law) const {
    const CurveContact contact(law.curve(), Law::recovers, thickness, Sphere{radius}.sections());
    double before = 0;
    double work = 0;
    for (int i = 1; i <= 100; ++i) {
      const double y = thickness * i / 100;
      expect_relative(contact.force(y), force(law.curve(), y), 1e-11, fmt::format("force at {}", y));
      work += Quadrature::integrate([&](double x) { return contact.force(x); }, before, y);
      expect_relative(contact.energy(y), work, 1e-8, fmt::format("work up to {}", y));
      before = y;
    }
    EXPECT_EQ(contact.force(0), 0);
    EXPECT_EQ(contact.energy(0), 0);
  }
};

TEST_P(CurveContacts, IntegrateTheStressOverTheContact) {
  expect_integrals(sample_law<Elastic>());
  expect_integrals(sample_law<RigidFoam>());
}

TEST_P(CurveContacts, TryAndAccept) {
  CurveContact contact(Elastic{3e5}.curve(), true, thickness, Sphere{radius}.sections());
  contact.start(0.1, thickness);
  EXPECT_EQ(contact.contact_radius(), 0);
  const PadTrial tried = contact.trial(0.04, 0, 1);
  EXPECT_EQ(contact.trial(0.01, 0, 1).force, contact.force(0.01)) << "a trial changes nothing";
  contact.accept(tried);
  EXPECT_EQ(contact.trial(0.01, 1, 1).force, contact.force(0.04 + 0.01));
  const double depth = std::min(0.04, radius);
  EXPECT_NEAR(contact.contact_radius(), std::sqrt(depth * (2 * radius - depth)), 1e-15);
  EXPECT_LT(contact.largest_stress(contact.trial(-0.05, 1, 1)), 0);
}

// Deeper than the sphere at 2 cm, half of it at 8 cm.
INSTANTIATE_TEST_SUITE_P(Radii, CurveContacts, testing::Values(0.02, 0.08, 1.0));

}  // namespace
}  // namespace dashpad::test
