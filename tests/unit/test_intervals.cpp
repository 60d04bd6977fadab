/// How sure figures are: each source against impacts that are solved by hand, and the rule that adds them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "dashpad/impact/flags.hpp"
#include "dashpad/impact/solve.hpp"
#include "dashpad/injury/figures.hpp"
#include "dashpad/quantities/constants.hpp"
#include "dashpad/quantities/unit_system.hpp"
#include "dashpad/uncertainty/intervals.hpp"
#include "head_on_pillar.hpp"
#include "output/result_rows.hpp"

namespace dashpad::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::StartsWith;

Solution with_intervals(const ImpactCase& impact) {
  Solution solution = solve(impact, {});
  uncertainty::add_intervals(impact, {}, solution);
  return solution;
}

const FigureInterval& interval(const Solution& solution, const char* key) {
  return *solution.summary.intervals->find(key);
}

const Contribution* part(const FigureInterval& figure_interval, Source source) {
  const auto found = std::ranges::find(figure_interval.sources, source, &Contribution::source);
  return found == figure_interval.sources.end() ? nullptr : &*found;
}

double hic15(const ImpactCase& impact) { return injury::whole_pulse_figures(solve(impact, {}))->hic15.value; }

Foam& foam_of(ImpactCase& impact) { return std::get<Foam>(impact.pad.material.law); }

TEST(Intervals, HoldTheNominalAndAddUp) {
  const Solution solution = with_intervals(head_on_pillar());
  EXPECT_LE(solution.summary.intervals->impacts, uncertainty::max_impacts);
  for (const FigureInterval& figure_interval : solution.summary.intervals->figures) {
    double down = 0, up = 0, variance_down = 0, variance_up = 0;
    for (const Contribution& each : figure_interval.sources) {
      EXPECT_LE(each.low, figure_interval.nominal) << figure_interval.key;
      EXPECT_GE(each.high, figure_interval.nominal) << figure_interval.key;
      const bool is_range = each.source == Source::continuation || each.source == Source::rate ||
                            each.source == Source::way_back;
      (is_range ? down : variance_down) +=
          is_range ? figure_interval.nominal - each.low : std::pow(figure_interval.nominal - each.low, 2);
      (is_range ? up : variance_up) +=
          is_range ? each.high - figure_interval.nominal : std::pow(each.high - figure_interval.nominal, 2);
    }
    EXPECT_NEAR(figure_interval.low, std::max(figure_interval.nominal - down - std::sqrt(variance_down), 0.0),
                1e-9 * figure_interval.nominal)
        << figure_interval.key;
    EXPECT_NEAR(figure_interval.high, figure_interval.nominal + up + std::sqrt(variance_up),
                1e-9 * figure_interval.nominal)
        << figure_interval.key;
  }
}

TEST(Intervals, StayWithinWhatIsPossible) {
  // A misfit that moves every figure beyond what it can be.
  ImpactCase impact = head_on_pillar();
  impact.pad.material.uncertainty.misfit =
      Misfit{.peak_acceleration = 1, .hic = 1, .rebound_speed = 1, .penetration = 0.2, .impacts = 4};
  const Solution solution = with_intervals(impact);
  const double speed = impact.impactor.speed;
  const std::pair<const char*, double> most[]{{"peak_strain", 1},
                                              {"peak_penetration", impact.pad.thickness},
                                              {"restitution", 1},
                                              {"rebound_speed", speed},
                                              {"rebound_height", speed * speed / (2 * standard_gravity)}};
  for (const auto& [key, value] : most) {
    EXPECT_LE(interval(solution, key).high, value) << key;
    EXPECT_GE(interval(solution, key).low, 0) << key;
    for (const Contribution& each : interval(solution, key).sources) EXPECT_LE(each.high, value) << key;
  }
  EXPECT_DOUBLE_EQ(interval(solution, "peak_strain").high, 1);
  EXPECT_DOUBLE_EQ(interval(solution, "peak_penetration").high, impact.pad.thickness);
  EXPECT_DOUBLE_EQ(interval(solution, "rebound_speed").low, 0);
  EXPECT_DOUBLE_EQ(interval(solution, "hic_d").low, 166.4);
  const UnitSystem& units = plain_si();
  EXPECT_THAT(output::interval_words(interval(solution, "peak_strain"), units), EndsWith(" or more"));
  EXPECT_THAT(output::interval_words(interval(solution, "peak_acceleration"), units), StartsWith("at most "));
  EXPECT_THAT(output::interval_words(interval(solution, "peak_penetration"), units), HasSubstr(" to "));
}

