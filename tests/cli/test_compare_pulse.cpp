// dashpad compare --pulse: a measured pulse over a case, its files, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <regex>

#include "command.hpp"
#include "schema.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A triangle of `peak` g: from 2 to 12 ms, its peak at 6 ms.
std::string triangle_of(double peak, const std::string& header = "time_ms,acc_g\n") {
  std::string text = header;
  for (int i = 0; i <= 200; ++i) {
    const double rising = (i - 20) / 40.0, falling = (120 - i) / 60.0;
    const double value = std::max(0.0, std::min(rising, falling));
    text += std::to_string(0.1 * i) + "," + std::to_string(peak * value) + "\n";
  }
  return text;
}

class ComparePulseTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("drop.csv"), triangle_of(40));
  }
  Outcome compare(const std::string& pulse, std::vector<std::string> more = {}) {
    more.insert(more.begin(), {"compare", case_file(), "--pulse", pulse});
    return dashpad(more);
  }
  json compared(const std::string& pulse, std::vector<std::string> more = {}) {
    more.insert(more.end(), {"--json", "-"});
    const Outcome outcome = compare(pulse, more);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    json result = json::parse(outcome.out);
    EXPECT_EQ(schema_faults(result, "pulse-comparison"), "");
    return result;
  }
  /// What is said to a pulse that is refused; nothing may be written.
  std::string refused(const std::string& text, std::vector<std::string> more = {}) {
    write_file(file("bad.csv"), text);
    const auto before = other_files();
    more.insert(more.end(), {"--json", file("never.json")});
    const Outcome outcome = compare(file("bad.csv"), more);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(other_files(), before);
    EXPECT_THAT(outcome.err, HasSubstr("1 error; nothing was run"));
    return outcome.err;
  }
};

double value_at(const json& result, const char* key, const char* part) {
  return result.at("figures").at(key).at(part).get<double>();
}

