// dashpad pulse: figures of measured pulses, their files, and what is refused.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <array>
#include <cmath>
#include <random>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// A half sine of 100 g and 10 ms, a sample every 0.1 ms.
std::string half_sine(const std::string& header = "time [ms],acceleration [g]\n") {
  std::string text = header;
  for (int i = -50; i <= 150; ++i) {
    const double time = 0.1 * i;
    const double value = i < 0 || i > 100 ? 0 : 100 * std::sin(std::acos(-1) * i / 100);
    text += std::to_string(time) + "," + std::to_string(value) + "\n";
  }
  return text;
}

std::string channel(const std::string& code, const std::string& factor) {
  std::string text = "Channel code :" + code + "\nUnit :g\nReference channel :implicit\n" +
                     "Time of first sample :0\nSampling interval :0.0001\nNumber of samples :200\n";
  for (int i = 0; i < 200; ++i) text += (i < 50 || i > 150 ? "0" : factor) + "\n";
  return text;
}

class PulseTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("drop.csv"), half_sine());
    fs::create_directories(file("test/Channel"));
    write_file(file("test/v1.mme"), "Title :x\n");
    write_file(file("test/Channel/v1.001"), channel("11HEAD0000H3ACXA", "-30"));
    write_file(file("test/Channel/v1.002"), channel("11HEAD0000H3ACYA", "40"));
  }
  Outcome pulse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "pulse");
    return dashpad(arguments);
  }
  /// What is said to a command line that is refused; nothing may be written.
  std::string refused(const std::vector<std::string>& arguments) {
    const auto before = other_files();
    const Outcome outcome = pulse(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(other_files(), before);
    return outcome.err;
  }
};

