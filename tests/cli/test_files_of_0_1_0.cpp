// Files that dashpad 0.1.0 wrote: today's command reads them, or refuses them in a sentence that says what to
// do.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::AnyOf;
using testing::EndsWith;
using testing::HasSubstr;

/// Works on copies.
class FilesOf010Test : public CommandTest {
 protected:
  void SetUp() override {
    for (const auto& entry : fs::directory_iterator(DASHPAD_SOURCE_DIR "/tests/cli/files-0.1.0"))
      fs::copy_file(entry.path(), file(entry.path().filename().string()));
    ASSERT_EQ(shell("gunzip " + file("study.db.gz")).exit_code, 0);
  }

  /// One fault, and the way out of it.
  static void expect_a_way_out(const Outcome& outcome, const std::string& name) {
    EXPECT_EQ(outcome.exit_code, 2) << outcome.out;
    EXPECT_THAT(outcome.err, AllOf(HasSubstr(name), EndsWith("1 error; nothing was run\n"),
                                   AnyOf(HasSubstr("give another name"), HasSubstr("use the version that"),
                                         HasSubstr("give another file"))));
  }
};

TEST_F(FilesOf010Test, ACaseWithACardOfAFitIsSolved) {
  const Outcome outcome = dashpad({"run", file("case.toml"), "--json", "-"});
  ASSERT_EQ(outcome.exit_code, 0) << outcome.err;
  // 37.66 g by the program of 0.1.0, whose columns did not help each other.
  EXPECT_NEAR(nlohmann::json::parse(outcome.out)["peak_acceleration_g"].get<double>(), 36.135, 0.01);
  EXPECT_EQ(dashpad({"materials", file("card.toml")}).exit_code, 0);
}

TEST_F(FilesOf010Test, AStudyAnswers) {
  const Outcome summary = dashpad({"study", "summary", file("study.db")});
  EXPECT_EQ(summary.exit_code, 0) << summary.err;
  EXPECT_THAT(summary.out, HasSubstr("20 rows, computed by Dashpad 0.1.0 (17de466b5d41)"));
  const Outcome rows = dashpad({"study", "export", file("study.db"), "--csv", "-"});
  EXPECT_EQ(rows.exit_code, 0) << rows.err;
  EXPECT_EQ(std::ranges::count(rows.out, '\n'), 21);
}

TEST_F(FilesOf010Test, AStudyGoesOnOrSaysWhatToDo) {
  const Outcome outcome = dashpad({"study", file("study.toml"), "--out", file("study.db")});
  if (outcome.exit_code == 0)
    EXPECT_THAT(outcome.out, HasSubstr("all were already in the store"));
  else
    expect_a_way_out(outcome, "study.db");
}

TEST_F(FilesOf010Test, AFitGoesOnOrSaysWhatToDo) {
  const Outcome outcome = dashpad({"fit", file("fit.toml"), "--state", file("fit.state")});
  if (outcome.exit_code != 0) expect_a_way_out(outcome, "fit.state");
}

}  // namespace
}  // namespace dashpad::test
