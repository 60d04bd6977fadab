// dashpad pulse at a terminal: what takes longer than a second says what it is at.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "terminal.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::Not;

using PulseProgressTest = CommandTest;

TEST_F(PulseProgressTest, ALongPulseSaysWhatItIsAt) {
  std::string text = "acc [g]\n";
  for (int i = 0; i < 2'000'000; ++i) text += i % 1000 < 10 ? "9\n" : "1\n";
  write_file(file("long.csv"), text);
  Terminal terminal{{"pulse", file("long.csv"), "--interval", "1 us"}};
  EXPECT_TRUE(terminal.has_shown_when_slowed("  1 s"));
  EXPECT_EQ(terminal.end(), 0);
  EXPECT_THAT(terminal.shown(), AllOf(ContainsRegex("(long\\.csv|2000000 samples)  1 s"), HasSubstr("\r "),
                                      HasSubstr("HIC15")));
}

/// A hole takes no space on the disk.
TEST_F(PulseProgressTest, WhatTakesMinutesIsAnnounced) {
  write_file(file("large.csv"), "");
  fs::resize_file(file("large.csv"), 950'000'000);
  const std::string said = file("said");
  const Outcome outcome = shell("$DASHPAD pulse " + file("large.csv") + " 2> " + said + " &\n" +
                                until("[ -s " + said + " ]") + "kill -KILL $!; cat " + said + " >&2");
  EXPECT_THAT(outcome.err,
              testing::StartsWith("Reading " + file("large.csv") + " will take about 2 minutes\n"));
  write_file(file("small.csv"), "t_ms,a_g\n0,1\n1,3\n");
  EXPECT_EQ(dashpad({"pulse", file("small.csv")}).err, "");
}

TEST_F(PulseProgressTest, AShortPulseIsSilent) {
  write_file(file("short.csv"), "acc [g]\n1\n3\n1\n");
  const auto shown = said_within(1, [&] {
    Terminal terminal{{"pulse", file("short.csv"), "--interval", "1 ms"}};
    EXPECT_EQ(terminal.end(), 0);
    return terminal.shown();
  });
  if (!shown) GTEST_SKIP() << "this machine does nothing within a second";
  EXPECT_THAT(*shown, AllOf(HasSubstr("HIC15"), Not(HasSubstr("Reading"))));
}

}  // namespace
}  // namespace dashpad::test
