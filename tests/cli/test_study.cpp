// dashpad study: a study from its file to its answers, as a user goes through it.

#include <csignal>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

constexpr const char* drawn_study = R"(title = "Drawn"
case = "case.toml"
samples = 200
seed = 3
indices = true
responses = ["peak_force", "peak_acceleration", "rebound_speed"]
[factors."impactor.speed"]
distribution = "normal"
mean = "3 m/s"
deviation = "0.2 m/s"
[factors."impactor.mass"]
distribution = "uniform"
low = "4 kg"
high = "6 kg"
)";

/// Draws that no machine has done before a test ends the study.
constexpr const char* endless = "samples = 3000000";

constexpr const char* grid_study = R"(title = "Grid"
case = "case.toml"
responses = ["peak_acceleration", "peak_penetration"]
[factors."impactor.mass"]
from = "1 kg"
to = "5 kg"
count = 5
[factors."impactor.speed"]
values = ["1 m/s", "2 m/s"]
[factors."pad.thickness"]
values = ["40 mm", "50 mm", "60 mm"]
)";

class StudyTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("drawn.toml"), drawn_study);
    write_file(file("grid.toml"), grid_study);
  }
  Outcome compute(const std::string& name) {
    return dashpad({"study", file(name + ".toml"), "--out", file(name + ".db")});
  }
  /// Refused with this in the message and no new file.
  void expect_refused(std::vector<std::string> arguments, const std::string& why) {
    const auto before = other_files();
    arguments.insert(arguments.begin(), "study");
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_THAT(outcome.err, HasSubstr(why));
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(other_files(), before);
  }
  std::string csv_of(const std::string& store) {
    return dashpad({"study", "export", file(store), "--csv", "-"}).out;
  }
};

TEST_F(StudyTest, ComputesAndSumsUp) {
  const Outcome outcome = compute("drawn");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              ContainsRegex("^800 rows in .*drawn.db; 800 computed in .* rows/s; 0 doubtful\n$"));

  const Outcome summary =
      dashpad({"study", "summary", file("drawn.db"), "--limit", "peak_acceleration > 30 g", "--limit",
               "peak_force=2 kN", "--json", file("answers.json"), "--markdown", file("answers.md")});
  EXPECT_EQ(summary.exit_code, 0) << summary.err;
  EXPECT_THAT(summary.out,
              AllOf(StartsWith("All limits are kept in 92 % of the draws (95 % interval 88.9 % to 94.5 %)\n"
                               "Drawn\n800 of 800"),
                    HasSubstr("Impact speed "), HasSubstr("normal, mean 3 m/s, standard deviation 0.2 m/s"),
                    HasSubstr("30 g"), HasSubstr("2000 N"), HasSubstr("Sobol' indices")));
  EXPECT_THAT(
      dashpad({"study", "summary", file("drawn.db"), "--limit", "peak_acceleration > 30 g"}).out,
      StartsWith("Peak acceleration exceeds 30 g in 8 % of the draws (95 % interval 5.54 % to 11.1 %)\n"));
  EXPECT_THAT(read_file(file("answers.md")),
              ContainsRegex("\\| Peak acceleration \\(g\\) \\| [0-9.]+ \\([0-9.]+ to [0-9.]+\\) \\|"));
  const json answers = json::parse(read_file(file("answers.json")));
  const json& group = answers.at("groups").at(0);
  EXPECT_EQ(answers.at("rows"), 800);
  EXPECT_EQ(group.at("distributions").at(0).at("rows"), 400) << "only the two matrices are draws";
  EXPECT_EQ(group.at("exceedances").at(1).at("limit"), 2000);
  const json& exceedance = group.at("exceedances").at(0);
  EXPECT_NEAR(exceedance.at("limit").get<double>(), 30, 1e-9);
  EXPECT_LE(exceedance.at("probability").at("low"), exceedance.at("probability").at("value"));
}