TEST_F(PulseTest, ShowsFiguresAndHowTheyCameAbout) {
  const Outcome outcome = pulse({file("drop.csv")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(
      outcome.out,
      AllOf(HasSubstr("drop.csv (CSV)\n"), HasSubstr("time [ms] in ms (from the file), 1 ms = 0.001 s\n"),
            HasSubstr("acceleration [g] in g (from the file), 1 g = 9.80665 m/s2\n"),
            HasSubstr("\nSamples       201 from -5 to 15 ms\n"), HasSubstr("\nFilter        none\n"),
            ContainsRegex("Peak acceleration +100.0 g +at 5 ms\n"),
            ContainsRegex("; the same for HIC36 and\\s+unlimited\\s+HIC\n"),
            ContainsRegex("; the same for the cumulative\\s+3\\s+ms\\s+clip\n"),
            Not(HasSubstr("Dwell time above 150 g"))));
  const std::string all = pulse({file("drop.csv"), "--all"}).out;
  EXPECT_THAT(all, ContainsRegex("Peak acceleration +100.00 g +± 0[.]014 % +at 5 ms\n"));
  for (const std::string label :
       {"HIC15 ", "HIC36 ", "Unlimited HIC ", "HIC(d) ", "3 ms clip ", "Cumulative 3 ms clip ",
        "Severity index ", "Velocity change ", "Dwell time above 80 g ", "Dwell time above 150 g ",
        "Dwell time above 200 g "})
    EXPECT_THAT(all, HasSubstr("\n  " + label));
}

/// For a half sine of height A and length T: speed 2 A T / pi, 3 ms clip A cos(pi 1.5 ms / T), time above
/// A cos(x) is 2 x T / pi.
TEST_F(PulseTest, FiguresOfAHalfSineAreThoseOfItsFormula) {
  const Outcome outcome = pulse({file("drop.csv"), "--json", "-", "--dwell", "50", "--window", "4"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.err, HasSubstr("Peak acceleration"));
  const json figures = json::parse(outcome.out).at("figures");
  const double pi = std::acos(-1);
  EXPECT_NEAR(figures.at("peak_acceleration").at("value_g").get<double>(), 100, 1e-9);
  EXPECT_NEAR(figures.at("velocity_change").at("value_m_per_s").get<double>(), 2 / pi * 9.80665, 1e-3);
  EXPECT_NEAR(figures.at("clip_3ms").at("value_g").get<double>(), 100 * std::cos(0.15 * pi), 0.02);
  EXPECT_NEAR(figures.at("dwell_time").at(0).at("value_s").get<double>(), 1e-2 * 2 / 3, 1e-5);
  const json window = figures.at("hic_windows").at(0);
  EXPECT_NEAR(window.at("end_s").get<double>() - window.at("begin_s").get<double>(), 4e-3, 1e-9);
  const double mean = 100 * std::sin(0.2 * pi) / (0.2 * pi);
  EXPECT_NEAR(window.at("value").get<double>(), 4e-3 * std::pow(mean, 2.5),
              0.1);  // a polygon of 100 sides: 2e-4 less
}

TEST_F(PulseTest, JsonSaysHowToGetTheSameAgain) {
  const Outcome outcome = pulse({file("drop.csv"), "--json", "-", "--acceleration-unit", "m/s2", "--filter",
                                 "CFC180", "--corner", "iso", "--ends", "held", "--resample", "0.05 ms"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result.at("source").at("format"), "CSV");
  EXPECT_EQ(result.at("source").at("time").at("unit_origin"), "header");
  EXPECT_EQ(result.at("source").at("acceleration").at(0).at("unit_origin"), "given");
  EXPECT_EQ(result.at("source").at("samples"), 201);
  EXPECT_EQ(result.at("source").at("remarks").size(), 1U);
  EXPECT_DOUBLE_EQ(result.at("processing").at("resampled_to_s").get<double>(), 5e-5);
  EXPECT_EQ(result.at("processing").at("samples"), 401);
  EXPECT_EQ(result.at("processing").at("filter").at("channel_frequency_class"), 180);
  EXPECT_EQ(result.at("processing").at("filter").at("corner"), "iso");
  EXPECT_EQ(result.at("processing").at("filter").at("ends"), "held");
  EXPECT_TRUE(result.contains("program"));
}

TEST_F(PulseTest, ReadsWhatItWrites) {
  ASSERT_EQ(pulse({file("drop.csv"), "--csv", file("again.csv")}).exit_code, 0);
  const Outcome first = pulse({file("drop.csv"), "--json", "-"});
  const Outcome second = pulse({file("again.csv"), "--json", "-"});
  ASSERT_EQ(second.exit_code, 0) << second.err;
  EXPECT_NEAR(json::parse(first.out).at("figures").at("hic15").at("value").get<double>(),
              json::parse(second.out).at("figures").at("hic15").at("value").get<double>(), 1e-6);
}

TEST_F(PulseTest, ReadsTheHistoryOfARun) {
  ASSERT_EQ(dashpad({"run", case_file(), "--csv", file("run.csv")}).exit_code, 0);
  const Outcome outcome = pulse({file("run.csv")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("acceleration_g in g (from the file)"));
}

/// All examples: the steps of some grow to 14 times their median, and that is no gap.
TEST_F(PulseTest, HistoriesOfRunsHaveNoGaps) {
  for (const auto& entry : fs::directory_iterator(DASHPAD_SOURCE_DIR "/examples")) {
    if (entry.path().extension() != ".toml") continue;
    SCOPED_TRACE(entry.path());
    dashpad({"run", entry.path().string(), "--csv", file("run.csv"), "--force"});
    const Outcome outcome = pulse({file("run.csv")});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, Not(HasSubstr("REMARK")));
  }
}

TEST_F(PulseTest, ReadsExportsInEveryConsistentSystem) {
  std::vector<double> peaks;
  for (const std::string system : {"kg-m-s", "kg-mm-ms", "t-mm-s", "lbf-s2/in-in-s"}) {
    SCOPED_TRACE(system);
    ASSERT_EQ(dashpad({"export", case_file(), "--format", "csv", "--curves", "acceleration", "--system",
                       system, "--out", file("curve.csv"), "--force"})
                  .exit_code,
              0);
    const Outcome outcome = pulse({file("curve.csv"), "--json", "-"});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    peaks.push_back(
        json::parse(outcome.out).at("figures").at("peak_acceleration").at("value_g").get<double>());
    EXPECT_NEAR(peaks.back(), peaks.front(), 1e-9 * peaks.front());
  }
  EXPECT_GT(peaks.front(), 10);
}

/// A half sine of 60 g and 20 ms in x, at 10 kHz, and noise of 20 g in all directions. The length of noise
/// has a mean, which no filter takes away: combined before the filter, HIC15 comes out far too high.
TEST_F(PulseTest, DirectionsAreFilteredBeforeTheyAreCombined) {
  std::mt19937 random(1984);
  const auto noise =
      [&] {  // -20 to 20 g; the distributions of the standard library are not the same everywhere
        return 40 * (static_cast<double>(random()) / 4294967296.0 - 0.5);
      };
  std::string clean = "t_ms,a_g\n", noisy = "t_ms,ax_g,ay_g,az_g\n", combined = "t_ms,a_g\n";
  for (int i = 0; i <= 600; ++i) {
    const double x = i < 200 || i > 400 ? 0 : 60 * std::sin(std::acos(-1) * (i - 200) / 200);
    const std::array<double, 3> a{x + noise(), noise(), noise()};
    const std::string time = std::to_string(0.1 * i) + ",";
    clean += time + std::to_string(x) + "\n";
    noisy += time + std::to_string(a[0]) + "," + std::to_string(a[1]) + "," + std::to_string(a[2]) + "\n";
    combined += time + std::to_string(std::hypot(a[0], a[1], a[2])) + "\n";
  }
  const auto hic15 = [&](const std::string& text, const std::vector<std::string>& more) {
    write_file(file("p.csv"), text);
    std::vector<std::string> arguments{file("p.csv"), "--filter", "CFC180", "--json", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    const Outcome outcome = pulse(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("filtered separately, then combined") != std::string::npos, !more.empty());
    return json::parse(outcome.out).at("figures").at("hic15").at("value").get<double>();
  };
  const double truth = hic15(clean, {}), wrong = hic15(combined, {});
  const double filtered_first = hic15(noisy, {"--resultant"});
  EXPECT_NEAR(filtered_first, truth, 0.05 * truth);
  EXPECT_GT(wrong, filtered_first + 0.1 * truth);
}

/// A vibration of half the sampling frequency in both directions: nothing is left of it. Its resultant is
/// constant, and would pass.
TEST_F(PulseTest, FiltersTheDirectionsOfATest) {
  for (const std::string name : {"1", "2"}) {
    std::string text = channel(name == "1" ? "11HEAD0000H3ACXA" : "11HEAD0000H3ACYA", "");
    text.erase(text.find("samples :200\n") + 13);
    for (int i = 0; i < 200; ++i) text += i % 2 == 0 ? "30\n" : "-30\n";
    write_file(file("test/Channel/v1.00" + name), text);
  }
  const auto hic15 = [&](const std::string& filter) {
    std::vector<std::string> arguments{file("test"), "--resultant", "--json", "-"};
    if (!filter.empty()) arguments.insert(arguments.end(), {"--filter", filter, "--ends", "negated-before"});
    const Outcome outcome = pulse(arguments);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("\nResultant     of 2 directions, filtered separately, then combined\n") !=
                  std::string::npos,
              !filter.empty());
    return json::parse(outcome.out).at("figures").at("hic15").at("value").get<double>();
  };
  EXPECT_LT(hic15("CFC180"), 0.3 * hic15(""));
}

TEST_F(PulseTest, SaysThatSamplesAreTooFewForTheFilter) {
  std::string text = "t_ms,a_g\n";
  for (int i = 0; i < 50; ++i) text += std::to_string(0.8 * i) + ",1\n";
  write_file(file("slow.csv"), text);
  const auto remark =
      HasSubstr("REMARK: the sampling rate is 1.25 kHz, but CFC180 requires at least 1.8 kHz\n");
  EXPECT_THAT(pulse({file("slow.csv"), "--filter", "CFC180"}).out, remark);
  EXPECT_THAT(pulse({file("slow.csv"), "--filter", "CFC180", "--resample", "0.1 ms"}).out, remark);
  EXPECT_THAT(pulse({file("slow.csv"), "--filter", "CFC60"}).out, Not(HasSubstr("REMARK")));
  EXPECT_THAT(pulse({file("drop.csv"), "--filter", "CFC1000"}).out, Not(HasSubstr("REMARK")));
  EXPECT_THAT(pulse({file("drop.csv"), "--filter", "CFC1000", "--resample", "0.2 ms"}).out,
              HasSubstr("REMARK: the sampling rate is 5 kHz, but CFC1000 requires at least 10 kHz\n"));
}

TEST_F(PulseTest, BridgesGapsOnlyIfAsked) {
  write_file(file("gap.csv"), "t_ms,a_g\n0,0\n1,1\n2,2\n3,3\n50,3\n51,2\n52,1\n");
  EXPECT_THAT(refused({file("gap.csv")}),
              HasSubstr("gap.csv:6: t_ms: has a gap of 47 ms between lines 5 and 6 (typical step: 1 ms); "
                        "--bridge-gaps interpolates linearly"));
  const Outcome outcome = pulse({file("gap.csv"), "--bridge-gaps"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      HasSubstr("REMARK: the gap of 47 ms between lines 5 and 6 was bridged by linear interpolation\n"));
  EXPECT_EQ(pulse({file("test"), "--channel", "1", "--bridge-gaps"}).exit_code, 0)
      << "explicit times may have gaps";
}

TEST_F(PulseTest, RoundingNoiseInTimesIsShownAsZero) {
  write_file(file("noise.csv"), "t_ms,a_g\n7.3459e-16,100\n5,100\n10,100\n15,100\n");
  const std::string text = pulse({file("noise.csv")}).out;
  EXPECT_THAT(text, AllOf(HasSubstr("\nSamples       4 from 0 to 15 ms\n"), HasSubstr("at 0 ms\n"),
                          Not(HasSubstr("e-1"))));
}

TEST_F(PulseTest, SaysWhatWasRepaired) {
  write_file(file("repaired.csv"), "\xef\xbb\xbftime [ms];acc [g]\n0,0;1,5\n\n1,0;2,5\n");
  EXPECT_THAT(pulse({file("repaired.csv")}).out,
              AllOf(HasSubstr("REMARK: the byte order mark"), HasSubstr("REMARK: decimal commas"),
                    HasSubstr("REMARK: 1 line without content was left out")));
}

TEST_F(PulseTest, ListsAndChoosesChannels) {
  const Outcome list = pulse({file("test"), "--list"});
  EXPECT_EQ(list.exit_code, 0) << list.err;
  EXPECT_THAT(list.out, AllOf(StartsWith(" No.  code"), HasSubstr("\n   2  11HEAD0000H3ACYA  g")));
  EXPECT_THAT(pulse({file("test"), "--channel", "2"}).out, ContainsRegex("Peak acceleration +40.00 g"));
  EXPECT_THAT(
      pulse({file("test/v1.mme"), "--resultant"}).out,
      AllOf(ContainsRegex("Peak acceleration +50.00 g"), HasSubstr("\nResultant     of 2 directions")));
  EXPECT_THAT(refused({file("test")}), HasSubstr("several channels match"));
  EXPECT_THAT(pulse({file("drop.csv"), "--list"}).out,
              HasSubstr("\n   2  acceleration [g]                g\n"));
}

TEST_F(PulseTest, DrawsThePulse) {
  const Outcome outcome = pulse({file("drop.csv"), "--filter", "CFC180", "--picture", file("drop.svg")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_file(file("drop.svg")),
              AllOf(HasSubstr("<svg"), HasSubstr("as measured"), HasSubstr("CFC180"), HasSubstr(">HIC15 ")));
}

TEST_F(PulseTest, RefusesWithAllThatIsWrong) {
  write_file(file("bad.csv"), "time [ms],acc [g]\n0,1\n1,x\n1,2\n1,3\n");
  EXPECT_THAT(
      refused({file("bad.csv"), "--window", "-1", "--resample", "5", "--dwell", "x", "--corner", "iso",
               "--json", file("none/x.json")}),
      AllOf(HasSubstr("bad.csv:3: acc [g] = x: must be a number\n"),
            HasSubstr("bad.csv:5: time [ms]: 1 sample has the same time"),
            HasSubstr("--window -1: must be more than 0 ms\n"), HasSubstr("--resample 5: a time needs"),
            HasSubstr("--dwell x: "), HasSubstr("--corner: applies only with --filter"),
            HasSubstr("there is no folder"), HasSubstr("7 errors")));
}

TEST_F(PulseTest, RefusesWhatHasNoMeaning) {
  EXPECT_THAT(refused({file("none.csv")}), HasSubstr("none.csv: no such file"));
  EXPECT_THAT(refused({file("drop.csv"), "--channel", "1"}), HasSubstr("--channel: applies only to ISO-MME"));
  EXPECT_THAT(refused({file("test"), "--time", "1"}), HasSubstr("--time: applies only to tables"));
  EXPECT_THAT(refused({file("drop.csv"), "--picture", file("x.bmp")}), HasSubstr("must end in .svg"));
  EXPECT_THAT(refused({file("drop.csv"), "--filter", "CFC100"}), HasSubstr("CFC60"));
  EXPECT_THAT(refused({file("drop.csv"), "--list", "--json", "-"}), Not(IsEmpty()));
  EXPECT_THAT(refused({file("drop.csv"), "--json", file("drop.csv"), "--force"}),
              HasSubstr("choose another name"));
  write_file(file("uneven.csv"), "time [ms],acc [g]\n0,1\n1,2\n3,3\n");
  EXPECT_THAT(
      pulse({file("uneven.csv"), "--filter", "CFC60"}).out,
      HasSubstr(
          "REMARK: a filter needs evenly spaced samples, so these were resampled at intervals of 1 ms"));
  EXPECT_EQ(pulse({file("uneven.csv"), "--filter", "CFC60", "--resample", "0.1 ms"}).exit_code, 0);
}

TEST_F(PulseTest, UnitsAreThoseOfTheUser) {
  EXPECT_THAT(pulse({file("drop.csv"), "--units", "us"}).out, HasSubstr(" mph"));
  EXPECT_THAT(pulse({file("drop.csv"), "--units", "us", "--csv", "-"}).out,
              StartsWith("time_ms,acceleration_g\n"));
  EXPECT_THAT(pulse({file("drop.csv"), "--csv", "-"}).out, StartsWith("time_s,acceleration_g\n"));
}

}  // namespace
}  // namespace dashpad::test