TEST_F(ComparePulseTest, AnswersInWordsThenShowsFiguresAndWhatTheyRestOn) {
  const Outcome outcome = compare(file("drop.csv"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(
      outcome.out,
      AllOf(StartsWith("The computed peak is "), HasSubstr("; HIC15 is "),
            ContainsRegex("\n  Peak acceleration +-34 % +26[.][0-9]+ g computed.*, 40[.]00 g\\s+measured\n"),
            HasSubstr("\n  Time to peak "),
            ContainsRegex("\n  Width at half peak .* computed.*, 5[.]000 ms measured\n"),
            HasSubstr("\n  Velocity change "), HasSubstr("\n  HIC15 "), HasSubstr("\n  Restitution "),
            HasSubstr("Aligned at the onset, where each pulse first reaches 5 % of its peak"),
            ContainsRegex("Impactor +a sphere of mass 5 kg"), HasSubstr("drop.csv (CSV) compared with "),
            HasSubstr("Acceleration  acc_g in g (from the file)")));
  EXPECT_TRUE(other_files() == std::vector<std::string>{"drop.csv"});
}

TEST_F(ComparePulseTest, SaysWhetherTheMeasuredPeakLiesInTheIntervalOfTheComputed) {
  const std::vector<std::string> command{"compare", examples + "helmet-pad-10fps.toml", "--pulse",
                                         examples + "pulses/synthetic-helmet-pad.csv"};
  const std::string said = std::regex_replace(dashpad(command).out, std::regex("\n +"), " ");
  EXPECT_THAT(said,
              AllOf(HasSubstr(" The measured peak lies outside the 95 % interval of the computed one.\n"),
                    ContainsRegex("Peak acceleration .* g computed \\([0-9.]+ to [0-9.]+ g at 95 %\\), 32")));
}

TEST_F(ComparePulseTest, FiguresAreThoseOfRunAndOfPulse) {
  const json result = compared(file("drop.csv"));
  const json run = json::parse(dashpad({"run", case_file(), "--json", "-"}).out);
  const json pulse = json::parse(dashpad({"pulse", file("drop.csv"), "--json", "-"}).out).at("figures");
  EXPECT_DOUBLE_EQ(value_at(result, "peak_acceleration", "computed_g"), run.at("peak_acceleration_g"));
  EXPECT_NEAR(value_at(result, "hic15", "computed") / run["injury"]["hic15"]["value"].get<double>(), 1, 1e-4);
  EXPECT_EQ(value_at(result, "hic15", "measured"), pulse.at("hic15").at("value"));
  EXPECT_NEAR(value_at(result, "time_to_peak", "measured_s"), 0.95 * 4e-3, 1e-9);
  EXPECT_NEAR(value_at(result, "velocity_change", "measured_m_per_s"), 40 * 9.80665 * 5e-3, 1e-6);
  EXPECT_NEAR(value_at(result, "peak_acceleration", "difference_share"),
              run.at("peak_acceleration_g").get<double>() / 40 - 1, 1e-9);
}

TEST_F(ComparePulseTest, ARunOverItselfShowsNoDifference) {
  ASSERT_EQ(dashpad({"run", case_file(), "--csv", file("run.csv")}).exit_code, 0);
  const json result = compared(file("run.csv"));
  for (const auto& [key, figure] : result.at("figures").items())
    EXPECT_NEAR(figure.at("difference_share").get<double>(), 0, key == "time_to_peak" ? 1e-2 : 1e-4) << key;
  EXPECT_NEAR(result.at("alignment").at("shift_s").get<double>(), 0, 1e-8);
  EXPECT_THAT(
      result.at("answer").get<std::string>(),
      AllOf(HasSubstr("The computed peak is within 0.5 % of the measured one"), HasSubstr("HIC15 agrees")));
}

TEST_F(ComparePulseTest, AlignsAsAskedFor) {
  const double onset = compared(file("drop.csv"))["alignment"]["shift_s"];
  const double peak = compared(file("drop.csv"), {"--align", "peak"})["alignment"]["shift_s"];
  const json none = compared(file("drop.csv"), {"--align", "none"});
  EXPECT_NE(onset, peak);
  EXPECT_EQ(none["alignment"]["shift_s"], 0);
  EXPECT_NEAR(value_at(none, "time_to_peak", "measured_s"), 6e-3, 1e-12);
  EXPECT_EQ(compare(file("drop.csv"), {"--align", "middle"}).exit_code, 2);
}

TEST_F(ComparePulseTest, TakesTheOptionsOfPulse) {
  write_file(file("bare.csv"), triangle_of(40, ""));
  const std::vector<std::string> options{
      "--time", "1",        "--acceleration", "2",          "--time-unit", "ms",      "--acceleration-unit",
      "m/s2",   "--filter", "CFC180",         "--resample", "0.1 ms",      "--speed", "0.2 m/s"};
  const json result = compared(file("bare.csv"), options);
  EXPECT_LT(value_at(result, "peak_acceleration", "measured_g"), 40 / 9.80665);
  EXPECT_THAT(result["pulse"]["filter"].get<std::string>(), StartsWith("CFC180"));
  EXPECT_EQ(result["pulse"]["speed_m_per_s"], 0.2);
  EXPECT_NEAR(value_at(result, "restitution", "measured"), 0, 1e-2);
  EXPECT_LT(value_at(result, "peak_acceleration", "computed_g"),
            value_at(compared(file("drop.csv")), "peak_acceleration", "computed_g"));
  for (const char* option : {"--filter", "--align", "--zero"})
    EXPECT_THAT(
        dashpad({"compare", case_file(), option, option == std::string{"--align"} ? "peak" : "CFC60"}).err,
        HasSubstr("requires --pulse"));
  EXPECT_THAT(compare(file("drop.csv"), {"--time-step", "0.1"}).err,
              HasSubstr("--time-step excludes --pulse"));
}

TEST_F(ComparePulseTest, SaysWhatToBewareOf) {
  write_file(file("cut.csv"), "time_ms,acc_g\n0,1\n5,40\n10,10\n");
  const json pulse = compared(file("cut.csv"))["pulse"];
  std::vector<std::string> names;
  for (const json& flag : pulse["flags"]) names.push_back(flag["name"]);
  EXPECT_THAT(names, testing::UnorderedElementsAre("PULSE CUT", "PULSE CUT", "IMPOSSIBLE VELOCITY CHANGE"));
  EXPECT_THAT(compare(file("cut.csv")).out, HasSubstr("PULSE CUT: the pulse ends at 10 g"));
  const Outcome bottomed =
      dashpad({"compare", examples + "rigid-floor-bottoming.toml", "--pulse", file("drop.csv")});
  EXPECT_EQ(bottomed.exit_code, 0) << bottomed.err;
  EXPECT_THAT(bottomed.out, AllOf(StartsWith("The computed pulse is incomplete and cannot be compared."),
                                  HasSubstr("BOTTOMED at ")));
}

/// The case strikes at 3 m/s.
TEST_F(ComparePulseTest, SaysWhenCaseAndPulseAreOfUnlikeImpacts) {
  const auto names = [&](const std::string& speed) {
    std::vector<std::string> all;
    const json result = compared(file("drop.csv"), {"--speed", speed});
    for (const json& flag : result["pulse"]["flags"])
      if (flag["name"] != "IMPOSSIBLE VELOCITY CHANGE") all.push_back(flag["name"]);
    return all;
  };
  EXPECT_TRUE(names("3.02 m/s").empty());
  EXPECT_THAT(names("3.04 m/s"), testing::ElementsAre("UNLIKE SPEEDS"));
  const Outcome outcome = compare(file("drop.csv"), {"--drop-height", "0.8 m"});
  EXPECT_THAT(
      outcome.out,
      AllOf(ContainsRegex("But\\s+the\\s+impact\\s+speed\\s+in\\s+the\\s+case\\s+is\\s+24 %\\s+lower[.]\n"),
            HasSubstr("UNLIKE SPEEDS: the impact speed in the case, 3 m/s, is 24 % lower than")));
  EXPECT_THAT(compare(file("drop.csv")).out,
              AllOf(Not(ContainsRegex("But\\s+the\\s+impact")), Not(HasSubstr("UNLIKE"))));
}

TEST_F(ComparePulseTest, RefusesAPulseWithoutATriggerOrWithFaults) {
  EXPECT_THAT(refused(triangle_of(0)), HasSubstr("its acceleration is 0 throughout"));
  const std::string late = "time_ms,acc_g\n0,4\n5,40\n10,0\n";
  EXPECT_THAT(refused(late), HasSubstr("--pulse " + file("bad.csv") +
                                       ": its first sample is already above 5 % of its peak"));
  EXPECT_EQ(compare(file("bad.csv"), {"--align", "peak"}).exit_code, 0);
  EXPECT_THAT(refused("time_ms,acc_g\n0,0\n1,nan\n2,40\n3,0\n"), HasSubstr("bad.csv:3: acc_g = nan"));
  EXPECT_THAT(refused("time_ms,acc_g\n0,0\n2,40\n1,20\n3,0\n"),
              HasSubstr("bad.csv:4: time_ms = 1: is earlier"));
  EXPECT_THAT(refused("time_ms,ax_g,ay_g\n0,0,0\n1,30,40\n2,0,0\n"), HasSubstr("--acceleration"));
  EXPECT_THAT(compare(file("missing.csv")).err, HasSubstr("missing.csv: no such file"));
  EXPECT_THAT(compare("").err, HasSubstr("--pulse: must not be empty"));
}

TEST_F(ComparePulseTest, FaultsOfCaseAndPulseAreToldTogether) {
  write_file(file("bad.toml"), with(elastic_case(), "80 mm", "80 kg"));
  EXPECT_THAT(dashpad({"compare", file("bad.toml"), "--pulse", file("missing.csv"), "--align", "peak"}).err,
              AllOf(HasSubstr("impactor.radius"), HasSubstr("missing.csv"), HasSubstr("2 errors")));
}

TEST_F(ComparePulseTest, KeepsThePulseAndTheCase) {
  for (const auto& [name, kind] : {std::pair{"drop.csv", "the measurement"}, {"case.toml", "the case file"}})
    EXPECT_THAT(compare(file("drop.csv"), {"--force", "--json", file(name)}).err,
                HasSubstr(file(name) + ": is " + kind + "; choose another name"));
  EXPECT_EQ(read_file(file("drop.csv")), triangle_of(40));
}

TEST_F(ComparePulseTest, WritesAPageAndAPicture) {
  ASSERT_EQ(compare(file("drop.csv"), {"--report", file("page.html")}).exit_code, 0);
  EXPECT_THAT(read_file(file("page.html")),
              AllOf(HasSubstr("<title>The computed peak is "), HasSubstr("data-label=\"measured\""),
                    HasSubstr("data-label=\"computed\""), HasSubstr("Width at half peak")));
  ASSERT_EQ(compare(file("drop.csv"), {"--picture", file("a.svg"), "--units", "us"}).exit_code, 0);
  EXPECT_THAT(read_file(file("a.svg")), AllOf(HasSubstr(">Deceleration (g)<"), HasSubstr("measured"),
                                              HasSubstr("computed"), Not(HasSubstr("1984"))));
}

}  // namespace
}  // namespace dashpad::test