TEST_F(StudyTest, AllLimitsTogetherAreCountedByRows) {
  write_file(file("both.toml"), R"(title = "Both"
case = "case.toml"
samples = 300
responses = ["peak_acceleration", "hic_unlimited", "rebound_speed"]
[factors."impactor.speed"]
distribution = "uniform"
low = "2 m/s"
high = "4 m/s"
[factors."impactor.mass"]
distribution = "uniform"
low = "4 kg"
high = "6 kg"
)");
  EXPECT_EQ(compute("both").exit_code, 0);
  // The faster and the heavier: neither limit decides alone.
  const Outcome summary = dashpad({"study", "summary", file("both.db"), "--limit", "peak_acceleration > 30 g",
                                   "--limit", "rebound_speed > 3.1 m/s", "--json", file("answers.json")});
  const json group = json::parse(read_file(file("answers.json"))).at("groups").at(0);
  std::istringstream rows(csv_of("both.db"));
  std::string line;
  std::getline(rows, line);
  std::vector<std::string> names;
  for (std::istringstream header(line); std::getline(header, line, ',');) names.push_back(line);
  const auto column = [&](const std::string& start) {
    return std::ranges::find_if(names, [&](const std::string& name) { return name.starts_with(start); }) -
           names.begin();
  };
  const auto peak = column("peak_acceleration"), rebound = column("rebound_speed");
  int any = 0, both = 0;
  while (std::getline(rows, line)) {
    std::vector<std::string> fields;
    for (std::istringstream cells(line); std::getline(cells, line, ',');) fields.push_back(line);
    const double factor = names[static_cast<std::size_t>(peak)].ends_with("_g") ? 1 : 1 / 9.80665;
    const bool is_hard = factor * std::stod(fields[static_cast<std::size_t>(peak)]) > 30,
               is_fast = std::stod(fields[static_cast<std::size_t>(rebound)]) > 3.1;
    any += is_hard || is_fast ? 1 : 0;
    both += is_hard && is_fast ? 1 : 0;
  }
  EXPECT_GT(any, both);
  EXPECT_EQ(group.at("any_limit_exceeded").at("rows_above"), any);
  EXPECT_NEAR(group.at("any_limit_exceeded").at("probability").at("value"), any / 300.0, 1e-12);
  EXPECT_THAT(summary.out, AllOf(StartsWith("All limits are kept in "), HasSubstr("One limit or more")));
  // The limits of a standard.
  const Outcome standard = dashpad({"study", "summary", file("both.db"), "--standard", "en-1177"});
  EXPECT_THAT(standard.out, AllOf(StartsWith("All limits are kept in "), HasSubstr("SECONDARY SOURCE"),
                                  HasSubstr("REPLACED: the study's case does not have the mass")));
  expect_refused({"summary", file("both.db"), "--standard", "fmvss-208-hic15"},
                 "which this study did not keep");
}

