/// The physical rules of laws, materials and impacts.

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "dashpad/impact/impact_case.hpp"
#include "shared/samples.hpp"

namespace dashpad {
namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

const Elastic elastic{.modulus = 1e5};
const LinearViscoelastic viscoelastic{
    .asymptotic_modulus = 1e5, .initial_modulus = 2e5, .relaxation_time = 0.01};
const RigidFoam rigid{.crush_stress = 2e5, .crush_strain = 0.6, .second_stress = 4e5, .second_strain = 0.8};
const NineParameter nine{5e4, 0.675, 1.09, 8.81e-3, 4e4, 0.166, 9.76e-6, 0.0987};
const TwentyOneParameter twenty_one{5e4,  0.675, 1.09, 0.13,  0.156, 3.08,    3e4,     0.19,
                                    3.17, 0.58,  2.57, 0.296, 2.23,  1.64e-3, 9.76e-6, 0.0987};

std::vector<std::string> keys(const std::vector<Violation>& broken) {
  std::vector<std::string> result;
  for (const Violation& violation : broken) result.push_back(violation.key);
  return result;
}
using Keys = std::vector<std::string>;

template <class Law>
class law_rules : public ::testing::Test {};
TYPED_TEST_SUITE(law_rules, test::LawsOfTheReport);

template <class Law>
const Law& sound() {
  if constexpr (std::is_same_v<Law, Elastic>) return elastic;
  if constexpr (std::is_same_v<Law, LinearViscoelastic>) return viscoelastic;
  if constexpr (std::is_same_v<Law, RigidFoam>) return rigid;
  if constexpr (std::is_same_v<Law, NineParameter>) return nine;
  if constexpr (std::is_same_v<Law, TwentyOneParameter>) return twenty_one;
}

TYPED_TEST(law_rules, sound_parameters_break_none) {
  EXPECT_EQ(keys(violations(PadLaw(sound<TypeParam>()))), Keys());
  EXPECT_EQ(name_of(PadLaw(sound<TypeParam>())), TypeParam::name);
}

TYPED_TEST(law_rules, each_parameter_must_be_in_its_bounds) {
  for (const auto& parameter : TypeParam::parameters) {
    for (const double value : {nan, infinity, -infinity, -1.0, 1e16}) {
      TypeParam law = sound<TypeParam>();
      parameter.set(law, value);
      // A value that is out of bounds may break a rule with another parameter as well.
      EXPECT_EQ(keys(violations(PadLaw(law))).front(), parameter.key) << value;
    }
    if (parameter.bounds.lowest == 0) {
      TypeParam law = sound<TypeParam>();
      parameter.set(law, 0);
      EXPECT_EQ(violations(PadLaw(law)).empty(), parameter.bounds.lowest_admitted) << parameter.key;
    }
  }
}

TYPED_TEST(law_rules, a_value_that_is_no_number_is_reported_once) {
  for (const auto& parameter : TypeParam::parameters) {
    TypeParam law = sound<TypeParam>();
    parameter.set(law, nan);
    EXPECT_EQ(keys(violations(PadLaw(law))), Keys{parameter.key});
  }
}

TEST(law_rules_between_parameters, are_checked) {
  LinearViscoelastic stiffening = viscoelastic;
  stiffening.initial_modulus = 0.5e5;
  EXPECT_EQ(keys(violations(PadLaw(stiffening))), Keys{"initial_modulus"});
  RigidFoam folded = rigid;
  folded.second_strain = folded.crush_strain;
  folded.second_stress = 1e5;
  EXPECT_EQ(keys(violations(PadLaw(folded))), (Keys{"second_strain", "second_stress"}));
  TwentyOneParameter steep = twenty_one;
  steep.onset_strain_exponent = 0.5;
  EXPECT_EQ(keys(violations(PadLaw(steep))), Keys{"onset_strain_exponent"});
}

ImpactCase sound_case() {
  return {.title = "",
          .impactor = {.mass = 4.5, .nose = Sphere{0.08}, .speed = 9},
          .pad = {.thickness = 0.025,
                  .material = {.name = "",
                               .title = "",
                               .source = "",
                               .law = nine,
                               .fitted = FittedRange{0.95, 1, 100},
                               .also_published = {}}},
          .support = Support::linear(1e5)};
}

struct Change {
  void (*make)(ImpactCase&);
  Keys broken;
};

TEST(case_rules, each_is_checked) {
  EXPECT_EQ(keys(violations(sound_case())), Keys());
  const std::vector<Change> changes{
      {[](ImpactCase& impact) { impact.impactor.mass = 0; }, {"impactor.mass"}},
      {[](ImpactCase& impact) { impact.impactor.mass = nan; }, {"impactor.mass"}},
      {[](ImpactCase& impact) { impact.impactor.nose = Sphere{-1}; }, {"impactor.radius"}},
      {[](ImpactCase& impact) { impact.impactor.nose = Sphere{infinity}; }, {"impactor.radius"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Cone{0.1, 0.5};
       },
       {}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Cone{0.1, 0.5, nan};
       },
       {"impactor.tip_radius"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Cone{0.1, 0.5, 0.1};
       },
       {"impactor.tip_radius"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Cone{0.1, 1.57};
       },
       {"impactor.half_angle"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Cone{nan, nan};
       },
       {"impactor.radius", "impactor.half_angle"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Ellipsoid{0, -1, nan};
       },
       {"impactor.half_depth", "impactor.half_length", "impactor.half_width"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Rod{0.1, 0.1};
       },
       {}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Rod{0.1, 0.09};
       },
       {"impactor.tip_radius"}},
      {[](ImpactCase& impact) {
         impact.impactor.nose = Platen{0.1, 0};
       },
       {"impactor.width"}},
      {[](ImpactCase& impact) { impact.pad.area = 0.01; }, {}},
      {[](ImpactCase& impact) { impact.pad.area = 0; }, {"pad.area"}},
      {[](ImpactCase& impact) { impact.pad.area = nan; }, {"pad.area"}},
      {[](ImpactCase& impact) { impact.pad.sheet = 5; }, {}},
      {[](ImpactCase& impact) { impact.pad.sheet = -1; }, {"pad.sheet_mass_per_area"}},
      {[](ImpactCase& impact) { impact.pad.sheet = nan; }, {"pad.sheet_mass_per_area"}},
      {[](ImpactCase& impact) {
         impact.pad.sheet = 5;
         impact.blows = Blows{};
       },
       {"pad.sheet_mass_per_area"}},
      {[](ImpactCase& impact) {
         impact.pad.sheet = 5;
         impact.impactor.nose = Cylinder{.radius = 0.05, .length = 0.2};
       },
       {"pad.sheet_mass_per_area"}},
      {[](ImpactCase& impact) { impact.impactor.speed = 1e4; }, {"impactor.speed"}},
      {[](ImpactCase& impact) { impact.pad.thickness = 1e-9; }, {"pad.thickness"}},
      {[](ImpactCase& impact) { impact.pad.material.law = Elastic(); }, {"pad.parameters.modulus"}},
      {[](ImpactCase& impact) { impact.pad.material.fitted->highest_strain = 1.5; },
       {"pad.fitted.highest_strain"}},
      {[](ImpactCase& impact) { impact.pad.material.fitted->lowest_rate = -1; }, {"pad.fitted.lowest_rate"}},
      {[](ImpactCase& impact) { impact.pad.material.fitted->highest_rate = 1; }, {"pad.fitted.highest_rate"}},
      {[](ImpactCase& impact) { impact.pad.material.fitted.reset(); }, {}},
      {[](ImpactCase& impact) { impact.support = Support::rigid(); }, {}},
      {[](ImpactCase& impact) { impact.support = Support::linear(1e100); }, {"support.stiffness"}},
      {[](ImpactCase& impact) {
         impact.support = Support::through({{1, 1}, {2, 1e50}});
       },
       {"support.points[2]"}},
      {[](ImpactCase& impact) { impact = ImpactCase(); },
       {"impactor.mass", "impactor.speed", "impactor.radius", "pad.thickness", "pad.parameters.modulus"}},
  };
  for (std::size_t i = 0; i < changes.size(); ++i) {
    ImpactCase impact = sound_case();
    changes[i].make(impact);
    EXPECT_EQ(keys(violations(impact)), changes[i].broken) << "change " << i;
    for (const Violation& violation : violations(impact))
      EXPECT_NE(violation.rule.find("must"), std::string::npos);
  }
}

}  // namespace
}  // namespace dashpad
