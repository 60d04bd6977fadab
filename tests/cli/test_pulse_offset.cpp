// dashpad pulse and what a measurement may hide: an offset of the sensor, a cut, a wrong sensitivity; and
// tables as loggers write them.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <iomanip>
#include <numbers>
#include <regex>
#include <sstream>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

/// Text without the breaks of lines that are too long for a terminal.
std::string unwrapped(const std::string& text) { return std::regex_replace(text, std::regex("\n +"), " "); }

constexpr double g = 9.80665;
constexpr double peak_in_g = 100;  // g

/// A half sine of 100 g and 10 ms from time 0 on, at 100 kHz, with an offset in g: HIC is 0.414646 of
/// peak_in_g^2.5 times the duration (docs/injury.md), the velocity change 2/pi of peak times duration.
double acceleration(double time_ms, double offset) {
  return (time_ms > 0 && time_ms < 10 ? peak_in_g * std::sin(std::numbers::pi * time_ms / 10) : 0) + offset;
}
constexpr double exact_hic = 414.646;
constexpr double exact_velocity_change = 2 / std::numbers::pi * peak_in_g * g * 10e-3;  // m/s

std::string table(double offset, double begin_ms = -8, double end_ms = 20) {
  std::string text = "time [ms],acceleration [g]\n";
  for (int i = static_cast<int>(std::lround(100 * begin_ms)); i <= std::lround(100 * end_ms); ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(acceleration(0.01 * i, offset)) + "\n";
  return text;
}

std::string with_comma(std::string text) {
  std::ranges::replace(text, '.', ',');
  return text;
}

std::string two_digits(double value) {
  std::ostringstream text;
  text << std::setprecision(2) << value;
  return text.str();
}

/// A channel of that many times the half sine from 8 ms after the first sample on.
std::string channel(const std::string& code, double factor, double offset) {
  std::string text = "Channel code :" + code + "\nUnit :g\nReference channel :implicit\n" +
                     "Time of first sample :-0.008\nSampling interval :0.00001\nNumber of samples :2801\n";
  for (int i = -800; i <= 2000; ++i)
    text += std::to_string(factor * acceleration(0.01 * i, 0) + offset) + "\n";
  return text;
}

class PulseOffsetTest : public CommandTest {
 protected:
  Outcome pulse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "pulse");
    return dashpad(arguments);
  }
  json result(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = pulse(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.exit_code == 0 ? json::parse(outcome.out) : json();
  }
  double hic15(const std::vector<std::string>& arguments) {
    return result(arguments).at("figures").at("hic15").at("value").get<double>();
  }
  std::string refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"--json", file("never.json")});
    const Outcome outcome = pulse(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_FALSE(fs::exists(file("never.json")));
    return outcome.err;
  }
  std::string written(const std::string& text) {
    write_file(file("drop.csv"), text);
    return file("drop.csv");
  }
};

TEST_F(PulseOffsetTest, SaysWhatAnOffsetDoesToHic) {
  const std::string drop = written(table(1.2));
  const Outcome outcome = pulse({drop});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const double higher = 100 * (hic15({drop}) / exact_hic - 1);
  EXPECT_GT(higher, 3);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\nQuiet part    1.2 g, the mean of "),
                                 HasSubstr("samples from -8 to -"), HasSubstr(" ms; scatter 0 g\n")));
  EXPECT_THAT(unwrapped(outcome.out),
              AllOf(HasSubstr("REMARK: there is an offset of 1.2 g before the impact: HIC15 is " +
                              two_digits(higher) +
                              " % higher with the offset than without; --zero auto subtracts it\n"),
                    Not(HasSubstr("PULSE CUT"))));
  const json offset = result({drop}).at("offset");
  EXPECT_NEAR(offset.at("mean_g").at(0).get<double>(), 1.2, 1e-9);
  EXPECT_EQ(offset.at("taken_off"), false);
  EXPECT_EQ(offset.at("interval"), "found");
  EXPECT_NEAR(offset.at("hic15_without").get<double>(), exact_hic, 1e-4 * exact_hic);
}

TEST_F(PulseOffsetTest, AWholePulseWithoutOffsetHasNoRemarks) {
  const Outcome outcome = pulse({written(table(0))});
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("\nQuiet part    0 g, "), Not(HasSubstr("REMARK")), Not(HasSubstr("CUT"))));
  EXPECT_TRUE(result({file("drop.csv")}).at("flags").empty());
}

