// dashpad sensitivity: the effect of each number of a case.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class SensitivityTest : public CommandTest {};

TEST_F(SensitivityTest, NamesWhatMattersMost) {
  const Outcome outcome = dashpad({"sensitivity", nine});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("Peak acceleration depends most on the impact speed (1 % more: "),
                                 HasSubstr("The uncertainty of foam and model changes it by"),
                                 HasSubstr("Thickness of the pad")));
}

TEST_F(SensitivityTest, ItsEffectIsThatOfTwoRuns) {
  const json answer = json::parse(dashpad({"sensitivity", nine, "--no-intervals", "--json", "-"}).out);
  double derivative = 0;
  for (const json& input : answer["inputs"])
    if (input["key"] == "pad.thickness") derivative = input["effects"]["peak_force"]["derivative"];
  const auto force = [](const char* thickness) {
    return json::parse(dashpad({"run", nine, "--set", std::string("pad.thickness=") + thickness,
                                "--tolerance", "1e-7", "--no-intervals", "--json", "-"})
                           .out)["peak_force_N"]
        .get<double>();
  };
  EXPECT_NEAR(derivative, (force("25.5 mm") - force("25.3 mm")) / 0.2e-3, 2e-3 * std::abs(derivative));
}

TEST_F(SensitivityTest, WritesFiles) {
  const Outcome outcome = dashpad({"sensitivity", case_file(), "--figure", "hic15", "--csv", file("s.csv"),
                                   "--report", file("s.html"), "--picture", file("s.svg")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_file(file("s.csv")), AllOf(StartsWith("input,input_unit,input_value,figure,"),
                                              HasSubstr("\nimpactor.speed,m/s,3,hic15,1,")));
  EXPECT_THAT(read_file(file("s.html")), HasSubstr("HIC15 depends most on the impact speed"));
  EXPECT_THAT(read_file(file("s.svg")), HasSubstr(" impact speed"));
}

TEST_F(SensitivityTest, RefusesAFigureThatIsNone) {
  const Outcome outcome = dashpad({"sensitivity", nine, "--figure", "hic16", "--picture", "x.gif"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--figure hic16: no such figure"), HasSubstr("--picture"),
                                 HasSubstr("2 errors")));
}

}  // namespace
}  // namespace dashpad::test
