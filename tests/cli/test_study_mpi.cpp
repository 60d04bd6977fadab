// dashpad study under mpirun: the same rows as on one machine, also after a rank was killed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* ranks_study = R"(title = "Ranks"
case = "case.toml"
samples = SAMPLES
responses = ["peak_force", "rebound_speed", "hic15"]
[factors."impactor.speed"]
distribution = "normal"
mean = "3 m/s"
deviation = "0.2 m/s"
)";

class StudyMpiTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    if (shell("command -v mpirun").exit_code != 0) GTEST_SKIP() << "mpirun is not installed";
    if (dashpad({"--version"}).out.find("MPI         supported") == std::string::npos)
      GTEST_SKIP() << "this dashpad was built without MPI";
  }
  void write_study(const std::string& samples) {
    write_file(file("study.toml"), with(ranks_study, "SAMPLES", samples));
  }
  /// Runs a script that ends a study by force, of as many rows as it takes for that to come before their end.
  /// How many that were.
  std::string interrupt(int ranks, const std::string& script, const std::string& store) {
    for (int samples = 60'000; samples < 4'000'000; samples *= 8) {
      write_study(std::to_string(samples));
      if (with_ranks(ranks, script).exit_code != 0) return std::to_string(samples);
      fs::remove(file(store));
    }
    throw std::runtime_error("the study always comes to its end");
  }

  std::string command(const std::string& store) {
    return "$DASHPAD study " + file("study.toml") + " --out " + file(store) + " --quiet";
  }
  /// Runs a script in which $RANKS starts that many ranks. Open MPI keeps memory until the end, from plugins
  /// that are gone by then: a build with AddressSanitizer is not to report it.
  static Outcome with_ranks(int ranks, const std::string& script) {
    return shell("export ASAN_OPTIONS=detect_leaks=0 RANKS='mpirun --oversubscribe --allow-run-as-root -n " +
                 std::to_string(ranks) + "'\n" + script);
  }
  /// One message and no store.
  void expect_refused(const Outcome& outcome, const std::string& words) const {
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << words << "\n" << outcome.err;
    EXPECT_EQ(outcome.err.find("1 error"), outcome.err.rfind("1 error")) << outcome.err;
    EXPECT_NE(outcome.err.find("1 error; nothing was run"), std::string::npos) << outcome.err;
    EXPECT_FALSE(fs::exists(file("new.db")));
  }
  std::string rows_of(const std::string& store) {
    const Outcome outcome = dashpad({"study", "export", file(store), "--csv", "-"});
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    return outcome.out;
  }
};

TEST_F(StudyMpiTest, TwoAndThreeRanksGiveTheRowsOfOneProcess) {
  write_study("2000");
  ASSERT_EQ(shell(command("one.db")).exit_code, 0);
  for (const int ranks : {2, 3}) {
    const std::string store = std::to_string(ranks) + ".db";
    const Outcome outcome = with_ranks(ranks, "$RANKS " + command(store));
    EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
    EXPECT_THAT(outcome.out, HasSubstr("2000 rows in"));
    EXPECT_EQ(outcome.out.find("2000 rows in"), outcome.out.rfind("2000 rows in")) << "only rank 0 speaks";
    EXPECT_EQ(rows_of(store), rows_of("one.db"));
  }
}

/// A rank that ends in the middle of its batch: the job ends with it, the store stays good.
TEST_F(StudyMpiTest, GoesOnAfterARankWasKilled) {
  const std::string kill_one = "$RANKS sh -c 'if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then (" +
                               until(with(has_rows(file("killed.db")), "$DASHPAD", "\"$0\"")) +
                               "kill -9 $$) & fi; exec " + with(command("killed.db"), "$DASHPAD", "\"$0\"") +
                               "' \"$DASHPAD\"";
  const std::string rows = interrupt(3, kill_one, "killed.db");
  const Outcome whole = with_ranks(3, "$RANKS " + command("killed.db"));
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.out.find("; " + rows + " computed"), std::string::npos)
      << "nothing was left from before: " << whole.out;
  ASSERT_EQ(shell(command("one.db")).exit_code, 0);
  EXPECT_EQ(rows_of("killed.db"), rows_of("one.db"));
}

TEST_F(StudyMpiTest, ATerminatedJobGoesOn) {
  const std::string rows = interrupt(2,
                                     "$RANKS " + command("stopped.db") + " &\n" +
                                         until(has_rows(file("stopped.db"))) + "kill -TERM $!; wait $!",
                                     "stopped.db");
  const Outcome whole = with_ranks(2, "$RANKS " + command("stopped.db"));
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_THAT(whole.out,
              AllOf(HasSubstr(rows + " rows in"), testing::Not(HasSubstr("; " + rows + " computed"))));
}

TEST_F(StudyMpiTest, AFaultIsSaidOnceAndEndsAllRanks) {
  write_study("100");
  ASSERT_EQ(shell(command("one.db")).exit_code, 0);
  write_study("200");
  const std::string missing = with(command("new.db"), "study.toml", "missing.toml");
  for (const auto& [arguments, words] :
       {std::pair{command("one.db"), "--extend to keep these rows"}, std::pair{missing, "missing.toml"},
        std::pair{command("new.db") + " --threads 2", "--threads"},
        std::pair{command("no/such/folder.db"), "no folder"},
        std::pair{command("study.toml"), "not the store"}})
    expect_refused(with_ranks(3, "$RANKS " + arguments), words);
}