/// A linear pad on a rigid floor: the peak is v sqrt(k m) / m, k = E A / t. So thickness and speed of a draw
/// decide, and 95 % of the draws stay below a peak from the thickness at which the 95 % quantile of the
/// speeds does.
TEST_F(StudyTest, SaysFromWhichLevelMostDrawsAreWithinTheLimits) {
  write_file(file("flat.toml"), R"([impactor]
nose = "flat-disc"
radius = "50 mm"
mass = "5 kg"
speed = "2 m/s"
[pad]
thickness = "50 mm"
law = "elastic"
parameters = { modulus = "300 kPa" }
neighbours = 0
[support]
type = "rigid"
)");
  const std::string rest = R"(
case = "flat.toml"
samples = 500
responses = ["peak_acceleration"]
[factors."impactor.speed"]
distribution = "uniform"
low = "1.5 m/s"
high = "2.5 m/s"
)";
  write_file(file("flat-study.toml"), rest + R"([factors."pad.thickness"]
values = ["80 mm", "50 mm", "55 mm", "60 mm", "65 mm", "70 mm", "75 mm"]
)");
  ASSERT_EQ(compute("flat-study").exit_code, 0);
  const auto answers_for = [&](const std::string& limit) {
    const Outcome outcome = dashpad({"study", "summary", file("flat-study.db"), "--limit", limit, "--json",
                                     file("turns.json"), "--force"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return std::pair{outcome.out, json::parse(read_file(file("turns.json"))).at("turning_levels").at(0)};
  };
  // a = v sqrt(E A / (t m)): t = v^2 E A / (m a^2) with v = 2.45 m/s.
  const double area = 3.14159265358979 * 0.05 * 0.05, v = 2.45, a = 22 * 9.80665;
  const double thickness = v * v * 300e3 * area / (5 * a * a);
  const auto [words, turn] = answers_for("peak_acceleration > 22 g");
  EXPECT_THAT(words, HasSubstr("95 % of the draws stay within the limit"));
  EXPECT_NEAR(turn.at("level").at("value").get<double>(), thickness, 0.005 * thickness);
  EXPECT_LT(turn.at("level").at("low"), thickness);
  EXPECT_GT(turn.at("level").at("high"), thickness);
  EXPECT_EQ(turn.at("kept"), "above");
  const auto [never, none] = answers_for("peak_acceleration > 1 g");
  EXPECT_THAT(never, HasSubstr("do 95 % of the draws stay within the limit"));
  EXPECT_TRUE(none.at("level").at("value").is_null());
}

/// The standard of a study file: its impactor, its figures, its answer.
TEST_F(StudyTest, AnswersForTheStandardOfItsFile) {
  const std::string rest = R"(case = "case.toml"
samples = 50
responses = ["rebound_speed"]
[factors."impactor.speed"]
distribution = "uniform"
low = "4 m/s"
high = "6 m/s"
)";
  write_file(file("mat.toml"), "standard = \"en-1177\"\n" + rest);
  EXPECT_EQ(compute("mat").exit_code, 0);
  EXPECT_THAT(csv_of("mat.db"), AllOf(HasSubstr("hic_unlimited"), HasSubstr("peak_acceleration")));
  const Outcome summary = dashpad({"study", "summary", file("mat.db")});
  EXPECT_THAT(summary.out, AllOf(StartsWith("All limits are kept in "), Not(HasSubstr("REPLACED"))));
  const json replayed = json::parse(dashpad({"study", "replay", file("mat.db"), "1", "--json", "-"}).out);
  EXPECT_EQ(replayed.at("case").at("impactor").at("mass_kg"), 4.6);
  const Outcome other = dashpad({"study", "summary", file("mat.db"), "--limit", "peak_acceleration > 1 g"});
  EXPECT_THAT(other.out, Not(HasSubstr("All limits")));
  write_file(file("two.toml"),
             "standard = [\"en-1177\", \"en-1078\", \"nothing\", 3, \"fmvss-218\"]\n" + rest);
  const Outcome two = dashpad({"study", file("two.toml"), "--out", file("two.db")});
  EXPECT_EQ(two.exit_code, 2);
  EXPECT_THAT(two.err, AllOf(HasSubstr("standard[2] = \"en-1078\": has another impactor than en-1177"),
                             HasSubstr("standard[3] = \"nothing\""), HasSubstr("standard[4]"),
                             HasSubstr("limits a time above a level")));
  EXPECT_FALSE(fs::exists(file("two.db")));
}

TEST_F(StudyTest, CombinationsAreRankedDrawByDraw) {
  write_file(file("rank.toml"), R"(title = "Rank"
case = "case.toml"
samples = 100
responses = ["peak_acceleration"]
[factors."pad.thickness"]
values = ["60 mm", "50 mm", "51 mm"]
[factors."impactor.speed"]
distribution = "normal"
mean = "3 m/s"
deviation = "0.2 m/s"
)");
  EXPECT_EQ(compute("rank").exit_code, 0);
  const Outcome summary = dashpad({"study", "summary", file("rank.db"), "--json", file("answers.json")});
  EXPECT_THAT(summary.out, HasSubstr("Ranking by peak acceleration"));
  const json ranking = json::parse(read_file(file("answers.json"))).at("rankings").at(0);
  const json& ranks = ranking.at("ranks");
  ASSERT_EQ(ranks.size(), 3u);
  EXPECT_EQ(ranks[0].at("group"), 0);
  EXPECT_EQ(ranks[1].at("group"), 2);  // 51 mm
  EXPECT_EQ(ranks[2].at("group"), 1);
  EXPECT_TRUE(ranks[0].at("difference").is_null());
  // Every draw is higher on the thinner pad, and the interval is far narrower than the scatter of the draws.
  for (const std::size_t k : {1u, 2u}) {
    EXPECT_EQ(ranks[k].at("higher").at("rows_above"), 100);
    EXPECT_GT(ranks[k].at("difference").at("low"), 0);
  }
  const double width =
      ranks[2].at("difference").at("high").get<double>() - ranks[2].at("difference").at("low").get<double>();
  EXPECT_LT(width, 0.05 * ranks[2].at("median").get<double>());
}

