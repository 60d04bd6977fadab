// dashpad solve-for: where a verdict turns.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

class SolveForTest : public CommandTest {};

json answer_of(const std::vector<std::string>& more, int exit_code = 0) {
  std::vector<std::string> arguments{"solve-for", "pad.thickness", examples + "disc-on-mat.toml", "--json",
                                     "-"};
  arguments.insert(arguments.end(), more.begin(), more.end());
  const Outcome outcome = dashpad(arguments);
  EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
  return json::parse(outcome.out);
}

TEST_F(SolveForTest, TheThicknessThatItGivesHasTheLimit) {
  const json answer = answer_of({"--until", "peak_acceleration <= 100 g"});
  ASSERT_EQ(answer["turns"].size(), 1u);
  const double thickness = answer["turns"][0]["value"];
  EXPECT_LT(answer["turns"][0]["low"], thickness);
  EXPECT_GT(answer["turns"][0]["high"], thickness);
  EXPECT_THAT(std::string(answer["answer"]), StartsWith("Passes if the thickness of the pad is at least "));
  const json run = json::parse(dashpad({"run", examples + "disc-on-mat.toml", "--set",
                                        "pad.thickness=" + std::to_string(thickness) + " m", "--json", "-"})
                                   .out);
  EXPECT_NEAR(run["peak_acceleration_g"], 100, 0.1);
}

TEST_F(SolveForTest, AnAimIsAskedForByAnEqualSign) {
  const json answer = answer_of({"--until", "hic15 = 100"});
  EXPECT_THAT(std::string(answer["answer"]), StartsWith("HIC15 is 100 if the thickness of the pad is "));
  EXPECT_THAT(std::string(answer_of({"--until", "hic15 = 1e5"}, 4)["answer"]),
              AllOf(HasSubstr("for any thickness of the pad between"), HasSubstr("the nearest is")));
}

TEST_F(SolveForTest, WithoutAnAnswerItSaysHowNearOneComes) {
  const json answer = answer_of({"--until", "peak_acceleration <= 5 g"}, 4);
  EXPECT_TRUE(answer["turns"].empty());
  EXPECT_FALSE(answer["nearest"].is_null());
  EXPECT_THAT(std::string(answer["answer"]),
              StartsWith("Does not pass for any thickness of the pad between"));
}

TEST_F(SolveForTest, TellsOfASpikeThatTheClipDoesNotSee) {
  const auto answer_with = [](const char* example, std::vector<std::string> limits) {
    std::vector<std::string> arguments{"solve-for",      "pad.thickness", examples + example,
                                       "--no-intervals", "--json",        "-"};
    arguments.insert(arguments.end(), limits.begin(), limits.end());
    return json::parse(dashpad(arguments).out);
  };
  const auto has_spike = [](const json& answer) {
    return std::ranges::any_of(answer["flags"],
                               [](const json& flag) { return flag["name"] == "SHORT SPIKE"; });
  };
  const json answer = answer_with("helmet-pad-10fps.toml", {"--until", "clip_3ms <= 45 g"});
  EXPECT_THAT(std::string(answer["answer"]),
              AllOf(StartsWith("Passes if "), HasSubstr("; a spike may go unseen from "),
                    HasSubstr("beyond the tests of its foam, with a peak of "),
                    HasSubstr(" g too short for the 3 ms clip to see")));
  EXPECT_TRUE(has_spike(answer));
  // A limit on the peak of the same impact sees it.
  const json seen = answer_with("helmet-pad-10fps.toml",
                                {"--until", "clip_3ms <= 45 g", "--until", "peak_acceleration <= 500 g"});
  EXPECT_THAT(std::string(seen["answer"]), AllOf(StartsWith("Passes if "), Not(HasSubstr("spike"))));
  EXPECT_FALSE(has_spike(seen));
  // On a soft support the pulse is smooth, and its peak hardly above its clip.
  EXPECT_FALSE(has_spike(answer_with("dashboard-20mph.toml", {"--standard", "fmvss-201-instrument-panel"})));
}

