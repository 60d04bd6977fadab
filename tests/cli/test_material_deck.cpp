// dashpad material: cards from decks and tables, and decks from cards.

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;
using testing::UnorderedElementsAre;

const std::string foam_deck = R"(*KEYWORD
*MAT_LOW_DENSITY_FOAM_TITLE
Soft foam
7,6e-11,0.5,1,0,0.4,0,0.1
2.5
*DEFINE_CURVE
1
0,0
0.1,0.02
0.4,0.03
0.7,0.11
*END
)";

const std::string foam_card = R"(title = "Soft foam"
source = "a test"
density = "60 kg/m3"
law = "foam"
[parameters]
unloading_factor = 0.4
unloading_shape = 2.5
[curve]
form = "table"
rate = "0.01 1/s"
stress_unit = "kPa"
strain = [0.1, 0.4, 0.7]
stress = [20, 30, 110]
)";

class MaterialCommandTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    write_file(file("foam.k"), foam_deck);
    write_file(file("foam.toml"), foam_card);
  }

  [[nodiscard]] Outcome import(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), {"material", "import"});
    return dashpad(arguments);
  }
  [[nodiscard]] Outcome export_as(const std::string& format, std::vector<std::string> more = {}) const {
    more.insert(more.begin(),
                {"material", "export", file("foam.toml"), "--format", format, "--units", "t-mm-s"});
    return dashpad(more);
  }
  /// Refused, with `complaint` on standard error and no file beside those there were.
  void expect_refused(const std::vector<std::string>& arguments, const std::string& complaint) const {
    const auto before = other_files();
    const Outcome outcome = import(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_EQ(outcome.out, "");
    EXPECT_THAT(outcome.err, HasSubstr(complaint));
    EXPECT_EQ(other_files().size(), before.size());
  }
  /// The same of a deck with this text.
  void expect_refused_deck(const std::string& deck, const std::string& complaint) const {
    write_file(file("bad.k"), deck);
    expect_refused({file("bad.k"), "--units", "t-mm-s", "-o", file("card.toml")}, complaint);
  }
};

TEST_F(MaterialCommandTest, ImportsADeckAndSaysWhatItUnderstood) {
  const Outcome outcome = import({file("foam.k"), "--units", "mm-t-s", "-o", file("card.toml")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("*MAT_057, line 2: Soft foam"), HasSubstr("3 points up to a strain of 0.7"),
                    HasSubstr("assumed: The lowest rate is not stated"), HasSubstr("DAMP = 0.1"),
                    HasSubstr("written: " + file("card.toml"))));
  const Outcome shown = dashpad({"materials", file("card.toml")});
  EXPECT_EQ(shown.exit_code, 0) << shown.err;
}

TEST_F(MaterialCommandTest, WithoutAFileTheCardIsOnStandardOutput) {
  const Outcome outcome = import({file("foam.k"), "--units", "t-mm-s"});
  EXPECT_EQ(outcome.exit_code, 0);
  EXPECT_THAT(outcome.out, AllOf(StartsWith("title = \"Soft foam\"\n"), HasSubstr("law = \"foam\"")));
  EXPECT_THAT(outcome.err, HasSubstr("assumed"));
}

TEST_F(MaterialCommandTest, AnExistingFileIsKeptUnlessForced) {
  write_file(file("card.toml"), "mine");
  expect_refused({file("foam.k"), "--units", "t-mm-s", "-o", file("card.toml")}, "card.toml");
  EXPECT_EQ(read_file(file("card.toml")), "mine");
  EXPECT_EQ(import({file("foam.k"), "--units", "t-mm-s", "-o", file("card.toml"), "--force"}).exit_code, 0);
  EXPECT_THAT(read_file(file("card.toml")), StartsWith("title"));
}

