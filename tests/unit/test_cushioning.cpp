/// Energy, hysteresis and efficiency of a material test.

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>

#include "dashpad/laboratory/material_test.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using laboratory::constant_rate_test;
using laboratory::cushion_figures;
using laboratory::CushionFigures;
using laboratory::drive;

TEST(Cushioning, OfAnElasticPadIsHalf) {
  for (const laboratory::StrainHistory& history :
       {constant_rate_test(50, 0.8), laboratory::parabolic_test(50, 0.8)}) {
    const laboratory::ColumnTest test = drive(Elastic{3e5}, history);
    const CushionFigures figures = cushion_figures(test);
    EXPECT_NEAR(figures.energy_in, 1.5e5 * 0.64, 1e-6);
    EXPECT_NEAR(figures.energy_returned, figures.energy_in, 1e-6);
    EXPECT_NEAR(figures.hysteresis, 0, 1e-11);
    EXPECT_NEAR(figures.peak_stress, 2.4e5, 1e-9);
    EXPECT_NEAR(figures.strain_at_peak, 0.8, 1e-15);
    EXPECT_NEAR(figures.best_efficiency.efficiency, 0.4, 1e-12) << "W/S = e/2, best at the end";
    EXPECT_NEAR(figures.best_efficiency.ideality, 0.5, 1e-12);
    const laboratory::CushionCurve curve = laboratory::cushion_curve(test);
    for (std::size_t i = 0; i < curve.strain.size(); ++i) {
      EXPECT_NEAR(curve.efficiency[i], curve.strain[i] / 2, 1e-11);
      EXPECT_NEAR(curve.ideality[i], 0.5, 1e-10);
    }
  }
}

TEST(Cushioning, OfAPlateauIsIdeal) {
  const RigidFoam foam{2e5, 0.8, 4e5, 0.9};
  const laboratory::ColumnTest test = drive(foam, constant_rate_test(50, 0.7));
  const CushionFigures figures = cushion_figures(test);
  EXPECT_NEAR(figures.energy_in, 2e5 * 0.7, 1e-6);
  EXPECT_EQ(figures.energy_returned, 0);
  EXPECT_EQ(figures.hysteresis, 1);
  EXPECT_EQ(figures.strain_at_peak, 0) << "where the plateau begins";
  EXPECT_EQ(figures.best_efficiency.strain, test.largest_strain);
  const laboratory::CushionCurve curve = laboratory::cushion_curve(test);
  ASSERT_EQ(curve.strain.size(), 200u);
  for (std::size_t i = 0; i < curve.strain.size(); ++i) {
    EXPECT_NEAR(curve.efficiency[i], curve.strain[i], 1e-12);
    EXPECT_NEAR(curve.ideality[i], 1, 1e-12);
    EXPECT_EQ(curve.stress[i], 2e5);
  }
}

/// Past the plateau the foam gets worse: the best place is where bottoming begins.
TEST(Cushioning, IsBestWhereBottomingBegins) {
  const RigidFoam foam{2e5, 0.6, 1e6, 0.7};
  const CushionFigures figures = cushion_figures(drive(foam, constant_rate_test(50, 0.75), 750));
  EXPECT_NEAR(figures.best_efficiency.strain, 0.6, 1e-9);
  EXPECT_NEAR(figures.best_efficiency.stress, 2e5, 1e-3);
  EXPECT_NEAR(figures.best_efficiency.efficiency, 0.6, 1e-9);
}

/// A linear solid on a parabola relaxes while the strain still creeps up to its peak.
TEST(Cushioning, SaysWhereThePeakStressIs) {
  const laboratory::ColumnTest test =
      drive(LinearViscoelastic{1e5, 1e6, 0.01}, laboratory::parabolic_test(1, 0.8));
  const CushionFigures figures = cushion_figures(test);
  EXPECT_LT(figures.strain_at_peak, test.largest_strain - 1e-3);
  for (const double stress : test.stress) EXPECT_LE(stress, figures.peak_stress);
}

/// Peak stress and best efficiency lie between places; more places do not move them.
TEST(Cushioning, FiguresDoNotDependOnThePlaces) {
  const NineParameter foam{5e4, 0.675, 1.09, 8.81e-3, 4e4, 0.166, 9.76e-6, 0.0987};
  const CushionFigures few = cushion_figures(drive(foam, laboratory::parabolic_test(100, 0.95), 300));
  const CushionFigures many = cushion_figures(drive(foam, laboratory::parabolic_test(100, 0.95), 3000));
  EXPECT_NEAR(few.peak_stress, many.peak_stress, 5e-5 * many.peak_stress);
  EXPECT_NEAR(few.strain_at_peak, many.strain_at_peak, 2e-5);
  EXPECT_NEAR(few.best_efficiency.efficiency, many.best_efficiency.efficiency, 1e-5);
  EXPECT_NEAR(few.best_efficiency.stress, many.best_efficiency.stress, 1e-4 * many.best_efficiency.stress);
}

TEST(Cushioning, CountsEveryCycleButOneLoading) {
  const laboratory::ColumnTest test = drive(Elastic{3e5}, laboratory::cyclic_test(10, 0.6, 0.2, 3));
  const CushionFigures figures = cushion_figures(test);
  const double once = 1.5e5 * (0.36 - 0.04);
  EXPECT_NEAR(figures.energy_in, 1.5e5 * 0.36 + 2 * once, 1e-6);
  EXPECT_NEAR(figures.energy_returned, 3 * once, 1e-6);
  EXPECT_EQ(laboratory::cushion_curve(test).strain.size(), 200u);
}