TEST_F(StudyTest, AShortOneSaysNothingOnTheWay) {
  const auto err = said_within(10, [&] {
    fs::remove(file("drawn.db"));
    return compute("drawn").err;
  });
  if (!err) GTEST_SKIP() << "this machine takes more than ten seconds for 800 rows";
  EXPECT_EQ(*err, "");
}

TEST_F(StudyTest, ThePageBeginsWithTheAnswer) {
  compute("drawn");
  const auto heading = [&](std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(),
                     {"study", "summary", file("drawn.db"), "--report", file("page.html"), "--force"});
    EXPECT_EQ(dashpad(arguments).exit_code, 0);
    const std::string page = read_file(file("page.html"));
    const std::size_t begin = page.find("<h1");
    std::string words = page.substr(begin, page.find("</h1>", begin) - begin);
    const std::string hard_blank = "\u00a0";
    for (std::size_t at = 0; (at = words.find(hard_blank, at)) != std::string::npos;)
      words.replace(at, hard_blank.size(), " ");
    return words;
  };
  EXPECT_THAT(
      heading({"--limit", "peak_acceleration > 30 g"}),
      ContainsRegex("Peak acceleration exceeds 30 g in [0-9.]+ % of the draws \\(95 % interval [0-9.]+ % to "
                    "[0-9.]+ %\\)$"));
  EXPECT_THAT(
      heading({"--response", "rebound_speed"}),
      ContainsRegex(
          "Rebound speed depends most on the impact speed, which explains [0-9.]+ % of its variance$"));
}

/// On an elastic pad on an elastic support the rebound is as fast as the impact: the speed alone explains it.
TEST_F(StudyTest, IndicesNameTheFactorThatMatters) {
  compute("drawn");
  dashpad(
      {"study", "summary", file("drawn.db"), "--response", "rebound_speed", "--json", file("answers.json")});
  const json answers = json::parse(read_file(file("answers.json")));
  const json& indices = answers.at("groups").at(0).at("sobol_indices").at(0).at("indices");
  EXPECT_EQ(indices.at(0).at("factor"), "impactor.speed");
  EXPECT_NEAR(indices.at(0).at("total").at("value").get<double>(), 1, 0.1);
  EXPECT_LT(indices.at(1).at("total").at("value").get<double>(), 1e-3);
}

TEST_F(StudyTest, TheSameRowsOnAnyNumberOfThreads) {
  for (const char* threads : {"1", "3"})
    EXPECT_EQ(dashpad({"study", file("drawn.toml"), "--out", file(std::string{threads} + ".db"), "--threads",
                       threads, "--quiet"})
                  .exit_code,
              0);
  EXPECT_EQ(csv_of("1.db"), csv_of("3.db"));
  EXPECT_THAT(csv_of("1.db"), HasSubstr("impactor.speed_m_per_s"));
}

TEST_F(StudyTest, TheSameCommandAgainHasNothingToDo) {
  compute("drawn");
  const std::string rows = csv_of("drawn.db");
  const Outcome again = compute("drawn");
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out, HasSubstr("all were already in the store"));
  EXPECT_EQ(csv_of("drawn.db"), rows);
}