TEST(Intervals, AnEndThatIsNoInformationIsLeftOutOfWords) {
  const auto words = [](const char* key, double low, double high) {
    return output::interval_words({.key = key, .nominal = low, .low = low, .high = high}, plain_si());
  };
  EXPECT_EQ(words("rebound_speed", 0.5, 1.25), "0.5 to 1.25 m/s");
  EXPECT_EQ(words("rebound_speed", 0, 1.25), "at most 1.25 m/s");
  EXPECT_EQ(words("peak_force", 1500, infinite), "1500 N or more");
  EXPECT_EQ(words("peak_force", 0, infinite), "unbounded");
  EXPECT_EQ(words("peak_strain", 0.94, 1), "0.94 or more");
  EXPECT_EQ(words("peak_strain", 0.94, 0.99), "0.94 to 0.99");
  EXPECT_EQ(words("hic_d", 166.4, 900), "at most 900");
}

/// Against impacts at the two ends of the exponent, solved one by one.
TEST(Intervals, ContinuationIsTheHullOfItsEnds) {
  ImpactCase impact = head_on_pillar();
  const Solution solution = with_intervals(impact);
  const Contribution* const of = part(interval(solution, "hic15"), Source::continuation);
  ASSERT_NE(of, nullptr);
  const double nominal = hic15(impact);
  foam_of(impact).continuation_exponent = 1;
  const double gentle = hic15(impact);
  foam_of(impact).continuation_exponent = 4;
  const double steep = hic15(impact);
  EXPECT_NEAR(of->low, std::min({gentle, steep, nominal}), 2e-3 * nominal);
  EXPECT_NEAR(of->high, std::max({gentle, steep, nominal}), 2e-3 * nominal);
}

/// A card whose formula goes on to 0.95 though the tests ended at 0.6 is no surer for it.
TEST(Intervals, ContinuationBeginsWhereTheTestsEnd) {
  ImpactCase impact = head_on_pillar();
  std::get<AvalleCurve>(foam_of(impact).curves.base).highest_strain = 0.95;
  EXPECT_EQ(part(interval(with_intervals(impact), "peak_acceleration"), Source::continuation), nullptr);
  impact.pad.material.fitted = FittedRange{0.6, 0.01, 100};
  EXPECT_NE(part(interval(with_intervals(impact), "peak_acceleration"), Source::continuation), nullptr);
}

/// HIC(d) over the foam's stiffness has its least value inside: neither end nor the nominal shows it.
TEST(Intervals, ARangeInWhichAFigureTurnsGivesItsLeastValue) {
  ImpactCase impact = head_on_pillar();
  // A foam tested slowly alone, whose stress may grow by a factor of three with the rate.
  foam_of(impact).curves.rate_effect = NoRateEffect{};
  impact.pad.material.uncertainty.rate_exponent = ValueRange{0, 0.1};
  const Solution solution = with_intervals(impact);
  const Contribution* const of = part(interval(solution, "hic_d"), Source::rate);
  ASSERT_NE(of, nullptr);
  double least = 1e300, most = 0;
  for (int i = 0; i <= 20; ++i) {
    ImpactCase other = impact;
    if (i > 0)
      foam_of(other).curves.rate_effect = PowerRateEffect{
          .exponent = 0.005 * i, .exponent_slope = 0, .highest_rate = solution.summary.peak_strain_rate};
    const double value = injury::whole_pulse_figures(solve(other, {}))->hic_d;
    least = std::min(least, value);
    most = std::max(most, value);
  }
  const double nominal = interval(solution, "hic_d").nominal;
  EXPECT_NEAR(of->low, least, 6e-3 * nominal);
  EXPECT_NEAR(of->high, most, 6e-3 * nominal);
}