TEST_F(SolveForTest, DrawsGiveAProbability) {
  const json answer = answer_of({"--until", "peak_acceleration <= 100 g", "--probability", "90 %", "--vary",
                                 "pad.scale=5 %", "--vary", "impactor.speed=2 %", "--draws", "256"});
  EXPECT_THAT(std::string(answer["answer"]),
              StartsWith("Passes with a probability of 90 % if the thickness"));
  const json nominal = answer_of({"--until", "peak_acceleration <= 100 g", "--no-intervals"});
  EXPECT_GT(answer["turns"][0]["value"], nominal["turns"][0]["value"]);
  EXPECT_LE(answer["turns"][0]["low"], answer["turns"][0]["value"]);
  EXPECT_EQ(answer["contributors"].size(), 2u);
  // The same draws each time.
  const json again = answer_of({"--until", "peak_acceleration <= 100 g", "--probability", "90 %", "--vary",
                                "pad.scale=5 %", "--vary", "impactor.speed=2 %", "--draws", "256"});
  EXPECT_EQ(answer["turns"], again["turns"]);
}

TEST_F(SolveForTest, DrawsFindANarrowWindow) {
  // Between what the acceleration and what the penetration allows, narrower than any first step.
  const json answer =
      answer_of({"--until", "peak_acceleration <= 100 g", "--until", "peak_penetration <= 12.5 mm", "--vary",
                 "impactor.speed=2 %", "--draws", "256", "--between", "10 mm..30 mm"},
                3);
  ASSERT_EQ(answer["turns"].size(), 2u);
  EXPECT_NEAR(answer["turns"][0]["value"], 0.02203, 2e-5);
  EXPECT_NEAR(answer["turns"][1]["value"], 0.02211, 2e-5);
}

TEST_F(SolveForTest, TooFewDrawsBoundNothing) {
  const json answer = answer_of({"--until", "peak_acceleration <= 100 g", "--vary", "impactor.speed=5 %",
                                 "--probability", "99.9 %", "--draws", "64"},
                                3);
  EXPECT_FALSE(answer["turns"][0]["low"].is_null());
  EXPECT_TRUE(answer["turns"][0]["high"].is_null());
}

TEST_F(SolveForTest, WhatHasNoFigureDoesNotPass) {
  const Outcome outcome = dashpad({"solve-for", "pad.scale", examples + "rigid-floor-bottoming.toml",
                                   "--until", "restitution >= 0.5", "--between", "0.1..20"});
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("Passes if the factor applied to the foam's stress is at least 2.33"),
                    HasSubstr("it has no verdict from 0.1 to 2.33")));
}

TEST_F(SolveForTest, WhatHasNoIntervalIsNotCertain) {
  const json answer = answer_of({"--until", "contact_end <= 15 ms"});
  EXPECT_THAT(std::string(answer["answer"]), testing::Not(HasSubstr("certain")));
  EXPECT_TRUE(answer["turns"][0]["low"].is_null());
  EXPECT_EQ(answer["flags"][0]["name"], "NO INTERVALS");
}

TEST_F(SolveForTest, AHeightIsThatOfACaseThatStatesIt) {
  const json answer = json::parse(dashpad({"solve-for", "impactor.drop_height", examples + "disc-on-mat.toml",
                                           "--until", "hic15 <= 1000", "--no-intervals", "--json", "-"})
                                      .out);
  const double height = answer["turns"][0]["value"];
  const json run =
      json::parse(dashpad({"run", examples + "disc-on-mat.toml", "--set",
                           "impactor.drop_height=" + std::to_string(height) + " m", "--json", "-"})
                      .out);
  EXPECT_NEAR(run["injury"]["hic15"]["value"], 1000, 1);
}

TEST_F(SolveForTest, AStandardBringsItsImpactor) {
  const Outcome outcome =
      dashpad({"solve-for", "pad.thickness", nine, "--standard", "fmvss-201-instrument-panel"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("Standard: FMVSS 201"), HasSubstr("3 ms clip"), HasSubstr("Over the range")));
  const Outcome speed =
      dashpad({"solve-for", "impactor.speed", nine, "--standard", "fmvss-201-instrument-panel"});
  EXPECT_THAT(speed.out, HasSubstr("REPLACED: the speed is not that of the standard"));
}