TEST_F(StudyTest, ASignalStopsItAndTheSameCommandGoesOn) {
  compute("drawn");
  const std::string command = "$DASHPAD study " + file("long.toml") + " --out " + file("long.db");
  // Not before the study has begun to write and has rows. False where it came to its end before.
  const auto is_stopped_by = [&](const std::string& signal, int code) {
    const std::string begun = "find " + file("") + " -name 'long.db*' -newer " + file("stamp") +
                              " | grep -q . && " + has_rows(file("long.db"));
    const Outcome stopped = shell("touch " + file("stamp") + "; sleep 0.02; " + command + " &\n" +
                                  until(begun) + "kill -" + signal + " $!; wait $!");
    if (stopped.exit_code == 0) return false;
    EXPECT_EQ(stopped.exit_code, code) << stopped.err;
    EXPECT_THAT(stopped.err, HasSubstr("Run the same command again to resume"));
    EXPECT_EQ(stopped.out, "");
    EXPECT_THAT(dashpad({"study", "summary", file("long.db")}).out, HasSubstr("NOT COMPLETE: "));
    return true;
  };
  int samples = 2500;
  do {  // as many rows as it takes on this machine
    samples *= 8;
    ASSERT_LT(samples, 2'000'000) << "it always comes to its end";
    fs::remove(file("long.db"));
    write_file(file("long.toml"), with(drawn_study, "samples = 200", "samples = " + std::to_string(samples)));
  } while (!is_stopped_by("TERM", 128 + SIGTERM) || !is_stopped_by("HUP", 128 + SIGHUP));
  const Outcome whole = shell(command);
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  const std::string rows = std::to_string(4 * samples);
  EXPECT_THAT(whole.out, AllOf(HasSubstr(rows + " rows in"), Not(HasSubstr(rows + " computed"))));
}

/// nohup ignores SIGHUP, and a script in the background SIGINT: neither stops the study then.
TEST_F(StudyTest, ASignalThatIsIgnoredStaysIgnored) {
  write_file(file("long.toml"), with(drawn_study, "samples = 200", endless));
  for (const char* signal : {"HUP", "INT", "TERM"}) {
    const std::string store = file(std::string{signal} + ".db");
    const std::string rows = "$($DASHPAD study export " + store + " --csv - 2> /dev/null | wc -l)";
    // A study that stops writes no more than the five batches of 256 rows that are under way.
    const Outcome outcome =
        shell("trap '' " + std::string{signal} + "\n$DASHPAD study " + file("long.toml") + " --out " + store +
              " --quiet --threads 1 &\n" + until("[ " + rows + " -gt 1 ]") + "kill -" + signal +
              " $!; kill -" + signal + " $!; seen=" + rows + "\n" +
              until("[ " + rows + " -gt $((seen + 5000)) ]") + "kill -KILL $!; wait $!");
    EXPECT_EQ(outcome.exit_code, 128 + SIGKILL) << signal << outcome.err;
  }
}

TEST_F(StudyTest, AStoreThatIsDeletedOrReplacedWhileItRunsIsNoticed) {
  write_file(file("long.toml"), with(drawn_study, "samples = 200", endless));
  const std::string store = file("long.db");
  for (const std::string& action : {"rm " + store, "cp case.toml other; mv other " + store}) {
    const Outcome outcome =
        shell("cd " + fs::path(store).parent_path().string() + "\n$DASHPAD study long.toml --out " + store +
              " --quiet &\n" + until("[ -s " + store + "-wal ]") + "kill -STOP $!; " + action +
              "; kill -CONT $!; wait $!");
    EXPECT_EQ(outcome.exit_code, 1) << action << outcome.out;
    EXPECT_EQ(outcome.out, "") << action;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(store), HasSubstr("deleted, renamed or replaced"))) << action;
    for (const char* left : {"long.db", "long.db-wal", "long.db-shm"}) fs::remove(file(left));
  }
}

