/// Fits to tests of real foams, against what those tests say beside the points that were fitted.

#include <gtest/gtest.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"

namespace dashpad::fit {
namespace {

/// Vinyl nitrile foam VN600 (examples/fits/vn600-quasi-static.csv names the experiment). The way up alone is
/// fitted up to a strain of 0.45; the rest of the way up is predicted. The formula has no knee there, so that
/// it must come within a tenth.
TEST(FitValidation, PredictsTheRestOfTheWayUp) {
  Fit fit =
      read_fit(DASHPAD_SOURCE_DIR "/examples/fits/vn600.toml", DASHPAD_SOURCE_DIR "/materials").value().fit;
  std::erase_if(fit.unknowns,
                [](const Unknown& unknown) { return unknown.key == "pad.parameters.unloading_shape"; });
  MaterialMeasurement& lower = fit.tests.front();
  std::size_t top = 0;
  while (top + 1 < lower.strain.size() && lower.strain[top + 1] >= lower.strain[top]) ++top;
  for (auto* values : {&lower.time, &lower.strain, &lower.stress}) values->resize(top + 1);
  MaterialMeasurement upper = lower;
  lower.highest_strain = 0.45;
  upper.lowest_strain = 0.45;
  upper.is_held_out = true;
  fit.tests.push_back(upper);
  const FitReport report = run_fit(fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  ASSERT_TRUE(report.tests[1].is_held_out);
  EXPECT_LT(*report.tests[0].rms_loading, 0.02 * report.tests[0].largest_stress);
  EXPECT_LT(*report.tests[1].rms_loading, 0.1 * report.tests[1].largest_stress);
}

/// The energy that comes back is no residual of the fit: it follows from both ways.
TEST(FitValidation, GivesBackTheEnergyOfTheLoop) {
  const FitReport report = run_fit(
      read_fit(DASHPAD_SOURCE_DIR "/examples/fits/vn600.toml", DASHPAD_SOURCE_DIR "/materials").value().fit);
  ASSERT_EQ(report.tests.at(0).loops.size(), 1U);
  EXPECT_NEAR(report.tests[0].loops[0].computed_return, report.tests[0].loops[0].measured_return, 0.02);
}

}  // namespace
}  // namespace dashpad::fit
