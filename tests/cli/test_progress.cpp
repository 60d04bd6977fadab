// What a person hears of a computation that takes long, and what a program that reads standard error does
// not.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "terminal.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

class ProgressTest : public CommandTest {
 protected:
  /// The command on a slow machine, ended once it has said something on standard error.
  [[nodiscard]] Outcome begun(const std::string& arguments) const {
    const std::string said = file("said");
    return shell("$DASHPAD " + arguments + " 2> " + said + " &\n" + slowed_until("[ -s " + said + " ]") +
                 "kill -TERM $!; wait $! 2> /dev/null; code=$?; cat " + said + " >&2; exit $code");
  }
};

TEST_F(ProgressTest, WhatTakesMinutesSaysSoFirst) {
  const std::string report_case = std::string{DASHPAD_SOURCE_DIR} + "/examples/dashboard-20mph.toml";
  for (const std::string& command :
       {"compare " + report_case + " --time-step 1e-6",
        "spit1984 " + std::string{DASHPAD_SOURCE_DIR} +
            "/examples/dashboard-20mph-21-parameter.toml --time-step 1e-6 --most-steps 1000000 "
            "--most-stations 1000000 --equilibrium-tolerance 1e-9"}) {
    const Outcome outcome = begun(command);
    EXPECT_EQ(outcome.exit_code, 128 + SIGTERM) << "it has to take long for this test";
    EXPECT_THAT(outcome.err, ContainsRegex("^Running the 1984 program.* will take about [0-9]+ minutes\n$"));
    EXPECT_EQ(outcome.out, "");
  }
}

TEST_F(ProgressTest, ATerminalShowsHowFarItIs) {
  const std::string report_case = std::string{DASHPAD_SOURCE_DIR} + "/examples/dashboard-20mph.toml";
  Terminal terminal{{"compare", report_case, "--time-step", "3e-5"}};
  EXPECT_TRUE(terminal.has_shown_when_slowed(" 2 s"));
  EXPECT_TRUE(terminal.has_shown("Running the 1984 program"));
  EXPECT_TRUE(terminal.has_shown(" %"));
}

TEST_F(ProgressTest, WhatIsDoneAtOnceShowsNoProgress) {
  const auto shown = said_within(1, [&] {
    Terminal terminal{{"run", case_file()}};
    EXPECT_EQ(terminal.end(), 0);
    return terminal.shown();
  });
  const auto compared = said_within(2, [&] { return dashpad({"compare", case_file()}).err; });
  if (!shown || !compared) GTEST_SKIP() << "this machine does nothing at once";
  EXPECT_THAT(*shown, AllOf(HasSubstr("Peak force"), Not(HasSubstr("Solving"))));
  EXPECT_EQ(*compared, "");
}

}  // namespace
}  // namespace dashpad::test