/// Half of the impacts bottom out on a rigid support: no limit on the force is kept by them.
TEST_F(StudyTest, RowsThatStruckThroughAreAboveEveryLimit) {
  const fs::path source{DASHPAD_SOURCE_DIR};
  write_file(file("struck.toml"), "case = \"" + (source / "examples/rigid-floor-bottoming.toml").string() +
                                      R"("
responses = ["peak_force", "hic15", "peak_strain"]
[factors."impactor.speed"]
values = ["1 mph", "2 mph", "15 mph", "20 mph"]
)");
  const Outcome computed = compute("struck");
  EXPECT_EQ(computed.exit_code, 0) << computed.err;
  EXPECT_THAT(computed.out, HasSubstr("0 doubtful; 2 bottomed out on a rigid support\n"));
  const Outcome summary = dashpad({"study", "summary", file("struck.db"), "--limit", "peak_force > 1000 kN",
                                   "--limit", "hic15 > 1e9", "--json", file("answers.json")});
  EXPECT_THAT(summary.out, AllOf(HasSubstr("BOTTOMED OUT: in 2 of 4 rows (50 %)"),
                                 ContainsRegex("Peak force +1000000 N +50 +2 +2 \\(50 %\\) +4\n"),
                                 ContainsRegex("HIC15 +1e\\+09 +50 +2 +2 \\(50 %\\) +4\n")));
  const json answers = json::parse(read_file(file("answers.json")));
  for (const json& exceedance : answers.at("groups").at(0).at("exceedances")) {
    EXPECT_EQ(exceedance.at("probability").at("value"), 0.5);
    EXPECT_EQ(exceedance.at("rows_struck_through"), 2);
  }
}

/// The run is stopped in the middle (SIGSTOP), so that it is there for certain while others read.
TEST_F(StudyTest, IsReadWhileItRuns) {
  write_file(file("long.toml"), with(drawn_study, "samples = 200", endless));
  const std::string store = file("long.db");
  const Outcome reads =
      shell("$DASHPAD study " + file("long.toml") + " --out " + store + " --quiet &\n" +
            until("$DASHPAD study summary " + store + " >" + file("summary") + " 2>/dev/null") +
            "kill -STOP $!\n" + "$DASHPAD study summary " + store + "; $DASHPAD study export " + store +
            " --csv " + file("rows.csv") + "; $DASHPAD study " + file("long.toml") + " --out " + store +
            "; echo second $?; kill -CONT $!; kill -TERM $!; wait $!");
  EXPECT_EQ(reads.exit_code, 128 + SIGTERM) << reads.err;
  EXPECT_THAT(reads.out, AllOf(HasSubstr("NOT COMPLETE: "), HasSubstr("second 2")));
  EXPECT_THAT(reads.err, HasSubstr("another run is writing to it"));
  EXPECT_THAT(read_file(file("summary")), HasSubstr("NOT COMPLETE: "));
  EXPECT_GT(fs::file_size(file("rows.csv")), 0U);
}

/// Another program's SQLite, with no knowledge of ours.
TEST_F(StudyTest, IsReadByOtherToolsWhileItRuns) {
  if (shell("command -v sqlite3").exit_code != 0) GTEST_SKIP() << "sqlite3 is not installed";
  write_file(file("long.toml"), with(drawn_study, "samples = 200", endless));
  const std::string store = file("long.db");
  const std::string count = "sqlite3 " + store + " 'SELECT count(*) FROM samples'";
  const Outcome reads =
      shell("$DASHPAD study " + file("long.toml") + " --out " + store + " --quiet &\n" +
            until("[ \"$(" + count + " 2>/dev/null || echo 0)\" -gt 0 ]") + "kill -STOP $!\n" + count +
            "; echo code $?; kill -CONT $!; kill -TERM $!; wait $!");
  EXPECT_EQ(reads.exit_code, 128 + SIGTERM) << reads.err;
  EXPECT_THAT(reads.out, ContainsRegex("^[1-9][0-9]*\ncode 0\n$"));
}

