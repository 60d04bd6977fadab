/// What the curves of a foam must keep to: each fault is found, under its key, and sound cards have none.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "dashpad/model/pad/law.hpp"
#include "model/pad/foam/foam_rules.hpp"

namespace dashpad {
namespace {

using testing::HasSubstr;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

TableCurve table() { return {{0.1, 0.3, 0.5, 0.7}, {30e3, 50e3, 80e3, 200e3}}; }
TableCurve times(double factor) {
  TableCurve curve = table();
  for (double& stress : curve.stress) stress *= factor;
  return curve;
}

Foam foam() {
  Foam law;
  law.curves = {.base = table(), .slowest_rate = 0.01, .rate_effect = NoRateEffect{}};
  return law;
}
Foam foam_with(const BaseCurve& base) {
  Foam law = foam();
  law.curves.base = base;
  return law;
}
Foam foam_with(const RateEffect& effect) {
  Foam law = foam();
  law.curves.rate_effect = effect;
  return law;
}
CrushableFoam crushable() {
  CrushableFoam law;
  law.unloading_modulus = 3e6;
  law.curves = foam().curves;
  return law;
}

/// All that is wrong, a line each.
std::string faults(const PadLaw& law) {
  std::string text;
  for (const Violation& broken : violations(law)) text += broken.key + ": " + broken.rule + "\n";
  return text;
}
void expect_fault(const PadLaw& law, const std::string& key, const std::string& words) {
  for (const Violation& broken : violations(law))
    if (broken.key == key && broken.rule.find(words) != std::string::npos) return;
  ADD_FAILURE() << "no fault of " << key << " with \"" << words << "\" in:\n" << faults(law);
}

TEST(foam_rules, sound_cards_break_none) {
  EXPECT_EQ(faults(foam()), "");
  EXPECT_EQ(faults(foam_with(AvalleCurve{60e3, 600e3, 0.5, 40e3, 1.6, 0.8})), "");
  EXPECT_EQ(faults(foam_with(PowerCurve{80e3, 0.675, 1.09, 0.8})), "");
  EXPECT_EQ(faults(foam_with(GibsonAshbyCurve{800e3, 50e3, 50e3, 0.05, 0.8})), "");
  EXPECT_EQ(faults(foam_with(HyperfoamCurve{60e3, 8, 10e3, -1.5, 0.7})), "");
  EXPECT_EQ(faults(foam_with(PowerRateEffect{0.1, 0.05, 100})), "");
  EXPECT_EQ(faults(foam_with(FactorRateEffect{{1, 10, 100}, {1.1, 1.1, 1.5}})), "");
  EXPECT_EQ(faults(foam_with(CurvesRateEffect{{{1, times(1.2)}, {100, times(1.5)}}, true})), "");
  Foam law = foam();
  law.unloading_curve = times(0.5);
  EXPECT_EQ(faults(law), "");
  EXPECT_EQ(faults(crushable()), "");
}

TEST(foam_rules, points_go_on_in_strain_and_end_below_full_compression) {
  TableCurve curve = table();
  curve.strain[2] = curve.strain[1];
  expect_fault(foam_with(curve), "curve.strain[3]", "more than the previous strain, 0.3");
  curve.strain[2] = 0.2;
  expect_fault(foam_with(curve), "curve.strain[3]", "more than the previous strain, 0.3");
  for (const double beyond : {1.0, 1.5, 70.0}) {
    curve = table();
    curve.strain[3] = beyond;
    expect_fault(foam_with(curve), "curve.strain[4]", "less than 1");
  }
  curve = table();
  curve.strain[0] = 0;
  expect_fault(foam_with(curve), "curve.strain[1]", "more than 0");
}

TEST(foam_rules, points_are_numbers) {
  for (const double wrong : {nan, infinity, -infinity}) {
    TableCurve curve = table();
    curve.strain[1] = wrong;
    expect_fault(foam_with(curve), "curve.strain[2]", "less than 1");
    curve = table();
    curve.stress[1] = wrong;
    EXPECT_THAT(faults(foam_with(curve)), HasSubstr("curve.stress[2]: "));
    EXPECT_THAT(faults(foam_with(CurvesRateEffect{{{1, curve}}})), HasSubstr("rate.curves[1].stress[2]: "));
    Foam law = foam();
    law.unloading_curve = curve;
    EXPECT_THAT(faults(law), HasSubstr("unloading.stress[2]: "));
    law = foam();
    law.curves.slowest_rate = wrong;
    EXPECT_THAT(faults(law), HasSubstr("curve.rate: "));
    EXPECT_THAT(faults(foam_with(PowerCurve{wrong, 1, 1, 0.8})), HasSubstr("curve.modulus: "));
    EXPECT_THAT(faults(foam_with(PowerCurve{1e5, 1, 1, wrong})), HasSubstr("curve.highest_strain: "));
    EXPECT_THAT(faults(foam_with(FactorRateEffect{{wrong}, {1.1}})), HasSubstr("rate.rates[1]: "));
    EXPECT_THAT(faults(foam_with(FactorRateEffect{{1}, {wrong}})), HasSubstr("rate.factors[1]: "));
    EXPECT_THAT(faults(foam_with(PowerRateEffect{wrong, 0, 10})), HasSubstr("rate.exponent: "));
    EXPECT_THAT(faults(foam_with(PowerRateEffect{0.1, 0, wrong})), HasSubstr("rate.highest_rate: "));
    CrushableFoam stays = crushable();
    stays.unloading_modulus = wrong;
    EXPECT_THAT(faults(stays), HasSubstr("unloading_modulus: "));
  }
}

TEST(foam_rules, there_are_points_enough_and_as_many_of_both) {
  expect_fault(foam_with(TableCurve{{0.1, 0.5}, {1e4, 5e4}}), "curve.strain", "between 3 and 2000 points");
  expect_fault(foam_with(TableCurve{}), "curve.strain", "between 3 and 2000 points");
  TableCurve many;
  for (int i = 1; i <= 2001; ++i) many.strain.push_back(0.9 * i / 2001), many.stress.push_back(1e3 * i);
  expect_fault(foam_with(many), "curve.strain", "between 3 and 2000 points");
  many.strain.pop_back(), many.stress.pop_back();
  EXPECT_EQ(faults(foam_with(many)), "");
  TableCurve uneven = table();
  uneven.stress.pop_back();
  expect_fault(foam_with(uneven), "curve.stress", "the number of entries, 3, must equal that of strain, 4");
}

TEST(foam_rules, the_slowest_curve_rises) {
  TableCurve curve = table();
  curve.stress[2] = 49e3;
  expect_fault(foam_with(curve), "curve.stress[3]", "must not be less than the previous stress");
  curve.stress[2] = 50e3;  // a plateau
  EXPECT_EQ(faults(foam_with(curve)), "");
  curve = table();
  curve.stress[0] = -1;
  EXPECT_THAT(faults(foam_with(curve)), HasSubstr("curve.stress[1]: "));
  // A plateau that gives way faster than it densifies.
  expect_fault(foam_with(AvalleCurve{60e3, 100e3, 10, 1e-3, 6, 0.8}), "curve.highest_strain",
               "does not at a strain of");
  expect_fault(foam_with(HyperfoamCurve{60e3, 8, 0, 0, 1.0}), "curve.highest_strain", "1");
}

TEST(foam_rules, the_gas_of_gibson_and_ashby_keeps_some_room) {
  for (const double highest : {0.9, 0.95})
    expect_fault(foam_with(GibsonAshbyCurve{800e3, 50e3, 50e3, 0.1, highest}), "curve.highest_strain",
                 "less than 1 - relative_density");
  EXPECT_EQ(faults(foam_with(GibsonAshbyCurve{800e3, 50e3, 50e3, 0.1, 0.89})), "");
}

TEST(foam_rules, faster_curves_do_not_cross_slower_ones) {
  // Twice the stress, and less at the end.
  TableCurve crossing = times(2);
  crossing.stress[3] = 165e3;
  for (const Violation& broken : violations(PadLaw(foam_with(CurvesRateEffect{{{5, crossing}}}))))
    if (broken.key == "rate.curves[1].stress") {
      EXPECT_THAT(broken.rule, HasSubstr("at 5 1/s crosses the one at 0.01 1/s: at a strain of "));
      const auto at = broken.rule.find("strain of ") + 10;
      const double strain = std::stod(broken.rule.substr(at));
      EXPECT_GT(strain, 0.5) << broken.rule;
      EXPECT_LT(strain, 0.7) << broken.rule;
    }
  expect_fault(foam_with(CurvesRateEffect{{{5, crossing}}}), "rate.curves[1].stress", "crosses");
  expect_fault(foam_with(CurvesRateEffect{{{5, times(2)}, {50, times(1.8)}}}), "rate.curves[2].stress",
               "the curve at 50 1/s crosses the one at 5 1/s");
  // What a plotter leaves.
  EXPECT_EQ(faults(foam_with(CurvesRateEffect{{{5, times(0.985)}}})), "");
  expect_fault(foam_with(CurvesRateEffect{{{5, times(0.97)}}}), "rate.curves[1].stress", "crosses");
}

TEST(foam_rules, rates_rise_from_the_slowest_on) {
  expect_fault(foam_with(CurvesRateEffect{{{10, times(1.2)}, {10, times(1.4)}}}), "rate.curves[2].rate",
               "more than the previous rate, 10 1/s");
  expect_fault(foam_with(CurvesRateEffect{{{0.01, times(1.2)}}}), "rate.curves[1].rate",
               "more than the previous rate");
  expect_fault(foam_with(FactorRateEffect{{10, 1}, {1.1, 1.2}}), "rate.rates[2]",
               "more than the previous rate, 10");
  expect_fault(foam_with(FactorRateEffect{{0.001}, {1.1}}), "rate.rates[1]",
               "more than the previous rate, 0.01");
  expect_fault(foam_with(PowerRateEffect{0.1, 0, 0.01}), "rate.highest_rate", "more than the previous rate");
  for (const double wrong : {0.0, -1.0, 2e9}) {
    Foam law = foam();
    law.curves.slowest_rate = wrong;
    EXPECT_THAT(faults(law), HasSubstr("curve.rate: must be more than 0"));
  }
}

TEST(foam_rules, a_faster_curve_falls_by_a_tenth_at_most) {
  TableCurve curve = times(3);
  curve.stress[1] = 0.91 * curve.stress[0];
  curve.stress[1] = std::max(curve.stress[1], 60e3);
  EXPECT_EQ(faults(foam_with(CurvesRateEffect{{{5, curve}}})), "");
  EXPECT_EQ(softening_rates(foam_with(CurvesRateEffect{{{5, curve}}}).curves), std::vector<double>{5});
  EXPECT_TRUE(softening_rates(foam_with(CurvesRateEffect{{{5, times(3)}}}).curves).empty());
  curve.stress[1] = 0.85 * curve.stress[0];
  expect_fault(foam_with(CurvesRateEffect{{{5, curve}}}), "rate.curves[1].stress", "falls by 15 %");
}

TEST(foam_rules, there_is_a_faster_curve_where_curves_are_said_to_be) {
  EXPECT_THAT(faults(foam_with(CurvesRateEffect{})), HasSubstr("rate.curves: must have between 1 and"));
  EXPECT_THAT(faults(foam_with(FactorRateEffect{})), HasSubstr("rate.factors: "));
  EXPECT_THAT(faults(foam_with(FactorRateEffect{{1, 2}, {1.1}})), HasSubstr("rate.factors: "));
}

TEST(foam_rules, factors_do_not_fall) {
  expect_fault(foam_with(FactorRateEffect{{1, 10}, {1.3, 1.2}}), "rate.factors[2]",
               "at least 1.3, the previous factor");
  expect_fault(foam_with(FactorRateEffect{{1}, {0.9}}), "rate.factors[1]", "at least 1");
}

TEST(foam_rules, the_way_back_is_not_above_the_way_in) {
  Foam law = foam();
  law.unloading_curve = times(0.5);
  law.unloading_curve->stress[2] = 90e3;
  expect_fault(law, "unloading.stress[3]", "at most the loading stress, 80000");
  law.unloading_curve = times(1.01);
  EXPECT_EQ(faults(law), "");
  law.unloading_curve = times(0.5);
  law.unloading_curve->strain[3] = 0.75;
  expect_fault(law, "unloading.strain[4]", "at most the last strain of the loading curve, 0.7");
}

TEST(foam_rules, a_foam_that_stays_crushed_unloads_at_least_as_steeply_as_it_loads) {
  CrushableFoam law = crushable();
  law.unloading_modulus = 1e5;
  expect_fault(law, "unloading_modulus", "at least the steepest slope of the curve");
  law.curves.base = GibsonAshbyCurve{800e3, 50e3, 0, 0, 0.8};
  law.unloading_modulus = 0.9 * 800e3;
  expect_fault(law, "unloading_modulus", "steepest slope");
  law.unloading_modulus = 800e3;
  EXPECT_EQ(faults(law), "");
}

TEST(foam_rules, bounds_of_single_numbers_are_kept) {
  Foam law = foam();
  law.friction = 0.5;
  EXPECT_THAT(faults(law), HasSubstr("friction: "));
  law = foam();
  law.lag_strain = 1e-5;
  EXPECT_THAT(faults(law), HasSubstr("lag_strain: "));
  law = foam();
  law.continuation_exponent = 0.5;
  EXPECT_THAT(faults(law), HasSubstr("continuation_exponent: "));
  law = foam();
  law.unloading_factor = nan;
  EXPECT_THAT(faults(law), HasSubstr("unloading_factor: "));
}

/// However broken a card is: faults, and no more than that.
TEST(foam_rules, never_fail_on_a_broken_card) {
  const std::vector<double> odd{nan, infinity, -infinity, 0, -0.0, -1, 1, 1e308, 1e-308};
  for (const double a : odd)
    for (const double b : odd) {
      const TableCurve curve{{a, b, 0.5}, {b, a, 1e5}};
      CrushableFoam stays = crushable();
      stays.continuation_exponent = b;
      stays.unloading_modulus = a;
      stays.curves.base = curve;
      EXPECT_NE(faults(stays), "");
      Foam law = foam_with(CurvesRateEffect{{{a, curve}, {b, times(1.1)}}});
      law.unloading_curve = curve;
      EXPECT_NE(faults(law), "");
      for (const BaseCurve& base :
           {BaseCurve(AvalleCurve{a, b, a, b, a, b}), BaseCurve(PowerCurve{a, b, a, b}),
            BaseCurve(GibsonAshbyCurve{a, b, a, b, a}), BaseCurve(HyperfoamCurve{a, b, a, b, b})})
        EXPECT_NE(faults(foam_with(base)), "");
    }
}

}  // namespace
}  // namespace dashpad
