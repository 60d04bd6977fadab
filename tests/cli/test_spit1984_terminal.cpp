// dashpad spit1984 --interactive, at a terminal as its users of 1984 sat at one, and through a pipe.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "terminal.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::EndsWith;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;
using testing::StartsWith;

struct Exchange {
  std::string prompt, answer;
};

/// The questions of ENSOL and the answers that made the second printout of the report's Appendix C.
const std::vector<Exchange> dialogue{
    {"5 = 21-PARAMETER: ", "5"},
    {"4 = PIECEWISE LINEAR SUPPORT (4 SLOPES): ", "1"},
    {"ENTER SPHERE RADIUS (IN.): ", "3."},
    {"ENTER INITIAL SPEED (MPH): ", "20."},
    {"ENTER WEIGHT (LBS): ", "10."},
    {"ENTER FOAM THICKNESS (IN.): ", "1."},
    {"INITIAL TIME STEP SIZE (MSEC): ", ".1"},
    {"ENTER PRINT INTERVAL, NDEL: ", "10"},
    {"ENTER SUPPORT STIFFNESS (LB/IN): ", "600."},
};

/// Answers the first questions, as many as `count`, with the return key.
void answer(Terminal& terminal, std::size_t count = dialogue.size()) {
  for (std::size_t i = 0; i < count; ++i) {
    ASSERT_TRUE(terminal.shows(dialogue[i].prompt));
    terminal.type(dialogue[i].answer + "\r");
  }
}

std::string typed_lines() {
  std::string text;
  for (const Exchange& exchange : dialogue) text += exchange.answer + "\n";
  return text;
}

const std::string last_row =
    "      0.243E+02     -0.999E+01      0.000E+00     -0.331E+03      0.665E+00      0.648E+00";

class Spit1984TerminalTest : public CommandTest {
 protected:
  /// The command with all the answers on standard input.
  Outcome piped(const std::string& more) {
    write_file(file("answers"), typed_lines());
    return shell("cat " + file("answers") + " | $DASHPAD spit1984 --interactive " + more);
  }
};

TEST_F(Spit1984TerminalTest, AsksAndPrintsThePublishedReport) {
  Terminal terminal{{"spit1984", "--interactive"}};
  answer(terminal);
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_THAT(terminal.shown(),
              AllOf(StartsWith("SPHERE/PAD IMPACT TRACKER VERSION 2-DEC 1984\r\n"),
                    HasSubstr("PLEASE CHOOSE MODEL: 1 = ELASTIC\r\n"), HasSubstr("SPHERE PARMS:\r\n"),
                    HasSubstr("1984 program in pdp10 arithmetic\r\n"), EndsWith(last_row + "\r\n")));
}

TEST_F(Spit1984TerminalTest, WritesThePrintersReport) {
  Terminal terminal{{"spit1984", "--interactive", "--listing", file("for21.txt")}};
  answer(terminal);
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_THAT(terminal.shown(), EndsWith(last_row + "\r\n"));
  const std::string example = std::string{DASHPAD_SOURCE_DIR} + "/examples/dashboard-20mph-21-parameter.toml";
  EXPECT_EQ(read_file(file("for21.txt")), dashpad({"spit1984", example, "--listing", "-"}).out);
}

TEST_F(Spit1984TerminalTest, AsksAgainAfterATypingError) {
  Terminal terminal{{"spit1984", "--interactive"}};
  ASSERT_TRUE(terminal.shows(dialogue[0].prompt));
  terminal.type("five\r");
  ASSERT_TRUE(terminal.shows("That is not a whole number. Please try again: "));
  terminal.type("6\r");
  ASSERT_TRUE(terminal.shows("Please type a whole number from 1 to 5: "));
  terminal.type("5\r");
  ASSERT_TRUE(terminal.shows(dialogue[1].prompt));
  terminal.type("1\r");
  ASSERT_TRUE(terminal.shows(dialogue[2].prompt));
  terminal.type("3 inch\r");
  ASSERT_TRUE(terminal.shows("That is not a number. Please try again: "));
  terminal.type(
      "4\x7f"
      "3.\r");  // a slip of the finger, rubbed out
  for (std::size_t i = 3; i < dialogue.size(); ++i) {
    ASSERT_TRUE(terminal.shows(dialogue[i].prompt));
    terminal.type(dialogue[i].answer + "\r");
  }
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_THAT(terminal.shown(), EndsWith(last_row + "\r\n"));
}