TEST(Cushioning, LeavesOutAHoldAndCountsCreep) {
  const laboratory::CushionCurve held =
      laboratory::cushion_curve(drive(Elastic{3e5}, laboratory::ramp_and_hold_test(10, 0.6, 1)));
  EXPECT_EQ(held.strain.size(), 200u);
  const LinearViscoelastic solid{140e3, 420e3, 5e-3};
  const auto crept = laboratory::creep(solid, {5e4, 100, 0.1});
  ASSERT_TRUE(crept);
  const CushionFigures figures = cushion_figures(*crept);
  const double first = crept->strain[200];
  EXPECT_NEAR(figures.energy_in, crept->work[200] + 5e4 * (crept->strain.back() - first), 1e-6);
  EXPECT_EQ(figures.energy_returned, 0);
}

/// The energy of a law with memory, by a trapezium rule so fine that it serves as reference.
template <class Law>
void expect_energies() {
  const auto law = sample_law<Law>();
  for (const double rate : {1.0, 100.0})
    for (const laboratory::StrainHistory& history :
         {constant_rate_test(rate, 0.9), laboratory::parabolic_test(rate, 0.9)}) {
      const CushionFigures figures = cushion_figures(drive(law, history));
      const laboratory::ColumnTest fine = drive(law, history, 20000);
      double in = 0, returned = 0;
      for (std::size_t i = 1; i < fine.size(); ++i) {
        const double work = (fine.stress[i] + fine.stress[i - 1]) / 2 * (fine.strain[i] - fine.strain[i - 1]);
        (work > 0 ? in : returned) += std::abs(work);
      }
      expect_relative(figures.energy_in, in, 2e-7, "energy in");
      expect_relative(figures.energy_returned, returned, 5e-7, "energy returned");
      EXPECT_LT(figures.energy_error, 1e-8);
      // The same from two places only: the places do not matter.
      const CushionFigures two = cushion_figures(drive(law, history, 2));
      EXPECT_LE(std::abs(two.energy_in - figures.energy_in),
                (two.energy_error + figures.energy_error) * figures.energy_in);
      EXPECT_LE(std::abs(two.energy_returned - figures.energy_returned),
                (two.energy_error + figures.energy_error) * figures.energy_in);
    }
}
TEST(Cushioning, HasTheEnergiesOfTheNineParameterLaw) { expect_energies<NineParameter>(); }
TEST(Cushioning, HasTheEnergiesOfTheLinearSolid) { expect_energies<LinearViscoelastic>(); }

TEST(Cushioning, HasTheEnergiesOfTheTwentyOneParameterLaw) {
  const auto law = sample_law<TwentyOneParameter>();
  const laboratory::ColumnTest fine = drive(law, constant_rate_test(100, 0.9), 20000);
  double in = 0;
  for (std::size_t i = 1; i <= 20000; ++i)
    in += (fine.stress[i] + fine.stress[i - 1]) / 2 * (fine.strain[i] - fine.strain[i - 1]);
  const CushionFigures figures = cushion_figures(drive(law, constant_rate_test(100, 0.9)));
  expect_relative(figures.energy_in, in, 2e-7, "energy in");
}

TEST(StressLimit, IsFoundBetweenThePlaces) {
  const laboratory::CushionCurve curve =
      laboratory::cushion_curve(drive(Elastic{3e5}, constant_rate_test(50, 0.8), 7));
  for (const double limit : {1e-3, 1e3, 5e4, 1e5, 2.399e5}) {
    const auto point = laboratory::at_stress_limit(curve, limit);
    ASSERT_TRUE(point) << limit;
    expect_relative(point->strain, limit / 3e5, 1e-10, "strain");
    expect_relative(point->energy, limit * limit / 6e5, 1e-9, "energy");
    expect_relative(point->efficiency, point->strain / 2, 1e-9, "efficiency");
    EXPECT_NEAR(point->ideality, 0.5, 1e-9);
    EXPECT_EQ(point->stress, limit);
  }
  EXPECT_FALSE(laboratory::at_stress_limit(curve, 2.41e5));
  EXPECT_FALSE(laboratory::at_stress_limit({}, 1));
  EXPECT_THROW((void)laboratory::at_stress_limit(curve, 0), std::invalid_argument);
}

/// Against the exact strain, where G = limit: at one rate, the stress of law 4 is its envelope.
TEST(StressLimit, IsAccurateOnAFoam) {
  const auto law = sample_law<NineParameter>();
  const laboratory::CushionCurve curve = laboratory::cushion_curve(drive(law, constant_rate_test(100, 0.95)));
  const double B = law.asymptotic_modulus + law.rate_modulus * std::pow(100, 0.166);
  for (const double strain : {0.0012, 0.0123, 0.1234, 0.5678, 0.9123, 0.9481}) {
    const double limit = B * std::pow(strain, 0.675) / std::pow(1 - strain, 1.09);
    const auto point = laboratory::at_stress_limit(curve, limit);
    ASSERT_TRUE(point);
    EXPECT_NEAR(point->strain, strain, strain < 0.004 ? 2e-5 : 1e-6);
    const CushionFigures until = cushion_figures(drive(law, constant_rate_test(100, strain)));
    expect_relative(point->energy, until.energy_in, strain < 0.004 ? 1e-2 : 1e-5, "energy");
  }
}

TEST(StressLimit, BelowTheCrushStressIsMetAtStrainZero) {
  const laboratory::CushionCurve curve =
      laboratory::cushion_curve(drive(sample_law<RigidFoam>(), constant_rate_test(50, 0.5)));
  const auto point = laboratory::at_stress_limit(curve, 1e5);
  ASSERT_TRUE(point);
  EXPECT_EQ(point->strain, 0);
  EXPECT_EQ(point->energy, 0);
}

}  // namespace
}  // namespace dashpad::test
