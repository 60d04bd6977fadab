// dashpad material: cards from decks and tables, and decks from cards.

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
                    HasSubstr("assumed: The rate of the slowest curve"), HasSubstr("DAMP = 0.1"),
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
  expect_refused_deck(foam_deck.substr(0, foam_deck.find("0.4,0.03")), "bad.k:6: curve 1: has 1 points");
  expect_refused_deck("*KEYWORD\n*END\n", "holds no *MAT_057");
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
         "bad.csv:4: strain = 70: a strain is below 1: is it in per cent?");
  expect("strain,stress\n0.1,20\n0.4,30\n0.7,110\n", "bad.csv:1: stress: its unit is not stated");
  expect("strain,force_N\n0.1,20\n0.4,30\n0.7,110\n", "bad.csv:1: force_N: is a force; over the area");
  expect("x,stress_kPa\n0.1,20\n0.4,30\n0.7,110\n", "no column for the strain");
  expect("strain,stress_kPa,stress_kPa\n0.1,20,30\n0.4,30,40\n0.7,110,120\n", "after an @");
  expect("strain,stress_kPa\n0.1,20\n0.4,none\n0.7,110\n", "bad.csv:3: stress_kPa = none");
  expect("0.1,20\n0.4,30\n0.7,110\n", "needs a line above the numbers");
  expect("", "is empty");
  write_file(file("good.csv"), "strain,stress_kPa\n0.1,20\n0.4,30\n0.7,110\n");
  expect_refused({file("good.csv"), "--rate", "fast"}, "--rate");
  expect_refused({file("good.csv"), "--units", "t-mm-s"}, "--units: a table states its units");
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
  EXPECT_THAT(outcome.out,
              AllOf(StartsWith("*KEYWORD\n$ Dashpad "), HasSubstr("$ Not in this deck: The curve is that"),
                    HasSubstr("\n*MAT_LOW_DENSITY_FOAM_TITLE\nSoft foam\n"), HasSubstr("*END\n")));
  EXPECT_THAT(outcome.err, HasSubstr("which the deck cannot state"));
}

TEST_F(MaterialCommandTest, OnlyWhatFitsIsExported) {
  const Outcome wrong_law = export_as("ls-dyna-063", {"-o", file("out.k")});
  EXPECT_EQ(wrong_law.exit_code, 2);
  EXPECT_THAT(wrong_law.err, HasSubstr("crushable-foam"));
  EXPECT_EQ(export_as("abaqus").exit_code, 2);
  write_file(file("foam.toml"), with(foam_card, "density = \"60 kg/m3\"\n", ""));
  const Outcome weightless = export_as("ls-dyna-083", {"-o", file("out.k")});
  EXPECT_EQ(weightless.exit_code, 2);
  EXPECT_THAT(weightless.err, HasSubstr("density"));
  EXPECT_EQ(export_as("ls-dyna-083", {"--density", "60 kg/m3"}).exit_code, 0);
  EXPECT_THAT(other_files(), UnorderedElementsAre("foam.k", "foam.toml"));
}

TEST_F(MaterialCommandTest, HelpTeaches) {
  EXPECT_THAT(dashpad({"material", "--help"}).out, AllOf(HasSubstr("import"), HasSubstr("export")));
  EXPECT_THAT(dashpad({"material", "import", "--help"}).out, HasSubstr("strain_percent"));
  EXPECT_THAT(dashpad({"material", "export", "--help"}).out, HasSubstr("MAT_FU_CHANG_FOAM"));
  EXPECT_EQ(dashpad({"material"}).exit_code, 2);
}

}  // namespace
}  // namespace dashpad::test
