// dashpad pulse with the limits of a standard, and with several pulses.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

/// A half sine of 10 ms with a sample every 0.1 ms, from 5 ms before it to 5 ms after it.
std::string half_sine_of(double peak) {
  std::string text = "time [ms],acceleration [g]\n";
  for (int i = -50; i <= 150; ++i)
    text +=
        fmt::format("{},{}\n", 0.1 * i, i < 0 || i > 100 ? 0 : peak * std::sin(std::numbers::pi * i / 100));
  return text;
}

/// Limits of the peak and of the time above 60 g; the impactor is anybody's.
std::string limits(const std::string& peak_limit, const std::string& time_in_ms = "9") {
  const std::string origin = "source = \"a test\"\nkind = \"own text\"\nverified = true\n";
  std::string text = "title = \"Two limits\"\nsource = \"a test\"\nkind = \"own text\"\n";
  for (const char* value : {"mass", "radius", "speed"})
    text += fmt::format("[{}]\nfrom_case = true\n{}", value, origin);
  text += "[[criteria]]\nmetric = \"peak_acceleration\"\nlimit_g = " + peak_limit +
          "\ndescription = \"none above\"\n" + origin;
  return text + "[[criteria]]\nmetric = \"dwell_time\"\nlevel_g = 60\nlimit = \"" + time_in_ms + " ms\"" +
         "\ndescription = \"not for longer\"\n" + origin;
}

class PulsesTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("low.csv"), half_sine_of(80));
    write_file(file("high.csv"), half_sine_of(120));
    write_file(file("limits.toml"), limits("100"));
  }
  Outcome pulses(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "pulse");
    return dashpad(arguments);
  }
  json judged(const std::string& pulse) {
    const Outcome outcome = pulses({file(pulse), "--standard", file("limits.toml"), "--json", "-"});
    EXPECT_THAT(outcome.exit_code, testing::AnyOf(0, 3, 4)) << outcome.err;
    return json::parse(outcome.out);
  }
};

/// A half sine of peak p is above 60 g for (pi - 2 arcsin(60 / p)) / pi of its 10 ms.
TEST_F(PulsesTest, AStandardsLimitsStandBesideTheFigures) {
  const json low = judged("low.csv");
  EXPECT_EQ(low["verdict"], "pass");
  EXPECT_EQ(low["criteria"][0]["metric"], "peak_acceleration");
  EXPECT_NEAR(low["criteria"][0]["value"], 80, 1e-9);
  EXPECT_NEAR(low["criteria"][0]["margin"], 20, 1e-9);
  EXPECT_NEAR(low["criteria"][1]["value"], 10e-3 * (1 - 2 * std::asin(0.75) / std::numbers::pi), 1e-5);
  EXPECT_EQ(judged("high.csv")["verdict"], "fail");
  EXPECT_EQ(judged("high.csv")["criteria"][1]["verdict"], "pass");

  const Outcome outcome = pulses({file("high.csv"), "--standard", file("limits.toml"), "--position", "centre",
                                  "--date", "26 November", "--drop-height", "0.5 m"});
  EXPECT_EQ(outcome.exit_code, 4);
  EXPECT_THAT(
      outcome.out,
      AllOf(StartsWith("Fails: peak acceleration is 120 g, but must be at most 100 g\n"),
            HasSubstr("Impact at 3.1316 m/s, after a fall of 500 mm. Position: centre. Date: 26 November.\n"),
            HasSubstr("Limits of Two limits\n"),
            ContainsRegex("Peak acceleration +120 g +at most 100 g +fail by 20 g"),
            HasSubstr("nothing is certified")));
}

/// The calibration alone makes the limit lie within what the measurement leaves open.
TEST_F(PulsesTest, ALimitWithinTheUncertaintyIsUndecided) {
  write_file(file("limits.toml"), limits("81"));
  EXPECT_EQ(pulses({file("low.csv"), "--standard", file("limits.toml")}).exit_code, 0);
  const Outcome outcome =
      pulses({file("low.csv"), "--standard", file("limits.toml"), "--calibration", "2 %"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("Undecided: peak acceleration is 1 g from its limit\n"),
                    ContainsRegex("the limit lies\\s+within the uncertainty of the\\s+measurement")));
}

TEST_F(PulsesTest, ACutPulseIsALowerBound) {
  std::string cut = half_sine_of(80);
  cut.resize(cut.find("\n7,") + 1);
  write_file(file("low.csv"), cut);
  const json judgement = judged("low.csv");
  EXPECT_EQ(judgement["verdict"], "undecided");
  EXPECT_EQ(judgement["criteria"][0]["lower_bound"], true);
  EXPECT_TRUE(judgement["criteria"][0]["margin"].is_null());  // what is left of the limit is none
  EXPECT_THAT(pulses({file("low.csv"), "--standard", file("limits.toml")}).out,
              StartsWith("Undecided: the pulse is cut off, so its figures are lower bounds\n"));
}

TEST_F(PulsesTest, SeveralStandOnOnePageWithMeanAndDeviation) {
  const Outcome outcome = pulses({file("low.csv"), file("high.csv"), "--standard", file("limits.toml"),
                                  "--json", file("both.json"), "--report", file("both.html"), "--markdown",
                                  file("both.md"), "--picture", file("both.svg")});
  EXPECT_EQ(outcome.exit_code, 4) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      AllOf(StartsWith(
                "1 of 2 pulses within the limits: peak acceleration 80 to 120 g (must be at most 100 g)\n"),
            ContainsRegex("Mean +100 g"), ContainsRegex("Standard deviation +28 g")));
  const json both = json::parse(read_file(file("both.json")));
  ASSERT_EQ(both.size(), 2U);
  EXPECT_EQ(both[1]["source"]["file"], file("high.csv"));
  EXPECT_EQ(both[0]["figures"],
            json::parse(
                pulses({file("low.csv"), "--standard", file("limits.toml"), "--json", "-"}).out)["figures"]);
  EXPECT_THAT(read_file(file("both.md")), HasSubstr("| Pulse | Peak acceleration | 3 ms clip | HIC15 |"));
  EXPECT_THAT(read_file(file("both.html")), HasSubstr("Accelerations, each from the start of contact"));
  EXPECT_THAT(read_file(file("both.svg")), HasSubstr("high.csv"));
}

TEST_F(PulsesTest, FaultsOfAllFilesAreToldAtOnce) {
  write_file(file("bad.csv"), "time [ms],acceleration [g]\n0,1\n1,x\n");
  const Outcome outcome =
      pulses({file("bad.csv"), file("none.csv"), file("low.csv"), "--csv", file("out.csv"), "--standard",
              "en-1079", "--window", "-1", "--json", file("out.json")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("bad.csv:3"), HasSubstr("none.csv"), HasSubstr("--csv: accepts only one pulse"),
                    HasSubstr("did you mean"), HasSubstr("--window -1")));
  EXPECT_EQ(outcome.err.find("--window -1"), outcome.err.rfind("--window -1"));
  EXPECT_FALSE(fs::exists(file("out.json")));
  // The standard is a file of the user's, too.
  const Outcome over =
      pulses({file("low.csv"), "--standard", file("limits.toml"), "--json", file("limits.toml"), "--force"});
  EXPECT_EQ(over.exit_code, 2);
  EXPECT_EQ(read_file(file("limits.toml")), limits("100"));
  EXPECT_EQ(pulses({"-", "-"}).exit_code, 2);
  EXPECT_EQ(pulses({file("low.csv"), file("high.csv"), "--list"}).exit_code, 2);
}

}  // namespace
}  // namespace dashpad::test
