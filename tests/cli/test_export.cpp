// dashpad export: curves for other programs' decks.

#include <algorithm>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

class ExportTest : public CommandTest {
 protected:
  /// On standard output.
  [[nodiscard]] Outcome exported(const std::string& format, const std::vector<std::string>& more = {}) const {
    std::vector<std::string> arguments{"export", case_file(), "--format", format, "--out", "-"};
    arguments.insert(arguments.end(), more.begin(), more.end());
    return dashpad(arguments);
  }
};

std::size_t count(const std::string& text, const std::string& part) {
  std::size_t found = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

/// The largest y of the points below `start`, a line's beginning, in columns 21 to 40.
double largest_below(const std::string& text, const std::string& start) {
  std::istringstream stream(text.substr(text.find("\n" + start)));
  double largest = 0;
  for (std::string line; std::getline(stream, line);) {
    if (line == "*END") break;
    if (line.size() == 40 && line[0] == ' ') largest = std::max(largest, std::stod(line.substr(20)));
  }
  return largest;
}

TEST_F(ExportTest, WritesAllCurvesAndSaysSo) {
  const Outcome outcome =
      dashpad({"export", case_file(), "--format", "ls-dyna", "--out", file("pad.k"), "--first-id", "9001"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("9001  force "), HasSubstr("9007  unloading ")));
  const std::string deck = read_file(file("pad.k"));
  EXPECT_THAT(deck, AllOf(StartsWith("*KEYWORD\n$ Dashpad "), HasSubstr("\n$ Dashpad: Elastic\n"),
                          testing::EndsWith("\n*END\n")));
  EXPECT_EQ(count(deck, "\n*DEFINE_CURVE_TITLE\n"), 7u);
  EXPECT_THAT(deck, HasSubstr("\n      9007         0       1.0       1.0       0.0       0.0         0\n"));
  EXPECT_THAT(other_files(), ElementsAre("pad.k"));
}

TEST_F(ExportTest, WritesRadiossBlocks) {
  const Outcome outcome = exported("radioss", {"--system", "t-mm-s", "--curves", "loading,unloading"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(count(outcome.out, "\n/FUNCT/"), 2u);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("/FUNCT/1\nDashpad loading: force (N) against penetration (mm)\n"),
                                 HasSubstr("as in /BEGIN: Mg mm s\n"), Not(HasSubstr("/END"))));
  EXPECT_THAT(outcome.err, HasSubstr("unloading"));
}

TEST_F(ExportTest, WritesTwoColumnsOfCsv) {
  const Outcome outcome = exported("csv", {"--curves", "force", "--system", "kg-m-s"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("# Dashpad "), HasSubstr("\ntime_s,force_N\n0,0\n")));
}

TEST_F(ExportTest, AgreesWithRunInEverySystem) {
  const auto result = nlohmann::json::parse(dashpad({"run", case_file(), "--json", "-"}).out);
  const double peak = result["peak_force_N"].get<double>();
  for (const auto& [system, newtons] :
       {std::pair{"kg-mm-ms", 1e3}, std::pair{"kg-m-s", 1.0}, std::pair{"t-mm-s", 1.0},
        std::pair{"lbf-s2/in-in-s", 4.4482216152605}})
    for (const char* name : {"force", "loading"}) {
      const Outcome outcome = exported("ls-dyna", {"--curves", name, "--system", system});
      // The history's largest force is not the summary's, which is read off between two steps.
      EXPECT_NEAR(largest_below(outcome.out, "*DEFINE_CURVE") * newtons, peak, 2e-2 * peak) << system;
    }
}

TEST_F(ExportTest, TakesAccelerationsInG) {
  const std::vector<std::string> curve{"--curves", "acceleration"};
  EXPECT_THAT(exported("csv", curve).out, HasSubstr("\ntime_ms,acceleration_mm_per_ms2\n"));
  EXPECT_THAT(exported("csv", {"--curves", "acceleration", "--acceleration-in-g"}).out,
              HasSubstr("\ntime_ms,acceleration_g\n"));
}

TEST_F(ExportTest, ThinsAndSaysTheError) {
  const Outcome outcome = exported("csv", {"--curves", "force", "--points", "9"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              testing::ContainsRegex("# force: 9 of [0-9]+ points, off by at most [0-9.e-]+ % of"));
  EXPECT_EQ(count(outcome.out.substr(outcome.out.find("\ntime_ms")), "\n"), 1 + 9 + 1u);
}

TEST_F(ExportTest, SolvesToTheToleranceAskedFor) {
  const auto points = [&](const char* tolerance) {
    return count(exported("csv", {"--curves", "force", "--tolerance", tolerance}).out, "\n");
  };
  EXPECT_GT(points("1e-7"), points("1e-2"));
}

TEST_F(ExportTest, KeepsTheNumberOfACurveThatIsNotThere) {
  const std::string rigid =
      with(with(elastic_case(), "3 m/s", "60 m/s"), "type = \"linear\"", "type = \"rigid\"");
  write_file(case_file(), with(rigid, "stiffness = \"100 N/mm\"\n", ""));
  const Outcome outcome = exported("ls-dyna", {"--curves", "unloading,loading"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(count(outcome.out, "\n*DEFINE_CURVE_TITLE\n"), 1u);
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\n$ FLAG: BOTTOMED at "), HasSubstr("\n         2         0"),
                                 HasSubstr("curve 1: not available: the impactor did not leave the pad")));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("not available"), HasSubstr("BOTTOMED at ")));

  const Outcome nothing =
      dashpad({"export", case_file(), "--format", "csv", "--out", file("u.csv"), "--curves", "unloading"});
  EXPECT_EQ(nothing.exit_code, 1);
  EXPECT_THAT(nothing.err, HasSubstr("nothing was written: unloading is not available"));
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(ExportTest, FlagsExtrapolation) {
  write_file(case_file(), with(elastic_case(), "[support]",
                               "[pad.fitted]\nhighest_strain = 0.01\nlowest_rate = \"1 1/s\"\n"
                               "highest_rate = \"2 1/s\"\n[support]"));
  for (const char* format : {"ls-dyna", "radioss"}) {
    const Outcome outcome = exported(format);
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr(" FLAG: EXTRAPOLATED STRAIN: the strain reaches"));
  }
}

