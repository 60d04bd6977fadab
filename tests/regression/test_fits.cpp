/// The example of a fit finds what it found before: our own earlier output, to notice changes.

#include <gtest/gtest.h>

#include "dashpad/fit/fit.hpp"
#include "dashpad/fit/report.hpp"

namespace dashpad::fit {
namespace {

TEST(FitRegression, TheExampleFindsWhatItFoundBefore) {
  const FitReport report = run_fit(
      read_fit(DASHPAD_SOURCE_DIR "/examples/fits/vn600.toml", DASHPAD_SOURCE_DIR "/materials").value().fit);
  ASSERT_TRUE(report.converged) << report.why_not;
  EXPECT_EQ(report.starts_at_best, 8);
  // Four digits, as it prints them; searches end within far less.
  const double before[]{20.84e3, 1036e3, 177.6e3, 1.431, 0.3251};
  ASSERT_EQ(report.unknowns.size(), 5U);
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(report.unknowns[i].value, before[i], 1e-3 * before[i]) << report.unknowns[i].key;
  EXPECT_NEAR(*report.unknowns[0].low, 15.31e3, 0.01 * 15.31e3);
  EXPECT_NEAR(*report.unknowns[0].high, 29.23e3, 0.01 * 29.23e3);
  EXPECT_EQ(report.unknowns[1].open(), "above");
  EXPECT_NEAR(*report.tests[0].rms_loading, 2.01e3, 20);
  EXPECT_NEAR(*report.tests[0].rms_unloading, 3.14e3, 30);
}

}  // namespace
}  // namespace dashpad::fit
