/// dashpad post-impact.

#include <cmath>

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class PostImpactTest : public CommandTest {
 protected:
  json result(const std::vector<std::string>& more) {
    std::vector<std::string> arguments{"post-impact", file("case.toml"), "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return json::parse(outcome.out);
  }
};

TEST_F(PostImpactTest, AgainstABodyHeldInPlaceTheSpeedTurnsRound) {
  const json now = result({});
  EXPECT_NEAR(now["restitution_sqrt_C"], 1, 1e-3);  // an elastic pad
  EXPECT_NEAR(now["bodies"][0]["velocity_after_m_per_s"], -3, 3e-3);
  EXPECT_EQ(now["bodies"][1]["velocity_after_m_per_s"], 0);
  EXPECT_TRUE(now["bodies"][1]["mass_kg"].is_null());
}

TEST_F(PostImpactTest, TwoFreeBodiesKeepTheirMomentumAndEqualOnesSwapVelocities) {
  const json now = result({"--other-mass", "5 kg", "--other-velocity", "1 m/s"});
  EXPECT_NEAR(now["bodies"][0]["velocity_after_m_per_s"], 1, 2e-3);
  EXPECT_NEAR(now["bodies"][1]["velocity_after_m_per_s"], 3, 2e-3);
  EXPECT_NEAR(now["solved_as"]["mass_kg"], 2.5, 1e-12);
  EXPECT_NEAR(now["solved_as"]["speed_m_per_s"], 2, 1e-12);
  EXPECT_NEAR(now["available_energy_J"], 5, 1e-9);
}

TEST_F(PostImpactTest, TheEnergyOfBothMomentsIsThatOfTheImpact) {
  const json now = result({});
  const json& peak = now["at_peak_force"];
  const json& end = now["at_the_end"];
  const double impact = 0.5 * 5 * 9;
  EXPECT_NEAR(double(peak["kinetic_J"]) + double(peak["support_J"]) + double(peak["pad_J"]), impact, 1e-6);
  EXPECT_NEAR(double(end["rebound_J"]) + double(end["support_J"]) + double(end["pad_J"]), impact,
              1e-3 * impact);
}

TEST_F(PostImpactTest, SaysThatCMultipliesEnergy) {
  const Outcome outcome = dashpad({"post-impact", file("case.toml")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("C multiplies an energy"));
}

TEST_F(PostImpactTest, HasAPageAndMarkdown) {
  const Outcome outcome = dashpad({"post-impact", file("case.toml"), "--other-mass", "5 kg", "--report",
                                   file("page.html"), "--markdown", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex("^# Afterwards, the impactor moves at .* and the other body at "));
  EXPECT_THAT(outcome.out, testing::ContainsRegex("\\| Absorbed by the pad \\| .* J \\| .* % \\|"));
  EXPECT_THAT(read_file(file("page.html")), HasSubstr("Energy balance"));
}

TEST_F(PostImpactTest, RefusesWhatCannotBeTwoBodiesThatApproach) {
  for (const std::vector<std::string>& more : {std::vector<std::string>{"--other-mass", "0 kg"},
                                               {"--other-mass", "-3 kg"},
                                               {"--other-mass", "3 m"},
                                               {"--other-velocity", "3 m/s"},
                                               {"--other-velocity", "20 mph"},
                                               {"--other-velocity", "nan m/s"}}) {
    std::vector<std::string> arguments{"post-impact", file("case.toml")};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << more[1];
    EXPECT_THAT(outcome.err, HasSubstr(more[0]));
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(PostImpactTest, RefusesRepeatedBlows) {
  const Outcome outcome =
      dashpad({"post-impact", DASHPAD_SOURCE_DIR "/examples/playground-three-drops.toml"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("blows: the two bodies collide only once"));
}

TEST_F(PostImpactTest, KeepsAnExistingFile) {
  write_file(file("out.json"), "mine");
  EXPECT_EQ(dashpad({"post-impact", file("case.toml"), "--json", file("out.json")}).exit_code, 2);
  EXPECT_EQ(read_file(file("out.json")), "mine");
  EXPECT_EQ(dashpad({"post-impact", file("case.toml"), "--json", file("out.json"), "--force"}).exit_code, 0);
  EXPECT_TRUE(json::accept(read_file(file("out.json"))));
}

}  // namespace
}  // namespace dashpad::test
