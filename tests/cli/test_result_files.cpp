// Result files: complete or not there at all, and never in the place of another file unasked.

#include <sys/stat.h>

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

class ResultFilesTest : public CommandTest {};

TEST_F(ResultFilesTest, AnExistingFileIsKept) {
  write_file(file("result.json"), "precious");
  const Outcome outcome =
      dashpad({"run", case_file(), "--json", file("result.json"), "--csv", file("history.csv")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("--force"), HasSubstr("1 error; nothing was run\n")));
  EXPECT_EQ(outcome.out, "");
  EXPECT_EQ(read_file(file("result.json")), "precious");
  EXPECT_THAT(other_files(), ElementsAre("result.json"));
}

TEST_F(ResultFilesTest, BothExistingFilesAreNamedAtOnce) {
  write_file(file("a.json"), "");
  write_file(file("a.csv"), "");
  const Outcome outcome = dashpad({"run", case_file(), "--json", file("a.json"), "--csv", file("a.csv")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(HasSubstr("a.json"), HasSubstr("a.csv"), HasSubstr("2 errors; nothing was run\n")));
}

TEST_F(ResultFilesTest, ForceOverwrites) {
  write_file(file("result.json"), "old");
  EXPECT_EQ(dashpad({"run", case_file(), "--json", file("result.json"), "--force"}).exit_code, 0);
  EXPECT_TRUE(nlohmann::json::accept(read_file(file("result.json"))));
  EXPECT_THAT(other_files(), ElementsAre("result.json"));
}

TEST_F(ResultFilesTest, ForceFollowsALinkAndKeepsTheMode) {
  write_file(file("real.json"), "old");
  ASSERT_EQ(::chmod(file("real.json").c_str(), 0640), 0);
  fs::create_symlink("real.json", file("link.json"));
  EXPECT_EQ(dashpad({"run", case_file(), "--json", file("link.json")}).exit_code, 2);
  EXPECT_EQ(dashpad({"run", case_file(), "--json", file("link.json"), "--force"}).exit_code, 0);
  EXPECT_TRUE(fs::is_symlink(file("link.json")));
  EXPECT_TRUE(nlohmann::json::accept(read_file(file("real.json"))));
  EXPECT_EQ(fs::status(file("real.json")).permissions(), fs::perms{0640});
}

TEST_F(ResultFilesTest, ANewFileHasTheModeOfAnyNewFile) {
  EXPECT_EQ(shell("umask 027; $DASHPAD run " + case_file() + " --json " + file("result.json")).exit_code, 0);
  EXPECT_EQ(fs::status(file("result.json")).permissions(), fs::perms{0640});
}

TEST_F(ResultFilesTest, AFileInTheWorkingFolderNeedsNoPath) {
  const fs::path folder = fs::path{case_file()}.parent_path();
  EXPECT_EQ(shell("cd " + folder.string() + "; $DASHPAD run case.toml --json r.json --csv h.csv").exit_code,
            0);
  EXPECT_TRUE(fs::exists(file("r.json")) && fs::exists(file("h.csv")));
}

TEST_F(ResultFilesTest, TwoResultsCannotShareAFile) {
  const std::string name = file("both");
  for (const std::string& other : {name, fs::path{name}.parent_path().string() + "/./both"}) {
    const Outcome outcome = dashpad({"run", case_file(), "--json", name, "--csv", other, "--force"});
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_THAT(outcome.err, HasSubstr("also given for --json"));
  }
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(ResultFilesTest, TwoResultsCannotShareStandardOutput) {
  const Outcome outcome = dashpad({"run", case_file(), "--json", "-", "--csv", "-"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(outcome.out, "");
}

TEST_F(ResultFilesTest, TheCaseIsNeverOverwritten) {
  const Outcome outcome = dashpad({"run", case_file(), "--json", case_file(), "--force"});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_EQ(read_file(case_file()), elastic_case());
}

TEST_F(ResultFilesTest, AMissingFolderIsNoticedBeforeTheRun) {
  const Outcome outcome = dashpad({"run", case_file(), "--csv", file("nowhere/history.csv")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("there is no folder"), HasSubstr("nothing was run")));
}

TEST_F(ResultFilesTest, AFolderIsNotAFile) {
  fs::create_directory(file("folder"));
  EXPECT_EQ(dashpad({"run", case_file(), "--csv", file("folder"), "--force"}).exit_code, 2);
  EXPECT_EQ(dashpad({"run", case_file(), "--csv", file("folder/"), "--force"}).exit_code, 2);
  EXPECT_EQ(dashpad({"run", case_file(), "--csv", ""}).exit_code, 2);
  EXPECT_THAT(other_files(), ElementsAre("folder"));
}

TEST_F(ResultFilesTest, AReadOnlyFolderIsNoticedBeforeTheRun) {
  if (::geteuid() == 0) GTEST_SKIP() << "root may write anywhere";
  fs::create_directory(file("closed"));
  fs::permissions(file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  const Outcome outcome = dashpad({"run", case_file(), "--json", file("closed/result.json")});
  fs::permissions(file("closed"), fs::perms::owner_all);
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("Permission denied"));
}

TEST_F(ResultFilesTest, AFullDeviceIsAnError) {
  for (const char* option : {"--json", "--csv"}) {
    const Outcome outcome = dashpad({"run", case_file(), option, "/dev/full"});
    EXPECT_EQ(outcome.exit_code, 1);
    EXPECT_THAT(outcome.err, HasSubstr("could not write /dev/full: No space left on device"));
  }
  EXPECT_TRUE(fs::is_character_file("/dev/full"));
}

TEST_F(ResultFilesTest, AFullStandardOutputIsAnError) {
  for (const char* arguments : {"", " --json -", " --csv -"}) {
    const Outcome outcome = shell("$DASHPAD run " + case_file() + arguments + " > /dev/full");
    EXPECT_EQ(outcome.exit_code, 1) << arguments;
    EXPECT_THAT(outcome.err, HasSubstr("could not write to standard output"));
  }
  EXPECT_EQ(shell("$DASHPAD --version > /dev/full").exit_code, 1);
}

TEST_F(ResultFilesTest, AFileThatCannotBeCompletedLeavesNothing) {
  const Outcome outcome =
      shell("ulimit -f 1; exec $DASHPAD run " + case_file() + " --csv " + file("history.csv"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_THAT(outcome.err, HasSubstr("could not write"));
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(ResultFilesTest, AFileThatCannotBeCompletedLeavesTheOldOne) {
  write_file(file("history.csv"), "precious");
  const Outcome outcome =
      shell("ulimit -f 1; exec $DASHPAD run " + case_file() + " --force --csv " + file("history.csv"));
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_EQ(read_file(file("history.csv")), "precious");
  EXPECT_THAT(other_files(), ElementsAre("history.csv"));
}

TEST_F(ResultFilesTest, WithoutTheSecondFileTheFirstIsNotWrittenEither) {
  const Outcome outcome =
      shell("ulimit -f 10; exec $DASHPAD run " + case_file() + " --tolerance 1e-6 --json " +
            file("result.json") + " --csv " + file("history.csv"));
  EXPECT_EQ(outcome.exit_code, 1) << "the history has to be larger than 10 blocks for this test";
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(ResultFilesTest, AReaderThatGoesAwayIsNoError) {
  const Outcome outcome = shell("{ $DASHPAD run " + case_file() +
                                " --tolerance 1e-6 --csv - 2>/dev/null; echo $? >&2; } | head -n 1");
  EXPECT_THAT(outcome.out, testing::StartsWith("time_s,"));
  EXPECT_EQ(outcome.err, "0\n");
  EXPECT_EQ(shell("{ $DASHPAD run " + case_file() + "; echo $? >&2; } | true").err, "0\n");
}

TEST_F(ResultFilesTest, AClosedStandardOutputIsAnErrorAndSpoilsNoFile) {
  const Outcome outcome = shell("$DASHPAD run " + case_file() + " --json " + file("result.json") + " >&-");
  EXPECT_EQ(outcome.exit_code, 1);
  EXPECT_TRUE(nlohmann::json::accept(read_file(file("result.json"))));
}

TEST_F(ResultFilesTest, ADeviceIsWrittenToAsItIs) {
  EXPECT_EQ(dashpad({"run", case_file(), "--json", "/dev/null"}).exit_code, 0);
  EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

}  // namespace
}  // namespace dashpad::test