TEST_F(ExportTest, FlagsAMissedToleranceAndExitsWith3) {
  const Outcome outcome =
      dashpad({"export", std::string{DASHPAD_SOURCE_DIR} + "/examples/helmet-pad-10fps.toml", "--format",
               "radioss", "--out", file("pad.inc"), "--tolerance", "1e-8"});
  EXPECT_EQ(outcome.exit_code, 3) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("TOLERANCE NOT MET"));
  EXPECT_THAT(read_file(file("pad.inc")), HasSubstr("# FLAG: TOLERANCE NOT MET"));
}

TEST_F(ExportTest, IsNotBrokenByATitle) {
  const std::string title =
      R"(title = "x\n*END\n/END\n#include y\n$ caf\u00e9 )" + std::string(300, '*') + "\"";
  write_file(case_file(), with(elastic_case(), "title = \"Elastic\"", title));
  const std::string deck = exported("ls-dyna").out;
  EXPECT_EQ(count(deck, "\n*"), 7 + 1u);
  const std::string blocks = exported("radioss").out;
  EXPECT_EQ(count(blocks, "\n/"), 7u);
  EXPECT_THAT(blocks, Not(HasSubstr("\n#include")));
  for (const std::string& text : {deck, blocks})
    EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c == '\n' || (c >= 0x20 && c < 0x7f); }));
}