/// Digits of the table: six behind the point.
TEST_F(PulseOffsetTest, ZeroTakesTheOffsetOffWhateverItIs) {
  const double truth = hic15({written(table(0))});
  EXPECT_NEAR(truth, exact_hic, 1e-5 * exact_hic);  // a polygon of a thousand sides
  for (const double offset : {1.2, -25.0}) {
    const std::string drop = written(table(offset));
    EXPECT_GT(std::abs(hic15({drop}) / truth - 1), 0.03);
    EXPECT_NEAR(hic15({drop, "--zero", "auto"}), truth, 1e-8 * truth);
    EXPECT_NEAR(hic15({drop, "--zero", "-8 ms,-1 ms"}), truth, 1e-8 * truth);
    EXPECT_NEAR(hic15({drop, "--zero", "12 ms, 0.02 s", "--filter", "CFC1000"}),
                hic15({drop, "--zero", "auto", "--filter", "CFC1000"}), 1e-8 * truth);
  }
  const Outcome outcome = pulse({written(table(1.2)), "--zero", "-8 ms,-1 ms"});
  EXPECT_THAT(unwrapped(outcome.out),
              AllOf(HasSubstr("\nZeroed        1.2 g subtracted, the mean of 701 samples from -8 to -1 ms; "
                              "scatter 0 g; HIC15 is "),
                    HasSubstr("% higher with the offset than without\n"), Not(HasSubstr("REMARK"))));
  const json offset = result({file("drop.csv"), "--zero", "-8 ms,-1 ms"}).at("offset");
  EXPECT_EQ(offset.at("interval"), "given");
  EXPECT_EQ(offset.at("taken_off"), true);
  EXPECT_EQ(offset.at("samples"), 701);
  EXPECT_NEAR(offset.at("mean_g").at(0).get<double>(), 1.2, 1e-9);
}

/// An offset in z alone goes into the length of all three. Each direction has its own.
TEST_F(PulseOffsetTest, ZeroIsForEachDirectionOfATest) {
  fs::create_directories(file("test/Channel"));
  write_file(file("test/v1.mme"), "Title :x\n");
  write_file(file("test/Channel/v1.001"), channel("11HEAD0000H3ACXA", 0.6, 2));
  write_file(file("test/Channel/v1.002"), channel("11HEAD0000H3ACYA", -0.8, 0));
  write_file(file("test/Channel/v1.003"), channel("11HEAD0000H3ACZA", 0, -3));
  EXPECT_GT(hic15({file("test"), "--resultant"}), 1.01 * exact_hic);
  EXPECT_NEAR(hic15({file("test"), "--resultant", "--zero", "auto"}), exact_hic, 1e-5 * exact_hic);
  EXPECT_NEAR(hic15({file("test"), "--resultant", "--zero", "-8 ms,-2 ms"}), exact_hic, 1e-5 * exact_hic);
  const json means = result({file("test"), "--resultant"}).at("offset").at("mean_g");
  EXPECT_NEAR(means.at(0).get<double>(), 2, 1e-6);
  EXPECT_NEAR(means.at(1).get<double>(), 0, 1e-6);
  EXPECT_NEAR(means.at(2).get<double>(), -3, 1e-6);
  EXPECT_THAT(pulse({file("test"), "--resultant"}).out, HasSubstr("\nQuiet part    2, 0, -3 g, the mean"));
  EXPECT_NEAR(hic15({file("test"), "--channel", "1", "--zero", "auto"}), exact_hic * std::pow(0.6, 2.5),
              1e-2);
}

TEST_F(PulseOffsetTest, ZeroAutoWantsAQuietPart) {
  const std::string drop = written(table(0, 0));
  EXPECT_THAT(
      refused({drop, "--zero", "auto"}),
      HasSubstr(
          "--zero auto: there is no quiet part before the impact; give an interval, such as \"0 ms,5 ms\""));
  EXPECT_THAT(pulse({drop}).out, Not(HasSubstr("Quiet part")));
  EXPECT_TRUE(result({drop}).at("offset").is_null());
  EXPECT_THAT(pulse({drop, "--zero", "2 ms,8 ms"}).out,
              HasSubstr("REMARK: the --zero interval is not quiet: its scatter is "));
}