TEST_F(Spit1984TerminalTest, AsksForAPiecewiseLinearSupport) {
  Terminal terminal{{"spit1984", "--interactive", "--json", file("result.json")}};
  ASSERT_TRUE(terminal.shows(dialogue[0].prompt));
  terminal.type("5\r");
  ASSERT_TRUE(terminal.shows(dialogue[1].prompt));
  terminal.type("2\r");
  for (std::size_t i = 2; i < 8; ++i) {
    ASSERT_TRUE(terminal.shows(dialogue[i].prompt));
    terminal.type(dialogue[i].answer + "\r");
  }
  ASSERT_TRUE(terminal.shows("DEFLECTION-LOAD PAIR  1:"));
  terminal.type("1. 600.\r");
  ASSERT_TRUE(terminal.shows("DEFLECTION-LOAD PAIR  2:"));
  terminal.type("2.\r");  // a missing number is a zero, which is refused
  EXPECT_EQ(terminal.end(), 2);
  EXPECT_THAT(terminal.shown(), HasSubstr("SPAR(4) = 0: "));
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(Spit1984TerminalTest, EndOfInputInTheMiddleIsOneClearLine) {
  Terminal terminal{{"spit1984", "--interactive", "--listing", file("for21.txt")}};
  answer(terminal, 4);
  ASSERT_TRUE(terminal.shows(dialogue[4].prompt));
  terminal.type("\x04");
  EXPECT_EQ(terminal.end(), 2);
  EXPECT_THAT(terminal.shown(), HasSubstr("\r\nthe input ended before the last answer\r\n1 error"));
  EXPECT_THAT(terminal.shown(), Not(HasSubstr("RUN SUMMARY")));
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(Spit1984TerminalTest, ControlCEndsIt) {
  Terminal terminal{{"spit1984", "--interactive", "--listing", file("for21.txt")}};
  answer(terminal, 2);
  ASSERT_TRUE(terminal.shows(dialogue[2].prompt));
  terminal.type("3\x03");
  EXPECT_EQ(terminal.end(), 128 + SIGINT);
  EXPECT_THAT(other_files(), IsEmpty());
}

// A million steps take minutes; nobody has to wait for them.
TEST_F(Spit1984TerminalTest, ControlCEndsALongRun) {
  Terminal terminal{{"spit1984", "--interactive", "--most-steps", "1000000", "--listing", file("for21.txt")}};
  answer(terminal, 6);
  ASSERT_TRUE(terminal.shows(dialogue[6].prompt));
  terminal.type("1.E-6\r");
  for (std::size_t i = 7; i < dialogue.size(); ++i) {
    ASSERT_TRUE(terminal.shows(dialogue[i].prompt));
    terminal.type(dialogue[i].answer + "\r");
  }
  ASSERT_TRUE(terminal.has_shown_when_slowed("Running the 1984 program"));
  terminal.type("\x03");
  EXPECT_EQ(terminal.end(), 128 + SIGINT);
  EXPECT_THAT(other_files(), IsEmpty());
}

TEST_F(Spit1984TerminalTest, ReadsTheAnswersFromAPipe) {
  const Outcome outcome = piped("--csv " + file("history.csv"));
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(StartsWith("SPHERE/PAD IMPACT TRACKER VERSION"), EndsWith(last_row + "\n")));
  EXPECT_EQ(outcome.err, "1984 program in pdp10 arithmetic\n");
  EXPECT_THAT(read_file(file("history.csv")), StartsWith("time_ms,"));
}

TEST_F(Spit1984TerminalTest, KeepsQuestionsOutOfAResultOnStandardOutput) {
  const Outcome outcome = piped("--json -");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_TRUE(nlohmann::json::accept(outcome.out)) << outcome.out;
  EXPECT_THAT(outcome.err, HasSubstr("ENTER WEIGHT (LBS): "));
}

TEST_F(Spit1984TerminalTest, TakesTheLastLineWithoutItsEnd) {
  const Outcome outcome = shell(
      "printf '4\\r\\n1\\r\\n3\\r\\n20\\r\\n10\\r\\n1\\r\\n.1\\r\\n10\\r\\n600' | $DASHPAD spit1984 "
      "--interactive");
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
}

TEST_F(Spit1984TerminalTest, RefusesAnswersThatMakeNoImpact) {
  const Outcome outcome =
      shell("yes '' | head -n 20 | sed '1s/.*/1/; 2s/.*/1/' | $DASHPAD spit1984 --interactive");
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, AllOf(HasSubstr("RAD = 0: "), HasSubstr("THK = 0: "), HasSubstr("7 errors")));
}

TEST_F(Spit1984TerminalTest, AnEmptyOrClosedInputIsRefused) {
  EXPECT_THAT(dashpad({"spit1984", "--interactive"}).err, StartsWith("the input ended"));
  EXPECT_EQ(shell("$DASHPAD spit1984 --interactive <&-").exit_code, 2);
  EXPECT_EQ(shell("$DASHPAD spit1984 --interactive </").exit_code, 2);
  EXPECT_EQ(shell("head -c 1000000 /dev/zero | $DASHPAD spit1984 --interactive").exit_code, 2);
}

}  // namespace
}  // namespace dashpad::test
