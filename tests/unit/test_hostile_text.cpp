// Names that others chose, on their way to a terminal.

#include <gtest/gtest.h>

#include <string>

#include "dashpad/input/fault.hpp"
#include "quantities/text.hpp"

namespace dashpad {
namespace {

TEST(HostileText, HasNothingThatATerminalObeys) {
  EXPECT_EQ(without_controls("a\x1b[31mb\x7f\n\tc\r"), "a [31mb \n\tc ");
  EXPECT_EQ(without_controls("x\xc2\x9b"
                             "31m\xe2\x80\xae"
                             "y\xe2\x81\xa6z"),
            "x 31m y z");
  EXPECT_EQ(without_controls("Pr\xfc"
                             "fung"),
            "Pr\xef\xbf\xbd"
            "fung");
  EXPECT_EQ(one_line("a\nb\tc"), "a b c");
}

TEST(HostileText, KeepsWhatPeopleWrite) {
  const std::string text = "Schaum \xc3\xa4, 25 kg/m\xc2\xb3, \xe6\xb3\xa1\xe6\xb2\xab \xf0\x9f\x98\x80";
  EXPECT_EQ(without_controls(text), text);
  EXPECT_EQ(one_line(text), text);
}

TEST(HostileText, HasNoEndlessNames) {
  EXPECT_EQ(quoted_part("short"), "short");
  EXPECT_EQ(quoted_part(std::string(100, 'a')), std::string(60, 'a') + "...");
  EXPECT_EQ(quoted_part("\xc3\xa4\xc3\xa4", 3), "\xc3\xa4...");
  const std::string line = "unknown unit \"" + std::string(100'000, 'x') + "\"; use m";
  EXPECT_LT(without_endless_words(line).size(), 100U);
  EXPECT_TRUE(without_endless_words(line).ends_with("...; use m") ||
              without_endless_words(line).ends_with("... use m"));
  const input::Fault fault{"case.toml", 3, std::string(200'000, 'k'), std::string(200'000, 'v'),
                           "unknown key"};
  EXPECT_LT(to_string(fault).size(), 400U);
  EXPECT_TRUE(to_string(fault).ends_with(": unknown key"));
}

}  // namespace
}  // namespace dashpad
