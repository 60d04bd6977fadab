/// The quantities of a case by name: those of case files, each with its own place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <stdexcept>
#include <string>
#include <vector>

#include "dashpad/case/case_quantity.hpp"
#include "model/parameter_values.hpp"
#include "sample_case.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

using testing::Contains;
using testing::Field;
using testing::IsEmpty;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// Sound cases: every law, and a foam with every form of its curves.
std::vector<ImpactCase> cases() {
  std::vector<ImpactCase> all;
  for_each_alternative<PadLaw>(
      [&]<class Law>(const Law&) { all.push_back(test::impact_on(test::sample_law<Law>())); });
  for (const BaseCurve& base : std::vector<BaseCurve>{
           AvalleCurve{40e3, 800e3, 0, 10e3, 2, 0.7}, PowerCurve{200e3, 0.5, 1, 0.7},
           GibsonAshbyCurve{200e3, 5e3, 101e3, 0.03, 0.7}, HyperfoamCurve{30e3, 6, 8e3, -1, 0.7}}) {
    Foam law = test::sample_law<Foam>();
    law.curves.base = base;
    all.push_back(test::impact_on(law));
  }
  for (const Nose& nose :
       std::vector<Nose>{FlatDisc{0.05}, Cone{0.08, 1, 0.01}, Ellipsoid{0.06, 0.09, 0.05}, Rod{0.03, 0.08},
                         Platen{0.1, 0.08}, Cylinder{0.05, 0.1}, Profile{.points = {{0, 0}, {0.03, 0.05}}}}) {
    all.push_back(test::impact_on(test::sample_law<Elastic>()));
    all.back().impactor.nose = nose;
    all.back().pad.area = 0.01;
    if (!std::holds_alternative<Cylinder>(nose)) all.back().pad.sheet = 5;
  }
  for (ImpactCase& impact : all) {
    impact.pad.material.density = impact.pad.condition.density = 50;
    impact.pad.material.density_exponent = 1.5;
    impact.pad.material.temperature_table = {{273, 313}, {1.6, 0.8}};
    impact.pad.condition.temperature = 290;
  }
  return all;
}

const CaseQuantity& found(const CaseQuantities& quantities, const std::string& key) {
  const CaseQuantity* const place = quantities.find(key);
  if (place == nullptr) throw std::logic_error("no " + key);
  return *place;
}

TEST(CaseQuantities, EachHasAPlaceOfItsOwn) {
  for (const ImpactCase& base : cases()) {
    const CaseQuantities all = quantities_of(base);
    std::vector<CaseQuantity> quantities(all.begin(), all.end());
    // Other ways to say a number that is among them.
    std::erase_if(quantities, [](const CaseQuantity& case_quantity) {
      return case_quantity.key == static_stress ||
             std::ranges::count(other_ways(), case_quantity.key, &OtherWay::key) > 0;
    });
    ImpactCase impact = base;
    double value = 1;
    for (const CaseQuantity& case_quantity : quantities) case_quantity.set(impact, value++);
    value = 1;
    for (const CaseQuantity& case_quantity : quantities)
      EXPECT_EQ(case_quantity.get(impact), value++) << base.title << case_quantity.key;
  }
}

TEST(CaseQuantities, AreCalledAsTheRulesThatTheyBreak) {
  for (const ImpactCase& base : cases()) {
    EXPECT_THAT(violations(base), IsEmpty()) << base.title;
    for (const CaseQuantity& case_quantity : quantities_of(base)) {
      ImpactCase impact = base;
      case_quantity.set(impact, nan);
      std::string key = case_quantity.key;
      for (const OtherWay& way : other_ways())
        if (key == way.key) key = way.instead_of;
      if (key == static_stress) key = "impactor.mass";
      EXPECT_THAT(violations(impact), Contains(Field(&Violation::key, key))) << base.title;
    }
  }
}