TEST_F(ExportTest, KeepsAnExistingFile) {
  write_file(file("pad.k"), "precious");
  const std::vector<std::string> arguments{"export",  case_file(), "--format",
                                           "ls-dyna", "--out",     file("pad.k")};
  const Outcome outcome = dashpad(arguments);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("--force"));
  EXPECT_EQ(read_file(file("pad.k")), "precious");
  std::vector<std::string> forced = arguments;
  forced.emplace_back("--force");
  EXPECT_EQ(dashpad(forced).exit_code, 0);
  EXPECT_THAT(read_file(file("pad.k")), StartsWith("*KEYWORD\n"));
}

TEST_F(ExportTest, RefusesWhatIsNotUnderstood) {
  const std::vector<std::vector<std::string>> lines{
      {},
      {"--format", "nastran", "--out", "-"},
      {"--format", "csv", "--out", "-"},
      {"--format", "csv", "--out", "-", "--curves", "force,motion"},
      {"--format", "ls-dyna"},
      {"--format", "ls-dyna", "--out", ""},
      {"--format", "ls-dyna", "--out", "-", "--curves", "force,power"},
      {"--format", "ls-dyna", "--out", "-", "--curves", "force,force"},
      {"--format", "ls-dyna", "--out", "-", "--curves", ""},
      {"--format", "ls-dyna", "--out", "-", "--system", "imperial"},
      {"--format", "ls-dyna", "--out", "-", "--first-id", "0"},
      {"--format", "ls-dyna", "--out", "-", "--first-id", "-3"},
      {"--format", "ls-dyna", "--out", "-", "--first-id", "99999999"},
      {"--format", "ls-dyna", "--out", "-", "--first-id", "99999999999999999999"},
      {"--format", "ls-dyna", "--out", "-", "--first-id", "1.5"},
      {"--format", "ls-dyna", "--out", "-", "--points", "1"},
      {"--format", "ls-dyna", "--out", "-", "--points", "nan"},
      {"--format", "ls-dyna", "--out", "-", "--tolerance", "nan"},
      {"--format", "ls-dyna", "--out", "-", "--tolerance", "1"},
      {"--format", "ls-dyna", "--out", "-", "--force=7"},
      {"--format", "ls-dyna", "--out", "-", "another.toml"},
      {"--format", "ls-dyna", "--out", case_file(), "--force"},
      {"--format", "ls-dyna", "--out", file("no/such/folder/pad.k")},
  };
  for (const auto& line : lines) {
    std::vector<std::string> arguments{"export", case_file()};
    arguments.insert(arguments.end(), line.begin(), line.end());
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << testing::PrintToString(line);
    EXPECT_EQ(outcome.out, "") << testing::PrintToString(line);
    EXPECT_NE(outcome.err, "") << testing::PrintToString(line);
  }
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(ExportTest, NamesAllFaultsAtOnce) {
  write_file(case_file(), with(elastic_case(), "5 kg", "5 m"));
  write_file(file("taken.k"), "");
  const Outcome outcome = dashpad({"export", case_file(), "--format", "ls-dyna", "--out", file("taken.k"),
                                   "--curves", "force,force", "--tolerance", "5"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("impactor.mass"), HasSubstr("taken.k"),
                                 HasSubstr("is given twice"), HasSubstr("--tolerance 5")));
}

TEST_F(ExportTest, TakesMaterialsFromAFolder) {
  fs::create_directory(file("cards"));
  write_file(file("cards/mine.toml"),
             "title = \"Mine\"\nsource = \"a test\"\nlaw = \"elastic\"\n"
             "[parameters]\nmodulus = \"300 kPa\"\n");
  const std::string in_line = exported("csv", {"--curves", "force"}).out;
  write_file(case_file(), with(elastic_case(), "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"",
                               "material = \"mine\""));
  const Outcome named = exported("csv", {"--curves", "force", "--materials", file("cards")});
  EXPECT_EQ(named.exit_code, 0) << named.err;
  const auto numbers = [](const std::string& text) { return text.substr(text.find("\ntime_ms")); };
  EXPECT_EQ(numbers(named.out), numbers(in_line));
}

}  // namespace
}  // namespace dashpad::test
