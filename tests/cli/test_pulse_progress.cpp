// dashpad pulse at a terminal: what takes longer than a second says what it is at.

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <pty.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// All that the command writes to a pseudo-terminal.
std::string shown_on_terminal(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), DASHPAD_COMMAND);
  std::vector<char*> pointers;
  for (std::string& argument : arguments) pointers.push_back(argument.data());
  pointers.push_back(nullptr);
  int screen = -1;
  const pid_t process = ::forkpty(&screen, nullptr, nullptr, nullptr);
  if (process < 0) throw std::runtime_error("no pseudo-terminal");
  if (process == 0) {
    ::execv(pointers[0], pointers.data());
    ::_exit(127);
  }
  std::string shown;
  std::array<char, 4096> buffer{};
  for (ssize_t count = 0; (count = ::read(screen, buffer.data(), buffer.size())) > 0;)
    shown.append(buffer.data(), static_cast<std::size_t>(count));
  int status = 0;
  ::waitpid(process, &status, 0);
  ::close(screen);
  EXPECT_EQ(status, 0) << shown;
  return shown;
}

using PulseProgressTest = CommandTest;

TEST_F(PulseProgressTest, ALongPulseSaysWhatItIsAt) {
  std::string text = "acc [g]\n";
  for (int i = 0; i < 4'000'000; ++i) text += i % 1000 < 10 ? "9\n" : "1\n";
  write_file(file("long.csv"), text);
  EXPECT_THAT(shown_on_terminal({"pulse", file("long.csv"), "--interval", "1 us"}),
              AllOf(HasSubstr(" ... "), HasSubstr("\r "), HasSubstr("HIC15")));
}

/// A hole takes no space on the disk. It is no text, and is refused after the word of warning.
TEST_F(PulseProgressTest, WhatTakesMinutesIsAnnounced) {
  write_file(file("large.csv"), "");
  fs::resize_file(file("large.csv"), 950'000'000);
  const Outcome outcome = dashpad({"pulse", file("large.csv")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err,
              AllOf(testing::StartsWith(file("large.csv") + " has 906 MiB; this will take about 2 min\n"),
                    HasSubstr("is not text")));
  write_file(file("small.csv"), "t_ms,a_g\n0,1\n1,3\n");
  EXPECT_EQ(dashpad({"pulse", file("small.csv")}).err, "");
}

TEST_F(PulseProgressTest, AShortPulseIsSilent) {
  write_file(file("short.csv"), "acc [g]\n1\n3\n1\n");
  EXPECT_THAT(shown_on_terminal({"pulse", file("short.csv"), "--interval", "1 ms"}),
              AllOf(HasSubstr("HIC15"), Not(HasSubstr(" ... "))));
}

}  // namespace
}  // namespace dashpad::test