TEST_F(StudyTest, ReplaysARowWithoutTheFilesOfTheStudy) {
  compute("drawn");
  fs::remove(file("drawn.toml"));
  fs::remove(file("case.toml"));
  const Outcome outcome = dashpad(
      {"study", "replay", file("drawn.db"), "17", "--json", file("row.json"), "--csv", file("row.csv")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("Row 17: impactor.speed = "), HasSubstr("were reproduced to the last bit")));
  std::istringstream rows(csv_of("drawn.db"));
  std::string line;
  for (int i = 0; i <= 18; ++i) std::getline(rows, line);
  const double force = json::parse(read_file(file("row.json"))).at("peak_force_N");
  EXPECT_THAT(line, AllOf(testing::StartsWith("17,"), HasSubstr("," + json(force).dump() + ","))) << force;
  EXPECT_THAT(read_file(file("row.csv")), HasSubstr("\n"));
}

TEST_F(StudyTest, ReplaySaysSoWhereAStoredResponseDoesNotComeBack) {
  compute("drawn");
  if (shell("command -v sqlite3").exit_code != 0 && shell("python3 -c 'import sqlite3'").exit_code != 0)
    GTEST_SKIP() << "neither sqlite3 nor python3";
  const Outcome edit =
      shell("python3 -c \"import sqlite3; c = sqlite3.connect('" + file("drawn.db") +
            "'); c.execute('UPDATE samples SET peak_force = 1 WHERE row = 5'); c.commit()\"");
  ASSERT_EQ(edit.exit_code, 0) << edit.err;
  const Outcome outcome = dashpad({"study", "replay", file("drawn.db"), "5"});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("DIFFERENT"), HasSubstr("peak_force: stored 1, now ")));
}

