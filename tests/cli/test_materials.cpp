/// dashpad materials: the table of the cards, one card whole, and their picture.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "command.hpp"

namespace dashpad::test {
namespace {

using testing::AllOf;
using testing::ContainsRegex;
using testing::HasSubstr;

class MaterialsTest : public CommandTest {
 protected:
  void SetUp() override {
    CommandTest::SetUp();
    fs::create_directory(file("cards"));
    fs::copy(fs::path{DASHPAD_SOURCE_DIR} / "materials/plastazote-ld33.toml", file("cards"));
  }
  [[nodiscard]] Outcome materials(std::vector<std::string> arguments) const {
    arguments.insert(arguments.begin(), "materials");
    arguments.insert(arguments.end(), {"--materials", file("cards")});
    return dashpad(std::move(arguments));
  }
};

TEST_F(MaterialsTest, AreATable) {
  const Outcome outcome = dashpad({"materials"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out, AllOf(ContainsRegex("Name +Law +kg/m3 +Strain +Rates"),
                                 ContainsRegex("vn600 +foam +105 +0.55 "),
                                 ContainsRegex("eps-22 +crushable-foam +21.6 +0.1 .*datasheet"),
                                 ContainsRegex("eps-12-geofoam .*solver card")));
}

TEST_F(MaterialsTest, OneHasItsReservationsAndStresses) {
  const Outcome outcome = materials({"plastazote-ld33"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(ContainsRegex("\nBasis +datasheet\n"), HasSubstr("Unloading and friction are assumed."),
                    ContainsRegex("\nCurve +gibson-ashby"), ContainsRegex("relative_density +R +0.036 "),
                    ContainsRegex("at 0.03 1/s +1[0-9.]+ kPa +4[01][0-9.]* kPa +11[45][0-9.]* kPa")));
  EXPECT_THAT(materials({"plastazote-ld33", "--units", "us"}).out, HasSubstr(" psi"));
}

TEST_F(MaterialsTest, AreDrawn) {
  const Outcome all = dashpad({"materials", "--picture", file("foams.svg")});
  EXPECT_EQ(all.exit_code, 0) << all.err;
  EXPECT_THAT(
      read_file(file("foams.svg")),
      AllOf(HasSubstr(">vn600<"), HasSubstr(">ff-turbo-plus-conditioned<"), HasSubstr("Stress (kPa)")));
  EXPECT_EQ(materials({"plastazote-ld33", "--picture", file("one.png")}).exit_code, 0);
  EXPECT_TRUE(read_file(file("one.png")).starts_with("\x89PNG\r\n"));
}

TEST_F(MaterialsTest, ACardHasAPageAndMarkdown) {
  const Outcome outcome = materials({"plastazote-ld33", "--report", file("card.html"), "--markdown", "-"});
  EXPECT_EQ(outcome.exit_code, 0) << outcome.err;
  EXPECT_THAT(outcome.out,
              AllOf(HasSubstr("# Plastazote LD33"), HasSubstr("| relative\\_density | R | 0.036 |")));
  EXPECT_THAT(read_file(file("card.html")),
              AllOf(HasSubstr("Unloading and friction are assumed."), HasSubstr("Stress in first loading"),
                    HasSubstr("at 0.03 per second")));
  EXPECT_EQ(materials({"--report", file("all.html")}).exit_code, 0);
  EXPECT_THAT(read_file(file("all.html")), HasSubstr("1 material card"));
}

TEST_F(MaterialsTest, APictureIsKeptUnlessForced) {
  write_file(file("mine.svg"), "mine");
  const Outcome outcome = materials({"--picture", file("mine.svg")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.err, HasSubstr("mine.svg"));
  EXPECT_EQ(read_file(file("mine.svg")), "mine");
  EXPECT_EQ(materials({"--picture", file("mine.svg"), "--force"}).exit_code, 0);
  EXPECT_NE(read_file(file("mine.svg")), "mine");
}

TEST_F(MaterialsTest, NothingIsDrawnInTheWrongFormatOrInPart) {
  EXPECT_EQ(materials({"--picture", file("foams.gif")}).exit_code, 2);
  write_file(file("cards/bad.toml"), "title = 3\n");
  const Outcome outcome = materials({"--picture", file("foams.svg")});
  EXPECT_EQ(outcome.exit_code, 2);
  EXPECT_THAT(outcome.out, HasSubstr("plastazote-ld33"));
  EXPECT_THAT(outcome.err, HasSubstr("bad.toml"));
  EXPECT_FALSE(fs::exists(file("foams.svg")) || fs::exists(file("foams.gif")));
}

}  // namespace
}  // namespace dashpad::test
