// Texts in a given width.

#include <string>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "output/svg/svg.hpp"

namespace dashpad {
namespace {

using ::testing::ElementsAre;
using ::testing::EndsWith;

TEST(PlotText, KeepsWhatIsReadable) {
  EXPECT_EQ(output::readable("µ\t€\r\n\x7f𝄞"), "µ €   𝄞");
  EXPECT_EQ(output::readable("a\xff\xc3"), "a��");
}

TEST(PlotText, IsCutByCharacters) {
  EXPECT_EQ(output::shortened("äöü", 3), "äöü");
  EXPECT_EQ(output::shortened("äöüß", 3), "äö…");
}

TEST(TextFit, CutsWhatHasNoRoom) {
  EXPECT_EQ(output::fitting("short", 10, 100), "short");
  const std::string cut = output::fitting("äöüäöüäöüäöüäöüäöü", 10, 40);
  EXPECT_THAT(cut, EndsWith("…"));
  EXPECT_LE(output::text_room(cut, 10), 40);
}

TEST(TextFit, GoesOnInTheNextLine) {
  const double room = output::text_room("one two", 10);
  EXPECT_THAT(output::lines_within("one two three", 10, room), ElementsAre("one two", "three"));
  EXPECT_THAT(output::lines_within("äöüäöü", 10, output::text_room("äöüä", 10)), ElementsAre("äöüä", "öü"));
  EXPECT_THAT(output::lines_within("W", 10, 1), ElementsAre("W"));
  EXPECT_THAT(output::lines_within("", 10, 40), ElementsAre());
}

}  // namespace
}  // namespace dashpad
