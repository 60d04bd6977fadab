/// The search for the nose radius, on residuals and on strains made with a known radius.

#include "dashpad/report1986/validation/trends.hpp"

#include <gtest/gtest.h>

#include <boost/math/distributions/fisher_f.hpp>
#include <cmath>

#include "dashpad/report1986/validation/verdict.hpp"
#include "sample_case.hpp"

namespace dashpad::report1986 {
namespace {

using Residuals = std::vector<std::optional<double>>;

RadiusCriterion found(const std::function<Residuals(double)>& residuals) {
  return radius_criterion("name", "remark", "1", residuals);
}

TEST(NoseRadius, ElevenRadii) {
  const auto radii = radii_of_the_study();
  ASSERT_EQ(radii.size(), 11U);
  EXPECT_EQ(radii.front(), min_radius_in);
  EXPECT_EQ(radii.back(), greatest_radius_in);
}

/// Sums of squares that are a parabola: the radius is found between the steps, and the borders are where the
/// F test has them, but for the straight lines between the steps.
TEST(NoseRadius, ParabolaIsFoundExactlyWithItsBorders) {
  const auto residuals = [](double radius) -> Residuals {
    return {0.1 * (radius - 2.63), 0.02, -0.02, 0.01};
  };
  const RadiusCriterion criterion = found(residuals);
  EXPECT_NEAR(criterion.favoured_in, 2.63, 1e-12);
  EXPECT_FALSE(criterion.at_an_end);
  EXPECT_EQ(criterion.readings, 4);
  EXPECT_NEAR(criterion.misfit[4], std::sqrt((0.013 * 0.013 + 0.0009) / 4), 1e-15);
  const double quantile = boost::math::quantile(boost::math::fisher_f(1, 3), 0.95);
  const double half_width = 10 * std::sqrt(0.0009 * quantile / 3);
  EXPECT_NEAR(criterion.admitted.low, 2.63 - half_width, 0.03);
  EXPECT_NEAR(criterion.admitted.high, 2.63 + half_width, 0.03);
}

TEST(NoseRadius, MorePreciseReadingsAdmitLess) {
  const auto width = [](double noise) {
    const RadiusCriterion criterion = found([&](double radius) -> Residuals {
      return {0.1 * (radius - 2.5) + noise, 0.1 * (radius - 2.5) - noise, 0.1 * (radius - 2.5)};
    });
    return criterion.admitted.high - criterion.admitted.low;
  };
  EXPECT_LT(width(0.001), 0.25);
  EXPECT_LT(width(0.001), width(0.01));
  EXPECT_EQ(width(1), greatest_radius_in - min_radius_in) << "nothing can be told";
}

TEST(NoseRadius, LeastMisfitAtAnEndIsABound) {
  const RadiusCriterion high = found([](double radius) -> Residuals { return {radius - 5, radius - 5.01}; });
  EXPECT_EQ(high.favoured_in, greatest_radius_in);
  EXPECT_TRUE(high.at_an_end);
  const RadiusCriterion low = found([](double radius) -> Residuals { return {radius - 1, radius - 1}; });
  EXPECT_EQ(low.favoured_in, min_radius_in);
  EXPECT_TRUE(low.at_an_end);
}

TEST(NoseRadius, MissingFiguresAreNoMisfit) {
  const RadiusCriterion criterion = found([](double radius) -> Residuals {
    return {radius < 2.2 ? std::nullopt : std::optional(radius - 3.0), 0.01};
  });
  EXPECT_TRUE(std::isnan(criterion.misfit[0]));
  EXPECT_NEAR(criterion.favoured_in, 3, 1e-12);
  EXPECT_NE(criterion.remark.find("no result at 3 of 11 radii"), std::string::npos) << criterion.remark;
  const RadiusCriterion bound = found([](double radius) -> Residuals {
    return {radius < 1.7 ? std::nullopt : std::optional(radius - 1.0), 0.01};
  });
  EXPECT_EQ(bound.favoured_in, 1.75);
  EXPECT_TRUE(bound.at_an_end) << "no smaller radius has a figure";
  EXPECT_FALSE(criterion.at_an_end);
  const RadiusCriterion none = found([](double) -> Residuals { return {std::nullopt}; });
  EXPECT_TRUE(std::isnan(none.favoured_in));
  EXPECT_EQ(none.admitted.low, min_radius_in);
  EXPECT_EQ(none.admitted.high, greatest_radius_in);
}

/// A bound is no estimate, and takes no part in the mean.
TEST(NoseRadius, RadiusOfTheReportIsTheMeanOfEstimates) {
  RadiusStudy study;
  study.radii_in = radii_of_the_study();
  study.criteria = {{.favoured_in = 4},
                    {.favoured_in = 1.5, .at_an_end = true, .of_the_report = true},
                    {.favoured_in = 2.1, .of_the_report = true},
                    {.favoured_in = 2.5, .of_the_report = true}};
  EXPECT_EQ(study.of_the_report_in(), 2.25);
  study.criteria.resize(2);
  EXPECT_EQ(study.of_the_report_in(), 4);
}

/// Three tests on the plate whose strains were computed with 2.6 in.
TEST(NoseRadius, RadiusOfComputedStrainsIsFound) {
  std::vector<input::Fault> faults;
  ValidationData data = read_validation_data(test::source / "data/validation", faults);
  ASSERT_TRUE(faults.empty());
  const Material ensolite = input::read_material(test::materials / "ensolite-aac-9.toml").value();
  constexpr double truth = 2.6;
  for (MeasuredTest& test : data.measured.tests) {
    if (test.support != TestSupport::plate) continue;
    const double noise = test.number == 25 ? 0.001 : -0.0005;
    test.plug_strain = noise + *predict(data, ensolite, Program::accurate,
                                        {test.projectile, test.support, test.speed_mph, truth})
                                    .peak_strain;
  }
  std::vector<report1986::Setup> setups;
  for (const double radius : radii_of_the_study())
    for (const report1986::Setup& setup : setups_of_tests(data.measured, radius))
      if (setup.support == TestSupport::plate) setups.push_back(setup);
  const RadiusStudy study = study_radius(data, predict_all(data, ensolite, {Program::accurate}, setups), {});
  EXPECT_EQ(study.criteria.front().name, "strains on the plate");
  EXPECT_NEAR(study.favoured_in(), truth, 0.1);
  EXPECT_TRUE(study.criteria.front().admitted.holds(truth));
  EXPECT_LT(study.criteria.front().admitted.high - study.criteria.front().admitted.low, 1);
  EXPECT_FALSE(study.criteria.front().at_an_end);
}

}  // namespace
}  // namespace dashpad::report1986