TEST_F(PulseOffsetTest, ASpeedGivesRestitutionAndChecksTheVelocityChange) {
  const std::string drop = written(table(0));
  const double speed = exact_velocity_change / 1.6;
  const std::string at_speed = std::to_string(speed) + " m/s";
  const json impact = result({drop, "--speed", at_speed}).at("impact");
  EXPECT_NEAR(impact.at("restitution").get<double>(), 0.6, 1e-5);
  EXPECT_NEAR(impact.at("speed_m_per_s").get<double>(), speed, 1e-6);
  EXPECT_TRUE(impact.at("drop_height_m").is_null());
  const json of_drop = result({drop, "--drop-height", std::to_string(1e3 * speed * speed / 2 / g) + " mm"});
  EXPECT_NEAR(of_drop.at("impact").at("speed_m_per_s").get<double>(), speed, 1e-6);
  EXPECT_NEAR(of_drop.at("impact").at("drop_height_m").get<double>(), speed * speed / 2 / g, 1e-8);
  EXPECT_THAT(
      pulse({drop, "--speed", at_speed}).out,
      AllOf(ContainsRegex("  Restitution +0.6000 +relative to 3.9019 m/s\n"), Not(HasSubstr("IMPOSSIBLE"))));
  EXPECT_TRUE(result({drop}).at("impact").is_null());

  const Outcome low = pulse({drop, "--speed", "8 m/s"});
  EXPECT_EQ(low.exit_code, 0);
  EXPECT_THAT(
      unwrapped(low.out),
      HasSubstr(
          "IMPOSSIBLE VELOCITY CHANGE: 6.2431 m/s is less than the impact speed of 8 m/s; most likely, the "
          "pulse is cut, the unit or the sensitivity is wrong, or the sensor has an offset\n"));
  EXPECT_THAT(
      unwrapped(pulse({drop, "--speed", "3 m/s"}).out),
      HasSubstr(
          "IMPOSSIBLE VELOCITY CHANGE: 6.2431 m/s is more than twice the impact speed of 3 m/s; most likely, "
          "the "
          "sensor has an offset, the unit or the sensitivity is wrong, or there is more than one impact"));
  const nlohmann::json fast = result({drop, "--speed", "3 m/s"}).at("flags").at(0);
  EXPECT_EQ(fast.at("name"), "IMPOSSIBLE VELOCITY CHANGE");
  EXPECT_NEAR(fast.at("figures").at("velocity_change_m_per_s").get<double>(), 6.2431, 5e-5);
  EXPECT_EQ(fast.at("figures").at("speed_m_per_s"), 3);
}

/// Cut on either side, the rest of the pulse gives less.
TEST_F(PulseOffsetTest, ACutPulseIsToldAndItsFiguresAreLowerBounds) {
  const std::string consequence =
      "or the sensor has an offset; the HIC, clips and velocity change of an incomplete pulse are lower "
      "bounds\n";
  const Outcome end = pulse({written(table(0, -8, 5))});
  EXPECT_EQ(end.exit_code, 0);
  EXPECT_THAT(unwrapped(end.out),
              HasSubstr("PULSE CUT: the pulse ends at 100 g, 100 % of its peak: either its end is missing " +
                        consequence));
  const nlohmann::json cut = result({file("drop.csv")}).at("flags").at(0).at("figures");
  EXPECT_NEAR(cut.at("acceleration_m_per_s2").get<double>(), 980.665, 1e-9);
  EXPECT_NEAR(cut.at("peak_fraction").get<double>(), 1, 1e-12);
  EXPECT_LT(hic15({file("drop.csv")}), 0.6 * exact_hic);
  const Outcome begin = pulse({written(table(0, 2, 20))});
  EXPECT_THAT(
      unwrapped(begin.out),
      AllOf(
          HasSubstr(
              "PULSE CUT: the pulse starts at 58.779 g, 59 % of its peak: either its beginning is missing " +
              consequence),
          Not(HasSubstr("the pulse ends"))));
  const json flags = result({file("drop.csv")}).at("flags");
  ASSERT_EQ(flags.size(), 1U);
  EXPECT_EQ(flags.at(0).at("name"), "PULSE CUT");
}

/// Noise of 2 g at the end of a whole pulse is no cut: the quiet part says how much of it there is.
TEST_F(PulseOffsetTest, NoiseIsNoCut) {
  std::string text = "time [ms],acceleration [g]\n";
  for (int i = -800; i <= 2000; ++i)
    text += std::to_string(0.01 * i) + "," + std::to_string(acceleration(0.01 * i, i % 2 == 0 ? 1.5 : -1.5)) +
            "\n";
  EXPECT_THAT(pulse({written(text)}).out,
              AllOf(HasSubstr("scatter 1.5 g"), Not(HasSubstr("CUT")), Not(HasSubstr("REMARK"))));
}