TEST_F(MaterialCommandTest, SeveralFoamsGoIntoAFolder) {
  std::string two = foam_deck;
  two.insert(two.find("*DEFINE_CURVE"), "*MAT_057_TITLE\nHard foam\n8,6e-11,0.5,1,0,0.4\n2.5\n");
  write_file(file("two.k"), two);
  fs::create_directory(file("cards"));
  expect_refused({file("two.k"), "--units", "t-mm-s"}, "has 2 foams");
  const Outcome both = import({file("two.k"), "--units", "t-mm-s", "-o", file("cards")});
  EXPECT_EQ(both.exit_code, 0) << both.err;
  EXPECT_THAT(read_file(file("cards/hard-foam.toml")), HasSubstr("Hard foam"));
  EXPECT_THAT(read_file(file("cards/soft-foam.toml")), HasSubstr("Soft foam"));
  EXPECT_THAT(import({file("two.k"), "--units", "t-mm-s", "--material", "8"}).out, HasSubstr("Hard foam"));
  expect_refused({file("two.k"), "--units", "t-mm-s", "--material", "9"},
                 "; available: 7 (soft-foam), 8 (hard-foam)");
}

TEST_F(MaterialCommandTest, UnitsAreNeededAndKnown) {
  expect_refused({file("foam.k")}, "--units: is required");
  expect_refused({file("foam.k"), "--units", "cgs"}, "kg-mm-ms");
  expect_refused({file("foam.k"), "--units", "t-mm-s", "--rate", "1 1/s"}, "--rate: applies only to tables");
}

TEST_F(MaterialCommandTest, BadDecksAreRefusedWithTheirLine) {
  expect_refused_deck(with(foam_deck, "0.4,0.03", "0.4,nan"), "bad.k:10: curve 1: O3 = nan");
  expect_refused_deck(with(foam_deck, "0.4,0.03", "0.1,0.03"),
                      "bad.k:10: curve 1: strain = 0.1: appears twice");
  expect_refused_deck(with(foam_deck, "0.4,0.03", "0.4,0.01"), "bad.k:10: curve 1: stress = 10000");
  expect_refused_deck(with(foam_deck, "0.7,0.11", "70,0.11"), "bad.k:11: curve 1: strain = 70");
  expect_refused_deck(with(foam_deck, "0.4,0.03", "0.4   0.03"),
                      "bad.k:10: curve 1: A3 = 0.4   0.03: is not a number");
  expect_refused_deck(with(foam_deck, "0.4,0.03", "\xff,0.03"), "bad.k:10: curve 1: A3 = ");
  expect_refused_deck(with(foam_deck, "*DEFINE_CURVE\n1\n", "*DEFINE_CURVE\n2\n"),
                      "bad.k:4: *MAT_057: LCID = 1");
  expect_refused_deck(with(foam_deck, "2.5\n", ""), "bad.k:2: *MAT_057: ends after 1 of 2 lines");
  expect_refused_deck(foam_deck.substr(0, foam_deck.find("0.4,0.03")), "bad.k:6: curve 1: has 1 point at");
  expect_refused_deck("*KEYWORD\n*END\n", "contains no *MAT_057");
  expect_refused_deck("nothing\n", "is not a deck");
  expect_refused({file("absent.k"), "--units", "t-mm-s"}, "no such file");
  expect_refused({file(""), "--units", "t-mm-s"}, "is a folder");
}

TEST_F(MaterialCommandTest, ImportsATableOfOneTest) {
  write_file(file("test.csv"), "strain_percent,stress_kPa\n0,0\n10,20\n40,30\n70,110\n");
  const Outcome outcome = import({file("test.csv"), "--rate", "0.02 1/s"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("rate = \"0.02 1/s\""), HasSubstr("strain = [0.1, 0.4, 0.7]"),
                    HasSubstr("stress = [20000, 30000, 110000]"), HasSubstr("basis = \"test\"")));
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("assumed: The unloading"), Not(HasSubstr("rate of the slowest"))));
}

