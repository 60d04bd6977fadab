// dashpad spit1984: what it prints, what it writes, what it refuses.

#include <algorithm>
#include <sstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::ElementsAre;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

/// With `nine` the published cases, on which the program is known to come to an end or to an ABEND.
const std::string twenty_one = examples + "dashboard-20mph-21-parameter.toml";

class Spit1984Test : public CommandTest {
 protected:
  /// Runs with files asked for; nothing may come of it but complaints.
  Outcome refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "spit1984");
    for (const char* more : {"--json", "--csv", "--listing"}) {
      arguments.emplace_back(more);
      arguments.push_back(file(std::string{"refused"} + more));
    }
    const auto before = other_files();
    Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(arguments) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_NE(outcome.err, "");
    EXPECT_EQ(other_files(), before);
    return outcome;
  }

  Outcome refused_support(const std::string& support) {
    const std::string text = elastic_case();
    write_file(file("support.toml"), text.substr(0, text.find("[support]")) + "[support]\n" + support);
    return refused({file("support.toml")});
  }
};

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// The numbers of a row as they are printed, a blank between them.
bool has_row(const std::string& listing, const std::string& row) {
  const auto lines = lines_of(listing);
  return std::ranges::any_of(lines, [&](const std::string& line) {
    std::istringstream stream(line);
    std::string cells;
    for (std::string cell; stream >> cell;) cells += (cells.empty() ? "" : " ") + cell;
    return cells == row;
  });
}

TEST_F(Spit1984Test, PrintsTheReportAndPutsRemarksOnStandardError) {
  const Outcome outcome = dashpad({"spit1984", twenty_one});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("SPHERE/PAD IMPACT TRACKER\n"), HasSubstr("\fRUN SUMMARY\n")));
  EXPECT_EQ(outcome.err, "1984 program in pdp10 arithmetic\n");
}

// Appendix C of the report, the 21-parameter model: the rows at 1 ms and at the end.
TEST_F(Spit1984Test, PrintsThePublishedRows) {
  for (const Outcome& outcome :
       {dashpad({"spit1984", twenty_one}), dashpad({"spit1984", twenty_one, "--listing", "-"})}) {
    EXPECT_TRUE(has_row(outcome.out, "0.100E+01 -0.866E+02 -0.866E+01 0.352E+03 0.352E+00 0.208E+00"));
    EXPECT_TRUE(has_row(lines_of(outcome.out).back(),
                        "0.243E+02 -0.999E+01 0.000E+00 -0.331E+03 0.665E+00 0.648E+00"));
  }
}

TEST_F(Spit1984Test, FitsThePaper) {
  for (const char* arithmetic : {"pdp10", "binary32", "binary64"})
    for (const auto& more : {std::vector<std::string>{}, {"--listing", "-"}}) {
      std::vector<std::string> arguments{"spit1984", nine, "--arithmetic", arithmetic};
      arguments.insert(arguments.end(), more.begin(), more.end());
      for (const std::string& line : lines_of(dashpad(arguments).out)) EXPECT_LE(line.size(), 132u) << line;
    }
}

TEST_F(Spit1984Test, OnlyTheTerminalIsToldOfThePrecisionLimit) {
  const Outcome outcome =
      dashpad({"spit1984", twenty_one, "--arithmetic", "binary32", "--listing", file("for21.txt")});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, HasSubstr("STEP  "));
  EXPECT_THAT(outcome.err, HasSubstr("PRECISION LIMIT: 1 of 243 steps"));
  EXPECT_THAT(read_file(file("for21.txt")), AllOf(HasSubstr("RUN SUMMARY"), Not(HasSubstr("STEP  "))));
  EXPECT_THAT(other_files(), ElementsAre("for21.txt"));
}

