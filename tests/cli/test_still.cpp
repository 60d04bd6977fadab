/// dashpad run --png, and what dashpad run says of the pulse.

#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "command.hpp"

namespace dashpad::test {
namespace {

using nlohmann::json;
using testing::HasSubstr;
using testing::Not;

using StillTest = CommandTest;

TEST_F(StillTest, IsAPng) {
  const Outcome run = dashpad({"run", case_file(), "--png", file("still.png")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(read_file(file("still.png")).starts_with("\x89PNG\r\n"));
}

TEST_F(StillTest, NeedsNoOtherProgram) {
  const Outcome run = shell("PATH= \"$DASHPAD\" run '" + case_file() + "' --png '" + file("still.png") + "'");
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_TRUE(fs::exists(file("still.png")));
}

TEST_F(StillTest, TheRunHasInjuryFiguresInTextAndJson) {
  const Outcome run = dashpad({"run", case_file(), "--json", "-"});
  EXPECT_THAT(run.err, HasSubstr("HIC15"));
  const json injury = json::parse(run.out)["injury"];
  EXPECT_GT(injury["hic36"]["value"], 0);
  EXPECT_GE(injury["hic36"]["value"], injury["hic15"]["value"]);
  EXPECT_LT(injury["hic36"]["error"], 0.01);
}

TEST_F(StillTest, APadThatBottomedOutHasNoInjuryFigures) {
  const Outcome run =
      dashpad({"run", DASHPAD_SOURCE_DIR "/examples/rigid-floor-bottoming.toml", "--json", "-"});
  EXPECT_TRUE(json::parse(run.out)["injury"].is_null());
  EXPECT_THAT(run.err, Not(HasSubstr("HIC")));
}

}  // namespace
}  // namespace dashpad::test
