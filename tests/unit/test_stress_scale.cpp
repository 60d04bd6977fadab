/// Scale, density and temperature of a pad (theory.md, Eq. 39), and foams in case files.

#include <gtest/gtest.h>

#include <cmath>

#include "dashpad/impact/solve.hpp"
#include "dashpad/input/case_file.hpp"
#include "dashpad/model/pad/stress_scale.hpp"
#include "dashpad/study/study_file.hpp"
#include "sample_case.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

using test::edited;
using test::impact_on;
using test::sample_law;

template <class Law>
class Scale : public testing::Test {};
TYPED_TEST_SUITE(Scale, test::AllLaws);

/// Twice the stress under twice the mass is the same motion.
TYPED_TEST(Scale, OfTheStressIsThatOfTheMass) {
  ImpactCase plain = impact_on(sample_law<TypeParam>());
  ImpactCase doubled = plain;
  doubled.pad.condition.scale = 2;
  doubled.impactor.mass *= 2;
  const Summary a = solve(plain, {}).summary;
  const Summary b = solve(doubled, {}).summary;
  EXPECT_NEAR(b.peak_penetration / a.peak_penetration, 1, 1e-9);
  ASSERT_EQ(a.peak_force.has_value(), b.peak_force.has_value());
  EXPECT_NEAR(b.peak_force.value_or(2) / a.peak_force.value_or(1), 2, 1e-6);
}

TYPED_TEST(Scale, OfACaseIsThatOfTheLaw) {
  ImpactCase by_case = impact_on(sample_law<TypeParam>(), Support::linear(2e5));
  ImpactCase by_law = by_case;
  by_case.pad.condition.scale = 1.7;
  by_law.pad.material.law = scaled(by_law.pad.material.law, 1.7);
  const Summary a = solve(by_case, {}).summary;
  const Summary b = solve(by_law, {}).summary;
  EXPECT_NEAR(*a.peak_force / *b.peak_force, 1, 1e-9);
}

TEST(StressScale, FollowsDensityAndTemperature) {
  Material foam;
  foam.density = 50;
  foam.density_exponent = 1.5;
  foam.temperature_table = {{273.15, 293.15, 313.15}, {1.6, 1, 0.8}};
  EXPECT_DOUBLE_EQ(stress_factor({}, foam), 1);
  EXPECT_DOUBLE_EQ(stress_factor({2, 100.0, {}}, foam), 2 * std::pow(2, 1.5));
  EXPECT_NEAR(stress_factor({1, {}, 283.15}, foam), 1.3, 1e-12);
  EXPECT_DOUBLE_EQ(stress_factor({1, {}, 400}, foam), 0.8);
  EXPECT_TRUE(extrapolations({1, {}, 300}, foam).empty());
  EXPECT_EQ(extrapolations({1, {}, 400}, foam).size(), 1);
}

TEST(StressScale, OtherDensitiesWantALaw) {
  const Material silent;
  EXPECT_EQ(violations(PadCondition{1, 60, {}}, silent).front().key, "density");
  EXPECT_EQ(violations(PadCondition{1, {}, 300}, silent).front().key, "temperature");
  EXPECT_EQ(violations(PadCondition{0, {}, {}}, silent).front().key, "scale");
  EXPECT_EQ(violations(PadCondition{std::nan(""), {}, {}}, silent).front().key, "scale");
  EXPECT_TRUE(violations(PadCondition{}, silent).empty());
}

const std::string foam_in_line = R"(law = "foam"
scale = 1.5
[pad.curve]
form = "table"
rate = "0.01 1/s"
stress_unit = "kPa"
strain = [0.05, 0.1, 0.3, 0.6]
stress = [22, 31, 47, 135]
[pad.rate]
form = "factor"
rates = ["1 1/s", "100 1/s"]
factors = [1.2, 1.5])";

TEST(FoamInACase, IsRead) {
  const ImpactCase impact =
      test::read(edited(test::good_case, "material = \"ensolite-aac-9\"", foam_in_line)).impact;
  const Foam& foam = std::get<Foam>(impact.pad.material.law);
  EXPECT_EQ(impact.pad.condition.scale, 1.5);
  EXPECT_EQ(foam.lag_strain, 0.005);
  EXPECT_EQ(foam.unloading_factor, 1);
  EXPECT_EQ(std::get<TableCurve>(foam.curves.base).stress, (std::vector<double>{22e3, 31e3, 47e3, 135e3}));
  EXPECT_EQ(std::get<FactorRateEffect>(foam.curves.rate_effect).rate, (std::vector<double>{1, 100}));
  EXPECT_EQ(range_of(impact.pad.material)->highest_strain, 0.6);
  EXPECT_EQ(range_of(impact.pad.material)->highest_rate, 100);
}

std::vector<std::string> keys_at_fault(const std::string& text) {
  try {
    test::read(text);
  } catch (const input::InputError& error) {
    std::vector<std::string> keys;
    for (const input::Fault& fault : error.faults()) keys.push_back(fault.key);
    return keys;
  }
  return {};
}

TEST(FoamInACase, FaultsHaveTheirPlaces) {
  const auto with = [](const std::string& from, const std::string& to) {
    return edited(test::good_case, "material = \"ensolite-aac-9\"", edited(foam_in_line, from, to));
  };
  using Keys = std::vector<std::string>;
  EXPECT_EQ(keys_at_fault(with("0.1, 0.3", "0.3, 0.3")), Keys{"pad.curve.strain[3]"});
  EXPECT_EQ(keys_at_fault(with("31, 47", "47, 31")), Keys{"pad.curve.stress[3]"});
  EXPECT_EQ(keys_at_fault(with("0.6]", "1.2]")), Keys{"pad.curve.strain[4]"});
  EXPECT_EQ(keys_at_fault(with("0.6]", "nan]")), Keys{"pad.curve.strain[4]"});
  EXPECT_EQ(keys_at_fault(with("\"kPa\"", "\"kN\"")), Keys{"pad.curve.stress_unit"});
  EXPECT_EQ(keys_at_fault(with("[1.2, 1.5]", "[1.5, 1.2]")), Keys{"pad.rate.factors[2]"});
  EXPECT_EQ(keys_at_fault(with("scale = 1.5", "scale = -1")), Keys{"pad.scale"});
  EXPECT_EQ(keys_at_fault(with("scale = 1.5", "density = \"60 kg/m3\"")), Keys{"pad.density"});
  EXPECT_EQ(keys_at_fault(with("scale = 1.5", "temperature = \"40 degC\"")), Keys{"pad.temperature"});
  EXPECT_EQ(keys_at_fault(with("form = \"factor\"", "form = \"speed\"")).front(), "pad.rate.form");
}

}  // namespace
}  // namespace dashpad