TEST_F(Spit1984Test, WritesJson) {
  const Outcome outcome = dashpad({"spit1984", twenty_one, "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const json result = json::parse(outcome.out);
  EXPECT_EQ(result["arithmetic"], "pdp10");
  EXPECT_EQ(result["abend"], nullptr);
  EXPECT_EQ(result["steps"], 244);  // from 0 to 24.3 ms by 0.1 ms
  EXPECT_EQ(result["deck"]["VIN_mph"], 20);
  EXPECT_EQ(result["deck"]["KEYP"], 5);
  EXPECT_NEAR(result["peak_force_lbf"].get<double>(), -1276, 1);
}

TEST_F(Spit1984Test, WritesTheWholeHistoryAsCsv) {
  const Outcome outcome =
      dashpad({"spit1984", twenty_one, "--csv", file("history.csv"), "--json", file("result.json")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, StartsWith("SPHERE/PAD"));
  const auto rows = lines_of(read_file(file("history.csv")));
  ASSERT_EQ(rows.size(), 1 + json::parse(read_file(file("result.json")))["steps"].get<std::size_t>());
  EXPECT_EQ(rows[0], "time_ms,force_lbf,acceleration_g,speed_in_per_s,motion_in,penetration_in");
  EXPECT_THAT(rows[1], AllOf(StartsWith("0,0,0,352.8"), EndsWith(",0,0")));
  for (const std::string& row : rows) EXPECT_EQ(std::ranges::count(row, ','), 5) << row;
}

TEST_F(Spit1984Test, ReadsTheSameCsvFromStandardOutput) {
  dashpad({"spit1984", case_file(), "--csv", file("history.csv")});
  EXPECT_EQ(dashpad({"spit1984", case_file(), "--csv", "-"}).out, read_file(file("history.csv")));
}

TEST_F(Spit1984Test, ComputesInEachArithmetic) {
  std::vector<std::string> outputs;
  for (const char* arithmetic : {"pdp10", "binary32", "binary64"}) {
    const Outcome outcome = dashpad({"spit1984", nine, "--arithmetic", arithmetic, "--json", "-"});
    EXPECT_EQ(json::parse(outcome.out)["arithmetic"], arithmetic);
    EXPECT_THAT(outcome.err, StartsWith("1984 program in " + std::string{arithmetic} + " arithmetic\n"));
    outputs.push_back(json::parse(outcome.out)["peak_force_lbf"].dump());
  }
  EXPECT_NE(outputs[0], outputs[1]);
  EXPECT_NE(outputs[1], outputs[2]);
  EXPECT_THAT(refused({nine, "--arithmetic", "binary16"}).err, HasSubstr("binary16"));
  EXPECT_THAT(refused({nine, "--arithmetic", ""}).err, HasSubstr("--arithmetic"));
}

TEST_F(Spit1984Test, MendsTheDefectsThatAreNamed) {
  const auto mended = [](std::vector<std::string> options) {
    options.insert(options.begin(), "spit1984");
    options.insert(options.end(), {nine, "--json", "-"});  // CASE may come last
    const Outcome outcome = dashpad(options);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    std::vector<std::string> names;
    const json defects = json::parse(outcome.out)["defects"];
    for (const auto& [name, state] : defects.items())
      if (state == "mended") {
        names.push_back(name);
        EXPECT_THAT(outcome.err, HasSubstr(name + " corrected"));
      }
    return names;
  };
  EXPECT_THAT(mended({}), IsEmpty());
  EXPECT_THAT(mended({"--repair", "tension"}), ElementsAre("tension"));
  EXPECT_THAT(mended({"--repair", "tension", "--repair", "edge-residue"}),
              ElementsAre("edge-residue", "tension"));
  EXPECT_EQ(mended({"--arithmetic", "binary64", "--repair", "all"}).size(), 4u);
  EXPECT_THAT(refused({nine, "--repair", "everything"}).err, HasSubstr("everything"));
  refused({nine, "--repair"});
}

TEST_F(Spit1984Test, AnAbendIsExitCode3AndSaysWhatToDo) {
  const Outcome outcome = dashpad(
      {"spit1984", nine, "--arithmetic", "binary64", "--json", file("r.json"), "--csv", file("h.csv")});
  EXPECT_EQ(outcome.exit_code, 3);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("ABEND 900, too many iterations: "), HasSubstr("--time-step")));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("ABEND - TOO MANY ITERATIONS"), HasSubstr("RUN SUMMARY")));
  EXPECT_EQ(json::parse(read_file(file("r.json")))["abend"]["number"], 900);
  EXPECT_GE(lines_of(read_file(file("h.csv"))).size(), 3u);
}

