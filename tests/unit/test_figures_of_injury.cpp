/// The injury figures of a solved impact, and their errors.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/input/case_file.hpp"
#include "shared/samples.hpp"

namespace dashpad::test {
namespace {

using injury::injury_figures;

Solution solved(double tolerance) {
  const ImpactCase impact =
      input::read_case(source_folder / "examples/dashboard-20mph.toml", source_folder / "materials")
          .value()
          .impact;
  Options options;
  options.tolerance = tolerance;
  return solve(impact, options);
}

struct Named {
  const char* name;
  double value, error, reference;
};

/// Against the figures of a run 1,000 times as accurate.
TEST(InjuryFigures, OfASolvedImpactAreWithinTheirErrors) {
  const injury::InjuryFigures exact = injury_figures(solved(1e-6));
  for (const double tolerance : {1e-3, 1e-4}) {
    const injury::InjuryFigures now = injury_figures(solved(tolerance));
    for (const Named& figure :
         {Named{"peak", now.peak.magnitude, now.errors.peak, exact.peak.magnitude},
          Named{"HIC15", now.hic15.value, now.errors.hic15, exact.hic15.value},
          Named{"HIC36", now.hic36.value, now.errors.hic36, exact.hic36.value},
          Named{"HIC", now.hic_unlimited.value, now.errors.hic_unlimited, exact.hic_unlimited.value},
          Named{"HIC(d)", now.hic_d, now.errors.hic_d, exact.hic_d},
          Named{"clip", now.clip_3ms.level, now.errors.clip_3ms, exact.clip_3ms.level},
          Named{"cumulative", now.cumulative_3ms.level, now.errors.cumulative_3ms,
                exact.cumulative_3ms.level},
          Named{"SI", now.severity_index, now.errors.severity_index, exact.severity_index},
          Named{"velocity", now.velocity_change, now.errors.velocity_change, exact.velocity_change}}) {
      EXPECT_LE(std::abs(figure.value / figure.reference - 1), figure.error)
          << figure.name << ' ' << tolerance;
      EXPECT_LT(figure.error, 20 * tolerance) << figure.name;
    }
  }
}

TEST(InjuryFigures, TheVelocityChangeIsThatOfTheImpactor) {
  const Solution solution = solved(1e-5);
  const double change = *solution.summary.rebound_speed + solution.history.velocity.front();
  EXPECT_NEAR(injury_figures(solution).velocity_change / change, 1, 1e-4);
}

/// One run alone leaves nothing to compare with.
TEST(InjuryFigures, OfOneRunHaveUnknownErrors) {
  Solution solution;
  solution.history.time = {0, 0.005, 0.01};
  solution.history.acceleration = {0, -980.665, 0};
  solution.summary.errors.peak_force = 1e-3;
  const injury::InjuryFigures::Errors few = injury_figures(solution).errors;
  EXPECT_EQ(few.peak, 1e-3);
  for (const double error : {few.hic15, few.hic36, few.hic_unlimited, few.hic_d, few.clip_3ms,
                             few.cumulative_3ms, few.severity_index, few.velocity_change})
    EXPECT_EQ(error, std::numeric_limits<double>::infinity());
  solution.coarser = {{0, 0.0025, 0.01}, {0, -490.3325, 0}};
  EXPECT_TRUE(std::isfinite(injury_figures(solution).errors.hic15));
}

TEST(InjuryFigures, OfAPulseHaveNoErrors) {
  const Pulse pulse{{0, 0.01, 0.02}, {0, 980.665, 0}};
  const injury::InjuryFigures figures = injury_figures(pulse);
  EXPECT_EQ(figures.errors.hic36, 0);
  EXPECT_NEAR(figures.hic36.value, 2 * 246.4007, 1e-3);
  EXPECT_EQ(figures.peak.magnitude, 980.665);
}

TEST(InjuryFigures, OfNoPulseAreRefused) {
  EXPECT_THROW(injury_figures(Pulse{{0}, {1}}), std::invalid_argument);
  EXPECT_THROW(injury_figures(Pulse{{0, 1}, {1}}), std::invalid_argument);
  EXPECT_THROW(injury_figures(Pulse{{0, 0}, {1, 1}}), std::invalid_argument);
  EXPECT_THROW(injury_figures(Pulse{{0, 1}, {1, std::nan("")}}), std::invalid_argument);
}

}  // namespace
}  // namespace dashpad::test
