/// What is uncertain of a foam as factors of a study: against the intervals of the same impact.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "dashpad/impact/solve.hpp"
#include "dashpad/study/run_study.hpp"
#include "dashpad/study/study_file.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "head_on_pillar.hpp"
#include "study/foam_factors.hpp"

namespace dashpad::test::foam_factors_test {
namespace {

using study::Factor;
using study::Study;
using testing::ElementsAre;
using testing::HasSubstr;

/// The head on a pillar with a card that states all that it can.
Study uncertain_study() {
  Study study;
  study.base = head_on_pillar();
  study.base.pad.material.uncertainty.scatter = 0.08;
  study.base.pad.material.uncertainty.misfit =
      Misfit{.peak_acceleration = 0.05, .hic = 0.1, .rebound_speed = 0.02, .penetration = 0.01, .impacts = 9};
  study.base.pad.material.uncertainty.posterior = {
      .keys = {"curve.plateau_stress"}, .minus = {{210e3}}, .plus = {{240e3}}};
  study.responses = {"peak_acceleration", "hic15", "peak_penetration", "rebound_speed"};
  return study;
}

Factor at(const std::string& key, std::vector<double> values) {
  return {.key = key, .unit = "1", .spread = study::Levels{std::move(values)}, .lowest = {}, .highest = {}};
}

std::vector<study::StoredRow> rows_of(const Study& study) {
  const study::Design design(study);
  return study::Worker(study, design).compute(0, design.rows());
}

FigureInterval interval_of(const Study& study, const char* key) {
  Solution solution = solve(study.base, study.options);
  uncertainty::add_intervals(study.base, study.options, solution);
  return *solution.summary.intervals->find(key);
}

std::vector<std::string> keys_of(const std::vector<study::FoamFactor>& factors) {
  std::vector<std::string> keys;
  for (const study::FoamFactor& factor : factors) keys.push_back(factor.key);
  return keys;
}

TEST(FoamFactors, AreWhatTheCardLeavesUncertain) {
  Study study = uncertain_study();
  EXPECT_THAT(keys_of(foam_factors(study)),
              ElementsAre("foam.continuation", "foam.rate", "foam.way_back", "foam.lag_strain",
                          "foam.scatter", "foam.posterior_1", "foam.misfit", "foam.neighbours"));
  study.base.pad.material.law = Elastic{.modulus = 3e5};
  study.base.pad.material.uncertainty = {};
  EXPECT_THAT(keys_of(foam_factors(study)), ElementsAre("foam.neighbours"));
}

/// The ends of a range are those of its interval.
TEST(FoamFactors, MoveAnImpactToTheEndsOfItsIntervals) {
  const std::vector<std::pair<const char*, Source>> ranges{{"foam.continuation", Source::continuation},
                                                           {"foam.rate", Source::rate}};
  for (const auto& [key, source] : ranges) {
    Study study = uncertain_study();
    study.factors = {
        at(key, source == Source::rate ? std::vector<double>{0, 1} : std::vector<double>{-1, 0, 1})};
    ASSERT_TRUE(violations(study).empty()) << key;
    const auto rows = rows_of(study);
    const FigureInterval figure = interval_of(study, "peak_acceleration");
    const auto part = std::ranges::find(figure.sources, source, &Contribution::source);
    ASSERT_NE(part, figure.sources.end()) << key;
    std::vector<double> peaks;
    for (const study::StoredRow& row : rows) peaks.push_back(row.outcome.values.at(0));
    EXPECT_NEAR(std::ranges::min(peaks) / part->low, 1, 2e-3) << key;
    EXPECT_NEAR(std::ranges::max(peaks) / part->high, 1, 2e-3) << key;
  }
}

/// A standard deviation of each statistical source is its interval over 1.96.
TEST(FoamFactors, CountStandardDeviations) {
  const std::vector<std::pair<const char*, Source>> sources{{"foam.scatter", Source::scatter},
                                                            {"foam.posterior_1", Source::posterior},
                                                            {"foam.misfit", Source::misfit},
                                                            {"foam.neighbours", Source::neighbours}};
  const char* const names[]{"peak_acceleration", "hic15", "peak_penetration"};  // the first responses
  for (const auto& [key, source] : sources)
    for (std::size_t response = 0; response < std::size(names); ++response) {
      const char* const name = names[response];
      Study study = uncertain_study();
      const double place = source == Source::posterior ? 1 : 1.959964;
      study.factors = {at(key, {-place, 0, place})};
      const auto rows = rows_of(study);
      const FigureInterval figure = interval_of(study, name);
      const auto part = std::ranges::find(figure.sources, source, &Contribution::source);
      ASSERT_NE(part, figure.sources.end()) << key << ", " << name;
      const auto value = [&](std::size_t row) { return rows[row].outcome.values.at(response); };
      const double low = std::min(value(0), value(2)), high = std::max(value(0), value(2));
      const double scale = source == Source::posterior ? 1.959964 : 1;
      EXPECT_NEAR(value(1) - scale * (value(1) - low), part->low, 2e-3 * figure.nominal) << key << name;
      EXPECT_NEAR(value(1) + scale * (high - value(1)), part->high, 2e-3 * figure.nominal) << key << name;
    }
}

/// At 0 the card is as it is, to the last bit; what is drawn comes back when the row is solved again.
TEST(FoamFactors, LeaveTheNominalImpactAndAreReplayed) {
  Study study = uncertain_study();
  draw_foam_uncertainty(study);
  study.samples = 16;
  for (Factor& factor : study.factors) {
    const bool is_range = factor.key == "foam.continuation" || factor.key == "foam.rate" ||
                          factor.key == "foam.way_back" || factor.key == "foam.lag_strain";
    EXPECT_EQ(std::holds_alternative<study::Uniform>(factor.spread), is_range) << factor.key;
    EXPECT_EQ(std::holds_alternative<study::Normal>(factor.spread), !is_range) << factor.key;
  }
  ASSERT_TRUE(violations(study).empty());
  const study::Design design(study);
  study::Worker worker(study, design), other(study, design);
  const auto rows = worker.compute(0, design.rows());
  EXPECT_NE(rows[3].outcome.values, rows[4].outcome.values);
  study::Outcome again;
  other.replay(3, again);
  EXPECT_EQ(again.values, rows[3].outcome.values);

  for (Factor& factor : study.factors) factor = at(factor.key, {0});
  study.samples = 1;
  const auto nominal = rows_of(study);
  EXPECT_EQ(nominal.at(0).outcome.values.at(0), *solve(study.base, study.options).summary.peak_acceleration);
}

/// Mean and deviation of a scatter that moves a peak almost in proportion.
TEST(FoamFactors, AreDrawnWithTheirDistributions) {
  Study study = uncertain_study();
  study.factors = {{.key = "foam.misfit", .unit = "1", .spread = study::Normal{0, 1}}};
  study.samples = 256;
  std::vector<double> peaks;
  for (const study::StoredRow& row : rows_of(study)) peaks.push_back(row.outcome.values.at(0));
  const double mean = std::reduce(peaks.begin(), peaks.end()) / 256;
  double squares = 0;
  for (const double peak : peaks) squares += (peak - mean) * (peak - mean);
  EXPECT_NEAR(mean / *solve(study.base, study.options).summary.peak_acceleration, 1, 1e-3);
  EXPECT_NEAR(std::sqrt(squares / 256) / mean, 0.05, 5e-4);
}

TEST(FoamFactors, ThatLeaveTheirRangeAreRefused) {
  Study study = uncertain_study();
  study.factors = {at("foam.continuation", {0, 1.5})};
  ASSERT_EQ(violations(study).size(), 1u);
  EXPECT_THAT(violations(study).front().rule, HasSubstr("between -1 and 1"));
  study.factors = {at("foam.neighbours", {-1000, 1e308})};
  ASSERT_EQ(violations(study).size(), 1u);
  EXPECT_THAT(violations(study).front().rule, HasSubstr("between -20 and 20 standard deviations"));
  study.factors = {at("foam.posterior_2", {0})};
  ASSERT_FALSE(violations(study).empty());
  EXPECT_THAT(violations(study).front().rule,
              testing::AllOf(HasSubstr("is not among what the cards leave uncertain"),
                             HasSubstr("foam.posterior_1")));
}

/// An error that would press the nose through the pad ends at its floor.
TEST(FoamFactors, GoNoDeeperThanThePad) {
  Study study = uncertain_study();
  study.responses = {"peak_penetration", "peak_strain", "hic15"};
  study.factors = {at("foam.misfit", {-20, 20})};
  const auto rows = rows_of(study);
  EXPECT_NEAR(rows.at(1).outcome.values.at(0), study.base.pad.thickness, 1e-12);
  EXPECT_NEAR(rows.at(1).outcome.values.at(1), 1, 1e-12);
  for (const double value : rows.at(0).outcome.values) EXPECT_GE(value, 0);
}

/// What a card states is kept with the study that draws it.
TEST(FoamFactors, AreStoredWithTheUncertaintyOfTheCard) {
  Study study = uncertain_study();
  const std::string without = resolved_text(study);
  EXPECT_EQ(without.find("uncertainty"), std::string::npos);
  draw_foam_uncertainty(study);
  EXPECT_NE(resolved_text(study).find("uncertainty"), std::string::npos);
}

}  // namespace
}  // namespace dashpad::test::foam_factors_test