TEST_F(Spit1984Test, AFullHistoryOrContactFieldIsAnAbend) {
  const Outcome steps = dashpad({"spit1984", nine, "--most-steps", "20"});
  EXPECT_EQ(steps.exit_code, 3);
  EXPECT_THAT(steps.err, HasSubstr("ABEND 902, too many time steps: "));
  EXPECT_THAT(steps.out, HasSubstr("ABEND - TOO MANY TIME STEPS"));
  const Outcome stations =
      dashpad({"spit1984", nine, "--most-stations", "2", "--listing", file("for21.txt")});
  EXPECT_EQ(stations.exit_code, 3);
  EXPECT_THAT(stations.err, HasSubstr("ABEND 904, too many contact divisions: "));
  EXPECT_THAT(stations.out, HasSubstr("ABEND - TOO MANY CONTACT DIVISIONS"));
  EXPECT_THAT(read_file(file("for21.txt")), Not(HasSubstr("ABEND")));  // as printed
}

TEST_F(Spit1984Test, WarnsOfALongTimeStep) {
  const std::string warning = "the report recommends at most 1.64 ms for this support";  // 0.25 sqrt(M/K)
  EXPECT_THAT(dashpad({"spit1984", nine, "--time-step", "1.65"}).err,
              HasSubstr("TIME STEP of 1.65 ms: " + warning));
  EXPECT_THAT(dashpad({"spit1984", nine, "--time-step", "1.64"}).err, Not(HasSubstr("TIME STEP")));
}

TEST_F(Spit1984Test, RefusesWhatIsNoTimeStep) {
  for (const char* step : {"0", "-0.1", "nan", "-nan", "inf", "1e-9", "1e9", "1e400", "abc", "0.1ms", ""})
    EXPECT_THAT(refused({nine, "--time-step", step}).err, HasSubstr("--time-step")) << step;
}

TEST_F(Spit1984Test, RefusesOtherNumbersOutOfRange) {
  const std::vector<std::vector<std::string>> settings{
      {"--print-interval", "0"},          {"--print-interval", "1.5"},        {"--most-steps", "3"},
      {"--most-steps", "1e12"},           {"--most-stations", "1"},           {"--most-iterations", "0"},
      {"--equilibrium-tolerance", "nan"}, {"--equilibrium-tolerance", "1.1"}, {"--precision-tolerance", "-1"},
      {"--precision-tolerance", "nan"},
  };
  for (const auto& setting : settings)
    EXPECT_THAT(refused({nine, setting[0], setting[1]}).err, HasSubstr(setting[0])) << setting[1];
}

TEST_F(Spit1984Test, RefusesASupportThatTheProgramDoesNotKnow) {
  EXPECT_THAT(refused_support("type = \"rigid\"\n").err, HasSubstr("support.toml: support.type: "));
  std::string points = "type = \"curve\"\npoints = [";
  for (int i = 1; i <= 5; ++i)
    points += "[\"" + std::to_string(i) + " mm\", \"" + std::to_string(100 * i * i) + " N\"],";
  EXPECT_THAT(refused_support(points + "]\n").err, HasSubstr("support.points: "));
}

TEST_F(Spit1984Test, RefusesACaseThatRunRefuses) {
  write_file(file("bad.toml"), with(elastic_case(), "80 mm", "80 kg"));
  EXPECT_THAT(refused({file("bad.toml")}).err, HasSubstr("bad.toml:4: impactor.radius"));
  refused({file("missing.toml")});
}

TEST_F(Spit1984Test, WantsACaseOrATerminal) {
  EXPECT_THAT(refused({}).err, HasSubstr("CASE is missing; use --interactive"));
  EXPECT_THAT(refused({nine, "--interactive"}).err, HasSubstr("leave out CASE"));
  EXPECT_THAT(refused({"--interactive", "--time-step", "0.2"}).err, HasSubstr("--time-step"));
  EXPECT_THAT(refused({"--interactive", "--print-interval", "5"}).err, HasSubstr("--print-interval"));
}

TEST_F(Spit1984Test, KeepsExistingFilesUnlessForced) {
  for (const char* option : {"--listing", "--json", "--csv"}) {
    write_file(file("old"), "precious");
    const Outcome kept = dashpad({"spit1984", case_file(), option, file("old")});
    EXPECT_EQ(kept.exit_code, 2);
    EXPECT_EQ(kept.out, "");
    EXPECT_THAT(kept.err, AllOf(HasSubstr(option), HasSubstr("--force")));
    EXPECT_EQ(read_file(file("old")), "precious");
    dashpad({"spit1984", case_file(), option, file("old"), "--force"});
    EXPECT_NE(read_file(file("old")), "precious") << option;
  }
}

