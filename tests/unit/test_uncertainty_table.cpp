/// What is not known of a foam: read from cards and cases, written again, and refused where it makes no
/// sense.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "dashpad/input/case_file.hpp"
#include "dashpad/input/fault.hpp"
#include "dashpad/output/card_toml.hpp"
#include "shared/temporary_folder.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

const std::string foam = R"(title = "Foam"
source = "made up"
law = "foam"
[parameters]
recoil = 0.5
[curve]
form = "avalle"
rate = "0.01 1/s"
plateau_stress = "80 kPa"
modulus = "1 MPa"
plateau_exponent = 1
densification_stress = "100 kPa"
densification_exponent = 2
highest_strain = 0.7
)";

const std::string known = R"([uncertainty]
recoil = [0, 0.8]
unloading_factor = [0.2, 1]
lag_strain = [0.002, 0.02]
rate_exponent = [0, 0.05]
scatter = 0.04
[uncertainty.misfit]
peak_acceleration = 0.03
hic = 0.05
rebound_speed = 0.04
penetration = 0.02
impacts = 3
held_out = true
nose_over_pad = 1.6
[uncertainty.posterior]
keys = ["curve.plateau_stress", "parameters.recoil"]
minus = [[75e3, 0.4], [80e3, 0.2]]
plus = [[85e3, 0.6], [80e3, 0.7]]
)";

Material material_of(const TemporaryFolder& folder, const std::string& text) {
  return input::read_material(folder.write("foam.toml", text)).value();
}

/// All faults of a card, a line each.
std::string faults_of(const std::string& text) {
  const TemporaryFolder folder;
  try {
    material_of(folder, text);
  } catch (const input::InputError& error) {
    std::string all;
    for (const input::Fault& fault : error.faults()) all += to_string(fault) + "\n";
    return all;
  }
  return "";
}

TEST(UncertaintyTable, WhatACardSaysIsWrittenAsItWasRead) {
  const TemporaryFolder folder;
  const Uncertainty read = material_of(folder, foam + known).uncertainty;
  EXPECT_EQ(read.recoil, (ValueRange{0, 0.8}));
  EXPECT_EQ(read.scatter, 0.04);
  ASSERT_TRUE(read.misfit);
  EXPECT_EQ(*read.misfit, (Misfit{0.03, 0.05, 0.04, 0.02, 3, true, 1.6}));
  EXPECT_EQ(read.posterior.plus.at(1), (std::vector<double>{80e3, 0.7}));
  const Material again = material_of(folder, output::card_toml(material_of(folder, foam + known)));
  EXPECT_EQ(again.uncertainty, read);
}

TEST(UncertaintyTable, WhatACardLeavesOutIsNotThere) {
  const TemporaryFolder folder;
  EXPECT_EQ(material_of(folder, foam).uncertainty, Uncertainty{});
  EXPECT_THAT(output::card_toml(material_of(folder, foam)), Not(HasSubstr("uncertainty")));
}

TEST(UncertaintyTable, EachFaultIsSaid) {
  EXPECT_THAT(faults_of(foam + "[uncertainty]\nrecoil = [0.6, 0.9]\nscatter = 2\nrate_exponent = [0.5, 0.1]\n"
                               "lag_strain = [0.001]\nunloading = 1\n"),
              AllOf(HasSubstr("must include the card's value of recoil"),
                    HasSubstr("must be a fraction, from 0 to 1"), HasSubstr("uncertainty.rate_exponent"),
                    HasSubstr("must be two numbers, the lower first"), HasSubstr("uncertainty.unloading")));
  EXPECT_THAT(faults_of(foam + "[uncertainty.posterior]\nkeys = [\"curve.plateau\"]\nminus = [[1, 2]]\n"
                               "plus = [[\"x\"]]\n"),
              AllOf(HasSubstr("did you mean \"curve.plateau_stress\""),
                    HasSubstr("each row must have 1 numbers"), HasSubstr("must be a number")));
  EXPECT_THAT(faults_of(foam + "[uncertainty.misfit]\npeak_acceleration = 0.1\nhic = -1\nrebound_speed = 0\n"
                               "penetration = 0\nimpacts = 1.5\n"),
              AllOf(HasSubstr("uncertainty.misfit.hic"), HasSubstr("must be a whole number, 1 or more")));
}

}  // namespace
}  // namespace dashpad::test