TEST_F(MaterialCommandTest, ImportsATableOfSeveralRates) {
  write_file(file("tests.csv"),
             "strain;stress [MPa] @ 10 1/s;stress_kPa @ "
             "0,1/s\n0;0;0\n0.1;0.025;20\n0.4;0.04;30\n0.6;0.09;\n0.7;;110\n");
  expect_refused({file("tests.csv")}, "tests.csv:1: stress_kPa @ 0,1/s");
  write_file(file("tests.csv"),
             "strain;stress [MPa] @ 10 1/s;stress_kPa @ "
             "0.1/s\n0;0;0\n0.1;0.025;20\n0.4;0.04;30\n0.6;0.09;\n0.7;;110\n");
  const Outcome outcome = import({file("tests.csv")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("rate = \"0.1 1/s\""), HasSubstr("[[rate.curves]]\nrate = \"10 1/s\""),
                    HasSubstr("strain = [0.1, 0.4, 0.7]"), HasSubstr("strain = [0.1, 0.4, 0.6]"),
                    HasSubstr("stress = [25000, 40000, 90000]"), HasSubstr("interpolation = \"log-log\"")));
}

TEST_F(MaterialCommandTest, BadTablesAreRefusedWithTheirLine) {
  const auto expect = [&](const std::string& table, const std::string& complaint) {
    write_file(file("bad.csv"), table);
    expect_refused({file("bad.csv"), "-o", file("card.toml")}, complaint);
  };
  expect("strain,stress_kPa\n0.1,20\n0.4,30\n70,110\n",
         "bad.csv:4: strain = 70: a strain must be below 1; if it is in per cent");
  expect("strain,stress\n0.1,20\n0.4,30\n0.7,110\n", "bad.csv:1: stress: its unit is not stated");
  expect("strain,force_N\n0.1,20\n0.4,30\n0.7,110\n",
         "bad.csv:1: force_N: is a force; for a stress, give the specimen area");
  expect("x,stress_kPa\n0.1,20\n0.4,30\n0.7,110\n", "no column for the strain");
  expect("strain,stress_kPa,stress_kPa\n0.1,20,30\n0.4,30,40\n0.7,110,120\n", "after an @");
  expect("strain,stress_kPa\n0.1,20\n0.4,none\n0.7,110\n", "bad.csv:3: stress_kPa = none");
  expect("0.1,20\n0.4,30\n0.7,110\n", "needs a header line");
  expect("", "is empty");
  write_file(file("good.csv"), "strain,stress_kPa\n0.1,20\n0.4,30\n0.7,110\n");
  expect_refused({file("good.csv"), "--rate", "fast"}, "--rate");
  expect_refused({file("good.csv"), "--units", "t-mm-s"},
                 "--units: applies only to decks; a table states its units");
}

TEST_F(MaterialCommandTest, TemperaturesThatNoTestHadAreRefused) {
  const std::string table = file("good.csv"), other = file("other.csv");
  for (const std::string& each : {table, other})
    write_file(each, "strain,stress_kPa\n0.1,20\n0.4,30\n0.7,110\n");
  expect_refused({table, "--temperature", "-300 degC"},
                 "--temperature -300 degC: must be above absolute zero, -273.15 degC");
  expect_refused({table, "--temperature", "3000 K"}, "--temperature 3000 K: must be at most 2000 K");
  expect_refused({table, other, "--temperature", "23 degC"},
                 "--temperature: give one for each file; 1 was given for 2 files");
}

