// dashpad fall-height: from pulses, from figures, from a case.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "answers/true_mat.hpp"
#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

class FallHeightTest : public CommandTest {
 protected:
  /// Pulses of a made-up mat of known law, and their table.
  std::string table_of_pulses(double thickness, const std::vector<double>& heights) {
    TrueMat mat;
    mat.thickness = thickness;
    std::string table = "position,drop_height [m],file,temperature [degC]\n";
    std::uint64_t which = 0;
    for (const double height : heights) {
      const std::string name = fmt::format("pulse-{}-{}.csv", thickness, height);
      const Pulse pulse = measured_pulse(dropped(mat, height), 3, which++);
      std::string text = "time [s],a [m/s2]\n";
      for (std::size_t i = 0; i < pulse.time.size(); ++i)
        text += fmt::format("{:.7f},{:.4f}\n", pulse.time[i], pulse.acceleration[i]);
      write_file(file(name), text);
      table += fmt::format("centre,{},{},23\n", height, name);
    }
    return written(fmt::format("drops-{}.csv", thickness), table);
  }
  std::string written(const std::string& name, const std::string& text) {
    write_file(file(name), text);
    return file(name);
  }
  json answer_of(std::vector<std::string> arguments, int exit_code = 0) {
    arguments.insert(arguments.begin(), "fall-height");
    arguments.insert(arguments.end(), {"--json", "-"});
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, exit_code) << outcome.err;
    return json::parse(outcome.out);
  }
};

constexpr const char* figures =
    "position;drop_height [m];hic;gmax\n"
    "centre;1,2;412;98\n"
    "centre;1,5;611;121\n"
    "centre;1,8;842;147\n"
    "centre;2,1;1165;183\n"
    "centre;2,3;1390;207\n";

TEST_F(FallHeightTest, OfPulsesHasTheTruth) {
  // Of the made-up mats: 1.985 m, and 2.761 m with 20 mm more (tests/answers/true_mat.hpp, in small steps).
  for (const auto& [thickness, heights, truth] :
       {std::tuple{0.05, std::vector{1.2, 1.5, 1.8, 2.1, 2.3}, 1.985},
        std::tuple{0.07, std::vector{1.8, 2.2, 2.6, 3.0, 3.2}, 2.761}}) {
    const json answer = answer_of({table_of_pulses(thickness, heights), "--calibration", "1 %"});
    const json& hic = answer["measured"]["places"][0]["limits"][1];
    EXPECT_EQ(hic["figure"], "hic_unlimited");
    EXPECT_LT(hic["low_m"], truth);
    EXPECT_GT(hic["high_m"], truth);
    EXPECT_NEAR(hic["height_m"], truth, 0.01);
    EXPECT_LT(hic["high_m"].get<double>() - hic["low_m"].get<double>(), 0.1);
  }
}

TEST_F(FallHeightTest, OfFiguresAnswersInASentence) {
  const Outcome outcome = dashpad({"fall-height", written("d.csv", figures)});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out,
              StartsWith("Critical fall height 1.94 m (95 % interval 1.90 to 1.99 m), where unlimited HIC"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("NO CALIBRATION"), HasSubstr("position: centre"),
                                 HasSubstr("between drops from 1.8 m")));
}

TEST_F(FallHeightTest, WithoutADropAboveTheLimitIsNoHeight) {
  const Outcome outcome =
      dashpad({"fall-height", written("d.csv", "height [m],hic,gmax\n1,400,90\n1.2,520,99\n1.4,660,110\n")});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("Critical fall height more than 1.4 m: no drop exceeds"),
                                 HasSubstr("LIMIT NOT ENCLOSED")));
}

TEST_F(FallHeightTest, OfACaseIsWhereSolveForTurns) {
  const json answer = answer_of({examples + "playground-mat-in-layers.toml", "--between", "0.5 m..3 m"});
  const json& computed = answer["computed"];
  EXPECT_THAT(std::string(answer["answer"]), StartsWith("Critical fall height by computation "));
  const json turns =
      json::parse(dashpad({"solve-for", "impactor.drop_height", examples + "playground-mat-in-layers.toml",
                           "--standard", "en-1177", "--between", "0.5 m..3 m", "--json", "-"})
                      .out)["turns"];
  EXPECT_DOUBLE_EQ(computed["height_m"], turns[0]["value"]);
  EXPECT_LT(computed["low_m"], computed["height_m"]);
}

TEST_F(FallHeightTest, OfPulsesThatCannotBeIsInDoubt) {
  // Drops from heights that the table makes four times as great.
  const std::string table = table_of_pulses(0.05, {1.2, 1.8, 2.1, 2.3});
  std::string text = read_file(table);
  for (const auto& [height, wrong] :
       {std::pair{",1.2,", ",4.8,"}, {",1.8,", ",7.2,"}, {",2.1,", ",8.4,"}, {",2.3,", ",9.2,"}})
    text = with(text, height, wrong);
  const Outcome outcome = dashpad({"fall-height", written("wrong.csv", text)});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.out, HasSubstr("IMPOSSIBLE VELOCITY CHANGE"));
}

TEST_F(FallHeightTest, OfPulsesWritesATableThatItReadsAgain) {
  const std::string table = table_of_pulses(0.05, {1.2, 1.5, 1.8, 2.1, 2.3});
  EXPECT_EQ(dashpad({"fall-height", table, "--csv", file("again.csv")}).exit_code, 0);
  EXPECT_EQ(dashpad({"fall-height", file("again.csv")}).exit_code, 0);
}

TEST_F(FallHeightTest, WritesAPageAndATableThatItReadsAgain) {
  const std::string table = written("d.csv", figures);
  const Outcome outcome = dashpad({"fall-height", table, "--report", file("r.html"), "--csv",
                                   file("again.csv"), "--about", "Operator: M. Muster"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(read_file(file("r.html")),
              AllOf(HasSubstr("Operator: M. Muster"), HasSubstr("Critical fall height 1.94 m")));
  const json first = answer_of({table}), again = answer_of({file("again.csv")});
  EXPECT_EQ(first["answer"], again["answer"]);
}

TEST_F(FallHeightTest, RefusesWhatIsWrongAllAtOnce) {
  const Outcome outcome =
      dashpad({"fall-height", written("d.csv", "height [m],hic,file\n1,,no-such.csv\n2,,neither.csv\n"),
               "--calibration", "-2 %"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--calibration"), HasSubstr("no-such.csv"),
                                 HasSubstr("neither.csv"), HasSubstr("3 errors")));
  EXPECT_THAT(outcome.err, HasSubstr("line 2)"));
  EXPECT_THAT(
      dashpad({"fall-height", written("e.csv", figures), "--between", "1 m..2 m", "--no-intervals"}).err,
      AllOf(HasSubstr("--between: applies only with a case"), HasSubstr("2 errors")));
  EXPECT_THAT(dashpad({"fall-height", "a.csv", "b.csv"}).err, HasSubstr("one table at a time"));
  EXPECT_THAT(dashpad({"fall-height", examples + "disc-on-mat.toml", "--csv", file("x.csv")}).err,
              HasSubstr("--csv: has a row for each drop"));
}

}  // namespace
}  // namespace dashpad::test
