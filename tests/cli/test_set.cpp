// --set: values in place of those of the case file.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <regex>

#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class SetTest : public CommandTest {
 protected:
  const std::string helmet = examples + "helmet-pad-10fps.toml";

  std::string text_of(const std::string& name) {
    std::ifstream stream(name);
    return {std::istreambuf_iterator<char>(stream), {}};
  }
  /// What a case comes to with these settings, all in SI.
  nlohmann::json result(const std::string& name, const std::vector<std::string>& settings) {
    std::vector<std::string> arguments{"run", name, "--no-intervals", "--json", "-"};
    for (const std::string& setting : settings) arguments.insert(arguments.end(), {"--set", setting});
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return nlohmann::json::parse(outcome.out);
  }
  std::string complaint(const std::string& name, const std::string& setting) {
    const Outcome outcome = dashpad({"run", name, "--set", setting});
    EXPECT_EQ(outcome.exit_code, 2) << setting;
    EXPECT_EQ(outcome.out, "") << setting;
    return outcome.err;
  }
};

TEST_F(SetTest, IsTheSameAsAnEditedFile) {
  const std::string edited =
      std::regex_replace(text_of(helmet), std::regex("thickness = \"[^\"]*\""), "thickness = \"30 mm\"");
  ASSERT_NE(edited, text_of(helmet));
  write_file(file("edited.toml"), edited);
  const nlohmann::json set = result(helmet, {"pad.thickness=30 mm"});
  EXPECT_EQ(set.at("peak_force_N"), result(file("edited.toml"), {}).at("peak_force_N"));
  EXPECT_NE(set.at("peak_force_N"), result(helmet, {}).at("peak_force_N"));
}

TEST_F(SetTest, TakesThePlaceOfWhatItExcludes) {
  const double speed = std::sqrt(2 * 9.80665 * 1);
  EXPECT_NEAR(result(helmet, {"impactor.drop_height=1 m"}).at("case").at("impactor").at("speed_m_per_s"),
              speed, 1e-12);
  EXPECT_NEAR(result(helmet, {"impactor.weight=98.0665 N"}).at("case").at("impactor").at("mass_kg"), 10,
              1e-12);
}

TEST_F(SetTest, ReachesTheNumbersOfACardAndSaysSo) {
  const Outcome outcome = dashpad({"run", helmet, "--no-intervals", "--set", "pad.parameters.friction=0.3"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("team-wendy-hard-pu with friction = 0.3"));
  EXPECT_LT(result(helmet, {"pad.parameters.friction=0.3"}).at("rebound_speed_m_per_s"),
            result(helmet, {}).at("rebound_speed_m_per_s"));
}

TEST_F(SetTest, ReachesALayer) {
  const std::string mat = examples + "playground-mat-in-layers.toml";
  EXPECT_NE(result(mat, {"pad.layers[2].thickness=30 mm"}).at("peak_force_N"),
            result(mat, {}).at("peak_force_N"));
  EXPECT_THAT(complaint(mat, "pad.layers[9].thickness=30 mm"),
              HasSubstr("there is no such entry; the last is number 2"));
}

TEST_F(SetTest, FaultsAreThoseOfTheOption) {
  for (const auto& [setting, words] : std::vector<std::pair<std::string, std::string>>{
           {"pad.thickness=30 furlong", R"(--set: pad.thickness = "30 furlong": unknown unit)"},
           {"pad.thicknes=30 mm", R"(--set: pad.thicknes = "30 mm": unknown key; did you mean "thickness"?)"},
           {"impactor.speed=-3 m/s", R"(--set: impactor.speed = "-3 m/s": must be more than 0)"},
           {"pad.parameters.friction=0.9", "--set: pad.parameters.friction = 0.9: must be at least 0"},
           {"pad.parameters.frction=0.1",
            "--set: pad.parameters.frction = 0.1: is not a numeric key of this case"},
           {"pad.thickness.x=3", "--set: pad.thickness.x = 3: thickness is a value"},
           {"pad.thickness", "--set: pad.thickness must be KEY=VALUE"}})
    EXPECT_THAT(complaint(helmet, setting), AllOf(StartsWith(words), HasSubstr("1 error; nothing was run")));
}

TEST_F(SetTest, IsThereInEveryCommandThatReadsACase) {
  for (const std::vector<std::string>& arguments :
       std::vector<std::vector<std::string>>{{"check", nine},
                                             {"run", nine},
                                             {"assess", nine, "--standard", "en-1177"},
                                             {"compare", nine},
                                             {"post-impact", nine},
                                             {"export", nine, "--format", "ls-dyna", "--out", "-"},
                                             {"spit1984", nine}}) {
    std::vector<std::string> with = arguments;
    with.insert(with.end(), {"--set", "pad.thickness=1 furlong"});
    const Outcome outcome = dashpad(with);
    EXPECT_EQ(outcome.exit_code, 2) << arguments[0];
    EXPECT_THAT(outcome.err, StartsWith("--set: pad.thickness = \"1 furlong\"")) << arguments[0];
  }
}

}  // namespace
}  // namespace dashpad::test
