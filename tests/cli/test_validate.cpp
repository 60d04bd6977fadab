// dashpad validate: one run of the study, and what is refused before it.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <cstdlib>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::MatchesRegex;
using testing::StartsWith;

class ValidateTest : public CommandTest {
 protected:
  Outcome refused(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "validate");
    const auto before = other_files();
    Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_EQ(outcome.out, "");
    EXPECT_EQ(other_files(), before);
    return outcome;
  }
};

/// The example of the help, in a folder that is kept for the tests of the pages.
TEST_F(ValidateTest, WritesPageJsonAndFigures) {
  const char* kept = std::getenv("DASHPAD_VALIDATION_FILES");
  const fs::path folder = kept ? kept : file("files");
  fs::remove_all(folder);
  fs::create_directory(folder);
  const std::string example = "validate --report validation.html --json validation.json --figures figures\n";
  ASSERT_THAT(dashpad({"validate", "--help"}).out, HasSubstr("\n  dashpad " + example));
  const Outcome outcome = shell("cd '" + folder.string() + "' && $DASHPAD " + example);
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  // No bar: it is no terminal. Where it takes more than a minute, that is said.
  EXPECT_THAT(outcome.err, MatchesRegex("([A-Z][a-z ]+ will take about [0-9]+ minutes\n)*"));
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("33 tests"), HasSubstr("verdict"), HasSubstr("anomaly")));
  EXPECT_THAT(read_file(folder / "validation.html"),
              HasSubstr("foam law does not meet all the rules for the 1986 tests"));
  EXPECT_THAT(read_file(folder / "validation.json"), StartsWith("{\n  \"format\": 3,\n"));
  const json study = json::parse(read_file(folder / "validation.json"));
  EXPECT_EQ(study["tests"].size(), 33U);
  EXPECT_TRUE(study["passed"].is_boolean());
  std::size_t stills = 0;
  for (const auto& still : fs::directory_iterator(folder / "figures")) {
    EXPECT_THAT(read_file(still.path()), HasSubstr("<svg")) << still.path();
    ++stills;
  }
  EXPECT_EQ(stills, 14U);
}

TEST_F(ValidateTest, KeepsWhatIsThere) {
  write_file(file("v.json"), "mine");
  fs::create_directory(file("figures"));
  write_file(file("figures/figure-3-4.svg"), "mine");
  EXPECT_THAT(refused({"--json", file("v.json"), "--figures", file("figures")}).err,
              AllOf(HasSubstr("v.json: already exists"), HasSubstr("figure-3-4.svg: already exists")));
  EXPECT_EQ(read_file(file("v.json")), "mine");
}

TEST_F(ValidateTest, NamesAllFaultsOfTheData) {
  const fs::path data{file("data")};
  fs::copy(fs::path{DASHPAD_SOURCE_DIR} / "data/validation", data, fs::copy_options::recursive);
  write_file(data / "supports.csv",
             "support,deflection_in,force_lb\nload-cell,0.1,900\nload-cell,0.05,950\nplate,soft,5180\n");
  fs::remove(data / "table-3-2.csv");
  EXPECT_THAT(refused({"--data", data.string(), "--json", file("v.json")}).err,
              AllOf(HasSubstr("supports.csv:3"), HasSubstr("supports.csv:4"), HasSubstr("table-3-2.csv")));
}

TEST_F(ValidateTest, RefusesFoldersThatCannotBe) {
  EXPECT_THAT(refused({"--figures", file("none/figures")}).err, HasSubstr("there is no folder"));
  EXPECT_THAT(refused({"--figures", case_file()}).err, HasSubstr("is not a folder"));
  EXPECT_THAT(refused({"--figures", file("one"), "--json", file("one")}).err,
              HasSubstr("is also given for --json"));
  EXPECT_THAT(refused({"--figures", file("one/"), "--report", file("one")}).err,
              HasSubstr("is also given for --report"));
  EXPECT_THAT(refused({"--format", "png"}).err, HasSubstr("--figures"));
  if (::geteuid() == 0) GTEST_SKIP() << "nothing is closed to root";
  fs::create_directory(file("closed"));
  fs::permissions(file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  EXPECT_THAT(refused({"--json", file("closed/v.json")}).err, HasSubstr("cannot create a file"));
}

}  // namespace
}  // namespace dashpad::test
