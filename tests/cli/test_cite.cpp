// dashpad cite: what a result rests on.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::AllOf;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

const std::string helmet = examples + "helmet-pad-10fps.toml";

TEST(Cite, ListsFoamStandardMethodAndProgram) {
  const Outcome outcome = dashpad({"cite", helmet, "--standard", "en-1078"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(HasSubstr("\nFoam:\n"), HasSubstr("Koumlis and Lamberson 2019"),
                                 HasSubstr("\nStandard:\n"), HasSubstr("EN 1078, bicycle helmets"),
                                 HasSubstr("\nMethod:\n"), HasSubstr("Crash Padding Research. Volume III"),
                                 HasSubstr("1986"), HasSubstr("\nProgram:\n"), HasSubstr("Version ")));
  std::istringstream lines(outcome.out);
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 102U) << line;
}

TEST(Cite, WritesTheFormatsOfReferenceManagers) {
  const Outcome bibtex = dashpad({"cite", nine, "--format", "bibtex"});
  EXPECT_EQ(bibtex.exit_code, 0);
  EXPECT_THAT(bibtex.out,
              AllOf(StartsWith("@misc{foam-ensolite-aac-9,\n"), HasSubstr("@techreport{crash-padding-1986")));
  const json csl = json::parse(dashpad({"cite", nine, "--format", "csl-json"}).out);
  EXPECT_EQ(csl.at(1).at("id"), "crash-padding-1986");
  const json all = json::parse(dashpad({"cite", nine, "--json"}).out);
  EXPECT_EQ(all.at("case"), nine);
  EXPECT_EQ(all.at("sources").at(0).at("for"), "foam");
}

/// --set chooses the foam, and a law typed in the case has no source.
TEST(Cite, FollowsTheSettingsOfTheCase) {
  EXPECT_THAT(dashpad({"cite", nine, "--set", "pad.material=vn600"}).out,
              AllOf(HasSubstr("Landauer"), Not(HasSubstr("Ensolite"))));
  const test::TemporaryFolder folder;
  write_file(folder.path() / "typed.toml", elastic_case());
  EXPECT_THAT(dashpad({"cite", (folder.path() / "typed.toml").string()}).out,
              HasSubstr("typed in the case; no source is given"));
}

TEST(Cite, RefusesInOneLine) {
  const auto expect = [](std::vector<std::string> arguments, const std::string& message) {
    arguments.insert(arguments.begin(), "cite");
    const Outcome outcome = dashpad(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.out, IsEmpty());
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(message), HasSubstr("1 error")));
  };
  expect({"no-such.toml"}, "no-such.toml: ");
  expect({nine, "--standard", "en-1087"}, "did you mean \"en-1078\"?");
  expect({nine, "--standard", "en-1078:kerb"}, "kerbstone");
  expect({nine, "--json", "--format", "bibtex"}, "--json: give either --json or --format bibtex, not both");
  EXPECT_EQ(dashpad({"cite", nine, "--format", "ris"}).exit_code, 2);
  EXPECT_EQ(dashpad({"cite"}).exit_code, 2);
}

}  // namespace
}  // namespace dashpad::test