TEST(Intervals, AFoamTestedFarEnoughHasNoContinuationAndNoRate) {
  ImpactCase impact = head_on_pillar();
  std::get<AvalleCurve>(foam_of(impact).curves.base).highest_strain = 0.95;
  std::get<PowerRateEffect>(foam_of(impact).curves.rate_effect).highest_rate = 1000;
  const Solution solution = with_intervals(impact);
  EXPECT_EQ(part(interval(solution, "hic15"), Source::continuation), nullptr);
  EXPECT_EQ(part(interval(solution, "hic15"), Source::rate), nullptr);
  EXPECT_NE(part(interval(solution, "hic15"), Source::way_back), nullptr);
}

TEST(Intervals, WhatACardStatesOfTheWayBackIsTaken) {
  ImpactCase impact = head_on_pillar();
  impact.pad.material.uncertainty.recoil = ValueRange{1, 1};
  impact.pad.material.uncertainty.lag_strain = ValueRange{0.005, 0.005};
  EXPECT_EQ(part(interval(with_intervals(impact), "rebound_speed"), Source::way_back), nullptr);
  impact.pad.material.uncertainty.recoil.reset();
  const Solution open = with_intervals(impact);
  const Contribution* const of = part(interval(open, "rebound_speed"), Source::way_back);
  ASSERT_NE(of, nullptr);
  foam_of(impact).recoil = 0;
  EXPECT_NEAR(of->high, *solve(impact, {}).summary.rebound_speed, 0.01 * of->high);
}

TEST(Intervals, StatisticsAreTakenAt95PerCent) {
  ImpactCase impact = head_on_pillar();
  impact.pad.material.uncertainty.misfit =
      Misfit{.peak_acceleration = 0.03, .hic = 0.05, .rebound_speed = 0.1, .penetration = 0.02, .impacts = 3};
  impact.pad.material.uncertainty.scatter = 0.02;
  const Solution solution = with_intervals(impact);
  const FigureInterval& hic = interval(solution, "hic15");
  EXPECT_NEAR(part(hic, Source::misfit)->high, (1 + 1.96 * 0.05) * hic.nominal, 1e-4 * hic.nominal);
  impact.pad.condition.scale = 1 - 1.96 * 0.02;
  const double softer = hic15(impact);
  impact.pad.condition.scale = 1 + 1.96 * 0.02;
  const double stiffer = hic15(impact);
  EXPECT_NEAR(part(hic, Source::scatter)->high, std::max({softer, stiffer, hic.nominal}), 2e-3 * hic.nominal);
  EXPECT_NEAR(part(hic, Source::scatter)->low, std::min({softer, stiffer, hic.nominal}), 2e-3 * hic.nominal);
}

TEST(Intervals, ThePosteriorIsItsAxesInQuadrature) {
  ImpactCase impact = head_on_pillar();
  impact.pad.material.uncertainty.posterior = {.keys = {"curve.plateau_stress", "curve.densification_stress"},
                                               .minus = {{212e3, 108e3}, {222e3, 100e3}},
                                               .plus = {{232e3, 108e3}, {222e3, 116e3}}};
  const Solution solution = with_intervals(impact);
  const FigureInterval& hic = interval(solution, "hic15");
  double up = 0;
  for (int axis = 0; axis < 2; ++axis) {
    double most = 0;
    for (const double sign : {-1.0, 1.0}) {
      ImpactCase other = impact;
      AvalleCurve& curve = std::get<AvalleCurve>(foam_of(other).curves.base);
      (axis == 0 ? curve.plateau_stress : curve.densification_stress) += sign * (axis == 0 ? 10e3 : 8e3);
      most = std::max(most, hic15(other) - hic.nominal);
    }
    up = std::hypot(up, 1.96 * most);
  }
  EXPECT_NEAR(part(hic, Source::posterior)->high, hic.nominal + up, 4e-3 * hic.nominal);
}

