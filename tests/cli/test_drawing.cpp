/// dashpad run --drawing: where it is written, and where not.

#include <gmock/gmock.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::StartsWith;

using DrawingTest = CommandTest;

TEST_F(DrawingTest, IsAnSvg) {
  const Outcome run = dashpad({"run", case_file(), "--drawing", file("drawing.svg")});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  const std::string svg = read_file(file("drawing.svg"));
  EXPECT_THAT(svg, StartsWith("<svg xmlns=\"http://www.w3.org/2000/svg\""));
  EXPECT_THAT(svg, EndsWith("</svg>\n"));
  EXPECT_THAT(svg, HasSubstr("penetration</text>"));
}

TEST_F(DrawingTest, HasTheUnitsAskedFor) {
  const Outcome run = dashpad({"run", nine, "--units", "us", "--drawing", "-"});
  EXPECT_EQ(run.exit_code, 0) << run.err;
  EXPECT_THAT(run.out, StartsWith("<svg"));
  EXPECT_THAT(run.out, HasSubstr(">20 mph</text>"));
  EXPECT_THAT(run.out, HasSubstr(">1 in</text>"));
  EXPECT_THAT(run.err, HasSubstr("Peak force"));
}

TEST_F(DrawingTest, AnExistingFileIsKeptUnlessForced) {
  write_file(file("drawing.svg"), "mine");
  EXPECT_EQ(dashpad({"run", case_file(), "--drawing", file("drawing.svg")}).exit_code, 2);
  EXPECT_EQ(read_file(file("drawing.svg")), "mine");
  EXPECT_EQ(dashpad({"run", case_file(), "--drawing", file("drawing.svg"), "--force"}).exit_code, 0);
  EXPECT_THAT(read_file(file("drawing.svg")), StartsWith("<svg"));
}

TEST_F(DrawingTest, AnotherEndingIsRefusedBeforeTheRun) {
  const Outcome run =
      dashpad({"run", case_file(), "--drawing", file("drawing.bmp"), "--json", file("result.json")});
  EXPECT_EQ(run.exit_code, 2);
  EXPECT_THAT(run.err, HasSubstr("drawing.bmp: must end in .svg, .png or .pdf"));
  EXPECT_FALSE(fs::exists(file("drawing.bmp")));
  EXPECT_FALSE(fs::exists(file("result.json")));
}

TEST_F(DrawingTest, IsAPictureToo) {
  for (const auto& [ending, begin] : {std::pair{"png", "\x89PNG"}, {"pdf", "%PDF"}}) {
    const std::string name = file(std::string{"drawing."} + ending);
    ASSERT_EQ(dashpad({"run", case_file(), "--drawing", name}).exit_code, 0);
    EXPECT_THAT(read_file(name), StartsWith(begin));
  }
}

TEST_F(DrawingTest, SaysWhatBottomsOut) {
  const Outcome run = dashpad({"run", examples + "rigid-floor-bottoming.toml", "--drawing", "-"});
  EXPECT_THAT(run.out, HasSubstr(">Bottomed out</text>"));
}

}  // namespace
}  // namespace dashpad::test