TEST_F(PulseOffsetTest, RefusesWhatHasNoMeaning) {
  const std::string drop = written(table(0));
  EXPECT_THAT(
      refused({drop, "--zero", "1 ms,5", "--speed", "-3 m/s", "--drop-height", "1", "--sensitivity", "10 mV",
               "--interval", "0 ms"}),
      AllOf(HasSubstr("--zero 1 ms,5: a time needs a unit"),
            HasSubstr("--speed -3 m/s: must be more than 0\n"),
            HasSubstr("--drop-height 1: a length needs a unit"),
            HasSubstr("--drop-height: give --speed or --drop-height, not both\n"),
            HasSubstr("--sensitivity 10 mV: must be a voltage per unit of acceleration, such as \"10 mV/g\""),
            HasSubstr("--interval 0 ms: must be more than 0\n"), HasSubstr("6 errors")));
  EXPECT_THAT(refused({drop, "--zero", "5 ms"}),
              HasSubstr("must be auto, or two times separated by a comma"));
  EXPECT_THAT(refused({drop, "--zero", "0,5 ms,1 ms"}), HasSubstr("must be auto, or two times"));
  EXPECT_THAT(refused({drop, "--zero", "5 ms,5 ms"}),
              HasSubstr("the first time must be earlier than the second\n"));
  EXPECT_THAT(
      refused({drop, "--zero", "30 ms,40 ms"}),
      HasSubstr("--zero 30 ms,40 ms: contains fewer than two samples; the record runs from -8 to 20 ms\n"));
  EXPECT_THAT(refused({drop, "--interval", "1 ms", "--time", "1", "--bridge-gaps"}),
              AllOf(HasSubstr("--time: applies only to a table with times"),
                    HasSubstr("--bridge-gaps: applies only to a table with")));
}

TEST_F(PulseOffsetTest, ReadsALoggerFileOfOneColumnWithAnInterval) {
  std::string text = "acc [g]\n", german = "Beschleunigung [g]\n", volts = "ch1 [mV]\n";
  for (int i = -800; i <= 2000; ++i) {
    const std::string value = std::to_string(acceleration(0.01 * i, 0));
    text += value + "\n";
    german += with_comma(value) + "\n";
    volts += std::to_string(10 * acceleration(0.01 * i, 0)) + "\n";
  }
  const std::string advice =
      "has one column of numbers and no times; if this column is the acceleration, give the "
      "sampling interval, such as --interval \"0.1 ms\"\n  2 | ";
  for (const std::string& each : {text, german}) {
    EXPECT_THAT(refused({written(each)}), HasSubstr(advice));
    EXPECT_NEAR(hic15({written(each), "--interval", "0.01 ms"}), exact_hic, 1e-5 * exact_hic);
  }
  EXPECT_NEAR(hic15({written(volts), "--interval", "10 us", "--sensitivity", "10 mV/g"}), exact_hic,
              1e-5 * exact_hic);
  const Outcome outcome = pulse({written(volts), "--interval", "10 us", "--sensitivity", "10 mV/g"});
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("\nTime          samples in s (as given)"),
                    HasSubstr("ch1 [mV] in mV (from the file), at 10 mV/g, 1 mV = 0.980665 m/s2\n")));
  const json column = result({file("drop.csv"), "--interval", "10 us", "--sensitivity", "10 mV/g"})
                          .at("source")
                          .at("acceleration")
                          .at(0);
  EXPECT_EQ(column.at("sensitivity"), "10 mV/g");
  EXPECT_NEAR(column.at("si_factor").get<double>(), 0.980665, 1e-12);
}

/// Semicolons, decimal commas, Latin-1: no option is needed.
TEST_F(PulseOffsetTest, ReadsAGermanTableUnaided) {
  std::string text =
      "Pr\xfc"
      "fung 7;\nZeit [ms];Beschleunigung [m/s\xb2]\n";
  for (int i = -800; i <= 2000; ++i) {
    const std::string row =
        std::to_string(0.01 * i) + ";" + std::to_string(g * acceleration(0.01 * i, 0)) + "\r\n";
    text += with_comma(row);
  }
  EXPECT_NEAR(hic15({written(text)}), exact_hic, 1e-5 * exact_hic);
}

TEST_F(PulseOffsetTest, ManyFaultsOfAKindAreCounted) {
  std::string text = "time [ms],acc [g]\n0,1\n";
  for (int i = 1; i < 1000; ++i) text += std::to_string(i) + ",x" + std::to_string(i) + "\n";
  const std::string said = refused({written(text)});
  EXPECT_THAT(said,
              AllOf(HasSubstr("drop.csv:7: acc [g] = x5: must be a number\n  7 | 5,x5\n    |   ^^\nand 194 "
                              "more of this kind\n"),
                    HasSubstr("reading stopped here, after 200 errors\n  202 | 200,x200\n      |     ^^^^\n"
                              "200 errors; nothing was run\n")));
  EXPECT_EQ(std::ranges::count(said, '\n'), 20);
}

}  // namespace
}  // namespace dashpad::test