TEST_F(StudyMpiTest, RefusesBadStudiesWithOneMessage) {
  const std::string speed = "[factors.\"impactor.speed\"]\n";
  const std::string drawn = with(ranks_study, "SAMPLES", "100");
  const std::string grid = "case = \"case.toml\"\n" + speed;
  for (const auto& [text, words] :
       {std::pair{with(drawn, "impactor.speed", "impactor.sped"), "did you mean \"impactor.speed\"?"},
        std::pair{with(drawn, "3 m/s", "3 kg"), "\"kg\" denotes a mass"},
        std::pair{with(drawn, "hic15", "hic51"), "hic51"},
        std::pair{with(drawn, "samples = 100", "samples = 1000000000000"), "from 1 to 1000000000"},
        std::pair{grid + "values = []\n", "must have at least one value"},
        std::pair{grid + "from = \"1 m/s\"\nto = \"2 m/s\"\ncount = 0\n", "count = 0"},
        std::pair{grid + "from = \"1 m/s\"\nto = \"2 m/s\"\ncount = 1000000000000\n", "from 2 to 1000000"}}) {
    write_file(file("study.toml"), text);
    expect_refused(with_ranks(2, "$RANKS " + command("new.db")), words);
    expect_refused(shell(command("new.db")), words);
  }
}

TEST_F(StudyMpiTest, RefusesAReadOnlyFolder) {
  write_study("100");
  fs::create_directory(file("closed"));
  fs::permissions(file("closed"), fs::perms::owner_read | fs::perms::owner_exec);
  if (::access(file("closed").c_str(), W_OK) == 0) GTEST_SKIP() << "this user may write everywhere";
  expect_refused(with_ranks(2, "$RANKS " + command("closed/new.db")), "the folder is read-only");
  expect_refused(shell(command("closed/new.db")), "the folder is read-only");
}

/// Two ranks, the second one with another word in its command.
TEST_F(StudyMpiTest, RefusesRanksThatWouldComputeSomethingElse) {
  write_file(file("study.toml"), with(with(ranks_study, "case.toml", "foam.toml"), "SAMPLES", "100"));
  write_file(file("other.toml"), with(with(ranks_study, "case.toml", "foam.toml"), "SAMPLES", "101"));
  const std::string card = "law = \"elastic\"\n[parameters]\nmodulus = \"300 kPa\"\n";
  const std::string inline_law = "law = \"elastic\"\n[pad.parameters]\nmodulus = \"300 kPa\"\n";
  write_file(file("foam.toml"), with(elastic_case(), inline_law, "material = \"foam\"\n"));
  for (const char* folder : {"cards", "others"}) fs::create_directory(file(folder));
  write_file(file("cards/foam.toml"), "title = \"Foam\"\nsource = \"made up\"\n" + card);
  write_file(file("others/foam.toml"),
             "title = \"Foam\"\nsource = \"made up\"\n" + with(card, "300 kPa", "301 kPa"));
  const std::string first = command("new.db") + " --materials " + file("cards");
  const std::string start = "ASAN_OPTIONS=detect_leaks=0 mpirun --oversubscribe --allow-run-as-root -n 1 ";
  for (const auto& [second, words] :
       {std::pair{with(first, "/cards", "/others"),
                  "a card or a data file that it names, differs between ranks"},
        std::pair{with(first, "study.toml", "other.toml"), ".toml: differs between ranks"},
        std::pair{with(first, "study.toml", "missing.toml"), "rank 1: "}})
    expect_refused(shell(start + first + " : -n 1 " + second), words);
  EXPECT_EQ(shell(start + first + " : -n 1 " + first).exit_code, 0);
}

/// A limit on file sizes stands in for a full disk; MPI keeps its own files out of its way.
TEST_F(StudyMpiTest, AFullDiskKeepsTheRowsAndTheStudyGoesOn) {
  write_study("6000");
  const Outcome full = with_ranks(2, "export OMPI_MCA_btl=self,tcp\n$RANKS sh -c 'ulimit -f 600; exec " +
                                         with(command("full.db"), "$DASHPAD", "\"$0\"") + "' \"$DASHPAD\"");
  EXPECT_EQ(full.exit_code, 1) << full.err;
  const std::string words = "all rows written so far are kept";
  EXPECT_NE(full.err.find(words), std::string::npos) << full.err;
  EXPECT_EQ(full.err.find(words), full.err.rfind(words)) << full.err;
  const Outcome kept = dashpad({"study", "export", file("full.db"), "--csv", "-"});
  EXPECT_THAT(kept.err, AllOf(HasSubstr("NOT COMPLETE"), testing::Not(testing::StartsWith("0 rows"))));
  const Outcome whole = with_ranks(2, "$RANKS " + command("full.db"));
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  ASSERT_EQ(shell(command("one.db")).exit_code, 0);
  EXPECT_EQ(rows_of("full.db"), rows_of("one.db"));
}

}  // namespace
}  // namespace dashpad::test