TEST_F(MaterialCommandTest, ExportsACardThatIsImportedAsTheSame) {
  for (const char* const format : {"ls-dyna-057", "ls-dyna-083", "radioss-70", "radioss-90"}) {
    const Outcome outcome = export_as(format, {"-o", file("out.k"), "--force", "--first-id", "11"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("  differs: "));
    const Outcome again = import({file("out.k"), "--units", "t-mm-s"});
    EXPECT_EQ(again.exit_code, 0) << again.err;
    EXPECT_THAT(again.out, AllOf(HasSubstr("title = \"Soft foam\""), HasSubstr("density = \"60 kg/m3\""),
                                 HasSubstr("unloading_factor = 0.4"), HasSubstr("unloading_shape = 2.5"),
                                 HasSubstr("rate = \"0.01 1/s\""), HasSubstr("strain = [0.1, 0.4, 0.7]"),
                                 HasSubstr("stress = [20000, 30000, 110000]")))
        << format;
  }
}

TEST_F(MaterialCommandTest, ExportsAndImportsAViscoelasticFoam) {
  write_file(
      file("foam.toml"),
      "title = \"Slow foam\"\nlaw = \"viscoelastic-foam\"\nsource = \"a test\"\ndensity = \"60 kg/m3\"\n"
      "[parameters]\nfirst_modulus = \"30 kPa\"\nfirst_exponent = 6\nfirst_share = 3\n"
      "first_time = \"20 ms\"\nsecond_share = 1\nsecond_time = \"0.3 s\"\n");
  const Outcome outcome = export_as("radioss-62", {"-o", file("out.rad")});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  const Outcome again = import({file("out.rad"), "--units", "t-mm-s"});
  EXPECT_EQ(again.exit_code, 0) << again.err;
  EXPECT_THAT(again.out,
              AllOf(HasSubstr("law = \"viscoelastic-foam\""), HasSubstr("first_modulus = \"30000 Pa\""),
                    HasSubstr("first_share = 3"), HasSubstr("second_time = \"0.3 s\"")));
  EXPECT_THAT(
      again.err,
      AllOf(HasSubstr("law viscoelastic-foam, moduli 30 and 0 kPa"),
            HasSubstr("a branch with 3 times the long-term stress relaxes with a time constant of 0.02 s")));
}

TEST_F(MaterialCommandTest, ADeckSaysWhatItDoesNotSay) {
  const Outcome outcome = export_as("ls-dyna-057");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(
      outcome.out,
      AllOf(StartsWith("*KEYWORD\n$ Dashpad "), HasSubstr("$ Difference from the card: The curve is for"),
            HasSubstr("\n*MAT_LOW_DENSITY_FOAM_TITLE\nSoft foam\n"), HasSubstr("*END\n")));
  EXPECT_THAT(outcome.err, HasSubstr("a rate that the deck cannot state"));
}

TEST_F(MaterialCommandTest, OnlyWhatFitsIsExported) {
  const Outcome wrong_law = export_as("ls-dyna-063", {"-o", file("out.k")});
  EXPECT_EQ(wrong_law.exit_code, 2);
  EXPECT_THAT(wrong_law.err, HasSubstr("crushable-foam"));
  EXPECT_EQ(export_as("nastran").exit_code, 2);
  write_file(file("foam.toml"), with(foam_card, "density = \"60 kg/m3\"\n", ""));
  const Outcome weightless = export_as("ls-dyna-083", {"-o", file("out.k")});
  EXPECT_EQ(weightless.exit_code, 2);
  EXPECT_THAT(weightless.err, HasSubstr("density"));
  EXPECT_EQ(export_as("ls-dyna-083", {"--density", "60 kg/m3"}).exit_code, 0);
  EXPECT_THAT(other_files(), UnorderedElementsAre("foam.k", "foam.toml"));
}

/// The points of the first curve of a deck.
std::vector<std::pair<double, double>> curve_in(const std::string& deck) {
  std::istringstream lines(deck.substr(deck.find("$           STRAIN")));
  std::vector<std::pair<double, double>> points;
  std::string line;
  for (std::getline(lines, line); std::getline(lines, line) && !line.starts_with('*');) {
    std::istringstream fields(line);
    fields >> points.emplace_back().first >> points.back().second;
  }
  return points;
}

/// Verification: stress 110 kPa at the last tested strain of 0.7; beyond it the continuation of theory.md
/// rises faster than a straight line.
TEST_F(MaterialCommandTest, CurvesAreExtendedAsTheCardDoes) {
  const Outcome outcome = export_as("ls-dyna-057", {"--up-to", "0.9"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const auto points = curve_in(outcome.out);
  ASSERT_EQ(points.size(), 100);
  EXPECT_EQ(points.front(), (std::pair{0.0, 0.0}));
  EXPECT_EQ(points.back().first, 0.9);
  for (std::size_t i = 1; i < points.size(); ++i) {
    EXPECT_NEAR(points[i].first, 0.9 * static_cast<double>(i) / 99, 1e-6);
    EXPECT_GT(points[i].second, points[i - 1].second);
  }
  const auto at = [&](double strain) {
    const auto after = std::ranges::lower_bound(points, std::pair{strain, 0.0});
    const auto& [e, s] = *std::prev(after);
    return s + (after->second - s) * (strain - e) / (after->first - e);
  };
  EXPECT_NEAR(at(0.1), 0.02, 2e-4);
  EXPECT_NEAR(at(0.7), 0.11, 2e-4);
  const double slope = (at(0.7) - at(0.69)) / 0.01;
  EXPECT_GT(points.back().second, at(0.7) + 1.3 * 0.2 * slope);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("100 evenly spaced points"), HasSubstr("tested up to 0.7")));
  EXPECT_EQ(curve_in(export_as("ls-dyna-057", {"--points", "10"}).out).size(), 10);
}

TEST_F(MaterialCommandTest, ACardWithOneCurveMayHaveThatOfAnyRate) {
  write_file(
      file("foam.toml"),
      foam_card +
          "[rate]\nform = \"power\"\nexponent = 0.1\nexponent_slope = 0\nhighest_rate = \"100 1/s\"\n");
  const auto slow = curve_in(export_as("ls-dyna-057", {"--points", "20"}).out);
  const Outcome outcome = export_as("ls-dyna-057", {"--points", "20", "--rate", "100 1/s"});
  const auto fast = curve_in(outcome.out);
  ASSERT_EQ(fast.size(), 20) << outcome.err;
  for (std::size_t i = 1; i < fast.size(); ++i)
    EXPECT_NEAR(fast[i].second / slow[i].second, std::pow(1e4, 0.1), 2e-3) << "sigma (r / r0)^m";
  EXPECT_THAT(outcome.err, HasSubstr("100 1/s"));
  EXPECT_EQ(export_as("ls-dyna-083", {"--rate", "100 1/s"}).exit_code, 2);
  EXPECT_EQ(export_as("ls-dyna-057", {"--rate", "0.001 1/s"}).exit_code, 2);
  EXPECT_EQ(export_as("ls-dyna-057", {"--up-to", "1"}).exit_code, 2);
  EXPECT_EQ(export_as("ls-dyna-057", {"--points", "101"}).exit_code, 2);
}

TEST_F(MaterialCommandTest, ACheckDeckCompressesOneElement) {
  const Outcome outcome = export_as("ls-dyna-057", {"-o", file("out.k"), "--check-deck", file("check.k")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string deck = read_file(file("check.k"));
  EXPECT_THAT(deck, AllOf(HasSubstr("NOT RUN IN THIS SOLVER"), HasSubstr("*INCLUDE\nout.k\n"),
                          HasSubstr("*ELEMENT_SOLID"), HasSubstr("*END\n")));
  // 10 mm x 10 mm times the stress at a strain of 0.9 * 0.7, on the line from 0.4 to 0.7: 0.0913 MPa.
  EXPECT_THAT(deck, testing::ContainsRegex("0\\.63 +9\\.133"));
  EXPECT_THAT(outcome.out + outcome.err, HasSubstr("(not run in that solver)"));
  EXPECT_EQ(export_as("radioss-70", {"-o", file("r.inc"), "--check-deck", file("r.k")}).exit_code, 2);
  EXPECT_EQ(export_as("ls-dyna-057", {"--check-deck", file("c.k")}).exit_code, 2);
}

TEST_F(MaterialCommandTest, ACheckDeckOfAbaqusCompressesOneElement) {
  const Outcome outcome =
      export_as("abaqus-low-density-foam", {"-o", file("out.inp"), "--check-deck", file("check.inp")});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  const std::string deck = read_file(file("check.inp"));
  EXPECT_THAT(deck, AllOf(HasSubstr("NOT RUN IN THIS SOLVER"), HasSubstr("\n*INCLUDE, INPUT=out.inp\n"),
                          HasSubstr("\n*ELEMENT, TYPE=C3D8R"), HasSubstr("\nTOP, 3, 3, -6.3\n"),
                          HasSubstr("\n*END STEP\n")));
  const std::string material = read_file(file("out.inp"));
  const std::size_t name = material.find("NAME=") + 5;
  EXPECT_THAT(deck, HasSubstr("MATERIAL=" + material.substr(name, material.find('\n', name) - name) + "\n"));
}

TEST_F(MaterialCommandTest, IncludedFilesAreReadIfThatIsAllowed) {
  const std::size_t curve = foam_deck.find("*DEFINE_CURVE");
  fs::create_directory(file("parts"));
  write_file(file("parts/curve.k"), "$ a curve\n" + foam_deck.substr(curve));
  write_file(file("whole.k"), foam_deck.substr(0, curve) + "*INCLUDE\n$ beside it\nparts/curve.k\n*END\n");
  EXPECT_THAT(import({file("whole.k"), "--units", "t-mm-s"}).err, HasSubstr("--allow-includes"));
  const Outcome outcome = import({file("whole.k"), "--units", "t-mm-s", "--allow-includes"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_EQ(outcome.out,
            import({file("foam.k"), "--units", "t-mm-s"})
                .out.replace(import({file("foam.k"), "--units", "t-mm-s"}).out.find("foam.k"), 6, "whole.k"));

  const auto refused = [&](const std::string& name, const std::string& why) {
    write_file(file("whole.k"), foam_deck.substr(0, curve) + "*INCLUDE\n" + name + "\n*END\n");
    const Outcome bad = import({file("whole.k"), "--units", "t-mm-s", "--allow-includes"});
    EXPECT_EQ(bad.exit_code, 2);
    EXPECT_THAT(bad.err, AllOf(HasSubstr("whole.k:7: include = " + name), HasSubstr(why)));
  };
  refused("../curve.k", "..");
  refused("/etc/passwd", "in the folder of the deck");
  refused("whole.k", "includes itself");
  refused("missing.k", "missing.k");
  fs::create_symlink(file("parts/curve.k"), file("link.k"));
  refused("link.k", "link");
  refused("parts", "parts");

  // The *END of an included file, and a blank line before its name, end nothing.
  write_file(file("whole.k"), "*KEYWORD\n*INCLUDE\n\nparts/curve.k\n" + foam_deck.substr(9, curve - 9));
  EXPECT_EQ(import({file("whole.k"), "--units", "t-mm-s", "--allow-includes"}).exit_code, 0);

  // A fault in an included file has its name and line.
  write_file(file("parts/curve.k"), "*DEFINE_CURVE\n1\n0,0\n0.1,x\n");
  write_file(file("whole.k"), foam_deck.substr(0, curve) + "*INCLUDE\nparts/curve.k\n*END\n");
  EXPECT_THAT(import({file("whole.k"), "--units", "t-mm-s", "--allow-includes"}).err,
              HasSubstr("parts/curve.k:4"));
}

/// A foam that goes to Abaqus comes back with its curve.
TEST_F(MaterialCommandTest, GoesToAbaqusAndBack) {
  for (const std::string format : {"abaqus-low-density-foam", "abaqus-hyperfoam"}) {
    const Outcome outcome = export_as(format, {"-o", file(format + ".inp")});
    ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
    const Outcome back = import({file(format + ".inp"), "--units", "t-mm-s"});
    EXPECT_EQ(back.exit_code, 0) << back.err;
    EXPECT_THAT(back.out, AllOf(HasSubstr("density = \"60 kg/m3\""), HasSubstr("0.4"), HasSubstr("30000")));
  }
  const std::string deck = read_file(file("abaqus-low-density-foam.inp"));
  EXPECT_THAT(deck, AllOf(HasSubstr("*MATERIAL, NAME=foam\n"), HasSubstr("DIRECTION=COMPRESSION"),
                          HasSubstr(", -0.01\n")));
  EXPECT_THAT(read_file(file("abaqus-hyperfoam.inp")), HasSubstr("TEST DATA INPUT"));
}

TEST_F(MaterialCommandTest, HelpTeaches) {
  EXPECT_THAT(dashpad({"material", "--help"}).out, AllOf(HasSubstr("import"), HasSubstr("export")));
  EXPECT_THAT(dashpad({"material", "import", "--help"}).out, HasSubstr("strain_percent"));
  EXPECT_THAT(dashpad({"material", "export", "--help"}).out, HasSubstr("MAT_FU_CHANG_FOAM"));
  EXPECT_EQ(dashpad({"material"}).exit_code, 2);
}

}  // namespace
}  // namespace dashpad::test
