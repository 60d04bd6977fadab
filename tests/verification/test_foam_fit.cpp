/// The foam of the tests comes back from readings that were computed with it.

#include <gtest/gtest.h>

#include "dashpad/report1986/validation/study.hpp"

namespace dashpad::report1986 {
namespace {

/// The readings do not tell all four numbers apart, and the weak priors decide there: what comes back are the
/// readings, and the truth as far as the priors let it.
TEST(FoamFit, FindsTheFoamThatMadeTheReadings) {
  std::vector<input::Fault> faults;
  const ValidationData data = read_validation_data(DASHPAD_SOURCE_DIR "/data/validation", faults);
  ASSERT_TRUE(faults.empty());
  const FittedFoam truth{.plateau_stress_psi = 30,
                         .densification_stress_psi = 15,
                         .densification_exponent = 1.6,
                         .unloading_shape = 12};
  std::vector<Reading> readings;
  int test = 0;
  for (const TestSupport support : {TestSupport::load_cell, TestSupport::plate})
    for (const double speed : {11., 14., 17., 20.}) {
      const report1986::Setup setup{Projectile::aluminium, support, speed, held_out_radius_in};
      const Prediction prediction = predict(data, material_of(truth), Program::accurate, setup);
      ++test;
      for (const Quantity quantity : quantities)
        readings.push_back({test, setup, quantity, *predicted(prediction, quantity)});
    }
  const FittedFoam found = fit_foam(data, readings);
  ASSERT_TRUE(found.converged) << found.why_not;
  // The truth has no misfit but that of the priors: ln(30/16), ln(15/10)/1.2, 0.4/0.6, ln(12/8)/1.5, squared.
  EXPECT_LT(found.misfit, 1.03);
  for (const Reading& reading : readings) {
    const Prediction prediction = predict(data, material_of(found), Program::accurate, reading.setup);
    const double value = *predicted(prediction, reading.quantity);
    if (reading.quantity == Quantity::peak_strain)
      EXPECT_NEAR(value, reading.value, 0.01);
    else
      EXPECT_NEAR(value, reading.value, 0.03 * reading.value) << to_string(reading.quantity);
  }
  EXPECT_NEAR(found.plateau_stress_psi, truth.plateau_stress_psi, 0.1 * truth.plateau_stress_psi);
  EXPECT_NEAR(found.densification_exponent, truth.densification_exponent, 0.2);
  EXPECT_NEAR(found.unloading_shape, truth.unloading_shape, 0.1 * truth.unloading_shape);
}

}  // namespace
}  // namespace dashpad::report1986
