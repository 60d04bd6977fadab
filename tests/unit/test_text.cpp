/// Text for a terminal: on one line, and how much room it takes.

#include "quantities/text.hpp"

#include <gtest/gtest.h>

namespace dashpad {
namespace {

TEST(OneLine, HasNoLineBreaksAndNoControls) {
  EXPECT_EQ(one_line("a\nb\tc\x7f"), "a b c ");
  EXPECT_EQ(one_line("esc\x1b[31m"), "esc [31m");
}

/// What a terminal obeys instead of showing it: C1 controls, separators, directions.
TEST(OneLine, HasNoUnseenCharacters) {
  EXPECT_EQ(one_line("a\u009bb"), "a b");
  EXPECT_EQ(one_line("a\u2028b\u2029c"), "a b c");
  EXPECT_EQ(one_line("a\u202eb\u2066c\u2069d\u200fe"), "a b c d e");
}

TEST(OneLine, KeepsEverythingElse) {
  for (const char* text : {"Schaum, 30 mm, äöü", "泡沫", "a\u2013b \u00a0 \u2070", "\xff\xc2", "\xe2", ""})
    EXPECT_EQ(one_line(text), text);
}

TEST(WidthOf, CountsCharactersNotBytes) {
  EXPECT_EQ(width_of(""), 0);
  EXPECT_EQ(width_of("in·lbf"), 6);
  EXPECT_EQ(width_of("kJ/m³ 泡沫"), 8);
}

TEST(Wrapped, BreaksAtBlanksAndIndentsAllButTheFirstLine) {
  const std::string word(46, 'w');
  EXPECT_EQ(wrapped("  short", 4), "  short");
  EXPECT_EQ(wrapped(word + " " + word + " " + word + " end", 4),
            word + " " + word + "\n    " + word + " end");
  const std::string widest(100, 'w');
  EXPECT_EQ(wrapped(widest, 2), widest);
  EXPECT_EQ(wrapped(widest + " a", 2), widest + "\n  a");
}

/// An address cannot be broken; the columns count characters, not bytes.
TEST(Wrapped, KeepsWordsWhole) {
  const std::string address(150, 'u');
  EXPECT_EQ(wrapped("  see " + address + " for more", 4), "  see\n    " + address + "\n    for more");
  EXPECT_EQ(wrapped(address, 4), address);
  std::string wide;
  for (int i = 0; i < 110; ++i) wide += "³";
  EXPECT_EQ(wrapped(wide, 4), wide);
}

}  // namespace
}  // namespace dashpad