TEST_F(StudyTest, CushionCurvesOfAGrid) {
  compute("grid");
  const Outcome outcome = dashpad({"study", "summary", file("grid.db"), "--json", file("answers.json")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("A grid gives no probabilities"));
  const json answers = json::parse(read_file(file("answers.json")));
  const json& curves = answers.at("cushion_curves").at("curves");
  ASSERT_EQ(curves.size(), 6U);
  EXPECT_NEAR(curves.at(0).at("drop_height_m").get<double>(), 1 / (2 * 9.80665), 1e-12);
  EXPECT_EQ(curves.at(5).at("thickness_m"), 0.06);
  EXPECT_EQ(curves.at(0).at("points").size(), 5U);
  EXPECT_TRUE(answers.at("groups").at(0).at("distributions").at(0).at("mean").at("low").is_null());
}

TEST_F(StudyTest, PageAndStill) {
  compute("grid");
  compute("drawn");
  for (const char* name : {"grid", "drawn"}) {
    const Outcome outcome = dashpad(
        {"study", "summary", file(name + std::string{".db"}), "--picture", file(name + std::string{".svg"})});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  }
  EXPECT_THAT(read_file(file("grid.svg")),
              HasSubstr("weight divided by the contact area at the largest penetration"));
  const Outcome report = dashpad({"study", "summary", file("drawn.db"), "--report", file("drawn.html")});
  if (report.exit_code == 2 && report.err.find("without the page") != std::string::npos)
    GTEST_SKIP() << report.err;
  EXPECT_EQ(report.exit_code, 0) << report.err;
  EXPECT_THAT(read_file(file("drawn.html")), AllOf(HasSubstr("Effect of the factors"), HasSubstr("Scatter")));
}

TEST_F(StudyTest, Exports) {
  compute("grid");
  const Outcome outcome =
      dashpad({"study", "export", file("grid.db"), "--csv", file("grid.csv"), "--hdf5", file("grid.h5")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out, "30 rows\n");
  EXPECT_EQ(read_file(file("grid.csv")), csv_of("grid.db"));
  EXPECT_THAT(read_file(file("grid.h5")), HasSubstr("HDF"));
  expect_refused({"export", file("grid.db"), "--csv", file("grid.csv")}, "already exists");
  EXPECT_EQ(dashpad({"study", "export", file("grid.db"), "--csv", file("grid.csv"), "--force"}).exit_code, 0);
}

TEST_F(StudyTest, ExportsIntoPipesAndThroughLinks) {
  compute("grid");
  const std::string rows = csv_of("grid.db");
  const Outcome piped = shell("mkfifo '" + file("pipe") + "'; cat '" + file("pipe") + "' > '" + file("got") +
                              "' & \"$DASHPAD\" study export '" + file("grid.db") + "' --force --csv '" +
                              file("pipe") + "'; code=$?; wait; exit $code");
  EXPECT_EQ(piped.exit_code, 0) << piped.err;
  EXPECT_TRUE(fs::is_fifo(file("pipe")));
  EXPECT_EQ(read_file(file("got")), rows);
  expect_refused({"export", file("grid.db"), "--force", "--hdf5", file("pipe")}, "needs the name of a file");
  EXPECT_TRUE(fs::is_fifo(file("pipe")));

  write_file(file("kept.csv"), "old");
  fs::create_symlink(file("kept.csv"), file("link.csv"));
  EXPECT_EQ(dashpad({"study", "export", file("grid.db"), "--force", "--csv", file("link.csv")}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(file("link.csv")));
  EXPECT_EQ(read_file(file("kept.csv")), rows);
}

TEST_F(StudyTest, RefusesWhatIsNoRequest) {
  compute("drawn");
  const std::string store = file("drawn.db");
  expect_refused({}, "STUDY");
  expect_refused({file("drawn.toml")}, "--out");
  expect_refused({file("missing.toml"), "--out", file("new.db")}, "missing.toml");
  expect_refused({file("grid.toml"), "--out", store}, "a different study");
  expect_refused({file("grid.toml"), "--out", file("no/such/folder.db")}, "no folder");
  expect_refused({file("grid.toml"), "--out", case_file()}, "case.toml");
  expect_refused({file("drawn.toml"), "--out", store, "--threads", "0"}, "--threads");
  expect_refused({"summary", file("missing.db")}, "missing.db");
  expect_refused({"summary", case_file()}, "case.toml");
  expect_refused({"summary", store, "--response", "hic51"},
                 "not a response of this study; available: peak_force");
  expect_refused({"summary", store, "--limit", "peak_force"}, "must consist of a response, > and a value");
  expect_refused({"summary", store, "--limit", "peak_force > much"}, "peak_force > much");
  expect_refused({"summary", store, "--limit", "peak_force > 5"}, "peak_force > 5");
  expect_refused({"summary", store, "--limit", "peak_force > 5 kg"}, "peak_force > 5 kg");
  expect_refused({"summary", store, "--limit", "hic15 > 5"}, "hic15 is not a response");
  expect_refused({"summary", store, "--picture", file("still.gif")}, ".svg, .png or .pdf");
  expect_refused({"summary", store, "--json", file("drawn.toml")}, "already exists");
  expect_refused({"replay", store, "800"}, "must be a whole number from 0 to 799");
  expect_refused({"replay", store, "-1"}, "ROW");
  expect_refused({"replay", store, "first"}, "ROW");
  expect_refused({"export", store}, "--csv or --hdf5");
  expect_refused({"export", store, "--hdf5", "-"}, "needs the name of a file");
}

TEST_F(StudyTest, NamesAllFaultsAtOnce) {
  write_file(file("bad.toml"),
             with(with(drawn_study, "\"rebound_speed\"", "\"bounce\""), "\"4 kg\"", "\"4 m\""));
  const Outcome outcome = compute("bad");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("bad.toml:"), HasSubstr("4 m"), HasSubstr("nothing was run")));
  EXPECT_FALSE(fs::exists(file("bad.db")));
  compute("drawn");
  const Outcome two = dashpad({"study", "summary", file("drawn.db"), "--response", "a", "--limit", "b"});
  EXPECT_THAT(two.err, HasSubstr("2 errors"));
}

TEST_F(StudyTest, HelpTeaches) {
  for (const std::vector<std::string>& command :
       {std::vector<std::string>{"study"}, {"study", "replay"}, {"study", "summary"}, {"study", "export"}}) {
    std::vector<std::string> arguments = command;
    arguments.emplace_back("--help");
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 0);
    EXPECT_THAT(outcome.out, AllOf(HasSubstr("Examples:\n"), HasSubstr("Exit codes:")));
  }
}

}  // namespace
}  // namespace dashpad::test