TEST_F(Spit1984Test, NoticesFilesThatCannotBeWrittenBeforeTheRun) {
  EXPECT_THAT(refused({nine, "--listing", file("nowhere/a")}).err, HasSubstr("--listing"));
  for (const char* option : {"--listing", "--json", "--csv"}) {
    const Outcome missing = dashpad({"spit1984", nine, option, file("nowhere/a")});
    EXPECT_EQ(missing.exit_code, 2);
    EXPECT_THAT(missing.err, HasSubstr("there is no folder"));
  }
  EXPECT_EQ(dashpad({"spit1984", nine, "--json", "-", "--csv", "-"}).exit_code, 2);
  EXPECT_EQ(dashpad({"spit1984", nine, "--json", file("a"), "--listing", file("a")}).exit_code, 2);
  EXPECT_EQ(dashpad({"spit1984", case_file(), "--listing", case_file(), "--force"}).exit_code, 2);
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(Spit1984Test, NoticesAReadOnlyFolderBeforeTheRun) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::create_directory(file("closed"));
  fs::permissions(file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome outcome = dashpad({"spit1984", nine, "--listing", file("closed/for21.txt")});
  fs::permissions(file("closed"), fs::perms::owner_all);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("Permission denied"));
}

TEST_F(Spit1984Test, AFullDiskIsExitCode1) {
  for (const char* more : {"", " --listing -", " --json -", " --csv -"}) {
    const Outcome outcome = shell("$DASHPAD spit1984 " + nine + more + " > /dev/full");
    EXPECT_EQ(outcome.exit_code, 1) << more;
    EXPECT_THAT(outcome.err, HasSubstr("could not write to standard output")) << more;
  }
  EXPECT_EQ(dashpad({"spit1984", nine, "--listing", "/dev/full"}).exit_code, 1);
  const Outcome second = shell("ulimit -f 1; exec $DASHPAD spit1984 " + nine + " --csv " + file("h.csv"));
  EXPECT_EQ(second.exit_code, 1);
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(Spit1984Test, AReaderThatGoesAwayIsNoError) {
  const Outcome outcome =
      shell("{ $DASHPAD spit1984 " + nine + " --print-interval 1 2>/dev/null; echo $? >&2; } | head -n 1");
  EXPECT_EQ(outcome.out, "SPHERE/PAD IMPACT TRACKER\n");
  EXPECT_EQ(outcome.err, "0\n");
  EXPECT_EQ(shell("{ $DASHPAD spit1984 " + nine + " 2>/dev/null; echo $? >&2; } | true").err, "0\n");
}

// Extreme cases must end by themselves, whatever comes of them: done, or an ABEND.
TEST_F(Spit1984Test, EndsWhateverTheCase) {
  const std::vector<std::pair<std::string, std::string>> changes{
      {"100 N/mm", "1e9 N/mm"}, {"100 N/mm", "1e-6 N/mm"}, {"80 mm", "0.02 mm"}, {"80 mm", "50 m"},
      {"3 m/s", "0.0002 m/s"},  {"3 m/s", "900 m/s"},      {"50 mm", "0.1 mm"},  {"50 mm", "5 m"},
      {"5 kg", "900000 kg"},    {"5 kg", "2e-6 kg"},       {"300 kPa", "1 Pa"},  {"300 kPa", "1e9 Pa"},
  };
  for (const auto& [old, extreme] : changes)
    for (const char* arithmetic : {"pdp10", "binary32", "binary64"}) {
      write_file(file("extreme.toml"), with(elastic_case(), old, extreme));
      const Outcome outcome = shell("exec timeout 600 $DASHPAD spit1984 " + file("extreme.toml") +
                                    " --arithmetic " + arithmetic + " --json -");
      EXPECT_TRUE(outcome.exit_code == 0 || outcome.exit_code == 3)
          << extreme << " " << arithmetic << ": " << outcome.exit_code << outcome.err;
      EXPECT_TRUE(json::accept(outcome.out)) << extreme << " " << arithmetic;
    }
}

}  // namespace
}  // namespace dashpad::test