TEST(CaseQuantities, AreCalledAsInCaseFiles) {
  const ImpactCase impact = test::read(test::edited(test::good_case, "material = \"ensolite-aac-9\"",
                                                    R"(law = "foam"
scale = 1.5
parameters = { friction = 0.1 }
[pad.curve]
form = "gibson-ashby"
rate = "0.01 1/s"
modulus = "200 kPa"
plateau_stress = "5 kPa"
gas_pressure = "101 kPa"
relative_density = 0.036
highest_strain = 0.7
[pad.rate]
form = "power"
exponent = 0.1
exponent_slope = -0.2
highest_rate = "100 1/s")"))
                                .impact;
  std::map<std::string, double> values;
  std::map<std::string, std::string> units;
  for (const CaseQuantity& case_quantity : quantities_of(impact)) {
    values[case_quantity.key] = case_quantity.get(impact);
    units[case_quantity.key] = case_quantity.unit;
  }
  EXPECT_DOUBLE_EQ(values.at("impactor.radius"), 0.0762);
  EXPECT_DOUBLE_EQ(values.at("impactor.weight"), 44.4822161526050);
  EXPECT_DOUBLE_EQ(values.at("impactor.mass"), 4.5359237);
  EXPECT_DOUBLE_EQ(values.at("impactor.speed"), 8.9408);
  EXPECT_DOUBLE_EQ(values.at("pad.thickness"), 0.0254);
  EXPECT_EQ(values.at("pad.scale"), 1.5);
  EXPECT_EQ(values.at("pad.parameters.friction"), 0.1);
  EXPECT_EQ(values.at("pad.curve.modulus"), 200e3);
  EXPECT_EQ(units.at("pad.curve.modulus"), "Pa");
  EXPECT_EQ(values.at("pad.curve.plateau_stress"), 5e3);
  EXPECT_EQ(values.at("pad.curve.gas_pressure"), 101e3);
  EXPECT_EQ(values.at("pad.curve.relative_density"), 0.036);
  EXPECT_EQ(units.at("pad.curve.relative_density"), "1");
  EXPECT_EQ(values.at("pad.curve.highest_strain"), 0.7);
  EXPECT_EQ(values.at("pad.rate.exponent"), 0.1);
  EXPECT_EQ(values.at("pad.rate.exponent_slope"), -0.2);
  EXPECT_EQ(values.at("pad.rate.highest_rate"), 100);
  EXPECT_EQ(units.at("pad.rate.highest_rate"), "1/s");
  EXPECT_NEAR(values.at("support.stiffness"), 105076.1, 0.1);
  EXPECT_EQ(values.at("support.scale"), 1);
  EXPECT_FALSE(values.contains("pad.density"));
  EXPECT_FALSE(values.contains("pad.temperature"));
}

/// Tables have points, which are no quantities; a foam without a rate effect has none of its numbers either.
TEST(CaseQuantities, AreThoseOfTheFormsThatTheCaseHas) {
  Foam law = test::sample_law<Foam>();
  law.curves.rate_effect = NoRateEffect{};
  for (const CaseQuantity& case_quantity : quantities_of(test::impact_on(law))) {
    EXPECT_FALSE(case_quantity.key.starts_with("pad.curve.")) << case_quantity.key;
    EXPECT_FALSE(case_quantity.key.starts_with("pad.rate.")) << case_quantity.key;
    EXPECT_FALSE(case_quantity.key.starts_with("support.")) << case_quantity.key;
  }
}

TEST(CaseQuantities, AreRefusedByACaseWithAnotherForm) {
  Foam law = test::sample_law<Foam>();
  law.curves.base = PowerCurve{200e3, 0.5, 1, 0.7};
  const auto quantities = quantities_of(test::impact_on(law));
  law.curves.base = HyperfoamCurve{30e3, 6, 8e3, -1, 0.7};
  ImpactCase other = test::impact_on(law);
  EXPECT_THROW(found(quantities, "pad.curve.modulus").set(other, 1), std::bad_variant_access);
}

/// A density that the case does not give is that of the card.
TEST(CaseQuantities, AreThoseOfTheCardOrNoNumberWhereTheCaseIsSilent) {
  ImpactCase silent = cases().front();
  silent.pad.condition = {};
  const auto quantities = quantities_of(silent);
  EXPECT_EQ(found(quantities, "pad.density").get(silent), *silent.pad.material.density);
  EXPECT_TRUE(std::isnan(found(quantities, "pad.temperature").get(silent)));
}

/// Eq. of a free fall: v^2 = 2 g h; with the gravity of the case, or that of the earth.
TEST(CaseQuantities, AFallFromAHeightIsASpeed) {
  ImpactCase impact = test::impact_on(Elastic{3e5});
  for (const double gravity : {0.0, 3.71}) {
    impact.impactor.gravity = gravity;
    const auto quantities = quantities_of(impact);
    const CaseQuantity& height = found(quantities, "impactor.drop_height");
    height.set(impact, 1.5);
    EXPECT_NEAR(impact.impactor.speed, std::sqrt(2 * (gravity > 0 ? gravity : 9.80665) * 1.5), 1e-12);
    EXPECT_NEAR(height.get(impact), 1.5, 1e-12);
    EXPECT_EQ(impact.impactor.gravity, gravity);
    height.set(impact, -1);
    EXPECT_LT(impact.impactor.speed, 0);  // which a rule refuses, with a number in its sentence
  }
}

TEST(CaseQuantities, ScaleTheSupportOfTheFirstCase) {
  const ImpactCase base = test::impact_on(Elastic{3e5}, Support::through({{0.01, 100}, {0.02, 500}}));
  const auto quantities = quantities_of(base);
  const CaseQuantity& scale = found(quantities, "support.scale");
  ImpactCase impact = base;
  for (const double factor : {3.0, 2.0}) {
    scale.set(impact, factor);
    EXPECT_EQ(scale.get(impact), factor);
    EXPECT_DOUBLE_EQ(impact.support.force(0.02), 500 * factor);
  }
  EXPECT_THROW(scale.set(impact, nan), std::invalid_argument);
  EXPECT_THROW(found(quantities, "support.stiffness"), std::logic_error);
}

}  // namespace
}  // namespace dashpad