TEST(Intervals, WhatHasNoIntervalSaysWhy) {
  const auto reasons = [](const ImpactCase& impact) {
    std::string all;
    const Solution solution = with_intervals(impact);
    for (const OpenSource& open_source : solution.summary.intervals->sources)
      if (!open_source.why_not.empty()) all += open_source.words + ": " + open_source.why_not + "\n";
    return all;
  };
  ImpactCase impact = head_on_pillar();
  EXPECT_THAT(reasons(impact), HasSubstr("the sample-to-sample scatter: no measured value is given for "));
  impact.pad.material.uncertainty.scatter = 0.05;
  EXPECT_THAT(reasons(impact), IsEmpty());
  impact.impactor.nose = Cone{.radius = 0.08, .half_angle = 1.2};
  EXPECT_THAT(reasons(impact), HasSubstr("its size is not known for a cone"));
  impact = head_on_pillar();
  impact.pad.material.law = Elastic{2e6};
  impact.pad.material.fitted = FittedRange{0.2, 0.01, 1000};
  EXPECT_THAT(reasons(impact), HasSubstr("the elastic law has no parameter for strains above"));
}

TEST(Intervals, ColumnsAreOffByTheNoseOverThePad) {
  ImpactCase impact = head_on_pillar();
  const FigureInterval wide = interval(with_intervals(impact), "peak_acceleration");
  EXPECT_NEAR(part(wide, Source::neighbours)->high / wide.nominal, 1 + 1.96 * 0.06 * 3.3 / 3.2, 0.005);
  EXPECT_EQ(with_intervals(impact).summary.intervals->warning, "");
  impact.impactor.nose = Sphere{0.0125};
  EXPECT_THAT(with_intervals(impact).summary.intervals->warning,
              HasSubstr("SMALL NOSE: the nose radius is 0.5 times"));
  impact.impactor.nose = FlatDisc{0.04};
  EXPECT_THAT(with_intervals(impact).summary.intervals->warning,
              HasSubstr("SMALL NOSE: the flat-face radius is 1.6"));
  impact.pad.area = 0.001;
  EXPECT_EQ(with_intervals(impact).summary.intervals->warning, "");
  EXPECT_EQ(part(interval(with_intervals(impact), "peak_acceleration"), Source::neighbours), nullptr);
}

/// Each layer is varied, all at once.
TEST(Intervals, LayersHaveSourcesOfTheirOwn) {
  ImpactCase impact = head_on_pillar();
  impact.impactor.nose = FlatDisc{0.03};
  const Material material = impact.pad.material;
  set_layers(impact.pad, {{0.010, material}, {0.015, material}});
  const Solution solution = with_intervals(impact);
  EXPECT_NE(part(interval(solution, "hic15"), Source::continuation), nullptr);
  EXPECT_NE(part(interval(solution, "hic15"), Source::rate), nullptr);
}

/// A foam beyond its tests that does not matter is no reservation, and one that does says by how much.
TEST(Intervals, ExtrapolationIsAFlagWhereItMatters) {
  ImpactCase impact = head_on_pillar();
  const Solution solution = with_intervals(impact);
  std::string all;
  for (const Flag& flag : flags(solution.summary)) all += flag.text + "\n";
  EXPECT_THAT(all, HasSubstr("EXTRAPOLATED STRAIN: the strain reaches"));
  EXPECT_THAT(all, testing::AllOf(HasSubstr("; depending on the extrapolation, which is a guess, "),
                                  HasSubstr(" % higher\n")));
  foam_of(impact).gentlest_continuation = foam_of(impact).steepest_continuation = 2;
  for (const Flag& flag : flags(with_intervals(impact).summary)) EXPECT_NE(flag.name, "EXTRAPOLATED STRAIN");
}

TEST(Intervals, AnImpactThatBottomsOutNamesItsSourcesOnly) {
  ImpactCase impact = head_on_pillar();
  impact.pad.material.law = Elastic{1e4};
  impact.support = Support::rigid();
  const Solution solution = with_intervals(impact);
  ASSERT_TRUE(solution.summary.intervals);
  EXPECT_THAT(solution.summary.intervals->figures, IsEmpty());
  EXPECT_EQ(solution.summary.intervals->impacts, 0);
}

}  // namespace
}  // namespace dashpad::test
