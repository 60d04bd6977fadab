// dashpad study under mpirun: the same rows as on one machine, also after a rank was killed.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* study = R"(title = "Ranks"
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
    if (dashpad({"--version"}).out.find("with MPI") == std::string::npos)
      GTEST_SKIP() << "this dashpad was built without MPI";
  }
  void write_study(const std::string& samples) {
    write_file(file("study.toml"), with(study, "SAMPLES", samples));
  }

  std::string command(const std::string& store) {
    return "$DASHPAD study " + file("study.toml") + " --out " + file(store) + " --quiet";
  }
  /// Runs a script in which $RANKS starts that many ranks.
  static Outcome with_ranks(int ranks, const std::string& script) {
    return shell("RANKS='mpirun --oversubscribe --allow-run-as-root -n " + std::to_string(ranks) + "'\n" +
                 script);
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
  write_study("60000");
  const std::string kill_one =
      "$RANKS sh -c 'if [ \"$OMPI_COMM_WORLD_RANK\" = 1 ]; then (sleep 1; kill -9 $$) & fi; exec " +
      with(command("killed.db"), "$DASHPAD", "\"$0\"") + "' \"$DASHPAD\"";
  const Outcome killed = with_ranks(3, kill_one);
  EXPECT_NE(killed.exit_code, 0) << killed.out;
  const Outcome whole = with_ranks(3, "$RANKS " + command("killed.db"));
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_EQ(whole.out.find("; 60000 computed"), std::string::npos)
      << "nothing was left from before: " << whole.out;
  ASSERT_EQ(shell(command("one.db")).exit_code, 0);
  EXPECT_EQ(rows_of("killed.db"), rows_of("one.db"));
}

TEST_F(StudyMpiTest, ATerminatedJobGoesOn) {
  write_study("60000");
  with_ranks(2, "$RANKS " + command("stopped.db") + " & sleep 2; kill -TERM $!; wait $!");
  const Outcome whole = with_ranks(2, "$RANKS " + command("stopped.db"));
  EXPECT_EQ(whole.exit_code, 0) << whole.err;
  EXPECT_THAT(whole.out, AllOf(HasSubstr("60000 rows in"), testing::Not(HasSubstr("; 60000 computed"))));
}

TEST_F(StudyMpiTest, AFaultIsSaidOnceAndEndsAllRanks) {
  write_study("100");
  ASSERT_EQ(shell(command("one.db")).exit_code, 0);
  write_study("200");
  const std::string missing = with(command("new.db"), "study.toml", "missing.toml");
  for (const auto& [arguments, words] :
       {std::pair{command("one.db"), "another study"}, std::pair{missing, "missing.toml"},
        std::pair{command("new.db") + " --threads 2", "--threads"}}) {
    const Outcome outcome = with_ranks(3, "$RANKS " + arguments);
    EXPECT_EQ(outcome.exit_code, 2) << outcome.err;
    EXPECT_NE(outcome.err.find(words), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("1 fault"), outcome.err.rfind("1 fault")) << outcome.err;
  }
  EXPECT_FALSE(fs::exists(file("new.db")));
}

}  // namespace
}  // namespace dashpad::test