TEST_F(SolveForTest, WritesEveryFile) {
  const Outcome outcome = dashpad({"solve-for", "pad.thickness", nine, "--until", "hic15 <= 1600", "--json",
                                   file("a.json"), "--csv", file("a.csv"), "--picture", file("a.svg"),
                                   "--report", file("a.html"), "--markdown", file("a.md")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_file(file("a.csv")), StartsWith("pad.thickness [m],hic15,share_of_limit,"));
  EXPECT_THAT(read_file(file("a.svg")), HasSubstr("Share of the limit (%)"));
  EXPECT_THAT(read_file(file("a.html")), HasSubstr("Passes if the thickness of the pad"));
  EXPECT_THAT(read_file(file("a.md")), HasSubstr("Passes if the thickness of the pad"));
}

/// Commands of documents that are shown with their answer give it.
TEST_F(SolveForTest, TheDocumentsShowItsAnswers) {
  int shown = 0;
  for (const char* document : {"README.md", "docs/solve-for.md"}) {
    std::istringstream text(read_file(fs::path(DASHPAD_SOURCE_DIR) / document));
    for (std::string line; std::getline(text, line);) {
      if (!line.starts_with("$ dashpad solve-for ")) continue;
      std::string answer;
      std::getline(text, answer);
      const Outcome outcome = shell(std::string("cd ") + DASHPAD_SOURCE_DIR + " && $DASHPAD" +
                                    line.substr(std::string("$ dashpad").size()));
      EXPECT_THAT(outcome.out, StartsWith(answer + "\n")) << line;
      ++shown;
    }
  }
  EXPECT_GE(shown, 2);
}

TEST_F(SolveForTest, BadQuestionsAreRefusedAllAtOnce) {
  const Outcome outcome =
      dashpad({"solve-for", "pad.thicknes", nine, "--until", "hic16 <= 3", "--until", "hic15 ~ 3", "--until",
               "hic15 <= 0", "--between", "3 mm", "--probability", "95 %"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("did you mean \"pad.thickness\""), HasSubstr("hic16"), HasSubstr("hic15 ~ 3"),
                    HasSubstr("must not be 0"), HasSubstr("needs --vary"), HasSubstr("nothing was run")));
  for (const auto& [arguments, message] : std::vector<std::pair<std::vector<std::string>, std::string>>{
           {{"pad.thickness"}, "no limit: give --standard or --until"},
           {{"pad.thickness", "--until", "hic15 <= 700", "--between", "30 mm..20 mm"},
            "must begin below its end"},
           {{"pad.thickness", "--until", "hic15 <= 700", "--between", "-1 mm..20 mm"}, "pad.thickness"},
           {{"pad.thickness", "--until", "hic15 <= 700", "--vary", "pad.scale=five"},
            "is not a valid scatter"},
           {{"pad.thickness", "--until", "hic15 <= 700", "--vary", "pad.thickness=5 %"},
            "cannot also be drawn"},
           {{"pad.thickness", "--until", "hic15 = 700", "--until", "peak_acceleration <= 100 g"},
            "asks where one figure has a value"},
           {{"pad.thickness", "--until", "hic15 <= 700", "--draws", "100"}, "--draws: needs --vary"},
           {{"pad.thickness", "--until", "hic15 <= -7"}, "never below 0"},
           {{"pad.material", "--until", "hic15 <= 700"}, "pad.material"},
           {{"impactor.gravity", "--until", "hic15 <= 700"}, "--between"}}) {
    std::vector<std::string> all{"solve-for", arguments.front(), nine};
    all.insert(all.end(), arguments.begin() + 1, arguments.end());
    const Outcome refused = dashpad(all);
    EXPECT_EQ(refused.exit_code, 2) << message;
    EXPECT_THAT(refused.err, HasSubstr(message));
    EXPECT_EQ(refused.out, "");
  }
}

}  // namespace
}  // namespace dashpad::test
